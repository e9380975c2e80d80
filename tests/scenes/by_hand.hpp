#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "scenes/tracer.hpp"

/// Scenes put together by hand.
namespace rayaudit::by_hand {

inline Primitive matte(const Shape& shape, const Colour& reflected = {1, 1, 1}) {
  return {shape, {Finish::matte, reflected}};
}
inline Primitive mirror(const Shape& shape) { return {shape, {Finish::mirror, {1, 1, 1}}}; }
inline Primitive glass(const Shape& shape, double index = 1.5) {
  return {shape, {Finish::dielectric, {1, 1, 1}, {1, 1, 1}, index}};
}
inline Primitive glowing(const Sphere<double>& sphere, const Colour& emitted) {
  return {sphere, {Finish::matte, {0, 0, 0}}, emitted};
}

inline Light point_light(const Vec3<double>& where, const Colour& colour) {
  return {Light::Kind::point, where, colour};
}

/// Looks from z = -10 along z; a pixel is 1 x 1, x grows to the right and y upward.
inline Scene seen_straight(int width, int height, std::vector<Primitive> primitives) {
  Scene scene = {.name = "by hand", .film = {width, height}, .primitives = std::move(primitives)};
  scene.camera.projection = Projection::orthographic;
  scene.camera.eye = {0, 0, -10};
  scene.camera.half_width = width / 2.0, scene.camera.half_height = height / 2.0;
  return scene;
}

/// A sphere, a disk, a cylinder and a cone in one point light, all of them matte.
inline Scene plain(int width, int height) {
  Scene scene = {.name = "plain", .film = {width, height}};
  scene.camera = {.eye = {0, 1.5, -8}, .half_width = 0.6, .half_height = 0.45};
  scene.primitives = {matte(Disk<double>{{0, 0, 0}, {0, 1, 0}, 20}),
                      matte(Sphere<double>{{-1.5, 1, 0}, 1}, {0.75, 0.5, 0.5}),
                      matte(Cylinder<double>{{0.5, 0, 1}, {0.5, 2, 1}, 0.5}, {0.5, 0.75, 0.5}),
                      matte(Cone<double>{{2, 0, -0.5}, {2, 1.5, -0.5}, 0.75}, {0.5, 0.5, 0.75})};
  scene.lights = {point_light({4, 8, -6}, {400, 400, 400})};
  return scene;
}

inline const Subject& subject(std::string_view name) {
  return *std::find_if(built_in_subjects().begin(), built_in_subjects().end(),
                       [&](const Subject& any) { return any.name == name; });
}

/// The closest approach, and for disks division_free, which it does not answer.
inline const Subject& sound(const Format& format) {
  const auto made = [](const std::string& number) {
    Subject both = subject("closest_approach/" + number);
    const Subject& disks = subject("division_free/" + number);
    both.name = "sound/" + number;
    both.answer[0] = disks.answer[0], both.prove[0] = disks.prove[0];
    return both;
  };
  static const Subject in_float = made("float"), in_double = made("double"),
                       in_long_double = made("long_double");
  return format == float_format ? in_float : format == double_format ? in_double : in_long_double;
}

inline std::vector<Colour> picture(const Tracing& tracing, const Observe& observe = {}) {
  const Film& film = tracing.scene.film;
  std::vector<Colour> pixels(static_cast<std::size_t>(film.width) *
                             static_cast<std::size_t>(film.height));
  Tracer(tracing).rows(0, film.height, pixels, observe);
  return pixels;
}

}  // namespace rayaudit::by_hand
