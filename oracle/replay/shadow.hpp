#pragma once

#include <optional>
#include <string_view>

#include "numbers/wide_bound.hpp"
#include "oracle/replay/surd.hpp"

namespace rayaudit::replay {

/// How two exact numbers compare: open where the number does not tell, undefined where one of them
/// has no value.
enum class Order : signed char { less = -1, equal = 0, greater = 1, open, undefined };

inline bool holds(std::string_view sign, Order order) {
  if (order == Order::equal) return sign == "==" || sign == "<=" || sign == ">=";
  return sign[0] == (order == Order::less ? '<' : '>');
}

/// The exact number that goes beside a traced one. A run that rounding led astray may take the root
/// of a negative number: then it has no value from there on, but the run goes on.
template <class X>
class Shadow;

template <>
class Shadow<Surd> {
 public:
  explicit Shadow(int x) : value_(Surd(x)) {}
  explicit Shadow(double x) : Shadow([&] { return Surd(x); }) {}

  friend Shadow operator+(const Shadow& a, const Shadow& b) {
    return of(a, b, [&] { return *a.value_ + *b.value_; });
  }
  friend Shadow operator-(const Shadow& a, const Shadow& b) {
    return of(a, b, [&] { return *a.value_ - *b.value_; });
  }
  friend Shadow operator*(const Shadow& a, const Shadow& b) {
    return of(a, b, [&] { return *a.value_ * *b.value_; });
  }
  friend Shadow operator/(const Shadow& a, const Shadow& b) {
    return of(a, b, [&] { return *a.value_ / *b.value_; });
  }
  friend Shadow operator-(const Shadow& a) {
    return of(a, a, [&] { return -*a.value_; });
  }
  friend Shadow sqrt(const Shadow& a) {
    return of(a, a, [&] { return sqrt(*a.value_); });
  }

  friend Order order_of(const Shadow& a, const Shadow& b) {
    if (!a.value_ || !b.value_) return Order::undefined;
    return *a.value_ < *b.value_    ? Order::less
           : *a.value_ == *b.value_ ? Order::equal
                                    : Order::greater;
  }
  friend std::optional<Real> value_of(const Shadow& x) {
    if (!x.value_) return {};
    return x.value_->value();
  }

 private:
  /// What an operation yields, where it yields anything.
  template <class Operation>
  explicit Shadow(const Operation& operation) {
    try {
      value_ = operation();
    } catch (const Undefined&) {
    }
  }
  template <class Operation>
  static Shadow of(const Shadow& a, const Shadow& b, const Operation& operation) {
    if (!a.value_ || !b.value_) return {};
    return Shadow(operation);
  }
  Shadow() = default;

  std::optional<Surd> value_;
};

template <>
class Shadow<WideBound> {
  using Number = WideBound;

 public:
  explicit Shadow(int x) : value_(x) {}
  explicit Shadow(double x) : value_(x) {}

  friend Shadow operator+(const Shadow& a, const Shadow& b) { return a.value_ + b.value_; }
  friend Shadow operator-(const Shadow& a, const Shadow& b) { return a.value_ - b.value_; }
  friend Shadow operator*(const Shadow& a, const Shadow& b) { return a.value_ * b.value_; }
  friend Shadow operator/(const Shadow& a, const Shadow& b) { return a.value_ / b.value_; }
  friend Shadow operator-(const Shadow& a) { return -a.value_; }
  friend Shadow sqrt(const Shadow& a) { return sqrt(a.value_); }

  friend Order order_of(const Shadow& a, const Shadow& b) {
    Number::all_proved = true;
    const bool less = a.value_ < b.value_;
    if (!Number::all_proved) return Order::open;
    return less ? Order::less : a.value_ == b.value_ ? Order::equal : Order::greater;
  }
  friend std::optional<Real> value_of(const Shadow& x) {
    return Real{x.value_.value.high, x.value_.value.low, 0, 0};
  }

 private:
  Shadow(const Number& value) : value_(value) {}

  Number value_;
};

}  // namespace rayaudit::replay
