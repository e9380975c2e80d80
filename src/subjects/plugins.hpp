#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// The program that runs now.
inline constexpr const char* this_program = "/proc/self/exe";

/// How long a plugin may take for a batch, where nothing else is asked for.
inline constexpr std::chrono::milliseconds plugin_patience = std::chrono::seconds(2);

/// The plugin rayaudit-NAME.so beside the program, or where it is installed.
std::optional<std::filesystem::path> plugin_beside(const std::filesystem::path& program,
                                                   std::string_view name);

/// The subjects of a shared object that defines rayaudit_plugin_entry (rayaudit/plugin.h), each in
/// a child process of its own, named `name/format`; they hold that child for as long as they live.
/// What they do to it is an answer: crashed, garbage, timed_out where no answer comes for as long
/// as patience. Throws Error, in one sentence, where the file is no such plugin or says of a
/// subject what it cannot mean. The program must know the command serve-plugin.
std::vector<Subject> plugin_subjects(const std::filesystem::path& plugin,
                                     std::chrono::milliseconds patience = plugin_patience,
                                     const std::filesystem::path& program = this_program);

}  // namespace rayaudit
