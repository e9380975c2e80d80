#pragma once

#include <cstdint>
#include <optional>

#include "audit/cause.hpp"
#include "audit/judge.hpp"

namespace rayaudit {

/// A case of the same failure as another, of which no simpler one is a single step away: verdict,
/// claim and cause are the same.
struct Minimal {
  Case question = {};
  Answer answer = {};
  Judgement judgement = {};
  Diagnosis diagnosis = {};
  double margin = 0;  ///< in u of the subject's format
};

/// The worst case of a kind, kept whole.
struct Worst {
  double severity = 0;
  std::uint64_t place = 0;  ///< which case of the audit it was, from 0
  Case question = {};
  Answer answer = {};
  Judgement judgement = {};
  Diagnosis diagnosis = {};  ///< of wrong answers, found at the end of a run
  /// Of a subject elsewhere: was the answer as wrong when the case was asked again, alone?
  bool repeats = true;
  /// Of a run that looks for that: does rounding not excuse it (beyond_rounding.hpp)?
  bool beyond_rounding = false;
  /// Of the example of a finding, at the end of a run that looks for causes.
  std::optional<Minimal> minimal = {};
};

/// The case that is told of it first: the minimal one, where there is one.
inline Worst told_first(Worst worst) {
  if (!worst.minimal) return worst;
  const Minimal& minimal = *worst.minimal;
  worst.question = minimal.question, worst.answer = minimal.answer;
  worst.judgement = minimal.judgement, worst.diagnosis = minimal.diagnosis;
  worst.severity = minimal.margin;
  return worst;
}

/// What rounding does not excuse is worse than what it may.
inline bool is_worse(const Worst& a, const Worst& b) {
  if (a.beyond_rounding != b.beyond_rounding) return a.beyond_rounding;
  return a.severity != b.severity ? a.severity > b.severity : a.place < b.place;
}

inline void keep_worse(std::optional<Worst>& kept, const Worst& other) {
  if (!kept || is_worse(other, *kept)) kept = other;
}

}  // namespace rayaudit
