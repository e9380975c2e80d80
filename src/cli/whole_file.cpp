#include "cli/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "geometry/error.hpp"

namespace rayaudit {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30, read_bytes = 1 << 20;

/// Open for reading; standard input stays open.
class Source {
 public:
  explicit Source(const std::string& path)
      : name_(path == "-" ? "stdin" : path),
        descriptor_(path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) refuse();
  }
  ~Source() {
    if (descriptor_ != STDIN_FILENO) close(descriptor_);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  const std::string& name() const { return name_; }
  /// What the file system says; 0 for a pipe.
  std::size_t size() const {
    struct stat status = {};
    if (fstat(descriptor_, &status) != 0) refuse();
    return static_cast<std::size_t>(status.st_size);
  }
  /// Appends some of what is there; false at the end.
  bool append_to(std::string& text) const {
    const std::size_t before = text.size();
    text.resize(before + read_bytes);
    ssize_t got = 0;
    do {
      got = read(descriptor_, text.data() + before, read_bytes);
    } while (got < 0 && errno == EINTR);
    if (got < 0) refuse();
    text.resize(before + static_cast<std::size_t>(got));
    return got > 0;
  }

 private:
  [[noreturn]] void refuse() const {
    throw Error("`" + name_ + "` cannot be read: " + std::strerror(errno));
  }

  std::string name_;
  int descriptor_;
};

}  // namespace

WholeFile read_whole(const std::string& path) {
  const Source source(path);
  WholeFile whole = {source.name(), {}};
  const auto require_small = [&](std::size_t size) {
    if (size > most_bytes)
      throw Error("`" + whole.name + "` is larger than a gigabyte: no report is");
  };
  require_small(source.size());
  while (source.append_to(whole.text)) require_small(whole.text.size());
  return whole;
}

}  // namespace rayaudit
