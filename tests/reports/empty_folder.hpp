#pragma once

#include <filesystem>

namespace rayaudit {

/// A folder of a test's own, gone with it.
struct EmptyFolder {
  std::filesystem::path path;

  explicit EmptyFolder(const char* name)
      : path(std::filesystem::temp_directory_path() / (std::string("rayaudit-") + name)) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directory(path);
  }
  ~EmptyFolder() { std::filesystem::remove_all(path); }
  EmptyFolder(const EmptyFolder&) = delete;
  EmptyFolder& operator=(const EmptyFolder&) = delete;
};

}  // namespace rayaudit
