#ifndef RAYAUDIT_CASE_H
#define RAYAUDIT_CASE_H

/// A ray, a shape, and what may be said of them, in plain C: the words of plugin.h and oracle.h.
/// C99 or C++11. Every number is a double that denotes exactly the real it is; what works in float
/// is given doubles that are floats.

#include <math.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct rayaudit_vec3 {
  double x, y, z;
} rayaudit_vec3;

/// The points origin + t direction with t_min < t < t_max: t counts in units of the direction as
/// given, whatever its length.
typedef struct rayaudit_ray {
  rayaudit_vec3 origin, direction;
  double t_min, t_max;  ///< 0 and INFINITY for the half-line
} rayaudit_ray;

/// The flat disk, rim included; the normal of any length but 0.
typedef struct rayaudit_disk {
  rayaudit_vec3 centre, normal;
  double radius;
} rayaudit_disk;

typedef struct rayaudit_sphere {
  rayaudit_vec3 centre;
  double radius;
} rayaudit_sphere;

/// The lateral surface from base centre to top centre, open at both ends, its rims included.
typedef struct rayaudit_cylinder {
  rayaudit_vec3 base, top;
  double radius;
} rayaudit_cylinder;

/// The lateral surface from a base of that centre and radius to the apex: one nappe.
typedef struct rayaudit_cone {
  rayaudit_vec3 base, apex;
  double radius;
} rayaudit_cone;

/// The surface of the solid cylinder: lateral surface and caps.
typedef rayaudit_cylinder rayaudit_capped_cylinder;
/// The surface of the solid cone: one nappe and its base.
typedef rayaudit_cone rayaudit_capped_cone;

typedef enum rayaudit_shape {
  RAYAUDIT_DISK = 0,
  RAYAUDIT_SPHERE = 1,
  RAYAUDIT_CYLINDER = 2,
  RAYAUDIT_CONE = 3,
  RAYAUDIT_CAPPED_CYLINDER = 4,
  RAYAUDIT_CAPPED_CONE = 5
} rayaudit_shape;

/// How much of the surface of a disk, cylinder or cone is asked about.
typedef enum rayaudit_extent {
  RAYAUDIT_BOUNDED = 0,     ///< the shape as it is
  RAYAUDIT_UNBOUNDED = 1,   ///< the plane of the disk, an endless cylinder, an endless nappe
  RAYAUDIT_BOTH_NAPPES = 2  ///< the same, and of a cone the mirrored nappe too
} rayaudit_extent;

/// Do they meet, and where first?
typedef struct rayaudit_case {
  rayaudit_ray ray;
  int32_t shape;   ///< a rayaudit_shape, which says what of the union is meant
  int32_t extent;  ///< a rayaudit_extent
  union {
    rayaudit_disk disk;
    rayaudit_sphere sphere;
    rayaudit_cylinder cylinder;
    rayaudit_cone cone;
    rayaudit_capped_cylinder capped_cylinder;
    rayaudit_capped_cone capped_cone;
    double numbers[16];  ///< room for shapes to come
  } is;
} rayaudit_case;

typedef enum rayaudit_form {
  RAYAUDIT_MISS = 0,  ///< they do not meet
  RAYAUDIT_HIT = 1,   ///< they meet at t
  RAYAUDIT_AT = 2,    ///< they meet at a point
  RAYAUDIT_YES = 3    ///< they meet, no word of where
} rayaudit_form;

/// What is said of a case. A value is (x + x_low) 2^exponent, exactly: a long double, or a pair of
/// doubles, is told without loss, also where no double reaches.
typedef struct rayaudit_answer {
  int32_t form;      ///< a rayaudit_form
  int32_t exponent;  ///< of t, or of the point; 0 where doubles will do
  double t, t_low;
  rayaudit_vec3 point, point_low;
} rayaudit_answer;

static inline rayaudit_answer rayaudit_of_form(rayaudit_form form) {
  rayaudit_answer answer = {0, 0, 0, 0, {0, 0, 0}, {0, 0, 0}};
  answer.form = (int32_t)form;
  return answer;
}
static inline rayaudit_answer rayaudit_miss(void) { return rayaudit_of_form(RAYAUDIT_MISS); }
static inline rayaudit_answer rayaudit_yes(void) { return rayaudit_of_form(RAYAUDIT_YES); }
static inline rayaudit_answer rayaudit_hit(double t) {
  rayaudit_answer answer = rayaudit_of_form(RAYAUDIT_HIT);
  answer.t = t;
  return answer;
}
static inline rayaudit_answer rayaudit_at(double x, double y, double z) {
  rayaudit_answer answer = rayaudit_of_form(RAYAUDIT_AT);
  answer.point.x = x, answer.point.y = y, answer.point.z = z;
  return answer;
}

/// The exponent to take out of a number so that two doubles hold it; 0 for most.
static inline int rayaudit_exponent_of(long double x) {
  int exponent = 0;
  if (isfinite(x)) (void)frexpl(x, &exponent);
  return exponent < -900 || exponent > 1000 ? exponent : 0;
}
/// What is left of x beside its nearest double.
static inline double rayaudit_low_of(long double x) {
  const double high = (double)x;
  return isfinite(high) ? (double)(x - (long double)high) : 0;
}
/// Exactly t, to the last bit of x87's 64.
static inline rayaudit_answer rayaudit_hit_long(long double t) {
  const int exponent = rayaudit_exponent_of(t);
  const long double left = ldexpl(t, -exponent);
  rayaudit_answer answer = rayaudit_hit((double)left);
  answer.t_low = rayaudit_low_of(left);
  answer.exponent = exponent;
  return answer;
}
/// The same of a point; what is 2^-2000 of its largest coordinate, or less, is told as 0.
static inline rayaudit_answer rayaudit_at_long(long double x, long double y, long double z) {
  const long double largest = fmaxl(fabsl(x), fmaxl(fabsl(y), fabsl(z)));
  const int exponent = rayaudit_exponent_of(largest);
  rayaudit_answer answer;
  x = ldexpl(x, -exponent), y = ldexpl(y, -exponent), z = ldexpl(z, -exponent);
  answer = rayaudit_at((double)x, (double)y, (double)z);
  answer.point_low.x = rayaudit_low_of(x);
  answer.point_low.y = rayaudit_low_of(y);
  answer.point_low.z = rayaudit_low_of(z);
  answer.exponent = exponent;
  return answer;
}

#ifdef __cplusplus
}
#endif

#endif
