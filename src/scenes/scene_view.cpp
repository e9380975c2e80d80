#include "scenes/scene_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

/// In the units of pbrt: the shorter axis goes from -1 to 1.
std::array<double, 4> window_of(const SceneView& view, const Film& film) {
  if (view.window) return *view.window;
  const double aspect = view.aspect.value_or(film.width / static_cast<double>(film.height));
  const double x = std::max(aspect, 1.0), y = std::max(1 / aspect, 1.0);
  return {-x, x, -y, y};
}

double read_degrees(Parameters& parameters) {
  const double half = parameters.number("halffov", 45);
  const std::string_view name = parameters.has("halffov") ? "halffov" : "fov";
  const double degrees = name == "fov" ? parameters.number("fov", 90) : 2 * half;
  if (!(degrees > 0 && degrees < 180))
    parameters.refuse(
        name,
        fmt::format("a field of view of {:g} degrees: it must be between 0 and 180", degrees));
  return degrees;
}

std::optional<std::array<double, 4>> read_window(Parameters& parameters) {
  const std::vector<double> n = parameters.numbers("screenwindow", 4);
  if (n.empty()) return std::nullopt;
  if (!(n[0] < n[1] && n[2] < n[3]))
    parameters.refuse("screenwindow", "a screenwindow is least x, most x, least y, most y");
  return std::array{n[0], n[1], n[2], n[3]};
}

}  // namespace

SceneView read_view(const Token& directive, const Token& name, Parameters& parameters,
                    const Affine& to_world) {
  constexpr std::array<std::string_view, 2> known = {"perspective", "orthographic"};
  SceneView view;
  if (name.text == known[1]) {
    view.projection = Projection::orthographic;
  } else if (name.text != known[0]) {
    refuse(name, unknown_name("camera", name.text.substr(0, 100), known));
  }
  view.to_world = to_world;
  view.place = directive.place();
  if (view.projection == Projection::perspective) view.degrees = read_degrees(parameters);
  const double aspect = parameters.number("frameaspectratio", 1);
  if (!(aspect > 0)) parameters.refuse("frameaspectratio", "frameaspectratio must be above 0");
  if (parameters.has("frameaspectratio")) view.aspect = aspect;
  view.window = read_window(parameters);
  parameters.ignore({"shutteropen", "shutterclose"});
  parameters.finish();
  return view;
}

Camera camera(const SceneView& view, const Film& film) {
  const auto [left, right, bottom, top] = window_of(view, film);
  const Affine& a = view.to_world;
  if (!are_perpendicular(a.x, a.y) || !are_perpendicular(a.y, a.z) || !are_perpendicular(a.z, a.x))
    throw SceneError(view.place, "the camera's transform shears the picture");
  Camera camera = {.projection = view.projection};
  const Wide x = length(a.x), y = length(a.y), z = length(a.z);
  camera.right = nearest_doubles(a.x / x);
  camera.up = nearest_doubles(a.y / y);
  camera.forward = nearest_doubles(a.z / z);
  Wide half_width = x * (Wide{right} - left) / 2, half_height = y * (Wide{top} - bottom) / 2;
  Vec3<Wide> eye = a.moved;
  if (view.projection == Projection::perspective) {
    if (left != -right || bottom != -top)
      throw SceneError(view.place,
                       "a perspective screenwindow that is not symmetrical is not supported");
    const Wide slope = std::tan(Wide{view.degrees} / 2 * degree);
    half_width *= slope / z;
    half_height *= slope / z;
  } else {
    eye = a.point({(Wide{left} + right) / 2, (Wide{bottom} + top) / 2, 0});
  }
  camera.eye = nearest_doubles(eye);
  camera.half_width = static_cast<double>(half_width);
  camera.half_height = static_cast<double>(half_height);
  for (const double number : {camera.half_width, camera.half_height, 1 + std::abs(camera.eye.x),
                              1 + std::abs(camera.eye.y), 1 + std::abs(camera.eye.z)})
    if (!(number > 0 && std::isfinite(number)))
      throw SceneError(view.place,
                       "a camera whose place or window has no finite size in the world");
  return camera;
}

Film read_film(const Token& name, Parameters& parameters) {
  constexpr std::array<std::string_view, 4> known = {"image", "rgb", "gbuffer", "spectral"};
  if (std::find(known.begin(), known.end(), name.text) == known.end())
    refuse(name, unknown_name("film", name.text.substr(0, 100), known));
  const bool is_third = name.text == "image";  // version 3 and 4 differ in what is not said
  Film film = {is_third ? 640 : 1280, is_third ? 480 : 720};
  film.width = static_cast<int>(parameters.whole("xresolution", film.width, 1, most_pixels));
  film.height = static_cast<int>(parameters.whole("yresolution", film.height, 1, most_pixels));
  if (std::int64_t{film.width} * film.height > most_pixels)
    parameters.refuse("xresolution", fmt::format("a film of {} x {} pixels, more than {} in all",
                                                 film.width, film.height, most_pixels));
  parameters.ignore({"filename", "diagonal", "scale", "maxsampleluminance", "sensor", "iso",
                     "exposuretime", "maxcomponentvalue", "savefp16", "whitebalance"});
  parameters.finish();
  return film;
}

}  // namespace rayaudit
