#pragma once

#include <cstdint>
#include <optional>

#include "audit/cause.hpp"
#include "audit/judge.hpp"

namespace rayaudit {

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
};

inline bool is_worse(const Worst& a, const Worst& b) {
  return a.severity != b.severity ? a.severity > b.severity : a.place < b.place;
}

inline void keep_worse(std::optional<Worst>& kept, const Worst& other) {
  if (!kept || is_worse(other, *kept)) kept = other;
}

}  // namespace rayaudit
