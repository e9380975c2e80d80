// A disk in float, its rim a hit: c++ -shared -fPIC -O2 mine.cpp -o libmine.so
#include <rayaudit/plugin.h>

struct Vec {
  float x, y, z;
  explicit Vec(rayaudit_vec3 v) : x(float(v.x)), y(float(v.y)), z(float(v.z)) {}
};
static float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static rayaudit_answer meet(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  const Vec o(ray.origin), d(ray.direction), n(disk.normal);
  Vec from_centre(disk.centre);
  from_centre.x = o.x - from_centre.x, from_centre.y = o.y - from_centre.y;
  from_centre.z = o.z - from_centre.z;
  const float t = -dot(from_centre, n) / dot(d, n), r = float(disk.radius);
  from_centre.x += t * d.x, from_centre.y += t * d.y, from_centre.z += t * d.z;
  const bool inside = dot(from_centre, from_centre) <= r * r;
  return inside && t > ray.t_min && t < ray.t_max ? rayaudit_hit(t) : rayaudit_miss();
}

static void disks(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  for (size_t i = 0; i < count; ++i) answers[i] = meet(cases[i].ray, cases[i].is.disk);
}

static rayaudit_convention rim_is_hit() {
  rayaudit_convention made = {};
  made.rim = RAYAUDIT_IS_HIT;
  return made;
}

static const rayaudit_subject subjects[] = {
    {"mine", "float", rim_is_hit(), disks, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr}};
RAYAUDIT_PLUGIN(subjects)
