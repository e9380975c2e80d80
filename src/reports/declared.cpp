#include "reports/declared.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/wrapped.hpp"

namespace rayaudit {

std::string declared(const Convention& convention) {
  std::string words;
  const auto add = [&](std::string_view name, std::string_view value) {
    words += fmt::format("{}{}={}", words.empty() ? "" : ",", name, value);
  };
  for (std::size_t kind = 1; kind < convention.stances.size(); ++kind)
    if (const auto stance = convention.stances[kind]; stance != Convention::Stance::either)
      add(name(static_cast<oracle::Kind>(kind)),
          stance == Convention::Stance::hit ? "hit" : "miss");
  if (convention.inside != Convention::Inside::hit) add("inside", name(convention.inside));
  if (convention.unit_direction) add("direction", "unit");
  if (convention.line) add("ray", "line");
  if (convention.segment) add("ray", "segment");
  if (convention.extent != Extent::bounded) add("extent", word(convention.extent));
  if (convention.stand != Convention::Stand::anywhere) add("stand", word(convention.stand));
  if (convention.opening != Convention::Opening::radius) add("opening", word(convention.opening));
  if (std::isfinite(convention.t_min)) add("t_min", fmt::format("{}", convention.t_min));
  if (std::isfinite(convention.t_max)) add("t_max", fmt::format("{}", convention.t_max));
  return words;
}

std::string write_declared(const std::vector<Audit>& audits) {
  std::string text;
  const Subject* told = nullptr;
  for (const Audit& audit : audits) {
    const Subject* subject = audit.subject;
    if (subject == told) continue;
    told = subject;
    if (const std::string words = declared(subject->convention); !words.empty())
      text += wrapped(fmt::format("{} declares {}", subject->name, words), 2);
  }
  return text;
}

}  // namespace rayaudit
