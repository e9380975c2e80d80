#include "reports/png_file.hpp"

#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "geometry/error.hpp"

namespace rayaudit {
namespace {

static_assert(sizeof(PngFile::Pixel) == 3);

/// Runs a call of libpng, which leaves it by a jump where it fails: then false. What the call
/// itself makes must need no destructor.
template <class Call>
bool succeeds(png_structp png, const Call& call) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  call();
  return true;
}

/// What libpng had to complain of; it has no other way to tell.
using Complaint = std::array<char, 128>;

[[noreturn]] void fail(png_structp png, png_const_charp why) {
  auto& complaint = *static_cast<Complaint*>(png_get_error_ptr(png));
  std::snprintf(complaint.data(), complaint.size(), "%s", why);
  png_longjmp(png, 1);
}

void pass_over(png_structp, png_const_charp) {}

}  // namespace

struct PngFile::Open {
  std::string path;
  int width, height;
  std::FILE* file = nullptr;
  bool is_new = false;
  png_structp png = nullptr;
  png_infop about = nullptr;
  int rows = 0;          ///< that are written
  bool is_over = false;  ///< ended, or failed
  Complaint complaint = {};

  Open(const std::filesystem::path& to, int columns, int lines);
  ~Open();
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;

  bool is_begun() const { return png != nullptr; }
  void begin();
  void write(std::span<const Pixel> pixels);
  void end();

 private:
  void write_rows(const Pixel* pixels, int count);
  void flush();
  [[noreturn]] void complain(int reason);
};

/// To append leaves what stands in a file as it is.
PngFile::Open::Open(const std::filesystem::path& to, int columns, int lines)
    : path(to.string()), width(columns), height(lines) {
  struct stat there;
  is_new = ::stat(path.c_str(), &there) != 0;
  file = std::fopen(path.c_str(), "ab");
  if (file == nullptr) complain(errno);
}

PngFile::Open::~Open() {
  try {
    if (is_begun() && !is_over) end();
  } catch (const Error&) {  // nobody asks any more
  }
  if (png != nullptr) png_destroy_write_struct(&png, &about);
  if (file != nullptr) std::fclose(file);
  if (rows == 0 && is_new) ::unlink(path.c_str());
}

void PngFile::Open::complain(int reason) {
  is_over = true;
  const std::string why = reason != 0 ? std::strerror(reason) : complaint.data();
  throw Error("picture `" + path + "` cannot be written: " + why);
}

void PngFile::Open::begin() {
  png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint, fail, pass_over);
  if (png == nullptr) throw std::bad_alloc();
  errno = 0;
  // What is no file of bytes has no length to cut.
  if (::ftruncate(::fileno(file), 0) != 0 && errno != EINVAL) complain(errno);
  errno = 0;
  const bool done = succeeds(png, [this] {
    about = png_create_info_struct(png);
    if (about == nullptr) png_error(png, "no memory is left");
    png_init_io(png, file);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png, about, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, about, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, about);
  });
  if (!done) complain(errno);
}

void PngFile::Open::write_rows(const Pixel* pixels, int count) {
  errno = 0;
  const bool done = succeeds(png, [this, pixels, count] {
    for (int row = 0; row < count; ++row)
      png_write_row(png, &pixels[static_cast<std::size_t>(row) * width].red);
  });
  if (!done) complain(errno);
  rows += count;
}

/// So that a picture can be looked at while it grows.
void PngFile::Open::flush() {
  errno = 0;
  if (!succeeds(png, [this] { png_write_flush(png); }) || std::ferror(file) != 0) complain(errno);
}

void PngFile::Open::write(std::span<const Pixel> pixels) {
  assert(pixels.size() % static_cast<std::size_t>(width) == 0);
  const auto count = static_cast<int>(pixels.size() / static_cast<std::size_t>(width));
  assert(count <= height - rows);
  if (!is_begun()) begin();
  write_rows(pixels.data(), count);
  if (rows < height) flush();
}

void PngFile::Open::end() {
  if (!is_begun()) begin();
  const std::vector<Pixel> black(static_cast<std::size_t>(width), Pixel{0, 0, 0});
  while (rows < height) write_rows(black.data(), 1);
  errno = 0;
  if (!succeeds(png, [this] { png_write_end(png, about); })) complain(errno);
  if (std::fflush(file) != 0 || std::ferror(file) != 0) complain(errno);
  is_over = true;
}

PngFile::PngFile(const std::filesystem::path& path, int width, int height)
    : open_(std::make_unique<Open>(path, width, height)) {}
PngFile::~PngFile() = default;
PngFile::PngFile(PngFile&&) noexcept = default;

void PngFile::write(std::span<const Pixel> pixels) { open_->write(pixels); }

void PngFile::close() {
  if (open_ == nullptr) return;
  const std::unique_ptr<Open> open = std::move(open_);
  open->end();
}

}  // namespace rayaudit
