#include "scenes/scene_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

constexpr std::array<std::string_view, 9> other_shapes = {
    "trianglemesh", "plymesh",     "bilinearmesh", "loopsubdiv", "curve",
    "nurbs",        "heightfield", "hyperboloid",  "paraboloid"};

constexpr std::array<std::string_view, 4> mirrors = {"mirror", "conductor", "metal", "shinymetal"};
constexpr std::array<std::string_view, 2> glasses = {"glass", "dielectric"};
constexpr std::array<std::string_view, 2> mattes = {"matte", "diffuse"};
constexpr std::array<std::string_view, 19> other_materials = {"plastic",
                                                              "uber",
                                                              "substrate",
                                                              "translucent",
                                                              "disney",
                                                              "hair",
                                                              "mix",
                                                              "fourier",
                                                              "measured",
                                                              "subsurface",
                                                              "kdsubsurface",
                                                              "interface",
                                                              "none",
                                                              "",
                                                              "coateddiffuse",
                                                              "coatedconductor",
                                                              "thindielectric",
                                                              "diffusetransmission",
                                                              "debug"};

constexpr std::array<std::string_view, 2> lights = {"point", "distant"};
constexpr std::array<std::string_view, 6> other_lights = {"infinite",   "exinfinite",  "spot",
                                                          "projection", "goniometric", "area"};

template <class List>
bool is_in(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Throws SceneError for a name that is in no list.
template <class... Lists>
[[noreturn]] void refuse_name(const Token& name, std::string_view what, const Lists&... lists) {
  std::vector<std::string_view> known;
  (known.insert(known.end(), lists.begin(), lists.end()), ...);
  refuse(name, unknown_name(what, name.text.substr(0, 100), known));
}

double above_zero(Parameters& parameters, std::string_view name, double fallback) {
  const double number = parameters.number(name, fallback);
  if (!(number > 0))
    parameters.refuse(name, fmt::format("{} must be above 0, got {:g}", quotation(name), number));
  return number;
}

void require_full_sweep(Parameters& parameters) {
  const double sweep = parameters.number("phimax", 360);
  if (!(sweep >= 360))
    parameters.refuse("phimax", fmt::format("a partial sweep of {:g} degrees is not supported, "
                                            "360 is",
                                            sweep));
}

Shape read_sphere(Parameters& parameters) {
  const double radius = above_zero(parameters, "radius", 1);
  for (const auto& [name, full] : {std::pair{"zmin", -radius}, std::pair{"zmax", radius}}) {
    const double z = parameters.number(name, full);
    if (full < 0 ? z > full : z < full)
      parameters.refuse(name, fmt::format("a sphere cut at z = {:g} is not supported", z));
  }
  return Sphere<double>{{0, 0, 0}, radius};
}

Shape read_disk(Parameters& parameters) {
  const double inner = parameters.number("innerradius", 0);
  if (inner != 0) parameters.refuse("innerradius", "a disk with a hole is not supported");
  const double height = parameters.number("height", 0);
  return Disk<double>{{0, 0, height}, {0, 0, 1}, above_zero(parameters, "radius", 1)};
}

Shape read_cylinder(Parameters& parameters) {
  const double a = parameters.number("zmin", -1), b = parameters.number("zmax", 1);
  if (a == b)
    parameters.refuse(parameters.has("zmax") ? "zmax" : "zmin",
                      "a cylinder of no height: zmin is zmax");
  return Cylinder<double>{
      {0, 0, std::min(a, b)}, {0, 0, std::max(a, b)}, above_zero(parameters, "radius", 1)};
}

Shape read_cone(Parameters& parameters) {
  const double height = above_zero(parameters, "height", 1);
  return Cone<double>{{0, 0, 0}, {0, 0, height}, above_zero(parameters, "radius", 1)};
}

/// What all lights are brighter by.
Colour scaled(Parameters& parameters, std::string_view name) {
  const Colour colour = parameters.colour(name, {1, 1, 1});
  const Colour scale = parameters.colour("scale", {1, 1, 1});
  const Colour bright = {colour.x * scale.x, colour.y * scale.y, colour.z * scale.z};
  if (!std::isfinite(bright.x) || !std::isfinite(bright.y) || !std::isfinite(bright.z))
    parameters.refuse(name, quotation(name) + " times its scale overflows a double");
  return bright;
}

Vec3<double> in_world(const Vec3<Wide>& point, const Parameters& parameters,
                      std::string_view name) {
  const Vec3<double> world = nearest_doubles(point);
  if (!std::isfinite(world.x) || !std::isfinite(world.y) || !std::isfinite(world.z))
    parameters.refuse(name, "its place in the world overflows a double");
  return world;
}

Light read_point(Parameters& parameters, const Affine& transform) {
  const Vec3<double> from = parameters.vector("from", {0, 0, 0});
  return {Light::Kind::point, in_world(transform.point(in<Wide>(from)), parameters, "from"),
          scaled(parameters, "I")};
}

Light read_distant(Parameters& parameters, const Affine& transform) {
  const Vec3<Wide> from = in<Wide>(parameters.vector("from", {0, 0, 0}));
  const Vec3<Wide> to = in<Wide>(parameters.vector("to", {0, 0, 1}));
  if (from == to) parameters.refuse("to", "a distant light from a point to the same point");
  const Vec3<Wide> towards = transform.vector(from - to);
  return {Light::Kind::distant, in_world(towards / length(towards), parameters, "from"),
          scaled(parameters, "L")};
}

Material read_mirror(std::string_view name, Parameters& parameters) {
  Material material = {.finish = Finish::mirror};
  const std::string_view reflected =
      name == "mirror" || !parameters.has("reflectance") ? "Kr" : "reflectance";
  material.reflected = parameters.reflectance(reflected, {0.9, 0.9, 0.9});
  return material;
}

Material read_glass(Parameters& parameters) {
  Material material = {.finish = Finish::dielectric};
  material.reflected = parameters.reflectance("Kr", {1, 1, 1});
  material.refracted = parameters.reflectance("Kt", {1, 1, 1});
  const std::string_view index = parameters.has("eta") ? "eta" : "index";
  material.index = above_zero(parameters, index, 1.5);
  return material;
}

Material read_matte(Parameters& parameters) {
  const std::string_view reflected = parameters.has("Kd") ? "Kd" : "reflectance";
  return {.finish = Finish::matte, .reflected = parameters.reflectance(reflected, {0.5, 0.5, 0.5})};
}

}  // namespace

std::optional<Shape> read_shape(const Token& name, Parameters& parameters) {
  if (is_in(other_shapes, name.text)) {
    parameters.notes().skip(name.place(), parameters.owner() + " is not supported and left out");
    return std::nullopt;
  }
  std::optional<Shape> shape;
  if (name.text == "sphere") shape = read_sphere(parameters);
  if (name.text == "disk") shape = read_disk(parameters);
  if (name.text == "cylinder") shape = read_cylinder(parameters);
  if (name.text == "cone") shape = read_cone(parameters);
  if (!shape) refuse_name(name, "shape", shape_names, other_shapes);
  require_full_sweep(parameters);
  parameters.finish();
  return shape;
}

Material read_material(const Token& directive, const Token& name, Parameters& parameters) {
  Material material;
  if (is_in(mattes, name.text)) {
    material = read_matte(parameters);
  } else if (is_in(mirrors, name.text)) {
    material = read_mirror(name.text, parameters);
  } else if (is_in(glasses, name.text)) {
    material = read_glass(parameters);
  } else if (is_in(other_materials, name.text)) {
    parameters.notes().skip(directive.place(),
                            parameters.owner() + " is not supported, taken as matte");
    material.place = directive.place();
    return material;
  } else {
    refuse_name(name, "material", mattes, mirrors, glasses, other_materials);
  }
  material.place = directive.place();
  parameters.finish();
  return material;
}

std::optional<Light> read_light(const Token& name, Parameters& parameters,
                                const Affine& transform) {
  if (is_in(other_lights, name.text)) {
    parameters.notes().skip(name.place(), parameters.owner() + " is not supported and left out");
    return std::nullopt;
  }
  if (!is_in(lights, name.text)) refuse_name(name, "light", lights, other_lights);
  const Light light = name.text == "point" ? read_point(parameters, transform)
                                           : read_distant(parameters, transform);
  parameters.finish();
  return light;
}

std::optional<Colour> read_area_light(const Token& name, Parameters& parameters) {
  if (name.text != "diffuse" && name.text != "area")
    refuse_name(name, "area light", std::array<std::string_view, 2>{"diffuse", "area"});
  const Colour emitted = scaled(parameters, "L");
  parameters.ignore({"samples", "nsamples"});
  parameters.finish();
  return emitted;
}

}  // namespace rayaudit
