#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "oracle/truth.hpp"

/// The first stages of truth: eight or four cases at once, in numbers of two words and of three.
namespace rayaudit::oracle {

/// The most cases that are settled at once.
constexpr std::size_t most_in_lanes = 64;

/// More bits of t than these lanes never know.
constexpr int most_bits_in_lanes = 90;

/// Is it a question that lanes are made for: a shape as it is?
inline bool fits_lanes(const Case& question) { return question.extent == Extent::bounded; }

/// The instruction sets that lanes are compiled for; what comes of them is the same to the bit.
enum class Lanes : std::uint8_t { portable, avx2, avx512 };
std::string_view name(Lanes lanes);
/// Does this processor have them?
bool has(Lanes lanes);
/// The widest that this processor has.
Lanes widest_lanes();

/// How many words a number has.
enum class Words : std::uint8_t { two, three };

/// What lanes know of the i-th case, by bit i.
struct InLanes {
  std::uint64_t settled;   ///< its truth is told
  std::uint64_t doubtful;  ///< of the others: it may be a tie, for some sign is within its bound
};

/// Settles those cases whose verdict is proved, and whose t is known to 2^-bits, by numbers of so
/// many words. The cases (1 to most_in_lanes) fit lanes and are of one shape; they may be invalid,
/// which is left to later stages as all that is degenerate.
InLanes settle_in_lanes(std::span<const Case* const> cases, std::span<Truth* const> truths,
                        int bits, Words words, Lanes lanes);

}  // namespace rayaudit::oracle
