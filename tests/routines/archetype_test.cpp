#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "known.hpp"
#include "routines/routines.hpp"

using namespace rayaudit;

namespace {

/// A number with no more than a routine may ask for: + - * /, unary minus, sqrt, order, and a
/// constant said aloud. Counts what an exact number could not do.
class Archetype {
 public:
  static inline int undefined = 0;  ///< divisions by zero and roots of numbers below 0

  explicit Archetype(int constant) : number_(constant) {}
  explicit Archetype(double constant) : number_(constant) {}

  friend Archetype operator+(const Archetype& a, const Archetype& b) {
    return Archetype(a.number_ + b.number_);
  }
  friend Archetype operator-(const Archetype& a, const Archetype& b) {
    return Archetype(a.number_ - b.number_);
  }
  friend Archetype operator*(const Archetype& a, const Archetype& b) {
    return Archetype(a.number_ * b.number_);
  }
  friend Archetype operator/(const Archetype& a, const Archetype& b) {
    undefined += b.number_ == 0;
    return Archetype(a.number_ / b.number_);
  }
  friend Archetype operator-(const Archetype& a) { return Archetype(-a.number_); }
  friend Archetype sqrt(const Archetype& a) {
    undefined += a.number_ < 0;
    return Archetype(std::sqrt(a.number_));
  }

  friend bool operator==(const Archetype& a, const Archetype& b) { return a.number_ == b.number_; }
  friend bool operator<(const Archetype& a, const Archetype& b) { return a.number_ < b.number_; }
  friend bool operator>(const Archetype& a, const Archetype& b) { return a.number_ > b.number_; }
  friend bool operator<=(const Archetype& a, const Archetype& b) { return a.number_ <= b.number_; }
  friend bool operator>=(const Archetype& a, const Archetype& b) { return a.number_ >= b.number_; }

 private:
  double number_;
};

template <class N>
std::optional<Archetype> in_archetype(const std::optional<N>& t) {
  if (!t) return {};
  return Archetype(*t);
}
template <class N>
std::optional<Vec3<Archetype>> in_archetype(const std::optional<Vec3<N>>& point) {
  if (!point) return {};
  return in<Archetype>(*point);
}
bool in_archetype(bool met) { return met; }

}  // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(a_routine_runs_in_a_number_that_has_nothing_else, Routine, Routines) {
  int answered = 0;
  for (const std::string_view text : known::in_general_position) {
    const Case question = read_case_line(text).question;
    known::visit_in<Routine, Archetype>(question, [&](const auto& ray, const auto& shape) {
      known::visit_in<Routine, double>(question, [&](const auto& plain_ray, const auto& plain) {
        if constexpr (std::is_same_v<decltype(in<Archetype>(plain)), std::decay_t<decltype(shape)>>)
          BOOST_TEST((Routine()(ray, shape) == in_archetype(Routine()(plain_ray, plain))), text);
        ++answered;
      });
    });
  }
  BOOST_TEST(answered > 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_routine_asks_for_nothing_undefined, Routine, Routines) {
  if (std::is_same_v<Routine, Handout>) return;
  for (const known::Lines& lines : known::all_exact)
    for (const std::string_view text : lines) {
      Archetype::undefined = 0;
      known::visit_in<Routine, Archetype>(
          read_case_line(text).question,
          [](const auto& ray, const auto& shape) { (void)Routine()(ray, shape); });
      BOOST_TEST(Archetype::undefined == 0, text);
    }
}
