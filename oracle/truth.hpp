#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "geometry/case.hpp"
#include "geometry/format.hpp"
#include "geometry/real.hpp"

/// The exact truth of a case. Nothing behind this header rounds a decision, and nothing before it
/// needs CGAL.
namespace rayaudit::oracle {

/// Why a case is no question of truth at all. Where several apply, the first in this list names it.
enum class Invalid : std::uint8_t {
  no,
  nan,             ///< a number is NaN
  infinite,        ///< a number other than t_min, t_max is infinite
  zero_direction,  ///< d = 0
  zero_normal,     ///< n = 0
  zero_axis,       ///< a = b
  radius,          ///< r <= 0
  empty_range,     ///< t_min >= t_max
};
std::string_view name(Invalid invalid);

/// What a crossing is: proper, when every small enough change of the case keeps it, else a touch.
/// Where several kinds of touch apply, the later in this list names it.
enum class Kind : std::uint8_t {
  proper,
  tangent,  ///< a double root
  rim,     ///< a side condition is exactly 0; of a closed shape, an edge that the line only touches
  apex,    ///< the line passes outside the cone at its apex, or from one nappe into the other where
           ///< both count: it stays on its side of the surface
  start,   ///< t is exactly t_min
  end,     ///< t is exactly t_max
  within,  ///< the ray lies in the surface, from t to t_last
};
std::string_view name(Kind kind);

struct Crossing {
  Kind kind = Kind::proper;
  Real t = {};
  Real t_last = {};  ///< of a within: where the stretch ends, which may be infinite; else t
  /// The patch that it lies on: 0, or of a closed shape's cap one more than the number of the side
  /// condition that the cap closes. An edge is its cap's.
  std::uint8_t patch = 0;
};

/// Which arithmetic decided: numbers of two words in lanes, of three, CGAL's intervals, integers of
/// a fixed width, or exact numbers of any.
enum class Stage : std::uint8_t { lanes, wide_lanes, interval, integers, exact };
inline constexpr std::size_t stage_count = 5;
std::string_view name(Stage stage);

/// The crossings up to and including the first proper one, in order along the ray. Acceptable are
/// that proper hit (a miss where there is none), or any touch before it.
struct Truth {
  static constexpr int most = 2;  ///< crossings: every shape is of degree 2, or convex and closed
  static constexpr int most_roots = 4;  ///< real roots, over all patches of a shape

  Invalid invalid = Invalid::no;
  Stage stage = Stage::lanes;
  std::uint8_t count = 0;
  std::array<Crossing, most> listed = {};
  /// The other real roots of F on the line, to 2^-60, where they came at no price; a subject may
  /// have answered one of those.
  bool others_known = false;
  std::uint8_t other_count = 0;
  std::array<Real, most_roots> other_roots = {};

  std::span<const Crossing> crossings() const& { return {listed.data(), count}; }
  void crossings() const&& = delete;  ///< would not outlive the truth
  std::span<const Real> others() const& { return {other_roots.data(), other_count}; }
  void others() const&& = delete;
  /// The first proper crossing, or null where the truth is a miss.
  const Crossing* hit() const& {
    return count > 0 && listed[count - 1].kind == Kind::proper ? &listed[count - 1] : nullptr;
  }
  bool has_touch() const { return count > (hit() ? 1 : 0); }
  /// Back to a miss; what lies behind the counts may stay.
  void clear() {
    invalid = Invalid::no, stage = Stage::lanes;
    count = other_count = 0;
    others_known = false;
  }
};

/// The bits to which t must be known for answers in a format: 2^-10 ulp.
constexpr int bits_for(const Format& format) { return format.precision + 10; }

/// Settles every case: truths[i] is the truth of cases[i], each t within 2^-bits |t|, bits at most
/// 150. Never undecided, for any doubles whatever; invalid cases are told apart and named. Throws
/// UnfitArithmetic (oracle/environment.hpp) in a thread that does not compute as IEEE 754 has it.
void truth(std::span<const Case> cases, std::span<Truth> truths,
           int bits = bits_for(double_format));
Truth truth(const Case& question, int bits = bits_for(double_format));

/// How a real root of F, or of a cap's field, stands on its ray.
enum class Standing : std::uint8_t {
  acceptable,  ///< a crossing of the truth
  later,       ///< a crossing, but behind the first proper one
  behind,      ///< t < t_min
  past,        ///< t > t_max
  clipped,     ///< a side condition is negative; of a cap's: outside its edge
  mirrored,    ///< on the cone's other nappe
};
std::string_view name(Standing standing);

struct Root {
  Real t = {};
  Standing standing = Standing::acceptable;
  Kind kind = Kind::proper;  ///< of a crossing
};

/// Every real root of F, and of a closed shape's caps, along the whole line, in order (a double
/// root once, and one at an edge once), each t within 2^-bits |t|; none where the line lies in a
/// patch. The case must be valid. Slower than truth.
struct Roots {
  bool constant = false;  ///< F is the same all along the line, or a cap's field 0 all along
  std::uint8_t count = 0;
  std::array<Root, Truth::most_roots> listed = {};

  std::span<const Root> roots() const& { return {listed.data(), count}; }
  void roots() const&& = delete;  ///< would not outlive this
};
Roots roots(const Case& question, int bits = bits_for(double_format));

/// The t of a crossing of this case's truth, rounded to nearest (ties to even) in the number N:
/// float, double or long double; an infinity or a subnormal where N has it so. Always correct.
template <class N>
N rounded(const Case& question, const Crossing& crossing);
/// The same of where a stretch within the surface ends.
template <class N>
N rounded_last(const Case& question, const Crossing& crossing);

/// The t of a crossing in words: a closed form (`(3 + sqrt(5)) / 2`) where it is short enough to
/// read, else nothing; and in decimals, to the given number of significant digits.
struct Spelled {
  std::optional<std::string> closed_form;
  std::string decimals;
  bool terminates;  ///< the decimals are all there are
};
Spelled spelled(const Case& question, const Crossing& crossing, int digits);
Spelled spelled_last(const Case& question, const Crossing& crossing, int digits);

}  // namespace rayaudit::oracle
