#include "reports/explain_line.hpp"

#include <fmt/format.h>

#include "geometry/case_line.hpp"

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
  const Convention convention = joined(stated, subject.convention);
  std::string declared;
  for (std::size_t kind = 1; kind < convention.stances.size(); ++kind) {
    const auto stance = convention.stances[kind];
    if (stance != Convention::Stance::either)
      declared += fmt::format("{}{}={}", declared.empty() ? " --convention " : ",",
                              name(static_cast<oracle::Kind>(kind)),
                              stance == Convention::Stance::hit ? "hit" : "miss");
  }
  if (convention.inside != Convention::Inside::hit)
    declared += fmt::format("{}inside={}", declared.empty() ? " --convention " : ",",
                            convention.inside == Convention::Inside::miss ? "miss" : "start");
  return fmt::format("rayaudit explain --subject {}{} '{}'", subject.name, declared,
                     answered_line(worst));
}

}  // namespace rayaudit
