#include "cli/picture_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "geometry/error.hpp"

namespace rayaudit {
namespace {

namespace fs = std::filesystem;

fs::path made(const fs::path& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) throw Error("the folder `" + folder.string() + "` cannot be made: " + fault.message());
  return folder;
}

fs::path made_for_now() {
  std::error_code fault;
  const fs::path within = fs::temp_directory_path(fault);
  std::string name = (within / "rayaudit-XXXXXX").string();
  if (fault || mkdtemp(name.data()) == nullptr)
    throw Error("no folder for pictures can be made in `" + within.string() +
                "`: " + (fault ? fault.message() : std::strerror(errno)));
  return name;
}

}  // namespace

PictureFolder::PictureFolder(const std::string& named)
    : path_(named.empty() ? made_for_now() : made(named)), goes_(named.empty()) {}

PictureFolder::~PictureFolder() {
  std::error_code ignored;
  if (goes_) fs::remove_all(path_, ignored);
}

}  // namespace rayaudit
