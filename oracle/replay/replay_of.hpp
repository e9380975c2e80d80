#pragma once

#include <cmath>
#include <concepts>

#include "numbers/traced.hpp"
#include "numbers/wide_bound.hpp"
#include "oracle/replay/replay.hpp"
#include "oracle/replay/shadow.hpp"
#include "oracle/replay/sources.hpp"
#include "oracle/replay/surd.hpp"

/// The replay of any routine: for the source that lists the built-in ones, and for tests. Runs in
/// double-word numbers with a proved bound come first; what they leave open is run exactly.
namespace rayaudit::replay {

using NearlyExact = WideBound;

/// A case in another number, repaired, and the length that its direction had if it was.
template <class X, class S>
struct Repaired {
  Ray<X> ray;
  S shape;
  X length = X(1);
};

template <class X>
X length(const Vec3<X>& v) {
  using std::sqrt;
  return sqrt(dot(v, v));
}

template <class X, template <class> class S>
Repaired<X, S<X>> repaired(const Ray<double>& ray, const S<double>& shape, Repair repair) {
  Repaired<X, S<X>> made = {in<X>(ray), in<X>(shape)};
  if (repair == Repair::direction || repair == Repair::both) {
    made.length = length(made.ray.direction);
    made.ray.direction = made.ray.direction / made.length;
    made.ray.t_min = made.ray.t_min * made.length;
    made.ray.t_max = made.ray.t_max * made.length;
  }
  if (repair == Repair::normal || repair == Repair::both)
    if constexpr (requires { made.shape.normal; })
      made.shape.normal = made.shape.normal / length(made.shape.normal);
  return made;
}

/// The value of a number to 2^-90 of itself, or nothing.
inline std::optional<Real> told(const Surd& x) { return x.value(); }
inline std::optional<Real> told(const NearlyExact& x) {
  if (!(x.error() <= std::fabs(x.value.high) * 0x1p-90)) return {};
  return Real{x.value.high, x.value.low, 0, 0};
}

template <class X>
std::optional<Answer> told(bool met, const X&) {
  return met ? Answer::yes() : Answer::miss();
}
template <class X>
std::optional<Answer> told(const std::optional<X>& t, const X& length) {
  if (!t) return Answer::miss();
  const std::optional<Real> number = told(X(*t / length));
  if (!number) return {};
  return Answer::hit(*number);
}
template <class X>
std::optional<Answer> told(const std::optional<Vec3<X>>& point, const X&) {
  if (!point) return Answer::miss();
  const auto x = told(point->x), y = told(point->y), z = told(point->z);
  if (!x || !y || !z) return {};
  return Answer::at({*x, *y, *z});
}

template <class Routine, class X, class S>
std::optional<Answer> answer_in(const Case& question, Repair repair) {
  const auto made = repaired<X>(question.ray, std::get<S>(question.shape), repair);
  return told(Routine()(made.ray, made.shape), made.length);
}

template <class Routine, class S>
Exactly answer_exactly(const Case& question, Repair repair) {
  NearlyExact::all_proved = true;
  if (const auto answer = answer_in<Routine, NearlyExact, S>(question, repair);
      answer && NearlyExact::all_proved)
    return {.answer = *answer};
  Surd::begin();
  try {
    return {.answer = *answer_in<Routine, Surd, S>(question, repair)};
  } catch (const Undefined& undefined) {
    return {.end = Exactly::End::undefined, .undefined = undefined.words};
  } catch (const GivenUp&) {
    return {.end = Exactly::End::given_up};
  }
}

template <class N>
Real real_of(const RunningBound<N>& x) {
  return real(x.value);
}

/// What a watched run yields, in the words of a case; nothing where a comparison was left open.
template <class N, class X>
std::optional<Watched> told(const Trace<N, X>& trace, const Answer& answer, Wanted wanted) {
  Watched made{answer, {}};
  int comparison = 0;
  for (const auto& step : trace.steps) {
    Step plain{.file = below_src(step.file), .line = step.line, .operation = step.operation};
    plain.compares = step.compares;
    if (step.compares) {
      const Order order = order_of(step.value.exact, step.right.exact);
      if (order == Order::open) return {};
      plain.comparison = comparison++;
      plain.said = step.said, plain.proved = step.proved;
      plain.defined = order != Order::undefined;
      plain.exactly = plain.defined && holds(step.operation, order);
    }
    if (wanted == Wanted::parting && !plain.parts()) continue;
    plain.text = source_line(plain.file, plain.line);
    plain.used = step.used;
    plain.value = real_of(step.value.near), plain.right = real_of(step.right.near);
    plain.bound = step.value.near.error();
    const std::optional<Real> exact = value_of(step.value.exact);
    plain.exact = exact.value_or(Real{});
    if (step.compares)
      plain.exact_right = value_of(step.right.exact).value_or(Real{});
    else
      plain.defined = exact.has_value();
    made.steps.push_back(plain);
  }
  return made;
}

inline Answer plain_answer(bool met) { return met ? Answer::yes() : Answer::miss(); }
template <class N, class X>
Answer plain_answer(const std::optional<Traced<N, X>>& t) {
  return t ? Answer::hit(real_of(t->near)) : Answer::miss();
}
template <class N, class X>
Answer plain_answer(const std::optional<Vec3<Traced<N, X>>>& point) {
  if (!point) return Answer::miss();
  return Answer::at({real_of(point->x.near), real_of(point->y.near), real_of(point->z.near)});
}

template <class Routine, class N, class X, class S>
std::optional<Watched> watched_in(const Case& question, int forced, Wanted wanted) {
  using Number = Traced<N, X>;
  Trace<N, X>& trace = Trace<N, X>::of_thread();
  trace.begin(wanted == Wanted::all, forced);
  const Answer answer =
      plain_answer(Routine()(in<Number>(question.ray), in<Number>(std::get<S>(question.shape))));
  return told(trace, answer, wanted);
}

template <class Routine, class N, class S>
std::optional<Watched> watch(const Case& question, int forced, Wanted wanted) {
  if (wanted == Wanted::parting)
    if (auto seen = watched_in<Routine, N, Shadow<NearlyExact>, S>(question, forced, wanted))
      return seen;
  Surd::begin();
  try {
    return watched_in<Routine, N, Shadow<Surd>, S>(question, forced, wanted);
  } catch (const GivenUp&) {
    return {};
  }
}

template <class Routine, template <class> class S>
void add_shape(Replay& replay, std::size_t shape, const S<double>*) {
  if constexpr (std::invocable<const Routine&, const Ray<double>&, const S<double>&>) {
    replay.answer_exactly[shape] = answer_exactly<Routine, S<double>>;
    replay.watch[0][shape] = watch<Routine, float, S<double>>;
    replay.watch[1][shape] = watch<Routine, double, S<double>>;
    replay.watch[2][shape] = watch<Routine, long double, S<double>>;
  }
}

template <class Routine>
Replay replay_made_of() {
  Replay made{.routine = Routine::name};
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (add_shape<Routine>(made, I, static_cast<std::variant_alternative_t<I, Shape>*>(nullptr)), ...);
  }
  (std::make_index_sequence<shape_count>{});
  return made;
}

}  // namespace rayaudit::replay
