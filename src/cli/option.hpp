#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

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

}  // namespace rayaudit
