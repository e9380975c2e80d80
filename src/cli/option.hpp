#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "cli/formats.hpp"
#include "cli/seconds.hpp"
#include "cli/selection.hpp"
#include "cli/whole_number.hpp"
#include "geometry/error.hpp"

namespace rayaudit {

/// Adds an option `--name VALUE` that is read from its text; read throws Error where it cannot.
inline CLI::Option* add_option(CLI::App& command, const char* name, const char* value,
                               const char* about,
                               const std::function<void(const std::string&)>& read) {
  return command.add_option_function<std::string>(name, read, about)->type_name(value);
}

/// Adds an option `--name N` for a whole number in [least, most].
inline CLI::Option* add_number(CLI::App& command, const char* name, const char* about,
                               std::int64_t least, std::int64_t most,
                               const std::function<void(std::int64_t)>& take) {
  return add_option(command, name, "N", about,
                    [=](const std::string& text) { take(whole_number(name, text, least, most)); });
}

/// Adds the option for the seed of all that is drawn; it has its default already.
inline void add_seed(CLI::App& command, std::uint64_t& seed) {
  add_number(command, "--seed", "other cases for another seed", 0, largest_number,
             [&seed](std::int64_t n) { seed = static_cast<std::uint64_t>(n); })
      ->default_str(std::to_string(seed));
}

/// Adds an option `--name VALUE` that may be repeated.
inline CLI::Option* add_list(CLI::App& command, const char* name, const char* value,
                             const char* about, std::vector<std::string>& texts) {
  return command.add_option(name, texts, about)->type_name(value)->allow_extra_args(false);
}

/// Adds what brings subjects along, and says what becomes of them.
inline void add_bringers(CLI::App& command, SubjectChoice& choice, const std::string& use) {
  const std::string then = use.empty() ? "" : "; " + use;
  add_list(command, "--plugin", "FILE",
           ("a shared object that brings subjects (rayaudit/plugin.h)" + then + "; may be repeated")
               .c_str(),
           choice.plugins);
  add_option(command, "--program", "COMMAND",
             ("a program that reads case lines and writes them with its answers" + then).c_str(),
             [&choice](const std::string& text) {
               if (text.find_first_not_of(" \t\n") == text.npos)
                 throw Error("--program: expected a command");
               choice.program = text;
             });
  add_option(
      command, "--patience", "SECONDS",
      "in which a plugin must answer a batch, or a program read or write something; default: "
      "2 and 10",
      [&choice](const std::string& text) { choice.patience = seconds("--patience", text); });
}

/// Adds what such a program works in.
inline void add_program_format(CLI::App& command, SubjectChoice& choice) {
  add_option(command, "--format", "FORMAT",
             "what the program works in: float, double or long_double",
             [&choice](const std::string& text) { choice.format = known_format(text); })
      ->default_str("double")
      ->needs("--program");
}

/// Adds what to choose from subjects and shapes, by names or globs.
inline void add_subjects_and_shapes(CLI::App& command, SubjectChoice& choice,
                                    std::vector<std::string>& shapes) {
  command.add_option("SUBJECT", choice.names, "names or globs, as textbook/* or '*/float'")
      ->type_name("");
  add_bringers(command, choice, "without names, only what is brought along is chosen");
  add_program_format(command, choice);
  add_list(command, "--shape", "SHAPE,...", "names or globs", shapes)->delimiter(',');
}

}  // namespace rayaudit
