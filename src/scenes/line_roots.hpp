#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"
#include "oracle/truth.hpp"

namespace rayaudit {

/// Calls visit(i, truth) for each of the cases in order, all of one shape; t known to bits_for the
/// format.
template <class Visit>
void each_truth(std::span<const Case> cases, const Format& format, const Visit& visit) {
  constexpr std::size_t portion = 128;  // stays in the nearest caches
  std::vector<oracle::Truth> truths(std::min(portion, cases.size()));
  for (std::size_t first = 0; first < cases.size(); first += portion) {
    const std::size_t size = std::min(portion, cases.size() - first);
    oracle::truth(cases.subspan(first, size), {truths.data(), size}, oracle::bits_for(format));
    for (std::size_t i = 0; i < size; ++i) visit(first + i, truths[i]);
  }
}

/// The real roots of F along the whole line of a case, in order, each to nearest; none of a ray
/// that lies in the surface, nor of an invalid case.
struct LineRoots {
  static constexpr int none = -1;

  std::array<double, oracle::Truth::most_roots> t = {};
  int count = 0;

  /// The place of the root nearest to t.
  int nearest(double to) const;
  /// Where a ray that left the surface left it: the root nearest to 0.
  int departure() const { return nearest(0); }
};

/// Of a case with its truth, which tells the roots but in rare cases.
LineRoots line_roots(const Case& question, const oracle::Truth& truth);

/// The t that an answer tells; nothing of one that tells none.
std::optional<double> claimed_t(const Case& question, const Answer& answer);

/// The length of t in units of the ray's direction, in the world.
double world_length(const Ray<double>& ray, double t);

/// How far off in the world a ray is told, within its range, to meet the surface that it leaves
/// just where it leaves it; nothing where it is not told so. A surface that the line has no point
/// in common with is met nowhere else.
std::optional<double> self_intersection(const Case& question, const oracle::Truth& truth,
                                        const Answer& answer);

}  // namespace rayaudit
