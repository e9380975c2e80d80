#include "subjects/wide.hpp"

#include <utility>

#include "numbers/double_double.hpp"
#include "numbers/quad.hpp"
#include "routines/routines.hpp"
#include "subjects/subject_of.hpp"

namespace rayaudit {
namespace {

/// Every routine in N, whose answers take about so many times as long as those in double.
template <class N, class... Routine>
void add(std::vector<Subject>& subjects, int dear, const std::tuple<Routine...>&) {
  for (Subject subject : {subject_of<Routine, N>()...}) {
    subject.dear = dear;
    subjects.push_back(std::move(subject));
  }
}

}  // namespace

std::vector<Subject> wide_subjects() {
  std::vector<Subject> subjects;
  add<DoubleDouble>(subjects, 10, Routines{});
#ifdef RAYAUDIT_HAS_QUAD
  add<Quad>(subjects, 50, Routines{});
#endif
  return subjects;
}

std::vector<Absent> absent_wide_subjects() {
#ifdef RAYAUDIT_HAS_QUAD
  return {};
#else
  return {{"*/float128", "only gcc has this number, and another compiler built this program"}};
#endif
}

}  // namespace rayaudit
