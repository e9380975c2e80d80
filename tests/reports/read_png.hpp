#pragma once

#include <png.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "reports/png_file.hpp"

namespace rayaudit {

/// A picture as libpng reads it from a file, whole.
struct ReadPng {
  int width = 0, height = 0;
  std::vector<PngFile::Pixel> pixels = {};

  const PngFile::Pixel& at(int column, int row) const {
    return pixels.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(column));
  }
};

inline ReadPng read_png(const std::filesystem::path& path) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0)
    throw std::runtime_error(path.string() + ": " + static_cast<const char*>(image.message));
  if ((image.format &
       (PNG_FORMAT_FLAG_COLORMAP | PNG_FORMAT_FLAG_LINEAR | PNG_FORMAT_FLAG_ALPHA)) != 0)
    throw std::runtime_error(path.string() + ": not 8 bits of red, green and blue");
  image.format = PNG_FORMAT_RGB;
  ReadPng read = {static_cast<int>(image.width), static_cast<int>(image.height)};
  read.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  if (png_image_finish_read(&image, nullptr, read.pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(path.string() + ": " + static_cast<const char*>(image.message));
  return read;
}

}  // namespace rayaudit
