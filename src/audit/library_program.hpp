#pragma once

#include <optional>
#include <string>

#include "audit/library_finding.hpp"
#include "subjects/libraries/confirmation.hpp"

namespace rayaudit {

/// A finding as a program of its own against the library's public interface, on its minimal case.
struct LibraryProgram {
  OutsideProgram program;
  std::string sentence;      ///< of the documentation, which makes it a defect
  Worst shown;               ///< the minimal case
  std::string_view library;  ///< its plugin
};

/// That of a finding; nothing where there is no template of it, or none of its sentences says that
/// this is a defect.
std::optional<LibraryProgram> library_program(const LibraryFinding& finding);

}  // namespace rayaudit
