#include <Ogre.h>

#include <limits>
#include <string>

#include "rayaudit/plugin.h"

/// OGRE as a plugin: its ray against its sphere and its plane. What is relied on is quoted from its
/// headers.
namespace {

Ogre::Vector3 vector(const rayaudit_vec3& of) {
  return {static_cast<float>(of.x), static_cast<float>(of.y), static_cast<float>(of.z)};
}

Ogre::Ray built(const rayaudit_ray& ray) { return {vector(ray.origin), vector(ray.direction)}; }

/// "if true, the second element will indicate the distance along the ray at which it intersects.
/// This can be converted to a point in space by calling Ray::getPoint()" (RayTestResult,
/// OgreMath.h), which is "mOrigin + (mDirection * t)" (OgreRay.h): in units of the direction.
rayaudit_answer told(const Ogre::RayTestResult& result) {
  return result.first ? rayaudit_hit(result.second) : rayaudit_miss();
}

/// "Ray / sphere intersection" (OgreMath.h)
template <bool discard_inside>
rayaudit_answer sphere(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  const Ogre::Sphere body(vector(sphere.centre), static_cast<float>(sphere.radius));
  return told(Ogre::Math::intersects(built(ray), body, discard_inside));
}

/// "Ray / plane intersection" (OgreMath.h). A normal need not be of length 1: distances to such a
/// plane are only not "the true distance" (OgrePlane.h).
rayaudit_answer plane(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  const Ogre::Plane infinite(vector(disk.normal), vector(disk.centre));
  return told(Ogre::Math::intersects(built(ray), infinite));
}

template <auto hit, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = hit(cases[i].ray, cases[i].is.*shape);
}

using Shapes = decltype(rayaudit_case::is);

const std::string version = "OGRE " + std::to_string(OGRE_VERSION_MAJOR) + "." +
                            std::to_string(OGRE_VERSION_MINOR) + "." +
                            std::to_string(OGRE_VERSION_PATCH) + ", Math::intersects";
const std::string with_inside = version + ", discardInside = false";

/// "a ray in space, i.e. a line with an origin and direction" (OgreRay.h)
rayaudit_subject subject(const char* name, const std::string& about, rayaudit_inside inside,
                         rayaudit_batch sphere, rayaudit_batch disk) {
  rayaudit_subject made = {};
  made.name = name, made.format = "float", made.about = about.c_str();
  made.convention.inside = inside;
  made.convention.extent = RAYAUDIT_UNBOUNDED;
  // It knows no range: whatever the ray has, it answers from its start on, without end.
  made.convention.line = 1;
  made.convention.t_min = 0, made.convention.t_max = std::numeric_limits<double>::infinity();
  made.sphere = sphere, made.disk = disk;
  return made;
}

/// "Check origin inside first" (OgreRay.h): with discardInside, as it is if nothing is said, a ray
/// from inside meets the sphere where it starts.
const rayaudit_subject subjects[] = {
    subject("ogre", version, RAYAUDIT_INSIDE_IS_START, batch<sphere<true>, &Shapes::sphere>,
            batch<plane, &Shapes::disk>),
    subject("ogre_inside", with_inside, RAYAUDIT_INSIDE_IS_HIT,
            batch<sphere<false>, &Shapes::sphere>, nullptr)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
