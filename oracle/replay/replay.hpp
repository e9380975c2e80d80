#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"
#include "geometry/format.hpp"

/// A routine run again on a case, the same text in other numbers: exactly, and in its own number
/// with every step watched. Nothing here knows the truth, or names an exact number.
namespace rayaudit::replay {

/// What is done to a case before it is answered exactly: vectors are brought to length 1, which no
/// case but one along an axis can be in floats. t stays in units of the direction as given.
enum class Repair : std::uint8_t { none, direction, normal, both };

/// The answer of a routine in exact numbers with square roots.
struct Exactly {
  enum class End : std::uint8_t {
    answered,
    undefined,  ///< it divided by 0, took the root of a negative number, or met a NaN
    given_up,   ///< past the work limit
  };

  End end = End::answered;
  Answer answer = {};               ///< its t to within 2^-90 of itself
  std::string_view undefined = {};  ///< in words, as "a division by 0"
};

/// One step of a run: an operation, or a comparison of a left and a right side. What is exactly so
/// is so of the numbers that the steps before it would have yielded without rounding.
struct Step {
  std::string_view file = {};  ///< below src, as routines/textbook.hpp
  int line = 0;
  std::string_view text = {};  ///< of that line
  std::string_view operation = {};
  bool compares = false;
  bool used = false;  ///< by a later operation of the same line
  Real value = {}, right = {};
  double bound = 0;      ///< of an operation: the proved bound of |value - exact|; may be infinite
  bool defined = false;  ///< whether the exact sides are known
  Real exact = {}, exact_right = {};
  int comparison = -1;  ///< the place of a comparison among all of the run, from 0
  bool said = false;    ///< how it was answered, forced ones as they were
  bool exactly = false;
  bool proved = false;  ///< whether its running bounds leave no other answer

  bool parts() const { return compares && defined && said != exactly; }
};

/// A run in the routine's own number.
struct Watched {
  Answer answer;
  std::vector<Step> steps;
};

enum class Wanted : std::uint8_t {
  parting,  ///< of all steps the comparisons alone that are answered otherwise than exactly so
  all,
};

/// A routine as it can be replayed, by shape; null where it does not answer the shape.
struct Replay {
  using AnswerExactly = Exactly (*)(const Case& question, Repair repair);
  /// The comparison of that number, counted from 0, is answered the other way; none where it is -1.
  using Watch = std::optional<Watched> (*)(const Case& question, int forced, Wanted wanted);

  std::string_view routine;
  std::array<AnswerExactly, shape_count> answer_exactly = {};
  std::array<std::array<Watch, shape_count>, 3> watch = {};  ///< in float, double, long double

  Exactly exactly(const Case& question, Repair repair = Repair::none) const {
    return answer_exactly[question.shape.index()](question, repair);
  }
  /// Nothing where the work is past the limit.
  std::optional<Watched> watched(const Case& question, const Format& format, int forced,
                                 Wanted wanted) const {
    const std::size_t number = format == float_format ? 0 : format == double_format ? 1 : 2;
    return watch[number][question.shape.index()](question, forced, wanted);
  }
};

/// The replay of a built-in subject, by its name, `routine/number`; null for any other.
const Replay* replay_of(std::string_view subject);

}  // namespace rayaudit::replay
