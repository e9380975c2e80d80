#include "cli/report_order.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "cli/names.hpp"
#include "cli/output.hpp"
#include "geometry/error.hpp"

namespace rayaudit {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_unwritable(const std::string& file, int reason) {
  throw Error("report `" + file + "` cannot be written: " + std::strerror(reason));
}

/// Where the bytes go in the end: a link stays one, and its file is replaced.
fs::path place_of_bytes(const std::string& file) {
  std::error_code fault;
  const fs::path full = fs::absolute(file, fault);
  const fs::path place = fault ? fs::path() : fs::weakly_canonical(full, fault);
  return fault ? fs::path(file) : place;
}

/// A pipe or a terminal is written as it is; only a file can be replaced by another.
bool is_replaceable(const fs::path& place) {
  std::error_code ignored;
  return !fs::exists(place, ignored) || fs::is_regular_file(place, ignored);
}

/// A file beside the report that becomes it once it is whole.
fs::path draft_of(const fs::path& place) {
  fs::path draft = place;
  return draft += "." + std::to_string(getpid()) + ".tmp";
}

/// Creates the file with the text; the reason where that fails, else 0.
int write_file(const fs::path& file, std::string_view text, int flags) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) return errno;
  int reason = 0;
  while (!text.empty() && reason == 0) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      reason = errno;
    }
  }
  if (close(descriptor) != 0 && reason == 0) reason = errno;
  return reason;
}

void require_writable(const std::string& file) {
  const fs::path place = place_of_bytes(file);
  std::error_code fault;
  const fs::file_status status = fs::status(place, fault);
  if (status.type() == fs::file_type::none) throw_unwritable(file, fault.value());
  if (fs::is_directory(status)) throw_unwritable(file, EISDIR);
  if (fs::exists(status) && access(place.c_str(), W_OK) != 0) throw_unwritable(file, errno);
  if (!is_replaceable(place)) return;
  if (const int reason = write_file(draft_of(place), "", O_CREAT | O_EXCL))
    throw_unwritable(file, reason);
  unlink(draft_of(place).c_str());
}

ReportOrder read_report_order(std::string_view text, std::span<const std::string_view> names) {
  const std::size_t equals = text.find('=');
  ReportOrder order = {place_of("report", text.substr(0, equals), names), ""};
  if (equals == text.npos) return order;
  order.file = text.substr(equals + 1);
  if (order.file.empty())
    throw Error("--report " + std::string(text) + ": expected a file after the `=`");
  if (order.file == "-") order.file.clear();
  return order;
}

}  // namespace

std::vector<ReportOrder> read_report_orders(const std::vector<std::string>& texts,
                                            std::span<const std::string_view> names) {
  std::vector<ReportOrder> orders;
  orders.reserve(texts.size());
  for (const std::string& text : texts) orders.push_back(read_report_order(text, names));
  return orders;
}

void require_places(const std::vector<std::string>& files) {
  for (auto file = files.begin(); file != files.end(); ++file)
    for (auto other = files.begin(); other != file; ++other)
      if (file->empty() == other->empty() &&
          (file->empty() || place_of_bytes(*file) == place_of_bytes(*other)))
        throw Error(file->empty()
                        ? "two reports to standard output: name a file, as in --report json=FILE"
                        : "two reports to the file `" + *file + "`");
  for (const std::string& file : files)
    if (!file.empty()) require_writable(file);
}

void require_places(const std::vector<ReportOrder>& orders) {
  std::vector<std::string> files;
  files.reserve(orders.size());
  for (const ReportOrder& order : orders) files.push_back(order.file);
  require_places(files);
}

void deliver(const std::string& file, const std::string& text) {
  if (file.empty()) return print(text);
  const fs::path place = place_of_bytes(file);
  const bool replaced = is_replaceable(place);
  const fs::path target = replaced ? draft_of(place) : place;
  int reason = write_file(target, text, replaced ? O_CREAT | O_EXCL : 0);
  if (reason == 0 && replaced && rename(target.c_str(), place.c_str()) != 0) reason = errno;
  if (reason == 0) return;
  if (replaced) unlink(target.c_str());
  throw_unwritable(file, reason);
}

}  // namespace rayaudit
