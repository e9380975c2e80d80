#include "geometry/flat_case.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace rayaudit {
namespace {

rayaudit_vec3 flat(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

struct Flatten {
  rayaudit_case& made;

  void operator()(const Disk<double>& disk) const {
    made.is.disk = {flat(disk.centre), flat(disk.normal), disk.radius};
  }
  void operator()(const Sphere<double>& sphere) const {
    made.is.sphere = {flat(sphere.centre), sphere.radius};
  }
  void operator()(const Cylinder<double>& cylinder) const {
    made.is.cylinder = {flat(cylinder.base), flat(cylinder.top), cylinder.radius};
  }
  void operator()(const Cone<double>& cone) const {
    made.is.cone = {flat(cone.base), flat(cone.apex), cone.radius};
  }
};

/// A number and its low part, which says nothing beside an infinity or a NaN.
Real sum(double high, double low) {
  if (low == 0 || !std::isfinite(high)) return real(high);
  if (!std::isfinite(low)) return real(std::numeric_limits<double>::quiet_NaN());
  return normal({high, low, 0, 0});
}

/// The two doubles nearest to a number.
std::pair<double, double> two_doubles(const Real& x) {
  const double high = nearest<double>(x);
  if (!std::isfinite(high)) return {high, 0};
  return {high, nearest<double>(difference(x, real(high)))};
}

}  // namespace

rayaudit_case flat(const Case& question) {
  const Ray<double>& ray = question.ray;
  rayaudit_case made = {};
  made.ray = {flat(ray.origin), flat(ray.direction), ray.t_min, ray.t_max};
  made.shape = static_cast<std::int32_t>(question.shape.index());
  std::visit(Flatten{made}, question.shape);
  return made;
}

Case from_flat(const rayaudit_case& question) {
  const auto shape = [&]() -> Shape {
    switch (question.shape) {
      case RAYAUDIT_DISK:
        return in<double>(question.is.disk);
      case RAYAUDIT_SPHERE:
        return in<double>(question.is.sphere);
      case RAYAUDIT_CYLINDER:
        return in<double>(question.is.cylinder);
      default:
        return in<double>(question.is.cone);
    }
  };
  return {in<double>(question.ray), shape()};
}

rayaudit_answer flat(const Answer& answer) {
  rayaudit_answer made = {};
  made.form = static_cast<std::int32_t>(answer.form);
  if (answer.form == Answer::Form::hit) std::tie(made.t, made.t_low) = two_doubles(answer.t);
  if (answer.form == Answer::Form::at) {
    std::tie(made.point.x, made.point_low.x) = two_doubles(answer.point.x);
    std::tie(made.point.y, made.point_low.y) = two_doubles(answer.point.y);
    std::tie(made.point.z, made.point_low.z) = two_doubles(answer.point.z);
  }
  return made;
}

Answer from_flat(const rayaudit_answer& answer) {
  const auto& [x, y, z] = answer.point;
  const rayaudit_vec3& low = answer.point_low;
  switch (answer.form) {
    case RAYAUDIT_MISS:
      return Answer::miss();
    case RAYAUDIT_HIT:
      return Answer::hit(sum(answer.t, answer.t_low));
    case RAYAUDIT_AT:
      return Answer::at({sum(x, low.x), sum(y, low.y), sum(z, low.z)});
    case RAYAUDIT_YES:
      return Answer::yes();
    default:
      return Answer::garbage();
  }
}

}  // namespace rayaudit
