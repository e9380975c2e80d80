#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
// These need the ones above.
#include <IntAna_IntConicQuad.hxx>
#include <IntAna_Quadric.hxx>
#include <algorithm>
#include <cmath>

#include "rayaudit/plugin.h"

/// Open CASCADE as a plugin: a line and those of its quadrics that are shapes of ours. What is
/// relied on is quoted from the comments of its headers (7.6.3) that say so. "Two points are
/// considered to be coincident if their distance is smaller than the tolerance of confusion", which
/// is 1e-7 and "also used to define : the tolerance of intersection" (Precision.hxx). The simplest
/// wrong t of a sphere, by which a finding is shown, is off by less, and few of its false hits are
/// not rounding's: so neither has a sentence in programs/ that would make it a defect, though t is
/// off by more where a sphere lies far from the origin.
namespace {

gp_Pnt point(const rayaudit_vec3& at) { return {at.x, at.y, at.z}; }

/// "Normalizes the vector" (gp_Dir.hxx), of any length but 0.
gp_Dir direction(const rayaudit_vec3& of) { return {of.x, of.y, of.z}; }

/// "gives it an origin and a unit vector" (gp_Lin.hxx)
gp_Lin line(const rayaudit_ray& ray) { return {point(ray.origin), direction(ray.direction)}; }

long double length(const rayaudit_vec3& of) {
  const long double x = of.x, y = of.y, z = of.z;
  return std::sqrt(x * x + y * y + z * z);
}

/// "points ... associated with the parameter on the conic" (IntAna_IntConicQuad.hxx), of which the
/// smallest is told. The parameter is a length along the line, t counts in units of the direction.
rayaudit_answer told(const IntAna_IntConicQuad& met, const rayaudit_ray& ray) {
  // "Returns TRUE if the creation completed", "... if the conic is in the quadric",
  // "... if the line is in a quadric which is parallel to the quadric"
  if (!met.IsDone()) return rayaudit_miss();
  if (met.IsInQuadric()) return rayaudit_yes();
  if (met.IsParallel() || met.NbPoints() == 0) return rayaudit_miss();
  double first = met.ParamOnConic(1);
  for (int i = 2; i <= met.NbPoints(); ++i) first = std::min(first, met.ParamOnConic(i));
  return rayaudit_hit(static_cast<double>(first / length(ray.direction)));
}

/// "Tolang is used to determine if the angle between two vectors is null"
/// (IntAna_IntConicQuad.hxx). "The recommended precision value" (Precision.hxx) would take lines
/// that lean by 1e-12 for parallel, as whoever asks for it wants; this one is "used to determine
/// when two numbers can be considered equal" (gp.hxx), and takes no line that leans for one that
/// does not.
rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  const gp_Pln plane(point(disk.centre), direction(disk.normal));
  return told(IntAna_IntConicQuad(line(ray), plane, gp::Resolution()), ray);
}

rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  const gp_Sphere quadric(gp_Ax3(point(sphere.centre), gp::DZ()), sphere.radius);
  return told(IntAna_IntConicQuad(line(ray), IntAna_Quadric(quadric)), ray);
}

/// "Describes an infinite cylindrical surface" (gp_Cylinder.hxx)
rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cylinder& cylinder) {
  const gp_Cylinder quadric(gp_Ax3(point(cylinder.base), gp::DZ()), cylinder.radius);
  return told(IntAna_IntConicQuad(line(ray), IntAna_Quadric(quadric)), ray);
}

/// "Defines an infinite conical surface. A cone is defined by its half-angle", here with "the
/// radius of the circle in the reference plane" (gp_Cone.hxx) 0: the reference plane is the apex's.
/// Its quadric has both nappes.
rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cone& cone) {
  const long double tangent = cone.radius / (cone.apex.z - cone.base.z);
  const auto angle = static_cast<double>(std::atan(tangent));
  const gp_Cone quadric(gp_Ax3(point(cone.apex), gp::DZ()), angle, 0);
  return told(IntAna_IntConicQuad(line(ray), IntAna_Quadric(quadric)), ray);
}

/// The batch of a shape, which is a member of what a case is. What is "raised" (gp_Dir.hxx,
/// gp_Cone.hxx) is a refusal, which no answer has a form for: it is told as a miss.
template <auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    try {
      answers[i] = hit(cases[i].ray, cases[i].is.*shape);
    } catch (const Standard_Failure&) {
      answers[i] = rayaudit_miss();
    }
  }
}

/// "Describes a line in 3D space" (gp_Lin.hxx): both ways. Where it touches and what lies in a
/// surface the headers leave open.
constexpr rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.line = 1;
  made.extent = RAYAUDIT_BOTH_NAPPES;
  made.stand = RAYAUDIT_UPRIGHT_Z;
  made.opening = RAYAUDIT_BY_ANGLE;
  return made;
}

using Shapes = decltype(rayaudit_case::is);
const rayaudit_subject subjects[] = {
    {.name = "opencascade",
     .format = "double",
     .convention = declared(),
     .disk = batch<&Shapes::disk>,
     .sphere = batch<&Shapes::sphere>,
     .cylinder = batch<&Shapes::cylinder>,
     .cone = batch<&Shapes::cone>,
     .capped_cylinder = nullptr,
     .capped_cone = nullptr,
     .about = "Open CASCADE " OCC_VERSION_COMPLETE ", IntAna_IntConicQuad"}};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
