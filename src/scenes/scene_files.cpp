#include "scenes/scene_files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "geometry/quotation.hpp"

namespace rayaudit {
namespace {

/// Every shape keeps the name of its file.
constexpr std::size_t most_letters = 255;

std::string displayed(const std::filesystem::path& file) {
  std::string name = file.lexically_normal().string();
  for (char& letter : name)
    if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7f') letter = '?';
  return name.size() <= most_letters ? name : "..." + name.substr(name.size() - most_letters + 3);
}

[[noreturn]] void refuse_reading(const Place& place, const std::filesystem::path& file,
                                 const std::string& why) {
  throw SceneError(place, quotation(file.string()) + " cannot be read: " + why);
}

}  // namespace

void SceneFiles::count(std::uintmax_t bytes, const Place& place) {
  bytes_ += bytes;
  if (bytes_ > most_bytes)
    throw SceneError(place, fmt::format("a scene of more than {} MB of text, Includes counted",
                                        most_bytes >> 20));
}

std::string SceneFiles::read(const std::filesystem::path& file, const Place& place) {
  std::error_code fault;
  const auto status = std::filesystem::status(file, fault);
  if (fault) refuse_reading(place, file, fault.message());
  // What is no regular file may have no end.
  if (!std::filesystem::is_regular_file(status))
    refuse_reading(
        place, file,
        std::filesystem::is_directory(status) ? "it is a folder" : "it is no regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, fault);
  if (fault) refuse_reading(place, file, fault.message());
  count(size, place);
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!stream) refuse_reading(place, file, std::strerror(errno));
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (stream.bad()) refuse_reading(place, file, std::strerror(errno));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

SceneFiles::Text SceneFiles::open_first(const std::filesystem::path& file) {
  folders_ = {file.parent_path().empty() ? "." : file.parent_path()};
  open_ = {file};
  return {displayed(file), read(file, {displayed(file), 1, 1})};
}

std::filesystem::path SceneFiles::found(const Token& name) const {
  const std::filesystem::path asked(name.text);
  if (folders_.front().empty()) refuse(name, "Include: a text has no folder to look for files in");
  if (asked.empty()) refuse(name, "Include of a file without a name");
  std::error_code ignored;
  std::filesystem::path beside = folders_.back() / asked;
  if (std::filesystem::exists(beside, ignored)) return beside;
  std::filesystem::path beside_first = folders_.front() / asked;
  return std::filesystem::exists(beside_first, ignored) ? beside_first : beside;
}

SceneFiles::Text SceneFiles::open(const Token& name) {
  const std::filesystem::path file = found(name);
  if (folders_.size() > most_deep)
    refuse(name, fmt::format("Includes more than {} deep in each other", most_deep));
  if (++files_ > most_files) refuse(name, fmt::format("more than {} Includes", most_files));
  for (const std::filesystem::path& outer : open_) {
    std::error_code ignored;
    if (std::filesystem::equivalent(outer, file, ignored))
      refuse(name, "Include of " + quotation(name.text) + ", which is being read: it has no end");
  }
  std::string text = read(file, name.place());
  folders_.push_back(file.parent_path());
  open_.push_back(file);
  return {displayed(file), std::move(text)};
}

void SceneFiles::close() {
  folders_.pop_back();
  open_.pop_back();
}

}  // namespace rayaudit
