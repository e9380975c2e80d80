#include "geometry/case_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <clocale>
#include <cstdint>
#include <cstdlib>

#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

constexpr std::string_view hex_digits = "0123456789abcdef";

/// The leading bit of a double's significand, when that is written as a whole number.
constexpr std::uint64_t one = std::uint64_t{1} << 52;

/// Far beyond every format there is, and far from the ends of int.
constexpr int exponent_limit = 1'000'000;

constexpr auto is_white = [](char letter) {
  return letter == ' ' || (letter >= '\t' && letter <= '\r');
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_white(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_white(text.back())) text.remove_suffix(1);
  return text;
}

/// The words of a line, one after the other; an empty word is the end of the line.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  std::string_view next() {
    const std::string_view word = peek();
    rest_.remove_prefix(word.size());
    return word;
  }

  std::string_view peek() {
    const auto begin = std::find_if_not(rest_.begin(), rest_.end(), is_white);
    rest_.remove_prefix(static_cast<std::size_t>(begin - rest_.begin()));
    const auto end = std::find_if(rest_.begin(), rest_.end(), is_white);
    return rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  }

  /// What was not yet taken.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

std::string told(std::string_view word) {
  return word.empty() ? "the end of the line" : quotation(word);
}

/// What a number is: the radius of a sphere, the x of its centre.
struct Place {
  std::string_view owner, label;
  char component = 0;

  std::string owned() const { return std::string(owner) + ": "; }
  std::string name() const {
    return component == 0 ? std::string(label) : std::string(label) + " " + component;
  }
};

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
std::optional<Real> read_hex(std::string_view text, std::string_view word, const Place& place) {
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
    throw Error(place.owned() + "the exponent of " + place.name() + " " + told(word) +
                " is beyond " + std::to_string(exponent_limit));
  const int shift = *exponent - 4 * static_cast<int>(after_point);
  if (length <= 16 && whole < 2 * one) return folded(real(static_cast<double>(whole)), shift);
  HexDigits digits;
  for (const char letter : text.substr(0, i))
    if (letter != '.') digits.append(digit_of(letter));
  const std::optional<Real> number = digits.times_power_of_two(shift);
  if (!number)
    throw Error(place.owned() + place.name() + " " + told(word) +
                " has more digits than three doubles hold");
  return number;
}

[[noreturn]] void throw_overflow(std::string_view word, const Place& place) {
  throw Error(place.owned() + place.name() + " " + told(word) + " overflows a double");
}

/// A decimal, rounded to the nearest double; inf and nan too. Nothing where it is malformed.
std::optional<double> read_decimal(std::string_view text, std::string_view word,
                                   const Place& place) {
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

Real read_real(Words& words, const Place& place) {
  const std::string_view word = words.next();
  std::string_view text = word;
  const bool negative = text.substr(0, 1) == "-";
  if (negative || text.substr(0, 1) == "+") text.remove_prefix(1);
  std::optional<Real> number;
  if (text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X") {
    number = read_hex(text.substr(2), word, place);
  } else if (const auto decimal = read_decimal(text, word, place)) {
    number = real(*decimal);
  }
  if (!number) throw Error(place.owned() + "expected " + place.name() + ", got " + told(word));
  if (!negative) return *number;
  return {-number->high, -number->middle, -number->low, number->exponent};
}

void read(Words& words, const Place& place, Real& number) { number = read_real(words, place); }

void read(Words& words, const Place& place, double& number) {
  const std::string_view word = words.peek();
  const Real exact = read_real(words, place);
  number = nearest<double>(exact);
  if (std::isinf(number) && !is_infinite(exact)) throw_overflow(word, place);
}

template <class N>
void read(Words& words, const Place& place, Vec3<N>& vector) {
  read(words, {place.owner, place.label, 'x'}, vector.x);
  read(words, {place.owner, place.label, 'y'}, vector.y);
  read(words, {place.owner, place.label, 'z'}, vector.z);
}

template <class S>
Shape read_parts(Words& words) {
  S shape = {};
  std::size_t i = 0;
  std::apply(
      [&](auto&... part) {
        (read(words, {S::name, S::labels[i++]}, part), ...);
      },
      shape.parts());
  return shape;
}

Shape read_shape(Words& words) {
  static constexpr auto readers = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{&read_parts<std::variant_alternative_t<I, Shape>>...};
  }
  (std::make_index_sequence<shape_count>{});
  const std::string_view word = words.next();
  const auto found = std::find(shape_names.begin(), shape_names.end(), word);
  if (word.empty()) throw Error("expected a shape, got the end of the line");
  if (found == shape_names.end()) throw Error(unknown_name("shape", word, shape_names));
  return readers[static_cast<std::size_t>(found - shape_names.begin())](words);
}

std::string numbers_of(const Shape& shape) {
  const int count = std::visit(
      [](const auto& s) {
        int numbers = 0;
        for (const Part kind : s.kinds) numbers += kind == Part::length ? 1 : 3;
        return numbers;
      },
      shape);
  return std::string(name(shape)) + "'s " + std::to_string(count) + " numbers";
}

std::optional<Answer> read_answer(Words& words) {
  Answer answer;
  const std::string_view word = words.peek();
  if (word == "miss") {
    answer.form = Answer::Form::miss;
  } else if (word == "yes") {
    answer.form = Answer::Form::yes;
  } else if (word == "hit") {
    answer.form = Answer::Form::hit;
  } else if (word == "at") {
    answer.form = Answer::Form::at;
  } else if (word == "crashed") {
    answer.form = Answer::Form::crashed;
  } else if (word == "garbage") {
    answer.form = Answer::Form::garbage;
  } else if (word == "timed_out") {
    answer.form = Answer::Form::timed_out;
  } else {
    return std::nullopt;
  }
  words.next();
  if (answer.form == Answer::Form::hit) read(words, {"hit", "t"}, answer.t);
  if (answer.form == Answer::Form::at) read(words, {"at", "point"}, answer.point);
  return answer;
}

/// Passes over the touches of a truth; were there any?
bool pass_touches(Words& words) {
  static constexpr std::array<std::string_view, 6> kinds = {"tangent", "rim", "apex",
                                                            "start",   "end", "within"};
  bool any = false;
  for (; words.peek() == "touch"; any = true) {
    words.next();
    const std::string_view kind = words.next();
    if (kind.empty()) throw Error("touch: expected its kind, got the end of the line");
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
      throw Error(unknown_name("kind of touch", kind, kinds));
    read_real(words, {"touch", "t"});
    if (kind == kinds.back()) read_real(words, {"touch", "last t"});
  }
  return any;
}

/// `invalid WHY` refuses the case as clearly as a miss does.
std::optional<Answer> read_refusal(Words& words) {
  if (words.peek() != "invalid") return std::nullopt;
  words.next();
  if (words.next().empty()) throw Error("invalid: expected why, got the end of the line");
  return Answer::miss();
}

/// What may still follow after what was read last.
std::string expected_after(const CaseLine& line, bool range, bool touched) {
  if (line.answer) return "expected nothing after the answer";
  const std::string answers = "`hit`, `at`, `yes`, `miss` or nothing after the ";
  if (touched) return "expected `touch`, " + answers + "touch";
  return range ? "expected " + answers + "range's 2 numbers"
               : "expected `range`, " + answers + "ray's 6 numbers";
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

template <class N>
void write(std::string& line, const Vec3<N>& vector) {
  for (const N* component : {&vector.x, &vector.y, &vector.z}) {
    if (component != &vector.x) line += ' ';
    rayaudit::write(line, *component);
  }
}

}  // namespace

CaseLine read_case_line(std::string_view line) {
  const std::size_t comment = comment_start(line);
  Words words(line.substr(0, comment));
  CaseLine read_line;
  Ray<double>& ray = read_line.question.ray;
  read_line.question.shape = read_shape(words);
  const std::string_view word = words.next();
  if (word != "ray")
    throw Error("expected `ray` after the " + numbers_of(read_line.question.shape) + ", got " +
                told(word));
  read(words, {"ray", "origin"}, ray.origin);
  read(words, {"ray", "direction"}, ray.direction);
  std::string_view rest = words.rest();
  const bool range = words.peek() == "range";
  if (range) {
    words.next();
    read(words, {"range", "t_min"}, ray.t_min);
    read(words, {"range", "t_max"}, ray.t_max);
    rest = words.rest();
  }
  read_line.words = line.substr(0, comment - rest.size());
  const bool touched = pass_touches(words);
  read_line.answer = touched ? std::nullopt : read_refusal(words);
  if (!read_line.answer) read_line.answer = read_answer(words);
  if (const std::string_view left = words.next(); !left.empty())
    throw Error(expected_after(read_line, range, touched) + ", got " + told(left));
  if (comment < line.size()) read_line.why = trimmed(line.substr(comment + 1));
  return read_line;
}

bool is_blank(std::string_view line) {
  return trimmed(line.substr(0, comment_start(line))).empty();
}

std::size_t comment_start(std::string_view line) { return std::min(line.find('#'), line.size()); }

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

void write(std::string& line, const Answer& answer) {
  switch (answer.form) {
    case Answer::Form::miss:
      line += "miss";
      break;
    case Answer::Form::yes:
      line += "yes";
      break;
    case Answer::Form::hit:
      line += "hit ";
      write(line, answer.t);
      break;
    case Answer::Form::at:
      line += "at ";
      write(line, answer.point);
      break;
    case Answer::Form::crashed:
      line += "crashed";
      break;
    case Answer::Form::garbage:
      line += "garbage";
      break;
    case Answer::Form::timed_out:
      line += "timed_out";
      break;
    case Answer::Form::unasked:
      line += "unasked";
      break;
  }
}

void write(std::string& line, const Case& question) {
  line += name(question.shape);
  std::visit(
      [&](const auto& shape) {
        std::apply([&](const auto&... part) { ((line += ' ', write(line, part)), ...); },
                   shape.parts());
      },
      question.shape);
  const Ray<double>& ray = question.ray;
  line += " ray ";
  write(line, ray.origin);
  line += ' ';
  write(line, ray.direction);
  const bool whole = ray.t_min == 0 && !std::signbit(ray.t_min) &&
                     ray.t_max == std::numeric_limits<double>::infinity();
  if (whole) return;
  line += " range ";
  write(line, ray.t_min);
  line += ' ';
  write(line, ray.t_max);
}

std::string case_line(const Case& question) {
  std::string line;
  write(line, question);
  return line;
}

}  // namespace rayaudit
