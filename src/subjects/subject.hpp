#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"
#include "geometry/format.hpp"

namespace rayaudit {

/// An answer with what running error bounds prove of it: that the same operations without rounding
/// would have gone the same way, and how far from its t theirs can be.
struct Proved {
  Answer answer = {};
  bool certified = false;  ///< every comparison is proved, and the bound of t is finite
  double bound = 0;  ///< of |t - the t without rounding|; without a meaning for a miss or a yes
};

/// Whatever answers cases; a built-in one is named `routine/number`.
struct Subject {
  /// Answers cases that are all of one shape: answers[i] is the answer to cases[i].
  using Batch = std::function<void(std::span<const Case>, std::span<Answer>)>;
  using ProvedBatch = std::function<void(std::span<const Case>, std::span<Proved>)>;

  std::string name;
  Format format;                          ///< what it works in
  std::array<Batch, shape_count> answer;  ///< by shape; empty where it does not answer the shape
  /// The same answers in numbers with running error bounds; empty where the subject has none.
  std::array<ProvedBatch, shape_count> prove = {};

  bool answers(std::size_t shape) const { return answer[shape] != nullptr; }

  /// The format to draw its cases in, so that they reach it unrounded.
  const Format& drawn_in() const { return format == float_format ? float_format : double_format; }
};

/// Answers cases of any mix of shapes that the subject answers.
void answer_mixed(const Subject& subject, std::span<const Case> cases, std::span<Answer> answers);
Answer answer_one(const Subject& subject, const Case& question);

/// Every routine in every number it is instantiated in: float, double and long double.
const std::vector<Subject>& built_in_subjects();

}  // namespace rayaudit
