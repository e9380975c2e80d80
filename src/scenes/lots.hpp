#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace rayaudit {

/// What a lot is drawn for, and by which ray: nothing else decides it. A path tells the rays of a
/// pixel and bounce apart.
struct LotKey {
  enum class Purpose : std::uint32_t { place_in_pixel, point_of_light };

  Purpose purpose;
  std::uint32_t pixel;
  std::uint64_t path = 0;
  std::uint64_t bounce = 0, light = 0;
};

/// Two numbers from 0 to below 1, by Philox4x64-10 (Salmon, Moraes, Dror and Shaw, "Parallel random
/// numbers: as easy as 1, 2, 3", SC 2011).
inline std::array<double, 2> lots(std::uint64_t seed, const LotKey& key) {
  using Philox = r123::Philox4x64;
  constexpr std::uint64_t of_scenes = 0x7363656e6573;
  const std::uint64_t purpose = static_cast<std::uint64_t>(key.purpose) << 32;
  const Philox::ctr_type drawn =
      Philox{}(Philox::ctr_type{{purpose | key.pixel, key.path, key.bounce, key.light}},
               Philox::key_type{{seed, of_scenes}});
  const auto share = [](std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; };
  return {share(drawn[0]), share(drawn[1])};
}

}  // namespace rayaudit
