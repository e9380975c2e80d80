#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "geometry/case.hpp"
#include "geometry/format.hpp"
#include "scenes/place.hpp"

namespace rayaudit {

/// Linear red, green and blue.
using Colour = Vec3<double>;

enum class Projection : std::uint8_t { perspective, orthographic };

/// A camera in the world. The axes have length 1 but for rounding. A picture's left upper corner
/// is at -half_width, +half_height of the window, which lies at distance 1 of a perspective camera
/// and goes through the eye of an orthographic one.
struct Camera {
  Projection projection = Projection::perspective;
  Vec3<double> eye = {0, 0, 0};
  Vec3<double> right = {1, 0, 0}, up = {0, 1, 0}, forward = {0, 0, 1};
  double half_width = 1, half_height = 1;
};

struct Film {
  int width = 640, height = 480;
};
inline constexpr std::int64_t most_pixels = 100'000'000;

/// What a surface does with light.
enum class Finish : std::uint8_t {
  matte,       ///< scatters it: seen by the light that falls on it
  mirror,      ///< reflects it
  dielectric,  ///< reflects and refracts it
};

struct Material {
  Finish finish = Finish::matte;
  Colour reflected = {0.5, 0.5, 0.5};  ///< of the light that falls on it
  Colour refracted = {1, 1, 1};        ///< of a dielectric
  double index = 1.5;                  ///< of refraction, of a dielectric: inside over outside
  Place place = {};                    ///< what gave it to the shape
};

/// A shape as it stands in the world, rounded to doubles, and what it is made of.
struct Primitive {
  Shape shape;
  Material material = {};
  std::optional<Colour> emitted = {};  ///< of a sphere that is a light
  Place place = {};
};

struct Light {
  enum class Kind : std::uint8_t {
    point,    ///< at `where`, as bright as colour / distance^2
    distant,  ///< from the direction `where`, of length 1; as bright as colour everywhere
    sphere,   ///< the primitive that emits colour
  };
  Kind kind = Kind::point;
  Vec3<double> where = {0, 0, 0};
  Colour colour = {1, 1, 1};
  std::size_t primitive = 0;
  Place place = {};
};

/// Something in a scene file that rayaudit has no use for, and what is done instead.
struct Skipped {
  Place place;
  std::string what;  ///< a sentence without its full stop
};

/// Two surfaces that together leave no gap: a disk whose rim is an end of a cylinder or cone.
struct Seam {
  std::size_t disk, wall;
};

struct Scene {
  std::string name;  ///< of its file
  Camera camera = {};
  Film film = {};
  std::vector<Primitive> primitives = {};
  std::vector<Light> lights = {};
  std::vector<Seam> seams = {};
  int bounces = 5;  ///< at most so many reflections and refractions one after another
  int samples = 1;  ///< rays through a pixel
  std::vector<Skipped> skipped = {};
};

/// A scene whose every shape has numbers of a format.
struct Rounded {
  Scene scene;
  /// The most that the rounding of a number moved it, as a share of the largest component of its
  /// vector, and the shape that it happened to.
  double most_moved = 0;
  std::size_t primitive = 0;
};
Rounded rounded(Scene scene, const Format& format);

/// The seams of primitives, up to 2^-16 of their size.
std::vector<Seam> seams(const std::vector<Primitive>& primitives);

}  // namespace rayaudit
