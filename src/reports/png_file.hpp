#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace rayaudit {

/// A picture file that is written as it is made, row by row from the top, with libpng: 8 bits of
/// red, green and blue. Once begun it is a valid file whenever it is closed, also by its
/// destructor; rows that were not written are black. A file that stood there is replaced when the
/// first rows come, and left as it was where none do.
class PngFile {
 public:
  struct Pixel {
    std::uint8_t red, green, blue;
  };

  /// Throws Error where the file cannot be written.
  PngFile(const std::filesystem::path& path, int width, int height);
  ~PngFile();
  PngFile(PngFile&&) noexcept;

  /// Whole rows. Throws Error.
  void write(std::span<const Pixel> pixels);
  /// Ends the file, once; one without rows is black. Throws Error.
  void close();

 private:
  struct Open;
  std::unique_ptr<Open> open_;
};

}  // namespace rayaudit
