#pragma once

#include <filesystem>
#include <string_view>

#include "geometry/error.hpp"
#include "scenes/scene.hpp"

namespace rayaudit {

/// What is wrong with a scene file: `planet.pbrt:12:5: a sphere of radius 0`.
struct SceneError : Error {
  SceneError(Place where, const std::string& what)
      : Error(told(where) + ": " + what), place(std::move(where)) {}
  Place place;
};

enum class Strictness : std::uint8_t {
  lenient,  ///< what is not supported is named in Scene::skipped, and skipped
  strict,   ///< and here refused
};

/// Reads a scene in the format of pbrt (version 3's words, and those of version 4 that mean the
/// same: Physically Based Rendering, 3rd ed., and the file format's documentation); the subset is
/// told in data/scenes/README.md. Numbers may be hex floats, too. Includes are looked for beside
/// the file that has them, then beside the first. Throws SceneError.
Scene read_scene(const std::filesystem::path& file, Strictness strictness = Strictness::lenient);

/// The same of a text; Includes are looked for in the folder, nowhere where that is empty.
Scene read_scene_text(std::string_view text, const std::string& name,
                      const std::filesystem::path& folder,
                      Strictness strictness = Strictness::lenient);

}  // namespace rayaudit
