#include "geometry/case_line.hpp"

#include <algorithm>
#include <array>

#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

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

void read(Words& words, const NumberPlace& place, Real& number) {
  number = read_real(words.next(), place);
}
void read(Words& words, const NumberPlace& place, double& number) {
  number = read_double(words.next(), place);
}

template <class N>
void read(Words& words, const NumberPlace& place, Vec3<N>& vector) {
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

/// The word of an extent, where there is one.
Extent read_extent(Words& words, const Shape& shape) {
  const auto first = extent_words.begin() + 1;
  const auto found = std::find(first, extent_words.end(), words.peek());
  if (found == extent_words.end() || !has_extent(shape)) return Extent::bounded;
  words.next();
  return Extent{static_cast<std::uint8_t>(found - extent_words.begin())};
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

/// What must follow the words of the shape that were read.
std::string expected_after(const Case& question) {
  if (question.extent != Extent::bounded)
    return "`ray` after `" + std::string(word(question.extent)) + "`";
  return "`ray` after the " + numbers_of(question.shape);
}

/// The word of each form of an answer, in their order.
constexpr std::array<std::string_view, 8> form_words = {
    "miss", "hit", "at", "yes", "crashed", "garbage", "timed_out", "unasked"};

std::optional<Answer> read_answer(Words& words) {
  const auto word = std::find(form_words.begin(), form_words.end(), words.peek());
  if (word == form_words.end()) return std::nullopt;
  words.next();
  Answer answer = {.form = Answer::Form{static_cast<unsigned char>(word - form_words.begin())}};
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
    read_real(words.next(), {"touch", "t"});
    if (kind == kinds.back()) read_real(words.next(), {"touch", "last t"});
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
  read_line.question.extent = read_extent(words, read_line.question.shape);
  if (const std::string_view word = words.next(); word != "ray")
    throw Error("expected " + expected_after(read_line.question) + ", got " + told_word(word));
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
    throw Error(expected_after(read_line, range, touched) + ", got " + told_word(left));
  if (comment < line.size()) read_line.why = trimmed(line.substr(comment + 1));
  return read_line;
}

bool is_blank(std::string_view line) {
  return trimmed(line.substr(0, comment_start(line))).empty();
}

std::size_t comment_start(std::string_view line) { return std::min(line.find('#'), line.size()); }

void write(std::string& line, const Answer& answer) {
  line += form_words[static_cast<std::size_t>(answer.form)];
  if (answer.form == Answer::Form::hit) write(line += ' ', answer.t);
  if (answer.form == Answer::Form::at) write(line += ' ', answer.point);
}

void write(std::string& line, const Case& question) {
  line += name(question.shape);
  std::visit(
      [&](const auto& shape) {
        std::apply([&](const auto&... part) { ((line += ' ', write(line, part)), ...); },
                   shape.parts());
      },
      question.shape);
  if (question.extent != Extent::bounded && has_extent(question.shape))
    (line += ' ') += word(question.extent);
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
