#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle/prepared.hpp"

namespace rayaudit::oracle {

/// Cases are settled in blocks: one switch of the rounding mode for all of a block's intervals.
constexpr std::size_t block = 64;

/// Some of the cases of a block: the i-th by bit i.
using Some = std::uint64_t;

constexpr Some one(std::size_t i) { return Some{1} << i; }

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
  /// Lets go of those that are settled.
  void leave_out(Some settled) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if ((settled & one(place[i])) != 0) continue;
      asked[left] = asked[i], place[left] = place[i], t_exponent[left] = t_exponent[i];
      ++left;
    }
    count = left;
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
