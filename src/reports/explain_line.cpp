#include "reports/explain_line.hpp"

#include <fmt/format.h>

#include "geometry/case_line.hpp"
#include "reports/declared.hpp"

namespace rayaudit {

std::string answered_line(const Worst& worst) {
  std::string line = case_line(worst.question) + ' ';
  write(line, worst.answer);
  return line;
}

std::string explain_line(const Worst& worst, const Format& format) {
  std::string line = "rayaudit explain ";
  if (format != double_format) line += fmt::format("--format {} ", format.name);
  return line + '\'' + answered_line(worst) + '\'';
}

std::string explain_line(const Worst& worst, const Subject& subject, const Convention& stated) {
  // What the subject declares itself, it brings along.
  std::string words = declared(stated);
  if (!words.empty()) words.insert(0, " --convention ");
  const std::string brought = subject.brought_by.empty() ? "" : ' ' + subject.brought_by;
  return fmt::format("rayaudit explain --subject {}{}{} '{}'", subject.name, brought, words,
                     answered_line(worst));
}

}  // namespace rayaudit
