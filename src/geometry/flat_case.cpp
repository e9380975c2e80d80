#include "geometry/flat_case.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <tuple>
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
  void operator()(const CappedCylinder<double>& cylinder) const {
    made.is.capped_cylinder = {flat(cylinder.base), flat(cylinder.top), cylinder.radius};
  }
  void operator()(const CappedCone<double>& cone) const {
    made.is.capped_cone = {flat(cone.base), flat(cone.apex), cone.radius};
  }
};

/// (high + low) 2^exponent; the low part says nothing beside an infinity or a NaN.
Real sum(double high, double low, int exponent) {
  if (!std::isfinite(high)) return real(high);
  if (!std::isfinite(low)) return real(std::numeric_limits<double>::quiet_NaN());
  if (low == 0) return {high, 0, 0, exponent};
  return normal({high, low, 0, exponent});
}

/// The two doubles that are nearest to a number 2^-exponent.
std::pair<double, double> two_doubles(const Real& x, int exponent) {
  Real left = normal(x);
  if (!is_finite(left)) return {left.high, 0};
  left.exponent -= exponent;
  const double high = nearest<double>(left);
  return {high, nearest<double>(difference(left, real(high)))};
}

/// What to take out of numbers so that doubles hold them; 0 for most.
int exponent_of(std::initializer_list<Real> numbers) {
  int largest = std::numeric_limits<int>::min();
  for (const Real& each : numbers)
    if (is_finite(each) && sign(each) != 0) largest = std::max(largest, binade(each));
  return largest != std::numeric_limits<int>::min() && (largest < -900 || largest > 1000) ? largest
                                                                                          : 0;
}

}  // namespace

rayaudit_case flat(const Case& question) {
  const Ray<double>& ray = question.ray;
  rayaudit_case made = {};
  made.ray = {flat(ray.origin), flat(ray.direction), ray.t_min, ray.t_max};
  made.shape = static_cast<std::int32_t>(question.shape.index());
  made.extent = static_cast<std::int32_t>(question.extent);
  std::visit(Flatten{made}, question.shape);
  return made;
}

Case from_flat(const rayaudit_case& question) {
  const auto shape = [&]<std::size_t... I>(std::index_sequence<I...>) {
    Shape made;
    const auto take = [&]<template <class> class S>(const S<double>*) {
      made = part<double, S>(question);
    };
    ((question.shape == static_cast<std::int32_t>(I)
          ? take(static_cast<std::variant_alternative_t<I, Shape>*>(nullptr))
          : void()),
     ...);
    return made;
  };
  return {in<double>(question.ray), shape(std::make_index_sequence<shape_count>{}),
          Extent{static_cast<std::uint8_t>(question.extent)}};
}

rayaudit_answer flat(const Answer& answer) {
  rayaudit_answer made = {};
  made.form = static_cast<std::int32_t>(answer.form);
  const auto tell = [&](const Real& x, double& high, double& low) {
    std::tie(high, low) = two_doubles(x, made.exponent);
  };
  if (answer.form == Answer::Form::hit) {
    made.exponent = exponent_of({answer.t});
    tell(answer.t, made.t, made.t_low);
  }
  if (answer.form == Answer::Form::at) {
    const auto& [x, y, z] = answer.point;
    made.exponent = exponent_of({x, y, z});
    tell(x, made.point.x, made.point_low.x);
    tell(y, made.point.y, made.point_low.y);
    tell(z, made.point.z, made.point_low.z);
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
      return Answer::hit(sum(answer.t, answer.t_low, answer.exponent));
    case RAYAUDIT_AT:
      return Answer::at({sum(x, low.x, answer.exponent), sum(y, low.y, answer.exponent),
                         sum(z, low.z, answer.exponent)});
    case RAYAUDIT_YES:
      return Answer::yes();
    default:
      return Answer::garbage();
  }
}

}  // namespace rayaudit
