#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scenes/scene_tokens.hpp"

namespace rayaudit {

/// The files that a scene is read from: one, and those that it includes. Neither too many nor too
/// much, and none within itself.
class SceneFiles {
 public:
  static constexpr std::size_t most_deep = 32, most_files = 10'000;
  static constexpr std::uintmax_t most_bytes = std::uintmax_t{64} << 20;

  /// A text without a file; Includes are looked for in the folder, nowhere where it is empty.
  explicit SceneFiles(std::filesystem::path folder) : folders_{std::move(folder)} {}

  struct Text {
    std::string name, text;
  };
  /// Opens what an Include names, beside the file that has it or beside the first; to be closed
  /// after. Throws SceneError.
  Text open(const Token& name);
  void close();
  /// Counts text that is not from a file; throws SceneError where it is too much.
  void count(std::uintmax_t bytes, const Place& place);
  /// Reads the first file.
  Text open_first(const std::filesystem::path& file);

 private:
  std::filesystem::path found(const Token& name) const;
  std::string read(const std::filesystem::path& file, const Place& place);

  std::vector<std::filesystem::path> folders_, open_;
  std::uintmax_t bytes_ = 0;
  std::size_t files_ = 0;
};

}  // namespace rayaudit
