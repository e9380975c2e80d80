#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "audit/audit.hpp"

/// The simplest cases of what was found.
namespace rayaudit {

/// Simpler cases are looked for in so many rounds at most, each one step from the last; of a
/// subject elsewhere in fewer, for each is one asking.
inline constexpr int minimal_rounds = 256, minimal_rounds_elsewhere = 64;

/// Where a subject elsewhere crashed or said what is no answer, it is asked so many cases for a
/// simpler one, and no more: each may take a new process. Where its answer is wrong, no more once
/// so many simpler cases were left without one. The case may then not be minimal.
inline constexpr std::size_t minimal_cases_without_answer = 32;

/// A case is no minimal one where its margin falls below so many u, unless that of the case found
/// does too: there rounding the case itself might excuse the answer.
inline constexpr double telling_margin = 0x1p10;

/// The minimal case of a wrong answer whose cause was looked for: as simple as rounds of steps make
/// it without another verdict, claim or cause, asked as the subject's convention has it. Where the
/// cause is unknown, that of the minimal case may be known. Nothing of an answer that does not
/// repeat or that never came.
std::optional<Minimal> minimal(const Plan& plan, const Audit& audit, const Worst& worst);

/// Gives every example of a finding its minimal case; of a run that is held beside the textbook, of
/// what rounding does not excuse.
void minimise(const Plan& plan, std::vector<Audit>& audits);

}  // namespace rayaudit
