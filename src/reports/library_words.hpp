#pragma once

#include <string>

#include "audit/library_program.hpp"

namespace rayaudit {

/// The program below lines that say what it asks, how it is built, and by what it is judged wrong.
LibraryProgram headed(LibraryProgram shown_by, const LibraryFinding& finding,
                      const Convention& stated);

/// The families of a finding in words, at most so many and how many more: `62 of 2,048 in far, 9 of
/// 2,048 in grazing`.
std::string afflicted(const LibraryFinding& finding, std::size_t most);
/// Shares in words, the only one as its name: `80% formula, 20% rounding`.
std::string shares(const std::vector<Share>& shares, std::uint64_t of);

/// What a finding's minimal case shows, in words; of a wrong root whether t is one at all.
std::string what(const LibraryFinding& finding);

/// The exact answer to a case, as `miss` or `hit (3 + sqrt(5)) / 2 = 2.618...`; beside an answer by
/// its point with that of the hit, to nine digits: `hit 5, at 0 5 0`.
std::string exact_answer(const Case& question, Answer::Form beside = Answer::Form::hit);

/// How to check it by hand: the polynomial whose root t is, where the numbers of the case are small
/// enough to follow; else empty.
std::string by_hand(const Case& question);

}  // namespace rayaudit
