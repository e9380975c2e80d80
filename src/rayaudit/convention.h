#ifndef RAYAUDIT_CONVENTION_H
#define RAYAUDIT_CONVENTION_H

/// What is declared of the choices that mathematics leaves open, in plain C. C99 or C++11.

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// What a subject says of something that mathematics leaves open. Where it does not say, either is
/// right, and what it was seen to do is reported.
typedef enum rayaudit_stance {
  RAYAUDIT_EITHER = 0,
  RAYAUDIT_IS_HIT = 1,
  RAYAUDIT_IS_MISS = 2
} rayaudit_stance;

/// What a subject says of a hit at which the ray comes from inside the body (not of a disk).
typedef enum rayaudit_inside {
  RAYAUDIT_INSIDE_IS_HIT = 0,    ///< a hit like any other
  RAYAUDIT_INSIDE_IS_MISS = 1,   ///< the ray meets nothing
  RAYAUDIT_INSIDE_IS_START = 2,  ///< the hit is where the ray starts, at t_min
} rayaudit_inside;

/// What a subject declares, and is then held to; all 0 declares nothing.
typedef struct rayaudit_convention {
  int32_t tangent, rim, apex, start, end, within;  ///< each a rayaudit_stance towards such a touch
  int32_t inside;                                  ///< a rayaudit_inside
  int32_t unit_direction;  ///< not 0: it is to be given directions normalised in its format
  int32_t line;            ///< not 0: it answers for the whole line, both ways
  double t_min, t_max;     ///< it answers within these only, whatever the ray has; both 0: any
} rayaudit_convention;

#ifdef __cplusplus
}
#endif

#endif
