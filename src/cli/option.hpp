#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "cli/selection.hpp"
#include "cli/whole_number.hpp"

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

/// Adds what to choose from subjects and shapes, by names or globs.
inline void add_subjects_and_shapes(CLI::App& command, std::vector<std::string>& subjects,
                                    std::vector<std::string>& shapes) {
  command.add_option("SUBJECT", subjects, "names or globs, as textbook/* or '*/float'")
      ->type_name("");
  add_list(command, "--shape", "SHAPE,...", "names or globs", shapes)->delimiter(',');
}

}  // namespace rayaudit
