#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"
#include "subjects/plugins.hpp"

namespace rayaudit {

/// A program of its own that asks a library one case.
struct OutsideProgram {
  std::string file, text;  ///< its name, without a folder, and all of it
  /// A shell command that builds PROGRAM of FILE; without the word PROGRAM one that runs FILE.
  std::string build;
};

/// The words that a program prints for an answer: `miss`, `yes`, `hit 1.5`, `at 0 0 1`; or
/// `crashed` in place of one.
std::string printed(const Answer& answer);

/// Does the last line of what a program printed say the answer? Number for number, however they are
/// spelled.
bool says(std::string_view output, const Case& question, const Answer& answer);

/// Builds and runs the program in a folder of its own, outside of this process. Empty where it then
/// gives the answer to the case; else why it does not, in words: `it cannot be built: ...`.
/// Packages from npm are those that lie beside the program that is named; none is fetched.
std::string why_unconfirmed(const OutsideProgram& program, const Case& question,
                            const Answer& answer,
                            const std::filesystem::path& beside = this_program);

}  // namespace rayaudit
