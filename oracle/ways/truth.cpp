#include "oracle/truth.hpp"

#include <algorithm>

#include "oracle/block.hpp"
#include "oracle/ways.hpp"

namespace rayaudit::oracle {
namespace {

/// As subjects count their stages, from 1: lanes, intervals, exact numbers.
std::uint8_t counted(Stage stage) {
  if (stage == Stage::integers || stage == Stage::exact) return 3;
  return stage == Stage::interval ? 2 : 1;
}

Answer answer(const Case& question, const Truth& truth) {
  const Crossing* hit = truth.hit();
  Answer said = hit ? Answer::hit(real(rounded<double>(question, *hit))) : Answer::miss();
  if (truth.invalid == Invalid::no) said.stage = counted(truth.stage);
  return said;
}

}  // namespace

void answer_by_truth(std::span<const Case> cases, std::span<Answer> answers) {
  std::array<Truth, block> truths;
  for (std::size_t i = 0; i < cases.size(); i += block) {
    const auto some = cases.subspan(i, std::min(block, cases.size() - i));
    truth(some, {truths.data(), some.size()});
    std::transform(some.begin(), some.end(), truths.begin(), answers.begin() + i, answer);
  }
}

}  // namespace rayaudit::oracle
