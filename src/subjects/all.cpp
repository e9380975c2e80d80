#include <iterator>

#include "subjects/exact.hpp"
#include "subjects/subject.hpp"
#include "subjects/twins.hpp"
#include "subjects/wide.hpp"

namespace rayaudit {

const std::vector<Subject>& all_subjects() {
  static const std::vector<Subject> subjects = [] {
    std::vector<Subject> all = built_in_subjects();
    for (auto* more : {wide_subjects, exact_subjects, twin_subjects}) {
      std::vector<Subject> named = more();
      for (Subject& each : named) each.by_name_only = true;
      std::move(named.begin(), named.end(), std::back_inserter(all));
    }
    return all;
  }();
  return subjects;
}

std::vector<Absent> absent_subjects() {
  std::vector<Absent> absent = absent_wide_subjects();
  for (const Absent& each : absent_twins()) absent.push_back(each);
  return absent;
}

}  // namespace rayaudit
