#pragma once

#include "oracle/settle.hpp"

/// Of a line that lies in a patch: where, by signs alone.
namespace rayaudit::oracle {

/// An end of a stretch: that of the range, which may be none, or a root of a side condition.
struct StretchEnd {
  int side = -1;  ///< -1 for the range's
  Which which = Which::linear;
};

/// A stretch of a line, from first to last; empty until it is known not to be.
struct Stretch {
  bool empty = true;
  StretchEnd first = {}, last = {};
};

/// The part of a range where linear side conditions hold: each that rises may begin it, and each
/// that falls may end it.
template <class N, std::size_t sides, class R, class Sign>
class Narrowed {
 public:
  Narrowed(const std::array<Polynomial<N, 1>, sides>& side, const R& range, Sign& sign)
      : side_(side), range_(range), sign_(sign), has_{range.has_start, range.has_end} {}

  /// False where nothing is left.
  bool by(int i) {
    const int slope = sign_(side_[i].c[1]);
    if (slope == 0) return sign_(side_[i].c[0]) >= 0;
    const int which = slope > 0 ? 0 : 1;
    if (!has_[which] || within(i, which) > 0) end_[which] = i, has_[which] = true;
    return true;
  }

  Stretch stretch() const { return {is_empty(), {end_[0]}, {end_[1]}}; }

 private:
  /// The sign of what vanishes at the first (0) or last (1) end and is positive within, at the root
  /// of the i-th side condition.
  int within(int i, int which) const {
    const auto& [g0, g1] = side_[i].c;
    const LinearRoot<N, Sign> root{g0, g1, sign_(g1), sign_};
    if (end_[which] >= 0) return root.at(side_[end_[which]]);
    return root.at(which == 0 ? range_.above_start() : range_.below_end());
  }
  bool is_empty() const {
    if (!has_[0] || !has_[1]) return false;
    if (end_[0] >= 0) return within(end_[0], 1) < 0;
    return end_[1] >= 0 && within(end_[1], 0) < 0;
  }

  const std::array<Polynomial<N, 1>, sides>& side_;
  const R& range_;
  Sign& sign_;
  std::array<bool, 2> has_;
  std::array<int, 2> end_ = {-1, -1};
};

template <class S, class N, std::size_t sides, class R, class Sign>
Stretch stretch_of(const std::array<Polynomial<N, 1>, sides>& side, const R& range, Sign& sign,
                   Extent extent) {
  Narrowed<N, sides, R, Sign> narrowed(side, range, sign);
  for (int i = 0; i < static_cast<int>(sides); ++i)
    if (counts<S>(i, extent) && !narrowed.by(i)) return {};
  return narrowed.stretch();
}

/// The part of the range where a quadratic side condition holds that opens downward.
template <class N, class R, class Sign>
Stretch stretch_of(const Polynomial<N, 2>& g, const R& range, Sign& sign) {
  const int sign_d = sign(discriminant(g));
  if (sign_d < 0) return {};
  const auto root = [&](Which which) { return QuadraticRoot<N, Sign>{g, -1, which, sign}; };
  const Which smaller = sign_d == 0 ? Which::twofold : Which::smaller;
  const Which larger = sign_d == 0 ? Which::twofold : Which::larger;
  if (range.has_start && root(larger).at(range.above_start()) < 0) return {};
  if (range.has_end && root(smaller).at(range.below_end()) < 0) return {};
  const bool starts_inside = range.has_start && root(smaller).at(range.above_start()) < 0;
  const bool ends_inside = range.has_end && root(larger).at(range.below_end()) < 0;
  return {.empty = false,
          .first = starts_inside ? StretchEnd{} : StretchEnd{0, smaller},
          .last = ends_inside ? StretchEnd{} : StretchEnd{0, larger}};
}

template <class S, class N, class R, class Sign>
Stretch stretch_of(const std::array<Polynomial<N, 2>, 1>& side, const R& range, Sign& sign,
                   Extent extent) {
  if (counts<S>(0, extent)) return stretch_of(side[0], range, sign);
  return {.empty = false};
}

/// The side condition of a cap: within its edge the lateral field is not positive.
template <class N>
Polynomial<N, 2> edge_of_cap(const Polynomial<N, 2>& field) {
  return {{-field.c[0], -field.c[1], -field.c[2]}};
}

/// The part of the range where a line lies in a patch.
template <class S, class P, class R, class Sign>
Stretch stretch_of(const P& patch, const Outline& outline, const R& range, Sign& sign,
                   Extent extent) {
  if constexpr (caps<S> != 0)
    if (outline.patch != 0) return stretch_of(edge_of_cap(patch.field), range, sign);
  return stretch_of<S>(patch.side, range, sign, extent);
}

}  // namespace rayaudit::oracle
