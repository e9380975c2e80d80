#pragma once

#include <filesystem>
#include <string>

namespace rayaudit {

/// A folder for pictures: the one that is named, made where there is none; or, where none is, one
/// that is gone with its files at the end.
class PictureFolder {
 public:
  /// Throws Error where it cannot be made.
  explicit PictureFolder(const std::string& named);
  ~PictureFolder();
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool goes_;
};

}  // namespace rayaudit
