#include "subjects/exact.hpp"

#include <string_view>

#include "oracle/ways.hpp"

namespace rayaudit {
namespace {

Subject exact_subject(std::string_view name, int dear, oracle::Way* way) {
  Subject subject = {
      .name = std::string(name), .format = double_format, .answer = {}, .dear = dear};
  subject.answer.fill(way);
  return subject;
}

}  // namespace

std::vector<Subject> exact_subjects() {
  return {exact_subject("interval/double", 5, oracle::answer_by_intervals),
          exact_subject("mpzf/double", 60, oracle::answer_by_mpzf),
          exact_subject("gmpq/double", 350, oracle::answer_by_gmpq),
          exact_subject("epeck/double", 100, oracle::answer_by_epeck),
          exact_subject("epeck_sqrt/double", 700, oracle::answer_by_epeck_sqrt),
          exact_subject("oracle/double", 12, oracle::answer_by_truth)};
}

}  // namespace rayaudit
