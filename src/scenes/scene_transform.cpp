#include "scenes/scene_transform.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace rayaudit {
namespace {

/// Of a linear map less than this share of its columns' lengths: it has no inverse to speak of.
constexpr Wide least_determinant = 1e-12;

bool is_double(Wide x) { return std::abs(x) <= std::numeric_limits<double>::max(); }

bool has_doubles(const Vec3<Wide>& v) { return is_double(v.x) && is_double(v.y) && is_double(v.z); }

bool has_doubles(const Affine& a) {
  return has_doubles(a.x) && has_doubles(a.y) && has_doubles(a.z) && has_doubles(a.moved);
}

Transform with_doubles(const Transform& transform) {
  if (has_doubles(transform.to) && has_doubles(transform.from)) return transform;
  throw Error("the transform or its inverse overflows a double");
}

/// Rows and columns of a rotation change places in its inverse.
Affine transposed(const Affine& a) {
  return {{a.x.x, a.y.x, a.z.x}, {a.x.y, a.y.y, a.z.y}, {a.x.z, a.y.z, a.z.z}, {0, 0, 0}};
}

/// Sine and cosine of degrees, exact at multiples of 90.
std::array<Wide, 2> sine_cosine(double degrees) {
  int quarters = 0;
  const Wide rest = std::remquo(static_cast<Wide>(degrees), Wide{90}, &quarters);
  const Wide radians = rest * degree;
  const Wide sine = std::sin(radians), cosine = std::cos(radians);
  switch (quarters & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

Affine inverted(const Affine& a) {
  // Columns of length 1 neither overflow nor vanish.
  const Wide lengths[] = {length(a.x), length(a.y), length(a.z)};
  const Vec3<Wide> x = a.x / lengths[0], y = a.y / lengths[1], z = a.z / lengths[2];
  const Wide determinant = dot(x, cross(y, z));
  if (!(std::abs(determinant) > least_determinant))
    throw Error("a singular transform: it leaves no volume");
  const Vec3<Wide> rows[] = {cross(y, z) / (determinant * lengths[0]),
                             cross(z, x) / (determinant * lengths[1]),
                             cross(x, y) / (determinant * lengths[2])};
  const Affine linear = transposed({rows[0], rows[1], rows[2]});
  return {linear.x, linear.y, linear.z, -linear.vector(a.moved)};
}

bool are_of_one_length(Wide a, Wide b) { return std::abs(a - b) <= most_skew * std::max(a, b); }

[[noreturn]] void refuse_image(std::string_view shape, std::string_view why, const Affine& a) {
  throw Error(
      fmt::format("the image of this {0} is no {0}: {1} (its axes are scaled by {2:.6g}, "
                  "{3:.6g} and {4:.6g})",
                  shape, why, length(a.x), length(a.y), length(a.z)));
}

/// The mean length of the axes across, where circles across stay circles.
Wide scale_across(std::string_view shape, const Affine& a) {
  const Wide x = length(a.x), y = length(a.y);
  if (!are_of_one_length(x, y)) refuse_image(shape, "its circles become ellipses", a);
  if (!are_perpendicular(a.x, a.y)) refuse_image(shape, "the transform shears its circles", a);
  return (x + y) / 2;
}

double radius_of(Wide radius, std::string_view shape) {
  const double rounded = static_cast<double>(radius);
  if (!(rounded > 0)) throw Error(fmt::format("a {} whose radius in the world is 0", shape));
  if (!std::isfinite(rounded))
    throw Error(fmt::format("a {} whose radius in the world overflows a double", shape));
  return rounded;
}

Vec3<double> place_of(const Vec3<double>& point, const Affine& a, std::string_view shape) {
  const Vec3<Wide> image = a.point(in<Wide>(point));
  if (has_doubles(image)) return nearest_doubles(image);
  throw Error(fmt::format("a {} whose place in the world overflows a double", shape));
}

/// What images of each shape are.
struct Image {
  const Affine& a;

  Shape operator()(const Sphere<double>& sphere) const {
    const Wide across = scale_across("sphere", a);
    if (!are_of_one_length(across, length(a.z))) refuse_image("sphere", "it is stretched", a);
    if (!are_perpendicular(a.x, a.z) || !are_perpendicular(a.y, a.z))
      refuse_image("sphere", "the transform shears it", a);
    return Sphere<double>{place_of(sphere.centre, a, "sphere"),
                          radius_of(across * Wide{sphere.radius}, "sphere")};
  }

  Shape operator()(const Disk<double>& disk) const {
    const Wide across = scale_across("disk", a);
    Vec3<Wide> normal = cross(a.x / length(a.x), a.y / length(a.y));
    if (dot(normal, a.z) < 0) normal = -normal;
    return Disk<double>{place_of(disk.centre, a, "disk"), nearest_doubles(normal / length(normal)),
                        radius_of(across * Wide{disk.radius}, "disk")};
  }

  template <template <class> class S>
  Shape operator()(const S<double>& shape) const {
    return upright(shape, std::get<1>(shape.parts()));
  }

  /// Between two ends on the axis.
  template <template <class> class S>
  Shape upright(const S<double>& shape, const Vec3<double>& top) const {
    const Wide across = scale_across(shape.name, a);
    if (!are_perpendicular(a.x, a.z) || !are_perpendicular(a.y, a.z))
      refuse_image(shape.name, "its axis leans", a);
    const S<double> world = {place_of(shape.base, a, shape.name), place_of(top, a, shape.name),
                             radius_of(across * Wide{shape.radius}, shape.name)};
    if (std::get<0>(world.parts()) == std::get<1>(world.parts()))
      throw Error(fmt::format("a {} whose ends are one point in the world", shape.name));
    return world;
  }
};

}  // namespace

Affine Affine::after(const Affine& inner) const {
  return {vector(inner.x), vector(inner.y), vector(inner.z), point(inner.moved)};
}

Transform Transform::after(const Transform& inner) const {
  return with_doubles({to.after(inner.to), inner.from.after(from)});
}

Transform translate(const Vec3<double>& by) {
  Transform transform;
  transform.to.moved = in<Wide>(by);
  transform.from.moved = in<Wide>(-by);
  return transform;
}

Transform scale(const Vec3<double>& by) {
  if (by.x == 0 || by.y == 0 || by.z == 0)
    throw Error("a singular transform: Scale by 0 leaves no volume");
  const Vec3<Wide> to = in<Wide>(by);
  return with_doubles({{{to.x, 0, 0}, {0, to.y, 0}, {0, 0, to.z}},
                       {{1 / to.x, 0, 0}, {0, 1 / to.y, 0}, {0, 0, 1 / to.z}}});
}

Transform rotate(double degrees, const Vec3<double>& axis) {
  const Wide size = length(in<Wide>(axis));
  if (size == 0) throw Error("Rotate about an axis of length 0");
  const Vec3<Wide> n = in<Wide>(axis) / size;
  const auto [sine, cosine] = sine_cosine(degrees);
  const Wide rest = 1 - cosine;
  const Affine to = {
      {n.x * n.x * rest + cosine, n.x * n.y * rest + n.z * sine, n.x * n.z * rest - n.y * sine},
      {n.x * n.y * rest - n.z * sine, n.y * n.y * rest + cosine, n.y * n.z * rest + n.x * sine},
      {n.x * n.z * rest + n.y * sine, n.y * n.z * rest - n.x * sine, n.z * n.z * rest + cosine}};
  return {to, transposed(to)};
}

Transform look_at(const Vec3<double>& eye, const Vec3<double>& at, const Vec3<double>& up) {
  if (eye == at) throw Error("LookAt from a point to the same point");
  const Wide up_length = length(in<Wide>(up));
  if (up_length == 0) throw Error("LookAt with an up vector of length 0");
  const Vec3<Wide> towards = in<Wide>(at) - in<Wide>(eye);
  const Vec3<Wide> forward = towards / length(towards);
  const Vec3<Wide> across = cross(in<Wide>(up) / up_length, forward);
  if (!(length(across) > least_determinant))
    throw Error("LookAt with an up vector along the direction of view");
  const Vec3<Wide> right = across / length(across);
  const Affine from = {right, cross(forward, right), forward, in<Wide>(eye)};
  Affine to = transposed(from);
  to.moved = -to.vector(from.moved);
  return with_doubles({to, from});
}

Transform matrix(std::span<const double> columns) {
  if (columns[3] != 0 || columns[7] != 0 || columns[11] != 0 || columns[15] != 1)
    throw Error(
        "a matrix with perspective: its last row (numbers 4, 8, 12 and 16) must be 0 0 0 1");
  const auto column = [&](std::size_t i) {
    return Vec3<Wide>{columns[i], columns[i + 1], columns[i + 2]};
  };
  const Affine to = {column(0), column(4), column(8), column(12)};
  return with_doubles({to, inverted(to)});
}

Wide length(const Vec3<Wide>& v) { return std::hypot(v.x, v.y, v.z); }

Shape image(const Shape& shape, const Affine& transform) {
  return std::visit(Image{transform}, shape);
}

bool are_perpendicular(const Vec3<Wide>& a, const Vec3<Wide>& b) {
  return std::abs(dot(a / length(a), b / length(b))) <= most_skew;
}

Vec3<double> nearest_doubles(const Vec3<Wide>& v) {
  const auto nearest = [](Wide x) { return static_cast<double>(x + 0); };  // no -0
  return {nearest(v.x), nearest(v.y), nearest(v.z)};
}

}  // namespace rayaudit
