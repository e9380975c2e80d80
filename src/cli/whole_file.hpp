#pragma once

#include <string>

namespace rayaudit {

/// A file that was read to its end.
struct WholeFile {
  std::string name, text;
};

/// Reads a file, or standard input where the path is `-`. Throws Error where it cannot be read or
/// is larger than a gigabyte: whatever it is, no report is.
WholeFile read_whole(const std::string& path);

}  // namespace rayaudit
