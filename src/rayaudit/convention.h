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
  RAYAUDIT_INSIDE_IS_ANY = 3     ///< it does not say: whatever it answers is right
} rayaudit_inside;

/// How a subject wants cylinder and cone, capped or not, to stand.
typedef enum rayaudit_stand {
  RAYAUDIT_ANYWHERE = 0,   ///< as they come
  RAYAUDIT_UPRIGHT_Y = 1,  ///< middle of the axis at the world origin, axis along +y to top or apex
  RAYAUDIT_UPRIGHT_Z = 2   ///< the same along +z
} rayaudit_stand;

/// What a subject takes for the opening of a cone. What is asked is then the cone that it is told,
/// of height 1, not the one that was drawn.
typedef enum rayaudit_opening {
  RAYAUDIT_BY_RADIUS = 0,  ///< the radius of the base
  RAYAUDIT_BY_ANGLE = 1,   ///< the angle of axis and generator, whose tangent is the radius
  RAYAUDIT_BY_COSINE = 2   ///< the cosine of that angle
} rayaudit_opening;

/// What a subject declares, and is then held to; all 0 declares nothing.
typedef struct rayaudit_convention {
  int32_t tangent, rim, apex, start, end, within;  ///< each a rayaudit_stance towards such a touch
  int32_t inside;                                  ///< a rayaudit_inside
  int32_t unit_direction;  ///< not 0: directions, and normals, are to be normalised in its format
  int32_t line;            ///< not 0: it answers for the whole line, both ways
  int32_t extent;          ///< a rayaudit_extent: how much of disk, cylinder and cone it knows
  int32_t stand;           ///< a rayaudit_stand
  int32_t opening;         ///< a rayaudit_opening
  int32_t segment;      ///< not 0: it takes two points; directions are their difference, t_max is 1
  double t_min, t_max;  ///< it answers within these only, whatever the ray has; both 0: any
} rayaudit_convention;

#ifdef __cplusplus
}
#endif

#endif
