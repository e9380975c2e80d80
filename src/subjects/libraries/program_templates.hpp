#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// A sentence of a library's documentation, and the shape of failure that it makes a defect.
struct Says {
  /// A verdict or any; or what counts before those: length, of what hangs on the length of the
  /// direction; inside, of a ray from there; behind, of hits there.
  std::string key;
  std::string sentence;  ///< with its quotation marks, and where it stands
};

/// A program that asks a library one case through its public interface and prints its answer, with
/// places for the numbers: programs/SUBJECT.SHAPE.cpp (.mjs, .pov) beside this file. Its first
/// lines are comments, `// build: COMMAND` and `// says KEY: "..." (where)`.
struct ProgramTemplate {
  std::string_view file;   ///< without its folder
  std::string_view build;  ///< a shell command with the words FILE and PROGRAM
  std::vector<Says> says;
  std::string_view body;  ///< what comes after those lines

  std::string_view ending() const { return file.substr(file.rfind('.')); }
};

/// That of a subject's routine and shape; nothing where there is none.
std::optional<ProgramTemplate> program_template(std::string_view routine, std::size_t shape);

/// Reads one from its text.
ProgramTemplate read_template(std::string_view file, std::string_view text);

/// What it says of a failure: of its key, else of any; nothing where it says nothing.
std::optional<std::string> says_of(const ProgramTemplate& program, std::string_view key);

/// The program with the numbers of a case as literals that read back exactly: of floats with the
/// suffix f in C++, infinities as the language has them. Half the height of an upright shape is h,
/// and real is float or double.
std::string filled(const ProgramTemplate& program, const Case& question, const Format& format);

}  // namespace rayaudit
