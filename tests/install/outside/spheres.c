#include <math.h>
#include <rayaudit/plugin.h>

/* The quadratic formula, which forgets that a root may lie behind. */
static void spheres(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  for (size_t i = 0; i < count; ++i) {
    const rayaudit_vec3 o = cases[i].ray.origin, d = cases[i].ray.direction;
    const rayaudit_sphere* sphere = &cases[i].is.sphere;
    const rayaudit_vec3 v = {o.x - sphere->centre.x, o.y - sphere->centre.y,
                             o.z - sphere->centre.z};
    const double a = d.x * d.x + d.y * d.y + d.z * d.z, b = v.x * d.x + v.y * d.y + v.z * d.z;
    const double c = v.x * v.x + v.y * v.y + v.z * v.z - sphere->radius * sphere->radius;
    const double discriminant = b * b - a * c;
    if (discriminant >= 0) answers[i] = rayaudit_hit((-b - sqrt(discriminant)) / a);
  }
}

static const rayaudit_subject subjects[] = {
    {.name = "spheres", .format = "double", .sphere = spheres}};
RAYAUDIT_PLUGIN(subjects)
