#include "cli/lines.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace rayaudit {
namespace {

constexpr std::size_t block_bytes = 1 << 20, piece_bytes = 1 << 14, read_bytes = 1 << 16;

bool is_standard_input(const std::string& path) { return path.empty() || path == "-"; }

/// Would a read return at once?
bool is_ready(int descriptor) {
  pollfd asked = {descriptor, POLLIN, 0};
  return poll(&asked, 1, 0) == 1;
}

/// Up to and with the end of the line that holds the given place.
std::size_t line_end(std::string_view text, std::size_t place) {
  const std::size_t end = text.find('\n', std::min(place, text.size() - 1));
  return end == text.npos ? text.size() : end + 1;
}

[[noreturn]] void throw_system_error(const std::string& name) {
  throw Error("`" + name + "` cannot be read: " + std::strerror(errno));
}

}  // namespace

LineFile::LineFile(const std::string& path)
    : name_(is_standard_input(path) ? "stdin" : path),
      descriptor_(is_standard_input(path) ? STDIN_FILENO
                                          : open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0) throw_system_error(name_);
}

LineFile::~LineFile() {
  if (descriptor_ != STDIN_FILENO) close(descriptor_);
}

std::size_t LineFile::read_more() {
  const std::size_t size = text_.size();
  text_.resize(size + read_bytes);
  ssize_t got = 0;
  do {
    got = ::read(descriptor_, text_.data() + size, read_bytes);
  } while (got < 0 && errno == EINTR);
  if (got < 0) throw_system_error(name_);
  text_.resize(size + static_cast<std::size_t>(got));
  return static_cast<std::size_t>(got);
}

std::vector<Piece> LineFile::next() {
  text_.erase(0, used_);
  std::size_t end = 0;  // of the last whole line
  while (end == 0 || (text_.size() < block_bytes && is_ready(descriptor_))) {
    const std::size_t before = text_.size();
    if (read_more() == 0) {
      end = text_.size();
      break;
    }
    const std::size_t last = std::string_view(text_).substr(before).rfind('\n');
    if (last != text_.npos) end = before + last + 1;
  }
  used_ = end;
  std::vector<Piece> pieces;
  for (std::string_view rest = std::string_view(text_).substr(0, end); !rest.empty();) {
    const std::string_view piece = rest.substr(0, line_end(rest, piece_bytes));
    pieces.push_back({piece, next_number_});
    next_number_ += static_cast<std::uint64_t>(std::count(piece.begin(), piece.end(), '\n'));
    rest.remove_prefix(piece.size());
  }
  return pieces;
}

ReadPiece read_piece(const std::string& file, const Piece& piece, Answers answers) {
  ReadPiece read;
  std::uint64_t number = piece.first;
  for (std::string_view rest = piece.text; !rest.empty(); ++number) {
    const std::string_view whole = rest.substr(0, line_end(rest, 0));
    rest.remove_prefix(whole.size());
    Line line = {whole.substr(0, whole.size() - (whole.back() == '\n' ? 1 : 0)), number, {}};
    try {
      if (!is_blank(line.text)) line.read = read_case_line(line.text);
      if (answers == Answers::required && line.read && !line.read->answer)
        throw Error("expected an answer after the case: `hit`, `at`, `yes` or `miss`");
    } catch (const Error& fault) {
      read.fault = Error(file + ":" + std::to_string(number) + ": " + fault.what());
      return read;
    }
    read.lines.push_back(line);
  }
  return read;
}

}  // namespace rayaudit
