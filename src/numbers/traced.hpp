#pragma once

#include <string_view>
#include <vector>

#include "numbers/running_bound.hpp"

namespace rayaudit {

template <class N, class X>
struct Trace;

/// A number that a routine runs in as it does in N, and beside it in X, which is exact or nearly
/// so: the steps of the run, and above all its comparisons, are noted with their place in the
/// source. Comparisons are answered as N answers them; one of them may be forced the other way.
///
/// X has + - * /, unary minus and sqrt, and stands also for a number without a value, as after the
/// root of a negative one: rounding may lead a run where no exact number goes.
template <class N, class X>
struct Traced {
  RunningBound<N> near;
  X exact;
  int step =
      -1;  ///< the place of its step in the trace; -1 for a number of the case, or a constant

  explicit Traced(int x) : near(x), exact(x) {}
  explicit Traced(double x) : near(x), exact(x) {}
  Traced(const RunningBound<N>& value, const X& exactly) : near(value), exact(exactly) {}

  /// A number as the right side of an operation: its conversion knows the line that it stands on.
  struct Here {
    const Traced& number;
    int line;
    const char* file;

    Here(const Traced& x, int at_line = __builtin_LINE(), const char* in_file = __builtin_FILE())
        : number(x), line(at_line), file(in_file) {}
  };

  friend Traced operator+(const Traced& a, const Here& b) {
    return noted("+", &a, b, {a.near + b.number.near, a.exact + b.number.exact});
  }
  friend Traced operator-(const Traced& a, const Here& b) {
    return noted("-", &a, b, {a.near - b.number.near, a.exact - b.number.exact});
  }
  friend Traced operator*(const Traced& a, const Here& b) {
    return noted("*", &a, b, {a.near * b.number.near, a.exact * b.number.exact});
  }
  friend Traced operator/(const Traced& a, const Here& b) {
    return noted("/", &a, b, {a.near / b.number.near, a.exact / b.number.exact});
  }
  friend Traced operator-(const Here& a) {
    return noted("-", nullptr, a, {-a.number.near, -a.number.exact});
  }
  friend Traced sqrt(const Here& a) {
    return noted("sqrt", nullptr, a, {sqrt(a.number.near), sqrt(a.number.exact)});
  }

  // C++20 also tries a == b the other way round, so both sides are of one type.
  friend bool operator==(const Here& a, const Here& b) {
    return decided("==", a.number, b, [&] { return a.number.near == b.number.near; });
  }
  friend bool operator<(const Traced& a, const Here& b) {
    return decided("<", a, b, [&] { return a.near < b.number.near; });
  }
  friend bool operator>(const Traced& a, const Here& b) {
    return decided(">", a, b, [&] { return a.near > b.number.near; });
  }
  friend bool operator<=(const Traced& a, const Here& b) {
    return decided("<=", a, b, [&] { return a.near <= b.number.near; });
  }
  friend bool operator>=(const Traced& a, const Here& b) {
    return decided(">=", a, b, [&] { return a.near >= b.number.near; });
  }

 private:
  static Traced noted(const char* operation, const Traced* left, const Here& right, Traced value) {
    Trace<N, X>::of_thread().note(operation, left, right, value);
    return value;
  }
  template <class Comparison>
  static bool decided(const char* sign, const Traced& left, const Here& right,
                      const Comparison& comparison) {
    RunningBound<N>::all_proved = true;
    const bool said = comparison();
    return Trace<N, X>::of_thread().decide(sign, left, right, said, RunningBound<N>::all_proved);
  }
};

/// What a run left behind, in the thread that it ran in.
template <class N, class X>
struct Trace {
  using Number = Traced<N, X>;

  struct Step {
    const char* file;
    int line;
    const char* operation;
    Number value;  ///< of a comparison its left side
    Number right;  ///< of a comparison, else as value
    bool compares;
    bool said = false;    ///< how a comparison was answered
    bool proved = false;  ///< whether the bound of N leaves no other answer
    bool used = false;    ///< by another step of the same line, one after the other
  };

  bool wants_all = false;  ///< else comparisons alone are kept
  int forced = -1;         ///< which comparison is to be answered the other way, from 0
  int compared = 0;        ///< how many there have been
  std::vector<Step> steps;

  static Trace& of_thread() {
    static thread_local Trace trace;
    return trace;
  }

  void begin(bool all, int to_force) {
    wants_all = all, forced = to_force, compared = 0;
    line_begins_ = 0;
    steps.clear();
  }

  void note(const char* operation, const Number* left, const typename Number::Here& right,
            Number& value) {
    if (!wants_all) return;
    enter_line(right);
    if (left != nullptr) use(*left);
    use(right.number);
    value.step = static_cast<int>(steps.size());
    steps.push_back({right.file, right.line, operation, value, value, false});
  }

  bool decide(const char* sign, const Number& left, const typename Number::Here& right, bool said,
              bool proved) {
    if (wants_all) enter_line(right), use(left), use(right.number);
    const bool answer = (compared++ == forced) != said;
    steps.push_back({right.file, right.line, sign, left, right.number, true, answer, proved});
    return answer;
  }

 private:
  void enter_line(const typename Number::Here& here) {
    if (steps.empty() || steps.back().file != here.file || steps.back().line != here.line)
      line_begins_ = static_cast<int>(steps.size());
  }
  void use(const Number& number) {
    if (number.step >= line_begins_) steps[number.step].used = true;
  }

  int line_begins_ = 0;
};

}  // namespace rayaudit
