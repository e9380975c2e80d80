#include "cli/selection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/names.hpp"
#include "geometry/error.hpp"
#include "geometry/glob.hpp"

namespace rayaudit {
namespace {

/// Does a pattern stand for a subject that is asked for by name only?
bool reaches(const std::string& pattern, const std::vector<Subject>& all, std::size_t i) {
  if (!all[i].by_name_only || !is_glob(pattern)) return true;
  return std::none_of(all.begin(), all.end(), [&](const Subject& each) {
    return !each.by_name_only && matches(pattern, each.name);
  });
}

}  // namespace

void require_present(const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns)
    for (const auto& [subjects, why] : absent_subjects())
      if (matches(subjects, pattern))
        throw Error(fmt::format("subject `{}` is not here: {}", pattern, why));
}

std::vector<const Subject*> selected_subjects(const std::vector<std::string>& patterns) {
  require_present(patterns);
  const std::vector<Subject>& all = all_subjects();
  const std::vector<std::string> asked =
      patterns.empty() ? std::vector<std::string>{"*"} : patterns;
  std::vector<bool> chosen(all.size());
  for (const std::string& pattern : asked)
    for (const std::size_t i : selected("subject", {pattern}, names_of(all, &Subject::name)))
      if (reaches(pattern, all, i)) chosen[i] = true;
  std::vector<const Subject*> subjects;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (chosen[i]) subjects.push_back(&all[i]);
  return subjects;
}

std::vector<std::size_t> shapes_of(const Family& family) {
  std::vector<std::size_t> shapes;
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    if (family.draw[shape] != nullptr) shapes.push_back(shape);
  return shapes;
}

void require_difficulty(const Family& family, const Format& format, int difficulty) {
  const int least = family.difficulty->least, most = family.difficulty->most(format);
  if (difficulty < least || difficulty > most)
    throw Error(fmt::format("--difficulty {} is not one of family `{}` in {}: {} to {}", difficulty,
                            family.id, format.name, least, most));
}

}  // namespace rayaudit
