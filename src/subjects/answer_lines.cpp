#include "subjects/answer_lines.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"

namespace rayaudit {
namespace {

constexpr std::size_t longest_line = 1 << 16;
constexpr std::size_t most_comments = 100'000;

/// In the order of a case line: those of the shape come first.
std::vector<double> numbers_of(const Case& question) {
  std::vector<double> numbers;
  numbers.reserve(16);
  each_number(question, [&](double x) { numbers.push_back(x); });
  constexpr int of_ray = 6;
  std::rotate(numbers.begin(), numbers.begin() + of_ray, numbers.end());
  numbers.insert(numbers.end(), {question.ray.t_min, question.ray.t_max});
  return numbers;
}

bool is_same_number(double a, double b) { return a == b || (a != a && b != b); }

/// As numbers go: a NaN is one, and no zero has a sign.
bool is_same(const Case& a, const Case& b) {
  if (a.shape.index() != b.shape.index()) return false;
  const std::vector<double> of_a = numbers_of(a), of_b = numbers_of(b);
  return std::equal(of_a.begin(), of_a.end(), of_b.begin(), is_same_number);
}

/// Where a case differs from another of the same shape.
std::string told_difference(const Case& said, const Case& asked) {
  const std::vector<double> of_said = numbers_of(said), of_asked = numbers_of(asked);
  const auto [a, b] =
      std::mismatch(of_said.begin(), of_said.end(), of_asked.begin(), is_same_number);
  std::string text = "its number " + std::to_string(a - of_said.begin() + 1) + " came back as ";
  write(text, *a);
  text += ", not ";
  write(text, *b);
  return text;
}

}  // namespace

std::string AnswerLines::progress() const {
  return std::to_string(answered_) + " of " + std::to_string(cases_.size()) + " answers";
}

void AnswerLines::take(std::string_view piece) {
  for (std::size_t end; (end = piece.find('\n')) != piece.npos; piece.remove_prefix(end + 1)) {
    begun_ += piece.substr(0, end);
    take_line();
  }
  begun_ += piece;
  if (begun_.size() > longest_line) {
    ++number_;
    refuse(begun_, "it does not end");
  }
}

void AnswerLines::end() {
  if (!begun_.empty()) take_line();
  if (!is_complete())
    throw Fault{"ended after " + progress() + "; there is none to `" +
                case_line(cases_[answered_]) + "`"};
}

void AnswerLines::take_line() {
  const std::string line = std::exchange(begun_, {});
  ++number_;
  if (!is_blank(line)) return take_answer(line);
  if (++comments_ > most_comments)
    throw Fault{"printed over " + std::to_string(most_comments) +
                " lines that are blank or comments"};
}

void AnswerLines::take_answer(const std::string& line) {
  if (is_complete())
    refuse(line, std::to_string(cases_.size()) + " answers were asked for, this is one more");
  CaseLine read;
  try {
    read = read_case_line(line);
  } catch (const Error& fault) {
    refuse(line, fault.what());
  }
  if (!is_same(read.question, cases_[answered_])) refuse(line, told_other(read.question));
  if (!read.answer) refuse(line, "there is no answer after the case");
  answers_[answered_++] = *read.answer;
}

void AnswerLines::refuse(const std::string& line, const std::string& why) const {
  throw Fault{"printed, as line " + std::to_string(number_) + ", " + quotation(line) + ": " + why};
}

/// Another case came back than the one whose turn it is.
std::string AnswerLines::told_other(const Case& said) const {
  const auto told = [](std::size_t place) { return "case " + std::to_string(place + 1); };
  const auto found = std::find_if(cases_.begin(), cases_.end(),
                                  [&](const Case& each) { return is_same(each, said); });
  if (found != cases_.end())
    return "that is " + told(static_cast<std::size_t>(found - cases_.begin())) + " of " +
           std::to_string(cases_.size()) + " where it is the turn of " + told(answered_);
  const Case& due = cases_[answered_];
  const std::string turn = told(answered_) + " should come back as it was asked, but ";
  return turn + (said.shape.index() == due.shape.index() ? told_difference(said, due)
                                                         : "this has another shape");
}

}  // namespace rayaudit
