#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "geometry/format.hpp"
#include "geometry/vec3.hpp"

namespace rayaudit {

/// The numbers that a chunk of cases is drawn with: Philox4x64-10 (Salmon, Moraes, Dror and Shaw,
/// "Parallel random numbers: as easy as 1, 2, 3", SC 2011) keyed by all that the chunk depends on.
/// The conversions use nothing that differs between libraries or processors.
class Random {
 public:
  Random(std::uint64_t seed, std::string_view family, std::string_view shape, const Format& format,
         std::optional<int> difficulty, std::uint64_t chunk)
      : key_{{seed, code(family)}}, counter_{{0, chunk, code(shape), code(format, difficulty)}} {}

  std::uint64_t bits() {
    if (used_ == words_.size()) refill();
    return words_[used_++];
  }

  /// A whole number from 0 to end - 1; end at least 1.
  std::int64_t below(std::int64_t end) {
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::int64_t>(static_cast<Wide>(bits()) * static_cast<Wide>(end) >> 64);
  }
  /// A whole number from least to most, both included.
  std::int64_t whole(std::int64_t least, std::int64_t most) {
    return least + below(most - least + 1);
  }
  bool one_in(int n) { return below(n) == 0; }
  /// x or -x.
  template <class X>
  X either(const X& x) {
    return one_in(2) ? x : -x;
  }

  /// A number strictly between -1 and 1, of 53 bits and never 0.
  double symmetric() {
    const auto odd = static_cast<std::int64_t>(bits() >> 10 | 1);
    return static_cast<double>(odd - (std::int64_t{1} << 53)) * 0x1p-53;
  }
  double between(double least, double most) {
    return least + (most - least) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  /// A point of the cube from -1 to 1, no component 0.
  Vec3<double> in_cube() {
    const double x = symmetric(), y = symmetric(), z = symmetric();
    return {x, y, z};
  }
  /// A vector of a length from least to most, in every direction (but not evenly so).
  Vec3<double> vector(double least, double most) {
    const double length = between(least, most);
    const Vec3<double> v = in_cube();
    return length / std::sqrt(dot(v, v)) * v;
  }

 private:
  using Philox = r123::Philox4x64;
  static constexpr std::size_t blocks = 4;  ///< drawn together: they fill each other's latencies

  /// FNV-1a, 64 bits (Fowler, Noll, Vo).
  static constexpr std::uint64_t code(std::string_view name) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash;
  }
  static std::uint64_t code(const Format& format, std::optional<int> difficulty) {
    return static_cast<std::uint64_t>(format.precision) << 33 |
           static_cast<std::uint64_t>(difficulty.has_value()) << 32 |
           static_cast<std::uint32_t>(difficulty.value_or(0));
  }

  void refill() {
    for (std::size_t block = 0; block < blocks; ++block, ++counter_[0]) {
      const Philox::ctr_type drawn = Philox{}(counter_, key_);
      for (std::size_t i = 0; i < drawn.size(); ++i) words_[block * drawn.size() + i] = drawn[i];
    }
    used_ = 0;
  }

  Philox::key_type key_;
  Philox::ctr_type counter_;
  std::array<std::uint64_t, blocks* 4> words_ = {};
  std::size_t used_ = blocks * 4;
};

}  // namespace rayaudit
