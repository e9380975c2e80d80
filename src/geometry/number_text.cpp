#include "geometry/number_text.hpp"

#include <array>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>

#include "geometry/error.hpp"

namespace rayaudit {
namespace {

constexpr std::string_view hex_digits = "0123456789abcdef";

/// The leading bit of a double's significand, when that is written as a whole number.
constexpr std::uint64_t one = std::uint64_t{1} << 52;

/// Far beyond every format there is, and far from the ends of int.
constexpr int exponent_limit = 1'000'000;

/// x 2^exponent without an exponent of its own, where the parts are doubles then.
Real folded(const Real& x, int exponent) {
  const auto folds = [&](double part) {
    return part == 0 || std::ldexp(std::ldexp(part, exponent), -exponent) == part;
  };
  if (!folds(x.high) || !folds(x.middle) || !folds(x.low))
    return {x.high, x.middle, x.low, exponent};
  const auto fold = [&](double part) { return part == 0 ? 0 : std::ldexp(part, exponent); };
  return {fold(x.high), fold(x.middle), fold(x.low), 0};
}

constexpr auto digit_values = [] {
  std::array<signed char, 256> values;
  values.fill(-1);
  for (const std::string_view letters : {"0123456789abcdef", "0123456789ABCDEF"})
    for (std::size_t i = 0; i < letters.size(); ++i)
      values[static_cast<unsigned char>(letters[i])] = static_cast<signed char>(i);
  return values;
}();

/// The value of a hex digit, -1 of another letter.
int digit_of(char letter) { return digit_values[static_cast<unsigned char>(letter)]; }

/// A whole number of any length, from its hex digits.
class HexDigits {
 public:
  void append(int digit) {
    if (digit == 0 && position_ == top) return;
    chunk_ = chunk_ << 4 | static_cast<std::uint64_t>(digit);
    position_ -= 4;
    if ((top - position_) % 52 == 0) close_chunk();
  }

  /// The number times 2^shift, or nothing where three doubles cannot hold it.
  std::optional<Real> times_power_of_two(int shift) {
    close_chunk();
    if (!held_) return std::nullopt;
    return folded(normal(sum_), shift - position_);
  }

 private:
  static constexpr int top = 1000;  ///< of double's range, for the most digits below

  /// The number so far is sum_ 2^-position_.
  void close_chunk() {
    const double digits = static_cast<double>(chunk_);
    const double part = std::ldexp(digits, position_);
    held_ = held_ && std::ldexp(part, -position_) == digits;
    chunk_ = 0;
    ++chunks_;
    if (chunks_ == 1) {
      sum_.high = part;
    } else if (chunks_ == 2) {
      sum_.middle = part;
    } else if (chunks_ == 3) {
      sum_.low = part;
    } else {
      const Real sum = difference(sum_, real(-part));
      held_ = held_ && compare(difference(sum, sum_), real(part)) == 0;
      sum_ = sum;
    }
  }

  std::uint64_t chunk_ = 0;
  int position_ = top;
  int chunks_ = 0;
  Real sum_ = {};
  bool held_ = true;
};

/// The exponent `p+12` of a hex float, 0 where there is none; nothing where it is malformed.
std::optional<int> exponent_of(std::string_view text) {
  if (text.empty()) return 0;
  if ((text[0] | 0x20) != 'p') return std::nullopt;
  text.remove_prefix(1);
  if (text.substr(0, 1) == "+" && text.substr(1, 1) != "-") text.remove_prefix(1);
  int exponent = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (fault == std::errc::invalid_argument || end != text.data() + text.size()) return std::nullopt;
  if (fault == std::errc::result_out_of_range) return std::numeric_limits<int>::max();
  return exponent;
}

/// What follows the 0x of a hex float, exactly; nothing where it is malformed.
std::optional<Real> read_hex(std::string_view text, std::string_view word,
                             const NumberPlace& place) {
  std::uint64_t whole = 0;  // the digits, as far as 64 bits hold them
  std::size_t length = 0;   // the digits, zeros in front not counted
  std::size_t after_point = 0;
  bool point = false, any = false;
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    if (text[i] == '.' && !point) {
      point = true;
      continue;
    }
    const int digit = digit_of(text[i]);
    if (digit < 0) break;
    any = true;
    after_point += point;
    whole = whole << 4 | static_cast<std::uint64_t>(digit);
    length += length > 0 || digit > 0;
  }
  const std::optional<int> exponent = exponent_of(text.substr(i));
  if (!any || !exponent) return std::nullopt;
  if (*exponent > exponent_limit || *exponent < -exponent_limit)
    throw Error(place.owned() + "the exponent of " + place.name() + " " + told_word(word) +
                " is beyond " + std::to_string(exponent_limit));
  const int shift = *exponent - 4 * static_cast<int>(after_point);
  if (length <= 16 && whole < 2 * one) return folded(real(static_cast<double>(whole)), shift);
  HexDigits digits;
  for (const char letter : text.substr(0, i))
    if (letter != '.') digits.append(digit_of(letter));
  const std::optional<Real> number = digits.times_power_of_two(shift);
  if (!number)
    throw Error(place.owned() + place.name() + " " + told_word(word) +
                " has more digits than three doubles hold");
  return number;
}

[[noreturn]] void throw_overflow(std::string_view word, const NumberPlace& place) {
  throw Error(place.owned() + place.name() + " " + told_word(word) + " overflows a double");
}

/// A decimal, rounded to the nearest double; inf and nan too. Nothing where it is malformed.
std::optional<double> read_decimal(std::string_view text, std::string_view word,
                                   const NumberPlace& place) {
  if (text.substr(0, 1) == "-") return std::nullopt;  // from_chars takes a sign, ours is off
  double number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault == std::errc::invalid_argument || end != text.data() + text.size()) return std::nullopt;
  if (fault != std::errc::result_out_of_range) return number;
  // Out of range is said of overflow and underflow alike. The point is one in any locale.
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  number = strtod_l(std::string(text).c_str(), nullptr, plain);
  if (std::isinf(number)) throw_overflow(word, place);
  return number;
}

/// Appends the 13 hex digits of a whole number below 2^52.
void append_digits(std::string& line, std::uint64_t number) {
  for (int shift = 48; shift >= 0; shift -= 4) line += hex_digits[number >> shift & 15];
}

/// Ends `0x1.80` as `0x1.8p+1`.
void append_exponent(std::string& line, int exponent) {
  line.resize(line.find_last_not_of('0') + 1);
  if (line.back() == '.') line.pop_back();
  std::array<char, 12> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(exponent));
  line += exponent < 0 ? "p-" : "p+";
  line.append(digits.data(), end.ptr);
}

}  // namespace

Real read_real(std::string_view word, const NumberPlace& place) {
  std::string_view text = word;
  const bool negative = text.substr(0, 1) == "-";
  if (negative || text.substr(0, 1) == "+") text.remove_prefix(1);
  std::optional<Real> number;
  if (text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X") {
    number = read_hex(text.substr(2), word, place);
  } else if (const auto decimal = read_decimal(text, word, place)) {
    number = real(*decimal);
  }
  if (!number) throw Error(place.owned() + "expected " + place.name() + ", got " + told_word(word));
  if (!negative) return *number;
  return {-number->high, -number->middle, -number->low, number->exponent};
}

double read_double(std::string_view word, const NumberPlace& place) {
  const Real exact = read_real(word, place);
  const double number = nearest<double>(exact);
  if (std::isinf(number) && !is_infinite(exact)) throw_overflow(word, place);
  return number;
}

void write(std::string& line, double number) {
  if (std::isnan(number)) {
    line += "nan";
    return;
  }
  if (std::signbit(number)) line += '-';
  if (std::isinf(number)) {
    line += "inf";
  } else if (number == 0) {
    line += "0x0p+0";
  } else {
    const int exponent = std::ilogb(number);
    const double leading = std::ldexp(std::abs(number), 52 - exponent);
    line += "0x1.";
    append_digits(line, static_cast<std::uint64_t>(leading) - one);
    append_exponent(line, exponent);
  }
}

void write(std::string& line, const Real& number) {
  Real rest = normal(number);
  if (!is_finite(rest) || rest.high == 0 || (rest.middle == 0 && rest.exponent == 0))
    return write(line, rest.high);
  const int exponent = binade(rest);
  // The number is brought to [2^900, 2^901), where its leading digits are a whole number of
  // weights, and what is left of it moves up to them.
  const int shift = 900 - (exponent - rest.exponent);
  constexpr double weight = 0x1p848;
  const double sign = rest.high < 0 ? -1 : 1;
  const auto up = [](const Real& x, double factor, int e) {
    return Real{std::ldexp(factor * x.high, e), std::ldexp(factor * x.middle, e),
                std::ldexp(factor * x.low, e)};
  };
  line += sign < 0 ? "-0x1." : "0x1.";
  std::uint64_t leading_one = one;
  for (rest = up(rest, sign, shift); rest.high != 0; rest = up(rest, 1, 52)) {
    double digits = std::floor(rest.high / weight);
    if (digits * weight == rest.high && rest.middle < 0) digits -= 1;
    rest = normal({rest.high - digits * weight, rest.middle, rest.low});
    append_digits(line, static_cast<std::uint64_t>(digits) - leading_one);
    leading_one = 0;
  }
  append_exponent(line, exponent);
}

}  // namespace rayaudit
