#include "cli/command_text.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <string_view>

namespace rayaudit {

std::string quoted(const std::string& word) {
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string_view("_-./,=+").find(letter) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
  return text + '\'';
}

std::string command_text(const CLI::App& command, const std::vector<std::string>& without) {
  std::string text = "rayaudit " + command.get_name();
  for (const CLI::Option* option : command.get_options()) {
    if (std::find(without.begin(), without.end(), option->get_name()) != without.end()) continue;
    for (const std::string& value : option->results()) {
      if (!option->get_positional()) text += ' ' + option->get_name();
      if (option->get_expected_max() > 0) text += ' ' + quoted(value);
    }
  }
  return text;
}

}  // namespace rayaudit
