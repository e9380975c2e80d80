#include "routines/routines.hpp"
#include "subjects/certified.hpp"
#include "subjects/subject.hpp"
#include "subjects/subject_of.hpp"

namespace rayaudit {
namespace {

template <class... Routine>
std::vector<Subject> subjects_of(const std::tuple<Routine...>&) {
  std::vector<Subject> made;
  ((made.push_back(subject_of<Routine, float>()), made.push_back(subject_of<Routine, double>()),
    made.push_back(subject_of<Routine, long double>())),
   ...);
  made.push_back(certified_float());
  made.push_back(certified_double());
  return made;
}

}  // namespace

const std::vector<Subject>& built_in_subjects() {
  static const std::vector<Subject> subjects = subjects_of(Routines{});
  return subjects;
}

}  // namespace rayaudit
