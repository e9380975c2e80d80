// A sphere in double: cc -shared -fPIC -O2 mine.c -o libmine.so
#include <math.h>
#include <rayaudit/plugin.h>

static double dot(rayaudit_vec3 a, rayaudit_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static rayaudit_answer meet(rayaudit_ray ray, rayaudit_sphere sphere) {
  const rayaudit_vec3 o = {ray.origin.x - sphere.centre.x, ray.origin.y - sphere.centre.y,
                           ray.origin.z - sphere.centre.z};
  const double a = dot(ray.direction, ray.direction), b = dot(o, ray.direction);
  const double root = sqrt(b * b - a * (dot(o, o) - sphere.radius * sphere.radius));
  const double first = (-b - root) / a, last = (-b + root) / a;
  const double t = first > ray.t_min ? first : last;
  return t > ray.t_min && t < ray.t_max ? rayaudit_hit(t) : rayaudit_miss();
}

static void spheres(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  for (size_t i = 0; i < count; ++i) answers[i] = meet(cases[i].ray, cases[i].is.sphere);
}

static const rayaudit_subject subjects[] = {
    {.name = "mine", .format = "double", .sphere = spheres}};
RAYAUDIT_PLUGIN(subjects)
