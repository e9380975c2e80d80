#include "scenes/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"
#include "scenes/scene_files.hpp"
#include "scenes/scene_surfaces.hpp"
#include "scenes/scene_view.hpp"

namespace rayaudit {
namespace {

constexpr std::size_t most_primitives = 1'000'000, most_lights = 1'000'000, most_names = 100'000,
                      most_nested = 1000;
constexpr int most_samples = 65'536, most_bounces = 1000;

/// What AttributeBegin keeps and AttributeEnd brings back.
struct Attributes {
  Transform transform = {};
  Material material = {};
  std::optional<Colour> emitted = {};
  Place light_place = {};
  bool is_at_end = false;  ///< ActiveTransform EndTime: of motion rayaudit sees the begin
};

enum class Block { attribute, transform, object };
constexpr std::array<std::string_view, 3> begins = {"AttributeBegin", "TransformBegin",
                                                    "ObjectBegin"};

struct Opened {
  Block block;
  Attributes before;
  Place place;
};

/// A shape that stands where `transform` brings it.
struct Standing {
  Shape shape;
  Affine transform;
  Material material;
  std::optional<Colour> emitted;
  Place place, light_place;
};

template <class Named>
std::vector<std::string_view> names_of(const std::map<std::string, Named, std::less<>>& named) {
  std::vector<std::string_view> names;
  for (const auto& [name, meaning] : named) {
    if (names.size() == 1000) break;
    names.emplace_back(name);
  }
  return names;
}

/// Throws SceneError where the name is not there.
template <class Named>
const Named& find(const std::map<std::string, Named, std::less<>>& named, const Token& name,
                  std::string_view what) {
  const auto known = named.find(name.text);
  if (known != named.end()) return known->second;
  if (named.empty()) refuse(name, fmt::format("{} {} is not known", what, quotation(name.text)));
  refuse(name, unknown_name(what, name.text.substr(0, 100), names_of(named)));
}

/// Reads the directives of a scene, one after another.
class Reader {
 public:
  Reader(std::filesystem::path folder, Strictness strictness)
      : files_(std::move(folder)), notes_(strictness) {}

  Scene file(const std::filesystem::path& path) {
    const SceneFiles::Text first = files_.open_first(path);
    return scene(first.text, first.name);
  }
  Scene text(std::string_view text, const std::string& name) {
    files_.count(text.size(), {name, 1, 1});
    return scene(text, name);
  }

 private:
  enum class When { always, before_world, in_world };
  struct Directive {
    std::string_view name;
    When when;
    void (Reader::*read)(const Token& directive);
  };
  static const std::array<Directive, 34> directives;
  static const std::array<std::string_view, 19> unsupported;

  Scene scene(std::string_view text, const std::string& name);
  void read(Tokens& tokens);
  void read_directive();
  void require_place(const Directive& directive, const Token& token) const;
  [[noreturn]] void refuse_directive(const Token& token) const;
  void end(const Token& end);

  Token name(const Token& directive, std::string_view what) {
    return tokens_->string(directive.text, what);
  }
  Parameters parameters(const Token& directive, const Token& name) {
    return {*tokens_, fmt::format("{} \"{}\"", directive.text, name.text.substr(0, 60)), notes_};
  }
  Vec3<double> vector(const Token& directive) {
    const std::vector<double> n = tokens_->numbers(directive.text, 3);
    return {n[0], n[1], n[2]};
  }

  template <class Make>
  void transform(const Token& directive, const Make& make);
  template <class Named>
  void keep(std::map<std::string, Named, std::less<>>& named, const Token& name, Named meaning);
  void open(Block block, const Token& directive);
  void close(Block block, const Token& directive);
  void place(const Standing& standing, const Affine& transform, const Token& where);

  void world_begin(const Token& directive);
  void world_end(const Token& /*directive*/) { is_over_ = true; }
  void camera(const Token& directive);
  void film(const Token& directive);
  void sampler(const Token& directive);
  void integrator(const Token& directive);
  void no_account(const Token& /*directive*/) { tokens_->skip_arguments(); }

  void identity(const Token& directive);
  void translate(const Token& directive);
  void scale(const Token& directive);
  void rotate(const Token& directive);
  void look_at(const Token& directive);
  void matrix(const Token& directive);
  void concatenated_matrix(const Token& directive);
  void coordinate_system(const Token& directive);
  void coord_sys_transform(const Token& directive);
  void active_transform(const Token& directive);

  void attribute_begin(const Token& directive) { open(Block::attribute, directive); }
  void attribute_end(const Token& directive) { close(Block::attribute, directive); }
  void transform_begin(const Token& directive) { open(Block::transform, directive); }
  void transform_end(const Token& directive) { close(Block::transform, directive); }
  void object_begin(const Token& directive);
  void object_end(const Token& directive);
  void object_instance(const Token& directive);

  void shape(const Token& directive);
  void material(const Token& directive);
  void make_named_material(const Token& directive);
  void named_material(const Token& directive);
  void light_source(const Token& directive);
  void area_light_source(const Token& directive);
  void include(const Token& directive);

  SceneFiles files_;
  SceneNotes notes_;
  Scene scene_;
  Tokens* tokens_ = nullptr;
  Attributes now_;
  std::vector<Opened> opened_;
  SceneView view_;
  std::map<std::string, Transform, std::less<>> spaces_;
  std::map<std::string, Material, std::less<>> materials_;
  std::map<std::string, std::vector<Standing>, std::less<>> objects_;
  std::vector<Standing>* object_ = nullptr;  ///< between ObjectBegin and ObjectEnd
  std::size_t standing_ = 0;                 ///< of all objects
  bool has_camera_ = false, is_in_world_ = false, is_over_ = false;
};

const std::array<Reader::Directive, 34> Reader::directives = {{
    {"Shape", When::in_world, &Reader::shape},
    {"AttributeBegin", When::always, &Reader::attribute_begin},
    {"AttributeEnd", When::always, &Reader::attribute_end},
    {"Translate", When::always, &Reader::translate},
    {"Scale", When::always, &Reader::scale},
    {"Rotate", When::always, &Reader::rotate},
    {"Transform", When::always, &Reader::matrix},
    {"ConcatTransform", When::always, &Reader::concatenated_matrix},
    {"Material", When::in_world, &Reader::material},
    {"NamedMaterial", When::in_world, &Reader::named_material},
    {"MakeNamedMaterial", When::in_world, &Reader::make_named_material},
    {"ObjectInstance", When::in_world, &Reader::object_instance},
    {"ObjectBegin", When::in_world, &Reader::object_begin},
    {"ObjectEnd", When::in_world, &Reader::object_end},
    {"TransformBegin", When::always, &Reader::transform_begin},
    {"TransformEnd", When::always, &Reader::transform_end},
    {"Identity", When::always, &Reader::identity},
    {"LookAt", When::always, &Reader::look_at},
    {"CoordinateSystem", When::always, &Reader::coordinate_system},
    {"CoordSysTransform", When::always, &Reader::coord_sys_transform},
    {"ActiveTransform", When::always, &Reader::active_transform},
    {"LightSource", When::in_world, &Reader::light_source},
    {"AreaLightSource", When::in_world, &Reader::area_light_source},
    {"Include", When::always, &Reader::include},
    {"WorldBegin", When::before_world, &Reader::world_begin},
    {"WorldEnd", When::in_world, &Reader::world_end},
    {"Camera", When::before_world, &Reader::camera},
    {"Film", When::before_world, &Reader::film},
    {"Sampler", When::before_world, &Reader::sampler},
    {"Integrator", When::before_world, &Reader::integrator},
    // How pbrt goes about it, and sides that rayaudit does not tell apart.
    {"Accelerator", When::before_world, &Reader::no_account},
    {"Option", When::before_world, &Reader::no_account},
    {"ReverseOrientation", When::always, &Reader::no_account},
    {"TransformTimes", When::before_world, &Reader::no_account},
}};

const std::array<std::string_view, 19> Reader::unsupported = {
    "Attribute",         "ColorSpace", "Import",          "MakeNamedMedium", "MediumInterface",
    "PixelFilter",       "Texture",    "Volume",          "VolumeRegion",    "VolumeIntegrator",
    "SurfaceIntegrator", "Renderer",   "SearchPath",      "Exterior",        "Interior",
    "ShapeAlias",        "Procedural", "ObjectReference", "MotionTransform"};

Scene Reader::scene(std::string_view text, const std::string& name) {
  scene_.name = std::filesystem::path(name).filename().string();
  Tokens tokens(text, name);
  read(tokens);
  end(tokens.peek());
  return std::move(scene_);
}

void Reader::read(Tokens& tokens) {
  Tokens* const outer = std::exchange(tokens_, &tokens);
  while (tokens.peek().kind != Token::Kind::end) read_directive();
  tokens_ = outer;
}

void Reader::read_directive() {
  const Token token = tokens_->next();
  if (token.kind != Token::Kind::word || is_value(token.text))
    refuse(token, "expected a directive, got " + told(token));
  for (const Directive& directive : directives)
    if (directive.name == token.text) {
      require_place(directive, token);
      return (this->*directive.read)(token);
    }
  for (const std::string_view name : unsupported)
    if (name == token.text) {
      notes_.skip(token.place(), std::string(name) + " is not supported and skipped");
      return tokens_->skip_arguments();
    }
  refuse_directive(token);
}

void Reader::refuse_directive(const Token& token) const {
  std::vector<std::string_view> known(unsupported.begin(), unsupported.end());
  for (const Directive& directive : directives) known.push_back(directive.name);
  refuse(token, unknown_name("directive", token.text.substr(0, 100), known));
}

void Reader::require_place(const Directive& directive, const Token& token) const {
  if (is_over_) refuse(token, fmt::format("{} after WorldEnd", directive.name));
  if (directive.when == When::in_world && !is_in_world_)
    refuse(token, fmt::format("{} before WorldBegin", directive.name));
  if (directive.when == When::before_world && is_in_world_)
    refuse(token, fmt::format("{} after WorldBegin", directive.name));
}

void Reader::end(const Token& end) {
  if (!is_in_world_) refuse(end, "a scene without WorldBegin");
  if (!opened_.empty()) {
    const Opened& last = opened_.back();
    throw SceneError(last.place, fmt::format("{} without its end",
                                             begins[static_cast<std::size_t>(last.block)]));
  }
  scene_.camera = rayaudit::camera(view_, scene_.film);
  scene_.seams = seams(scene_.primitives);
  scene_.skipped = notes_.told();
}

template <class Make>
void Reader::transform(const Token& directive, const Make& make) {
  try {
    const Transform made = make();
    if (!now_.is_at_end) now_.transform = made;
  } catch (const SceneError&) {
    throw;
  } catch (const Error& fault) {
    refuse(directive, fault.what());
  }
}

template <class Named>
void Reader::keep(std::map<std::string, Named, std::less<>>& named, const Token& name,
                  Named meaning) {
  named.insert_or_assign(std::string(name.text), std::move(meaning));
  if (named.size() > most_names) refuse(name, fmt::format("more than {} names", most_names));
}

void Reader::identity(const Token& directive) {
  transform(directive, [] { return Transform{}; });
}

void Reader::translate(const Token& directive) {
  const Vec3<double> by = vector(directive);
  transform(directive, [&] { return now_.transform.after(rayaudit::translate(by)); });
}

void Reader::scale(const Token& directive) {
  const Vec3<double> by = vector(directive);
  transform(directive, [&] { return now_.transform.after(rayaudit::scale(by)); });
}

void Reader::rotate(const Token& directive) {
  const std::vector<double> n = tokens_->numbers(directive.text, 4);
  transform(directive, [&] {
    return now_.transform.after(rayaudit::rotate(n[0], {n[1], n[2], n[3]}));
  });
}

void Reader::look_at(const Token& directive) {
  const std::vector<double> n = tokens_->numbers(directive.text, 9);
  transform(directive, [&] {
    return now_.transform.after(
        rayaudit::look_at({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}));
  });
}

void Reader::matrix(const Token& directive) {
  const std::vector<double> n = tokens_->numbers(directive.text, 16);
  transform(directive, [&] { return rayaudit::matrix(n); });
}

void Reader::concatenated_matrix(const Token& directive) {
  const std::vector<double> n = tokens_->numbers(directive.text, 16);
  transform(directive, [&] { return now_.transform.after(rayaudit::matrix(n)); });
}

void Reader::coordinate_system(const Token& directive) {
  keep(spaces_, name(directive, "its name"), now_.transform);
}

void Reader::coord_sys_transform(const Token& directive) {
  const Transform& space =
      find(spaces_, name(directive, "a coordinate system"), "coordinate system");
  transform(directive, [&] { return space; });
}

void Reader::active_transform(const Token& directive) {
  constexpr std::array<std::string_view, 3> known = {"All", "StartTime", "EndTime"};
  const Token time = tokens_->next();
  if (time.kind != Token::Kind::word ||
      std::find(known.begin(), known.end(), time.text) == known.end())
    refuse(time, "ActiveTransform: expected `All`, `StartTime` or `EndTime`, got " + told(time));
  now_.is_at_end = time.text == known[2];
  if (now_.is_at_end)
    notes_.skip(directive.place(), "transforms at EndTime are skipped: nothing moves here");
}

void Reader::open(Block block, const Token& directive) {
  if (opened_.size() == most_nested)
    refuse(directive, fmt::format("more than {} blocks within each other", most_nested));
  opened_.push_back({block, now_, directive.place()});
}

void Reader::close(Block block, const Token& directive) {
  if (opened_.empty()) refuse(directive, fmt::format("{} without its begin", directive.text));
  Opened& last = opened_.back();
  if (last.block != block)
    refuse(directive, fmt::format("{} where the {} of line {} is open", directive.text,
                                  begins[static_cast<std::size_t>(last.block)], last.place.line));
  if (block == Block::transform) {
    now_.transform = last.before.transform;
  } else {
    now_ = std::move(last.before);
  }
  opened_.pop_back();
}

void Reader::world_begin(const Token& directive) {
  if (!opened_.empty())
    refuse(directive, fmt::format("WorldBegin where the {} of line {} is open",
                                  begins[static_cast<std::size_t>(opened_.back().block)],
                                  opened_.back().place.line));
  is_in_world_ = true;
  now_ = {};
  spaces_["world"] = {};
  if (!has_camera_) {
    spaces_["camera"] = {};
    view_.place = directive.place();
  }
}

void Reader::camera(const Token& directive) {
  const Token kind = name(directive, "a camera");
  Parameters given = parameters(directive, kind);
  view_ = read_view(directive, kind, given, now_.transform.from);
  spaces_["camera"] = now_.transform.inverse();
  has_camera_ = true;
}

void Reader::film(const Token& directive) {
  const Token kind = name(directive, "a film");
  Parameters given = parameters(directive, kind);
  scene_.film = read_film(kind, given);
}

void Reader::sampler(const Token& directive) {
  Parameters given = parameters(directive, name(directive, "a sampler"));
  const std::int64_t x = given.whole("xsamples", 1, 1, most_samples);
  const std::int64_t y = given.whole("ysamples", 1, 1, most_samples);
  scene_.samples = static_cast<int>(
      given.whole("pixelsamples", std::min<std::int64_t>(x * y, most_samples), 1, most_samples));
}

void Reader::integrator(const Token& directive) {
  Parameters given = parameters(directive, name(directive, "an integrator"));
  scene_.bounces = static_cast<int>(given.whole("maxdepth", scene_.bounces, 0, most_bounces));
}

void Reader::place(const Standing& standing, const Affine& transform, const Token& where) {
  if (scene_.primitives.size() == most_primitives)
    refuse(where, fmt::format("more than {} shapes", most_primitives));
  Primitive primitive = {.shape = standing.shape,
                         .material = standing.material,
                         .emitted = standing.emitted,
                         .place = standing.place};
  try {
    primitive.shape = image(standing.shape, transform);
  } catch (const Error& fault) {
    refuse(where, fault.what());
  }
  if (standing.emitted) {
    if (scene_.lights.size() == most_lights)
      refuse(where, fmt::format("more than {} lights", most_lights));
    const Vec3<double> centre = std::get<Sphere<double>>(primitive.shape).centre;
    scene_.lights.push_back({Light::Kind::sphere, centre, *standing.emitted,
                             scene_.primitives.size(), standing.light_place});
  }
  scene_.primitives.push_back(std::move(primitive));
}

void Reader::shape(const Token& directive) {
  const Token kind = name(directive, "a shape");
  Parameters given = parameters(directive, kind);
  const std::optional<Shape> shape = read_shape(kind, given);
  if (!shape) return;
  Standing standing = {*shape,       now_.transform.to, now_.material,
                       now_.emitted, directive.place(), now_.light_place};
  if (standing.emitted && !std::holds_alternative<Sphere<double>>(*shape)) {
    notes_.skip(directive.place(),
                fmt::format("a {} that is a light is not supported: it is dark", kind.text));
    standing.emitted.reset();
  }
  if (object_ == nullptr) return place(standing, standing.transform, directive);
  if (standing_++ == most_primitives)
    refuse(directive, fmt::format("more than {} shapes in objects", most_primitives));
  object_->push_back(std::move(standing));
}

void Reader::object_begin(const Token& directive) {
  const Token called = name(directive, "its name");
  if (object_ != nullptr) refuse(directive, "an ObjectBegin within another");
  open(Block::object, directive);
  keep(objects_, called, std::vector<Standing>{});
  object_ = &objects_.find(called.text)->second;
}

void Reader::object_end(const Token& directive) {
  close(Block::object, directive);
  object_ = nullptr;
}

void Reader::object_instance(const Token& directive) {
  const Token called = name(directive, "an object");
  if (object_ != nullptr) refuse(directive, "an ObjectInstance within an ObjectBegin");
  for (const Standing& standing : find(objects_, called, "object"))
    place(standing, now_.transform.to.after(standing.transform), directive);
}

void Reader::material(const Token& directive) {
  const Token kind = name(directive, "a material");
  Parameters given = parameters(directive, kind);
  now_.material = read_material(directive, kind, given);
}

void Reader::make_named_material(const Token& directive) {
  const Token called = name(directive, "its name");
  Parameters given = parameters(directive, called);
  Token kind = called;
  if (!given.has("type")) refuse(called, R"(MakeNamedMaterial without its "string type")");
  kind.text = given.word("type", "");
  keep(materials_, called, read_material(directive, kind, given));
}

void Reader::named_material(const Token& directive) {
  now_.material = find(materials_, name(directive, "a material"), "material");
}

void Reader::light_source(const Token& directive) {
  const Token kind = name(directive, "a light");
  Parameters given = parameters(directive, kind);
  std::optional<Light> light = read_light(kind, given, now_.transform.to);
  if (!light) return;
  if (scene_.lights.size() == most_lights)
    refuse(directive, fmt::format("more than {} lights", most_lights));
  light->place = directive.place();
  scene_.lights.push_back(*std::move(light));
}

void Reader::area_light_source(const Token& directive) {
  const Token kind = name(directive, "an area light");
  Parameters given = parameters(directive, kind);
  now_.emitted = read_area_light(kind, given);
  now_.light_place = directive.place();
}

void Reader::include(const Token& directive) {
  const SceneFiles::Text included = files_.open(name(directive, "a file"));
  Tokens tokens(included.text, included.name);
  read(tokens);
  files_.close();
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, Strictness strictness) {
  return Reader({}, strictness).file(file);
}

Scene read_scene_text(std::string_view text, const std::string& name,
                      const std::filesystem::path& folder, Strictness strictness) {
  return Reader(folder, strictness).text(text, name);
}

}  // namespace rayaudit
