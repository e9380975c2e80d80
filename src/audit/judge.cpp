#include "audit/judge.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace rayaudit {
namespace {

/// The bits to which the roots of a case are asked for; and where a comparison hangs on them.
constexpr int sharp = 90, sharpest = 150;

using oracle::Crossing;
using oracle::Kind;
using oracle::Standing;

Claim claim_of(Standing standing) {
  switch (standing) {
    case Standing::behind:
      return Claim::behind;
    case Standing::past:
      return Claim::past;
    case Standing::clipped:
      return Claim::clipped;
    case Standing::mirrored:
      return Claim::mirrored;
    case Standing::later:
      return Claim::later;
    case Standing::acceptable:
      return Claim::declined;
  }
  return Claim::none;
}

Real absolute(const Real& x) {
  return sign(x) < 0 ? Real{-x.high, -x.middle, -x.low, x.exponent} : x;
}

Real gap(const Real& a, const Real& b) { return absolute(difference(a, b)); }

/// The exact t that an answer is held against: that of the crossing; of a stretch the nearest,
/// which is the answer itself inside.
Real exact_t(const Real& t, const Crossing& crossing) {
  if (crossing.kind != Kind::within || compare(t, crossing.t) < 0) return crossing.t;
  return compare(t, crossing.t_last) > 0 ? crossing.t_last : t;
}

Real gap(const Real& t, const Crossing& crossing) { return gap(t, exact_t(t, crossing)); }

/// x / y for y != 0, where neither need be in the range of double.
double ratio(const Real& x, const Real& y) {
  const auto is_plain = [](const Real& a) {  // high says all of it that a double can
    const double size = std::fabs(a.high);
    return a.low == 0 && a.high + a.middle == a.high && size > 0x1p-400 && size < 0x1p400;
  };
  if (x.exponent == y.exponent && is_plain(x) && is_plain(y))
    return std::fabs(x.high) / std::fabs(y.high);
  const int e = binade(y);
  return scaled(x, e) / scaled(y, e);
}

/// By how much one gap is smaller than another, relatively to the largest of both and t, to whose
/// size the roots are known.
double lead(const Real& gap, const Real& other, const Real& t) {
  const Real by = difference(other, gap);
  const int way = sign(by);
  if (way == 0) return 0;
  const Real &larger = way > 0 ? other : gap, size = absolute(t);
  return way * ratio(by, compare(larger, size) < 0 ? size : larger);
}

/// What tells a gap from another where the roots are known to so many bits.
double least_lead(int bits) { return std::ldexp(1.0, 10 - bits); }

/// The root of F nearest to t, among all there are, and whether it is sure to be.
struct Nearest {
  const oracle::Root* root = nullptr;
  bool sure = true;

  Nearest(const oracle::Roots& roots, const Real& t, int bits) {
    for (const oracle::Root& other : roots.roots())
      if (root == nullptr || compare(gap(t, other.t), gap(t, root->t)) < 0) root = &other;
    for (const oracle::Root& other : roots.roots())
      if (&other != root && lead(gap(t, root->t), gap(t, other.t), t) < least_lead(bits))
        sure = false;
  }
};

bool is_far(const Real& t, const Real& exact) {
  return sign(t) == 0 ? sign(exact) != 0
                      : sign(exact) == 0 || ratio(gap(t, exact), exact) > wrong_t_limit;
}

/// What there is at a t that is not acceptable.
Claim claim_at(Settled& settled, const Real& t) {
  if (is_nan(t)) return Claim::nan;
  if (is_infinite(t)) return Claim::infinite;
  const auto claim = [&](const Nearest& nearest) {
    if (nearest.root == nullptr && settled.roots().constant) return Claim::parallel;
    return nearest.root == nullptr || is_far(t, nearest.root->t) ? Claim::no_root
                                                                 : claim_of(nearest.root->standing);
  };
  if (const Nearest nearest(settled.roots(), t, sharp); nearest.sure) return claim(nearest);
  const oracle::Roots roots = oracle::roots(settled.question(), sharpest);
  return claim({roots, t, sharpest});
}

/// What a bare yes can have meant where no hit is acceptable: the last root along the line.
Claim claim_of_yes(Settled& settled) {
  const auto roots = settled.roots().roots();
  if (!roots.empty()) return claim_of(roots.back().standing);
  return settled.roots().constant ? Claim::parallel : Claim::no_root;
}

/// The t that an answer claims, to 2^-bits; NaN for a point that is not finite.
Real claimed_t(const Case& question, const Answer& answer, int bits) {
  if (answer.form == Answer::Form::hit) return answer.t;
  const auto& [x, y, z] = answer.point;
  if (!is_finite(x) || !is_finite(y) || !is_finite(z))
    return {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};
  return oracle::projection(question.ray, answer.point, bits);
}

/// fl(o + t d), every operation rounded in N.
template <class N>
Vec3<Real> point_in(const Ray<double>& ray, const Real& t) {
  const N at = nearest<N>(t);
  const auto component = [&](double o, double d) {
    const N step = at * static_cast<N>(d);
    return real(static_cast<N>(static_cast<N>(o) + step));
  };
  return {component(ray.origin.x, ray.direction.x), component(ray.origin.y, ray.direction.y),
          component(ray.origin.z, ray.direction.z)};
}

Vec3<Real> point_of(const Case& question, const Answer& answer, const Format& format) {
  if (answer.form == Answer::Form::at) return answer.point;
  if (format == float_format) return point_in<float>(question.ray, answer.t);
  if (format == double_format) return point_in<double>(question.ray, answer.t);
  return point_in<long double>(question.ray, answer.t);
}

/// Where the rounded point of a hit lies; not measured in formats wider than a long double.
void measure_point(Judgement& judgement, Settled& settled, const Answer& answer,
                   const Format& format) {
  if (format.precision > long_double_format.precision) return;  // no number here to round it in
  const Case& question = settled.question();
  const Vec3<Real> point = point_of(question, answer, format);
  if (!is_finite(point.x) || !is_finite(point.y) || !is_finite(point.z)) return;
  Real largest = absolute(point.x);
  for (const Real& coordinate : {absolute(point.y), absolute(point.z)})
    if (compare(largest, coordinate) < 0) largest = coordinate;
  const Crossing& crossing = settled.truth().crossings()[judgement.crossing];
  const oracle::Position position = oracle::position(question.shape, point, crossing.patch);
  if (!is_nan(position.distance))
    judgement.distance = scaled(position.distance, spacing_exponent(largest, format));
  if (crossing.kind == Kind::within) return;
  const int before = settled.sensitivity(judgement.crossing).sign_before;
  judgement.side = position.sign_of_field == 0        ? Side::on
                   : position.sign_of_field == before ? Side::before
                                                      : Side::beyond;
}

/// How far a t is from the exact one.
struct Off {
  Real by, exact;
  bool none;    ///< not at all
  int spacing;  ///< the exponent of an ulp
  double ulps;

  Off(const Real& off, const Real& exactly, const Format& format)
      : by(off),
        exact(exactly),
        none(sign(off) == 0),
        spacing(spacing_exponent(exactly, format)),
        ulps(none ? 0 : scaled(off, spacing)) {}
};

/// The errors of a t that was held against a crossing.
void measure(Judgement& judgement, Settled& settled, const Answer& answer, const Off& off,
             const Format& format) {
  const Crossing& crossing = settled.truth().crossings()[judgement.crossing];
  judgement.ulps = off.ulps;
  if (off.none)
    judgement.relative = 0;
  else if (sign(off.exact) != 0)
    judgement.relative = ratio(off.by, off.exact);
  if (crossing.kind != Kind::within) {
    const Real& forced = settled.sensitivity(judgement.crossing).forced;
    if (is_finite(forced)) {
      // Where every number that t hangs on is 0, rounding the case does nothing to it.
      const double times = off.none            ? 0
                           : sign(forced) == 0 ? std::numeric_limits<double>::infinity()
                                               : ratio(off.by, forced);
      judgement.forced = std::ldexp(times, -format.unit_exponent());
      judgement.own = std::fmin(judgement.forced, judgement.ulps);
      judgement.condition = scaled(forced, off.spacing - format.unit_exponent());
    }
  }
  measure_point(judgement, settled, answer, format);
}

/// How the root stands that is not acceptable and yet nearer to t than every acceptable one, if
/// there is one. The roots are asked for again, so sharp that only an exact tie is left open, where
/// it takes that; an acceptable root wins those.
std::optional<Standing> nearer_elsewhere(Settled& settled, const Choices& choices,
                                         const Answer& answer) {
  for (const int bits : {sharp, sharpest}) {
    const Real t = claimed_t(settled.question(), answer, bits);
    const oracle::Roots roots =
        bits == sharp ? settled.roots() : oracle::roots(settled.question(), bits);
    std::optional<Real> accepted, refused;
    Standing standing = {};
    int crossing = 0;
    for (const oracle::Root& root : roots.roots()) {
      const Real off = gap(t, root.t);
      const bool listed = root.standing == Standing::acceptable;
      const bool is_accepted = listed && choices.accepts(crossing++);
      std::optional<Real>& nearest = is_accepted ? accepted : refused;
      if (nearest && compare(off, *nearest) >= 0) continue;
      nearest = off;
      if (!is_accepted) standing = root.standing;
    }
    if (!accepted || !refused) return {};
    const double by = lead(*refused, *accepted, t);
    if (by > least_lead(bits)) return standing;
    if (by < -least_lead(bits)) return {};
  }
  return {};
}

/// Is no root that is not acceptable anywhere near as close to t as the accepted gap? Answered from
/// what the truth knows; false where it takes sharper roots to tell.
bool is_surely_nearest(const oracle::Truth& truth, const Choices& choices, const Real& t,
                       const Real& accepted) {
  constexpr int bits = 28;  // fewer than any t of a truth has
  const auto further = [&](const Real& root) {
    return lead(accepted, gap(t, root), t) > std::ldexp(1.0, -bits);
  };
  for (int i = 0; i < choices.refused_count; ++i)
    if (!further(truth.crossings()[choices.refused[i]].t)) return false;
  return truth.others_known && std::ranges::all_of(truth.others(), further);
}

/// A t that is NaN or infinite, where a hit is acceptable.
void judge_not_finite(Judgement& judgement, const oracle::Truth& truth, const Choices& choices,
                      const Real& t, const Format& format) {
  for (const int i : choices.list()) {
    const Crossing& crossing = truth.crossings()[i];
    if (is_infinite(t) && sign(t) == sign(crossing.t) && overflows(crossing.t, format)) {
      judgement.taken = i != choices.must;
      judgement.verdict = judgement.taken ? Verdict::touch : Verdict::right;
      return;
    }
  }
  judgement.verdict = Verdict::not_finite;
  judgement.claim = is_nan(t) ? Claim::nan : Claim::infinite;
}

/// A finite t, where a hit is acceptable.
void judge_t(Judgement& judgement, Settled& settled, const Choices& choices, const Answer& answer,
             const Real& t, const Format& format) {
  const oracle::Truth& truth = settled.truth();
  int nearest = choices.acceptable[0];
  Real off = gap(t, truth.crossings()[nearest]);
  for (const int i : choices.list().subspan(1))
    if (const Real other = gap(t, truth.crossings()[i]); compare(other, off) < 0)
      nearest = i, off = other;
  const Off told(off, exact_t(t, truth.crossings()[nearest]), format);
  const bool within_an_ulp = told.ulps <= 1;
  if (!within_an_ulp && !is_surely_nearest(truth, choices, t, off))
    if (const auto standing = nearer_elsewhere(settled, choices, answer)) {
      judgement.verdict = Verdict::wrong_root;
      judgement.claim = claim_of(*standing);
      return;
    }
  judgement.crossing = nearest;
  judgement.taken = nearest != choices.must;
  judgement.verdict = judgement.taken                           ? Verdict::touch
                      : !within_an_ulp && is_far(t, told.exact) ? Verdict::wrong_t
                                                                : Verdict::right;
  measure(judgement, settled, answer, told, format);
}

void judge_yes(Judgement& judgement, const Choices& choices) {
  if (choices.must >= 0) {
    // Which of the crossings it meant, it does not say.
    judgement.touch.reset();
  } else {
    judgement.verdict = Verdict::touch;
    judgement.taken = true;
  }
}

/// A hit, where none is acceptable.
void judge_false_hit(Judgement& judgement, Settled& settled, const Answer& answer,
                     const Format& format) {
  judgement.verdict = Verdict::false_hit;
  judgement.claim =
      answer.form == Answer::Form::yes
          ? claim_of_yes(settled)
          : claim_at(settled, claimed_t(settled.question(), answer, oracle::bits_for(format)));
}

void judge_hit(Judgement& judgement, Settled& settled, const Choices& choices, const Answer& answer,
               const Format& format) {
  if (choices.count == 0) return judge_false_hit(judgement, settled, answer, format);
  if (answer.form == Answer::Form::yes) return judge_yes(judgement, choices);
  if (answer.form == Answer::Form::hit && is_finite(answer.t))
    return judge_t(judgement, settled, choices, answer, answer.t, format);
  const Real t = claimed_t(settled.question(), answer, oracle::bits_for(format));
  if (is_finite(t))
    judge_t(judgement, settled, choices, answer, t, format);
  else
    judge_not_finite(judgement, settled.truth(), choices, t, format);
}

/// Is the point told the first of the shape's own: its centre, or the centre of its base?
bool is_centre(const Case& question, const Answer& answer) {
  if (answer.form != Answer::Form::at) return false;
  const auto [x, y, z] =
      std::visit([](const auto& shape) { return std::get<0>(shape.parts()); }, question.shape);
  const auto is = [](const Real& a, double b) { return is_finite(a) && compare(a, real(b)) == 0; };
  return is(answer.point.x, x) && is(answer.point.y, y) && is(answer.point.z, z);
}

/// a b == c d, exactly, where no product underflows.
bool are_equal_products(double a, double b, double c, double d) {
  const double ab = a * b, cd = c * d;
  return ab == cd && std::fma(a, b, -ab) == std::fma(c, d, -cd);
}

/// Does the ray reach the world origin at the root t? Its line does so exactly.
bool is_at_origin(const Ray<double>& ray, const Real& t) {
  const auto& [o, d] = std::tie(ray.origin, ray.direction);
  const bool through = are_equal_products(o.y, d.z, o.z, d.y) &&
                       are_equal_products(o.z, d.x, o.x, d.z) &&
                       are_equal_products(o.x, d.y, o.y, d.x);
  const double reach = nearest<double>(t);
  const auto vanishes = [&](double from, double step) {
    return std::fabs(from + reach * step) <= std::fabs(from) * 0x1p-50;
  };
  return through && vanishes(o.x, d.x) && vanishes(o.y, d.y) && vanishes(o.z, d.z);
}

/// A point that no ray need come near is told for "no hit"; so is the world origin, which a ray may
/// well hit. Both slips have a name.
void name_sentinel(Judgement& judgement, const Settled& settled, const Answer& answer) {
  if (is_wrong(judgement.verdict) && is_centre(settled.question(), answer))
    judgement.claim = Claim::centre;
}

/// Any answer but the start of the ray, where that is what is declared.
Judgement judge_start(Settled& settled, const Answer& answer, const Format& format) {
  if (answer.form == Answer::Form::miss) return {.verdict = Verdict::false_miss};
  if (answer.form == Answer::Form::yes) return {};
  const Real t = claimed_t(settled.question(), answer, oracle::bits_for(format));
  if (!is_finite(t)) return {.verdict = Verdict::not_finite, .claim = claim_at(settled, t)};
  if (ulps(t, real(settled.question().ray.t_min), format) <= 1) return {};
  return {.verdict = Verdict::wrong_root, .claim = Claim::declined};
}

/// What stands in place of an answer to an invalid case.
Claim claim_of_none(const Answer& answer) {
  switch (answer.form) {
    case Answer::Form::crashed:
      return Claim::ended;
    case Answer::Form::garbage:
      return Claim::garbage;
    case Answer::Form::timed_out:
      return Claim::hung;
    default:
      return Claim::none;
  }
}

Judgement judge_none(const Answer& answer) {
  if (answer.form == Answer::Form::timed_out) return {.verdict = Verdict::timed_out};
  const bool is_garbage = answer.form == Answer::Form::garbage;
  return {.verdict = Verdict::crashed, .claim = is_garbage ? Claim::garbage : Claim::none};
}

}  // namespace

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, verdict_count> names = {
      "right",      "touch",   "false_hit", "false_miss",      "wrong_root",        "wrong_t",
      "not_finite", "crashed", "timed_out", "invalid_handled", "invalid_mishandled"};
  return names[static_cast<std::size_t>(verdict)];
}

bool is_wrong(Verdict verdict) {
  return verdict != Verdict::right && verdict != Verdict::touch &&
         verdict != Verdict::invalid_handled;
}

std::string_view name(Claim claim) {
  constexpr std::array<std::string_view, claim_count> names = {
      "none",  "no_root",  "nan",      "infinite", "behind", "past",    "clipped", "mirrored",
      "later", "declined", "parallel", "centre",   "origin", "garbage", "ended",   "hung"};
  return names[static_cast<std::size_t>(claim)];
}

std::string_view name(Side side) {
  constexpr std::array<std::string_view, side_count> names = {"unknown", "before", "on", "beyond"};
  return names[static_cast<std::size_t>(side)];
}

const oracle::Roots& Settled::roots() {
  if (!roots_) roots_ = oracle::roots(question_, sharp);
  return *roots_;
}

const oracle::Sensitivity& Settled::sensitivity(int crossing) {
  auto& known = sensitivities_[crossing];
  if (!known) known = oracle::sensitivity(question_, truth_.crossings()[crossing]);
  return *known;
}

double Settled::reach() {
  if (!quick_reach() && !reach_) reach_ = oracle::margin_exactly(question_).reach;
  return *reach_;
}

std::optional<double> Settled::quick_reach() {
  if (is_slow_) return {};
  if (reach_) return reach_;
  if (truth_.invalid != oracle::Invalid::no)
    reach_ = Judgement::unmeasured;
  else if (truth_.has_touch())
    reach_ = 0;
  else if (const auto margin = oracle::margin_by_bounds(question_))
    reach_ = margin->reach;
  is_slow_ = !reach_;
  return reach_;
}

bool comes_from_inside(Settled& settled) {
  const oracle::Truth& truth = settled.truth();
  if (truth.hit() == nullptr || std::holds_alternative<Disk<double>>(settled.question().shape))
    return false;
  return settled.sensitivity(truth.count - 1).sign_before < 0;
}

Choices::Choices(Settled& settled, const Convention& convention) {
  const bool is_hidden =
      convention.inside == Convention::Inside::miss && comes_from_inside(settled);
  const auto crossings = settled.truth().crossings();
  for (int i = 0; i < static_cast<int>(crossings.size()); ++i) {
    const Kind kind = crossings[i].kind;
    const auto proper = is_hidden ? Convention::Stance::miss : Convention::Stance::hit;
    const auto stance = kind == Kind::proper ? proper : convention.of(kind);
    if (must >= 0 || stance == Convention::Stance::miss) {
      refused[refused_count++] = i;
      continue;
    }
    acceptable[count++] = i;
    if (stance == Convention::Stance::hit)
      must = i;
    else if (!open_touch)
      open_touch = kind;
  }
}

bool Choices::accepts(int crossing) const {
  return std::ranges::find(list(), crossing) != list().end();
}

Judgement judge(Settled& settled, const Answer& answer, const Format& format,
                const Convention& convention) {
  const bool miss = answer.form == Answer::Form::miss;
  if (settled.truth().invalid != oracle::Invalid::no)
    return {.verdict = miss ? Verdict::invalid_handled : Verdict::invalid_mishandled,
            .claim = claim_of_none(answer)};
  if (!answer.is_given()) return judge_none(answer);
  if (convention.inside == Convention::Inside::any && comes_from_inside(settled)) return {};
  if (convention.inside == Convention::Inside::start && comes_from_inside(settled))
    return judge_start(settled, answer, format);
  const Choices choices(settled, convention);
  Judgement judgement{.touch = choices.open_touch};
  if (!miss) {
    judge_hit(judgement, settled, choices, answer, format);
    name_sentinel(judgement, settled, answer);
  } else if (choices.must >= 0) {
    const Real& t = settled.truth().crossings()[choices.must].t;
    judgement = {.verdict = Verdict::false_miss,
                 .claim = is_at_origin(settled.question().ray, t) ? Claim::origin : Claim::none,
                 .crossing = choices.must};
  } else if (choices.open_touch) {
    judgement.verdict = Verdict::touch;
  }
  return judgement;
}

Judgement judge(const Case& question, const Answer& answer, const Format& format,
                const Convention& convention) {
  const oracle::Truth truth = oracle::truth(question, oracle::bits_for(format));
  Settled settled(question, truth);
  return judge(settled, answer, format, convention);
}

}  // namespace rayaudit
