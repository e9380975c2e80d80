#ifndef RAYAUDIT_ORACLE_H
#define RAYAUDIT_ORACLE_H

/// The exact oracle, in plain C: what is true of a case, and what is to be said of an answer to it.
/// C99 or C++11; link librayaudit. For C++17 there is oracle.hpp on top of it.
///
///     rayaudit_case question;
///     rayaudit_read_case("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1", &question, NULL, NULL, 0);
///     rayaudit_truth truth;
///     rayaudit_truth_of(&question, &truth);  // truth.crossings[0].t.in_double:
///     0x1.1126145e9ecd5p+1
///
/// Nothing here rounds a decision or leaves it open, whatever the flags of the caller and the
/// floating-point state of its thread; which is put back. Any thread may call; nothing is kept in
/// between. Functions that return an int return RAYAUDIT_DONE or what went wrong, which is below 0.

#include <stddef.h>
#include <stdint.h>

#include "case.h"
#include "convention.h"

#ifdef __cplusplus
extern "C" {
#endif

#pragma GCC visibility push(default)

typedef enum rayaudit_status {
  RAYAUDIT_DONE = 0,
  RAYAUDIT_NONE_SUCH = -1,  ///< a shape, a form, a format or a stance is none that there is
  RAYAUDIT_NO_LINE = -2,    ///< a line that is read is no case line
  RAYAUDIT_NO_MEMORY = -3,
  RAYAUDIT_FAULT = -4  ///< ours
} rayaudit_status;

/// The floating-point format that an answer was worked out in; what an ulp is counted in.
typedef enum rayaudit_format {
  RAYAUDIT_DOUBLE = 0,
  RAYAUDIT_FLOAT = 1,
  RAYAUDIT_LONG_DOUBLE = 2
} rayaudit_format;

/// Why a case is no question of truth at all. Where several apply, the first names it.
typedef enum rayaudit_invalid {
  RAYAUDIT_VALID = 0,
  RAYAUDIT_NAN = 1,             ///< a number is NaN
  RAYAUDIT_INFINITE = 2,        ///< a number other than t_min, t_max is infinite
  RAYAUDIT_ZERO_DIRECTION = 3,  ///< the direction is 0
  RAYAUDIT_ZERO_NORMAL = 4,     ///< the normal is 0
  RAYAUDIT_ZERO_AXIS = 5,       ///< base and top, or apex, are the same point
  RAYAUDIT_RADIUS = 6,          ///< the radius is not above 0
  RAYAUDIT_EMPTY_RANGE = 7      ///< t_min >= t_max
} rayaudit_invalid;

/// What a crossing is: proper, when every small enough change of the case keeps it, else a touch.
typedef enum rayaudit_kind {
  RAYAUDIT_PROPER = 0,
  RAYAUDIT_TANGENT = 1,
  RAYAUDIT_RIM = 2,
  RAYAUDIT_APEX = 3,    ///< the line passes outside the cone at its apex
  RAYAUDIT_START = 4,   ///< t is exactly t_min
  RAYAUDIT_END = 5,     ///< t is exactly t_max
  RAYAUDIT_WITHIN = 6,  ///< the ray lies in the surface, from t to t_last
} rayaudit_kind;

/// One exact number, correctly rounded to each format.
typedef struct rayaudit_rounded {
  float in_float;
  double in_double;
  long double in_long_double;
} rayaudit_rounded;

typedef struct rayaudit_crossing {
  int32_t kind;             ///< a rayaudit_kind
  rayaudit_rounded t;       ///< in units of the direction as given
  rayaudit_rounded t_last;  ///< of a within: where the stretch ends; else t
} rayaudit_crossing;

/// The crossings up to and including the first proper one, in order along the ray. Right is that
/// hit, or a miss where there is none; a touch before it may be taken or passed by.
typedef struct rayaudit_truth {
  int32_t invalid;  ///< a rayaudit_invalid; of an invalid case the rest is 0
  int32_t hit;      ///< 1: the last crossing is a proper one; 0: a miss
  int32_t count;
  rayaudit_crossing crossings[4];
} rayaudit_truth;

typedef enum rayaudit_verdict {
  RAYAUDIT_RIGHT = 0,
  RAYAUDIT_TOUCH = 1,       ///< a matter of convention: a touch taken, or passed by
  RAYAUDIT_FALSE_HIT = 2,   ///< a hit where no hit is acceptable
  RAYAUDIT_FALSE_MISS = 3,  ///< a miss where there is a proper hit
  RAYAUDIT_WRONG_ROOT = 4,  ///< a t nearest to another root than an acceptable one
  RAYAUDIT_WRONG_T = 5,     ///< the right root, off by more than 1/128 of the exact t
  RAYAUDIT_NOT_FINITE = 6,  ///< a t that is NaN, or infinite where the exact t is not
  RAYAUDIT_CRASHED = 7,     ///< told of subjects in other processes only, as is the next
  RAYAUDIT_TIMED_OUT = 8,
  RAYAUDIT_INVALID_HANDLED = 9,     ///< the case is invalid, and a miss is said
  RAYAUDIT_INVALID_MISHANDLED = 10  ///< the case is invalid, and a hit is said
} rayaudit_verdict;

/// What there is at the place that a false hit or a wrong root claims.
typedef enum rayaudit_claim {
  RAYAUDIT_NOTHING = 0,
  RAYAUDIT_NO_ROOT = 1,  ///< no root is near
  RAYAUDIT_T_NAN = 2,
  RAYAUDIT_T_INFINITE = 3,
  RAYAUDIT_BEHIND = 4,     ///< a root before the range
  RAYAUDIT_PAST = 5,       ///< a root after the range
  RAYAUDIT_CLIPPED = 6,    ///< a root beside the disk, above or below the shape
  RAYAUDIT_MIRRORED = 7,   ///< a root on the cone's other nappe
  RAYAUDIT_LATER = 8,      ///< a crossing, but not the first
  RAYAUDIT_DECLINED = 9,   ///< what is declared to be a miss
  RAYAUDIT_PARALLEL = 10,  ///< the ray runs parallel to the surface
  RAYAUDIT_CENTRE = 11,    ///< the point told is the centre, or base, of the shape itself
  RAYAUDIT_ORIGIN = 12,    ///< of a false miss: the hit missed lies at the world origin
  RAYAUDIT_GARBAGE = 13,   ///< told of subjects in other processes only, as are the next
  RAYAUDIT_ENDED = 14,
  RAYAUDIT_HUNG = 15
} rayaudit_claim;

/// On which side of the surface the rounded point origin + t direction lies, as the ray came.
typedef enum rayaudit_side {
  RAYAUDIT_UNKNOWN = 0,
  RAYAUDIT_BEFORE = 1,
  RAYAUDIT_ON = 2,
  RAYAUDIT_BEYOND = 3
} rayaudit_side;

/// One answer held against the truth. A number that is not measured is NaN.
typedef struct rayaudit_judgement {
  int32_t verdict;   ///< a rayaudit_verdict
  int32_t claim;     ///< a rayaudit_claim
  int32_t touch;     ///< the kind of the touch that was on offer, or 0
  int32_t taken;     ///< 1: the answer took it
  int32_t crossing;  ///< the place in the truth's list of what t was held against, or -1
  int32_t side;      ///< a rayaudit_side
  double ulps;       ///< error of t in ulps of the format; correctly rounded it is 0.5 at most
  double relative;   ///< |t - exact| / |exact|
  double forced;     ///< error in units of what rounding the numbers of the case once would do to t
  double own;        ///< error in units of the larger of that and an ulp
  double distance;   ///< of the rounded point to the surface, in ulps of its largest coordinate
  double margin;     ///< how far from a case with another truth, in units u of the format
} rayaudit_judgement;

/// What an answer is held to; all 0 asks of an answer in double that it is not wrong.
typedef struct rayaudit_allowed {
  double max_ulp;  ///< of t, where above 0
  int32_t format;  ///< a rayaudit_format
  rayaudit_convention convention;
} rayaudit_allowed;

/// The truth of a case.
int rayaudit_truth_of(const rayaudit_case* question, rayaudit_truth* truth);
/// truths[i] is that of cases[i]: many at once take the least time each. Where one
/// of the cases is of a shape that there is not, what truths hold is not said.
int rayaudit_truths(const rayaudit_case* cases, size_t count, rayaudit_truth* truths);

/// Judges an answer to the case, as it was asked: its direction and its range are those of the
/// case. Of the convention, where there is one, count the stances towards touches and inside.
int rayaudit_judge(const rayaudit_case* question, const rayaudit_answer* answer, int32_t format,
                   const rayaudit_convention* convention, rayaudit_judgement* judgement);

/// The case as it is to be asked under the convention: with the extent and the opening that it
/// declares, standing as it does, with a direction normalised in the format or a segment, and a
/// range that is answered in. What was posed so already stays as it is.
int rayaudit_posed(const rayaudit_case* question, int32_t format,
                   const rayaudit_convention* convention, rayaudit_case* posed);

/// 1 where the answer is not wrong, and its t within max_ulp; else 0. Allowed may be null.
int rayaudit_agrees(const rayaudit_case* question, const rayaudit_answer* answer,
                    const rayaudit_allowed* allowed);

/// What a person needs to know of an answer that is not what it should be, in some lines: case,
/// got, truth, verdict, error, margin, cause where known, and the command that explains it. As
/// snprintf does: writes what has room in size, a 0 at its end, and returns the length of the
/// whole.
int rayaudit_told(const rayaudit_case* question, const rayaudit_answer* answer,
                  const rayaudit_allowed* allowed, char* text, size_t size);

/// Reads a case line, and the answer on it where there is one (else a miss); answer may be null.
/// Where it is none, writes a sentence that says why as snprintf does; why may be null.
int rayaudit_read_case(const char* line, rayaudit_case* question, rayaudit_answer* answer,
                       char* why, size_t size);
/// The case as a line without an end, and the answer where there is one; written as rayaudit_told.
int rayaudit_write_case(const rayaudit_case* question, const rayaudit_answer* answer, char* line,
                        size_t size);

/// Their words, as reports have them; null of what is none.
const char* rayaudit_verdict_name(int32_t verdict);
const char* rayaudit_claim_name(int32_t claim);
const char* rayaudit_side_name(int32_t side);
const char* rayaudit_kind_name(int32_t kind);
const char* rayaudit_invalid_name(int32_t invalid);
const char* rayaudit_format_name(int32_t format);
const char* rayaudit_version(void);

#pragma GCC visibility pop

#ifdef __cplusplus
}
#endif

#endif
