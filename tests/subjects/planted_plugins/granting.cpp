#include <cmath>
#include <initializer_list>

#include "rayaudit/plugin.h"

/// A plugin that stands for a library, in Embree's place: spheres by a routine that takes
/// directions for unit vectors, though it declares no such thing, once under Embree's own name; and
/// spheres and disks by the textbook's formulas.
namespace {

struct Vector {
  float x, y, z;
};
Vector vector(const rayaudit_vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
float dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

rayaudit_answer first(const rayaudit_ray& ray, float a, float b, float c) {
  const float discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return rayaudit_miss();
  for (const float t : {(-b - std::sqrt(discriminant)) / a, (-b + std::sqrt(discriminant)) / a})
    if (t > static_cast<float>(ray.t_min) && t < static_cast<float>(ray.t_max))
      return rayaudit_hit(t);
  return rayaudit_miss();
}

template <bool granting>
void spheres(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  for (size_t i = 0; i < count; ++i) {
    const rayaudit_sphere& sphere = cases[i].is.sphere;
    const Vector d = vector(cases[i].ray.direction);
    const Vector v = vector(cases[i].ray.origin) - vector(sphere.centre);
    const float r = static_cast<float>(sphere.radius);
    answers[i] = first(cases[i].ray, granting ? 1 : dot(d, d), dot(v, d), dot(v, v) - r * r);
  }
}

void disks(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  for (size_t i = 0; i < count; ++i) {
    const rayaudit_disk& disk = cases[i].is.disk;
    const Vector o = vector(cases[i].ray.origin), d = vector(cases[i].ray.direction);
    const Vector c = vector(disk.centre), n = vector(disk.normal);
    const float r = static_cast<float>(disk.radius), across = dot(d, n), t = dot(c - o, n) / across;
    const Vector p = Vector{o.x + t * d.x, o.y + t * d.y, o.z + t * d.z} - c;
    const bool is_hit = across != 0 && t > static_cast<float>(cases[i].ray.t_min) &&
                        t < static_cast<float>(cases[i].ray.t_max) && dot(p, p) <= r * r;
    answers[i] = is_hit ? rayaudit_hit(t) : rayaudit_miss();
  }
}

rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.rim = RAYAUDIT_IS_HIT;
  return made;
}

rayaudit_subject subject(const char* name, rayaudit_batch of_disks, rayaudit_batch of_spheres) {
  rayaudit_subject made = {};
  made.name = name, made.format = "float", made.convention = declared();
  made.disk = of_disks, made.sphere = of_spheres, made.about = "Planted 1.0";
  return made;
}

const rayaudit_subject subjects[] = {subject("embree", nullptr, spheres<true>),
                                     subject("embree_granting", nullptr, spheres<true>),
                                     subject("embree_right", disks, spheres<false>)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
