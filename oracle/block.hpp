#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle/prepared.hpp"

namespace rayaudit::oracle {

/// Cases are settled in blocks: one switch of the rounding mode for all of a block's intervals.
constexpr std::size_t block = 64;

/// A block on its way through the stages: the valid cases, scaled where they must be.
struct Block {
  std::array<const Case*, block> asked;
  std::array<std::uint8_t, block> place;  ///< asked[i] is cases[place[i]]
  std::array<int, block> t_exponent;
  std::size_t count = 0;
  std::vector<Scaled> scales;

  std::span<const Case* const> cases() const { return {asked.data(), count}; }

  /// Takes in a valid case; false where it is not moderate and powers of two do not come out of it
  /// exactly.
  bool ask(const Case& question, std::size_t at, bool moderate) {
    if (moderate) {
      add(question, at, 0);
      return true;
    }
    if (scales.empty()) scales.reserve(block);
    const Scaled& scale = scales.emplace_back(scaled(question));
    if (scale.exact) add(scale.question, at, scale.t_exponent());
    return scale.exact;
  }

 private:
  void add(const Case& question, std::size_t at, int exponent) {
    asked[count] = &question;
    place[count] = static_cast<std::uint8_t>(at);
    t_exponent[count] = exponent;
    ++count;
  }
};

}  // namespace rayaudit::oracle
