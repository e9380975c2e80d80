#include "oracle/environment.hpp"
#include "oracle/prepared.hpp"
#include "oracle/radical.hpp"
#include "oracle/ways.hpp"

namespace rayaudit::oracle {
namespace {

Answer answer(const Case& question) {
  const ExactRoots found = exact_roots(question, false);
  if (found.count == 0) return Answer::miss();
  const ExactRoot& last = found.listed[found.count - 1];
  if (last.outlined.kind != Kind::proper) return Answer::miss();
  return Answer::hit(real(nearest<double>(last.t)));
}

}  // namespace

void answer_by_mpzf(std::span<const Case> cases, std::span<Answer> answers) {
  require_plain_arithmetic();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const bool valid = invalid(cases[i], is_moderate(cases[i])) == Invalid::no;
    answers[i] = valid ? answer(cases[i]) : Answer::miss();
  }
}

}  // namespace rayaudit::oracle
