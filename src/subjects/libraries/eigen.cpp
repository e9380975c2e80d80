#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "rayaudit/plugin.h"

/// Eigen as a plugin: its line and its plane, in float and in double. What is relied on is quoted
/// from its documentation of ParametrizedLine and Hyperplane, in the headers.
namespace {

template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;

template <class T>
Vector<T> vector(const rayaudit_vec3& of) {
  return {static_cast<T>(of.x), static_cast<T>(of.y), static_cast<T>(of.z)};
}

/// "the vector normal is assumed to be normalized": that of a disk is of any length.
template <class T>
Vector<T> unit(const rayaudit_vec3& of) {
  const double length = std::hypot(of.x, of.y, of.z);
  return vector<T>({of.x / length, of.y / length, of.z / length});
}

/// "the parameter value of the intersection" is a quotient; where it is none, or infinite, there is
/// no other word for a line that runs along the plane.
template <class T>
rayaudit_answer plane(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  const Eigen::ParametrizedLine<T, 3> line(vector<T>(ray.origin), vector<T>(ray.direction));
  const Eigen::Hyperplane<T, 3> plane(unit<T>(disk.normal), vector<T>(disk.centre));
  const T t = line.intersectionParameter(plane);
  return std::isfinite(t) ? rayaudit_hit(t) : rayaudit_miss();
}

template <class T>
void planes(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = plane<T>(cases[i].ray, cases[i].is.disk);
}

const std::string about =
    "Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) +
    "." + std::to_string(EIGEN_MINOR_VERSION) + ", ParametrizedLine::intersectionParameter";

/// "the vector direction is assumed to be normalized", "t \in R": both ways.
template <class T>
rayaudit_subject subject(const char* format) {
  rayaudit_subject made = {};
  made.name = "eigen", made.format = format, made.about = about.c_str();
  made.convention.unit_direction = made.convention.line = 1;
  made.convention.extent = RAYAUDIT_UNBOUNDED;
  made.disk = planes<T>;
  return made;
}

const rayaudit_subject subjects[] = {subject<float>("float"), subject<double>("double")};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
