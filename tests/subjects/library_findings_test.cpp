#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "subjects/libraries/confirmation.hpp"

/// A program of the page of findings, built and run as its first lines say: it must print what the
/// page says that it prints, and `rayaudit judge` must find that wrong. Exit code 0 where it does,
/// and what is said begins with `skipped` where its library is not here.
namespace rayaudit {
namespace {

/// What the first lines of a program say, by their first words.
std::map<std::string, std::string> said(const std::string& text) {
  std::map<std::string, std::string> said;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && line.starts_with("// ");)
    if (const std::size_t colon = line.find(": "); colon != line.npos)
      said.emplace(line.substr(3, colon - 3), line.substr(colon + 2));
  return said;
}

/// Is a program not built because what it is built with is not here?
bool is_absent(const std::string& why) {
  for (const char* word : {"No such file", "not found", "cannot find", "npm", "ERR_MODULE"})
    if (why.starts_with("it ") && why.find(word) != why.npos) return true;
  return false;
}

bool is_judged_wrong(const std::string& judge, const std::string& line) {
  const std::string program = std::getenv("RAYAUDIT");
  const std::string fails = "false_hit,false_miss,wrong_root,wrong_t,not_finite,crashed,timed_out";
  const std::string command = fmt::format("echo '{}' | '{}' {} --fail-on {} >/dev/null 2>&1", line,
                                          program, judge.substr(judge.find(' ') + 1), fails);
  const int status = std::system(command.c_str());
  return WIFEXITED(status) && WEXITSTATUS(status) == 1;
}

int confirm(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  const auto words = said(text.str());
  const std::string line = words.at("case") + ' ' + words.at("observed");
  const CaseLine read = read_case_line(line);
  const OutsideProgram program = {file.filename(), text.str(), words.at("build")};
  if (const std::string why =
          why_unconfirmed(program, read.question, *read.answer, std::getenv("RAYAUDIT"));
      !why.empty()) {
    fmt::print("{}{}: {}\n", is_absent(why) ? "skipped " : "", file.filename().string(), why);
    return 1;
  }
  if (is_judged_wrong(words.at("wrong by"), line)) return 0;
  fmt::print("{}: `{}` is not judged wrong\n", file.filename().string(), line);
  return 1;
}

}  // namespace
}  // namespace rayaudit

int main(int, char** arguments) try {
  return rayaudit::confirm(arguments[1]);
} catch (const std::exception& why) {
  fmt::print("{}: {}\n", arguments[1], why.what());
  return 2;
}
