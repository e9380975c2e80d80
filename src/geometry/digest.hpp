#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace rayaudit {

/// A number that tells bytes from others, unless by chance of 2^-64; not to be trusted against
/// intent. FNV-1a, 64 bits: Fowler, Noll, Vo & Eastlake, "The FNV Non-Cryptographic Hash
/// Algorithm".
class Digest {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) add_byte(static_cast<std::uint8_t>(byte));
  }
  void add(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (int byte = 0; byte < 8; ++byte) add_byte(static_cast<std::uint8_t>(bits >> (8 * byte)));
  }
  std::uint64_t value() const { return value_; }

 private:
  void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3; }

  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace rayaudit
