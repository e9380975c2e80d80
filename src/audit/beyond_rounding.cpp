#include "audit/beyond_rounding.hpp"

#include <algorithm>
#include <cmath>

#include "subjects/peer.hpp"

namespace rayaudit {
namespace {

/// Is the textbook right there? What is declared to be a miss it takes; how far off its t may be,
/// its bound tells.
bool is_right(Settled& settled, const Answer& answer, const Format& format,
              const Convention& convention) {
  const Judgement judgement = judge(settled, answer, format, convention);
  return !is_wrong(judgement.verdict) || judgement.verdict == Verdict::wrong_t ||
         judgement.claim == Claim::declined;
}

/// How much more the opening of a cone moves than what it is told by: an angle, or its cosine.
double told_worse(const Case& question, const Convention& convention) {
  const auto* cone = std::get_if<Cone<double>>(&question.shape);
  if (cone == nullptr || convention.opening == Convention::Opening::radius) return 1;
  const Vec3<double> axis = cone->apex - cone->base;
  const double square = cone->radius * cone->radius / dot(axis, axis);
  return convention.opening == Convention::Opening::angle ? 1 + square : 1 + 1 / square;
}

/// Is the point that is told as near to the exact one as rounding its coordinates, and those of
/// where the ray begins, takes it? Its t may be off by any share of itself where that is small.
bool is_near_point(Settled& settled, const Answer& answer, const Judgement& judgement,
                   const Format& format) {
  if (answer.form != Answer::Form::at || judgement.crossing < 0) return false;
  const auto& [origin, direction, t_min, t_max] = settled.question().ray;
  const double t = nearest<double>(settled.truth().crossings()[judgement.crossing].t);
  const double length = std::hypot(direction.x, direction.y, direction.z);
  const double off = judgement.relative * std::fabs(t) * length;
  double size = std::max({std::fabs(origin.x), std::fabs(origin.y), std::fabs(origin.z)});
  for (const Real& x : {answer.point.x, answer.point.y, answer.point.z})
    size = std::max(size, std::fabs(nearest<double>(x)));
  return off <= std::ldexp(beyond_rounding_margin * size, format.unit_exponent());
}

/// Is an answer wrong by more than rounding the case, or what is told of it, might do?
bool is_far_off(Settled& settled, const Answer& answer, const Judgement& judgement, double margin,
                const Format& format, const Convention& convention) {
  const double least = beyond_rounding_margin * told_worse(settled.question(), convention);
  switch (judgement.verdict) {
    case Verdict::crashed:
    case Verdict::timed_out:
    case Verdict::not_finite:
      return true;
    case Verdict::invalid_mishandled:
      return false;
    case Verdict::wrong_t:
      return judgement.own > least && !is_near_point(settled, answer, judgement, format);
    default:
      return margin > least;
  }
}

/// Does that power of each of its numbers stay in the range of the format's normal numbers?
bool has_powers(const Case& question, int power, const Format& format) {
  bool all = true;
  each_number(question, [&](double x) {
    const int exponent = x == 0 ? 0 : std::ilogb(x);
    all = all && power * exponent >= format.min_exponent &&
          power * (exponent + 1) - 1 < format.max_exponent;
  });
  return all;
}

/// Is a t further off than that of the textbook could be?
bool is_further_off(Settled& settled, const Judgement& judgement, const Peer& peer) {
  const oracle::Crossing& crossing = settled.truth().crossings()[judgement.crossing];
  return judgement.relative * std::fabs(nearest<double>(crossing.t)) > peer.bound;
}

}  // namespace

bool is_beyond_rounding(Settled& settled, const Answer& answer, const Judgement& judgement,
                        double margin, const Format& format, const Convention& convention) {
  // A hit past the end of a range that was declared for it is told as a contract.
  if (judgement.claim == Claim::past) return false;
  if (!is_far_off(settled, answer, judgement, margin, format, convention)) return false;
  // Nobody need do without a length, nor without what the field of a cone is made of; but for all
  // that nobody need end.
  const bool is_missing = !answer.is_given();
  if (!has_powers(settled.question(), is_missing ? 2 : 4, format)) return false;
  const Peer peer = by_textbook(settled.question(), format);
  if (!peer.is_sure || !is_right(settled, peer.answer, format, convention)) return false;
  return judgement.verdict != Verdict::wrong_t || is_further_off(settled, judgement, peer);
}

}  // namespace rayaudit
