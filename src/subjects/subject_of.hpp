#pragma once

#include <cmath>
#include <concepts>
#include <optional>

#include "numbers/running_bound.hpp"
#include "subjects/subject.hpp"

/// A subject from any routine: for the source that lists the built-in ones, and for tests.
namespace rayaudit {

/// What a routine returns says what it answers: only yes, a t, or a point.
inline Answer answer_of(bool met) { return met ? Answer::yes() : Answer::miss(); }

template <class N>
Answer answer_of(const std::optional<N>& t) {
  return t ? Answer::hit(real(*t)) : Answer::miss();
}

template <class N>
Answer answer_of(const std::optional<Vec3<N>>& point) {
  return point ? Answer::at({real(point->x), real(point->y), real(point->z)}) : Answer::miss();
}

/// The same, written where it is to stand, and of that only what its form asks for: to put all of
/// an answer together elsewhere and copy it takes longer than most routines do.
inline void write(Answer& answer, bool met) {
  answer.form = met ? Answer::Form::yes : Answer::Form::miss;
}
template <class N>
void write(Answer& answer, const std::optional<N>& t) {
  answer.form = t ? Answer::Form::hit : Answer::Form::miss;
  if (t) answer.t = real(*t);
}
template <class N>
void write(Answer& answer, const std::optional<Vec3<N>>& point) {
  answer.form = point ? Answer::Form::at : Answer::Form::miss;
  if (point) answer.point = {real(point->x), real(point->y), real(point->z)};
}

template <class Routine, class N, class S>
void answer_batch(std::span<const Case> cases, std::span<Answer> answers) {
  const Routine routine;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    write(answers[i], routine(in<N>(cases[i].ray), in<N>(*std::get_if<S>(&cases[i].shape))));
    answers[i].stage = 0;
  }
}

/// With every comparison proved, what is left to prove is t.
template <class N>
Proved proved(bool met, const Ray<double>&, bool certified) {
  return {answer_of(met), certified};
}
template <class N>
Proved proved(const std::optional<RunningBound<N>>& t, const Ray<double>&, bool certified) {
  if (!t) return {Answer::miss(), certified};
  return {Answer::hit(real(t->value)), certified && t->is_bounded(), t->error()};
}
/// The t of a point is off by no more than the point, in units of the direction.
template <class N>
Proved proved(const std::optional<Vec3<RunningBound<N>>>& point, const Ray<double>& ray,
              bool certified) {
  if (!point) return {Answer::miss(), certified};
  const auto& [x, y, z] = *point;
  const Vec3<double>& d = ray.direction;
  const double bound = std::hypot(x.error(), y.error(), z.error()) / std::hypot(d.x, d.y, d.z);
  return {Answer::at({real(x.value), real(y.value), real(z.value)}),
          certified && std::isfinite(bound), bound * (1 + 0x1p-40)};
}

template <class Routine, class N, class S>
void prove_batch(std::span<const Case> cases, std::span<Proved> answers) {
  using Number = RunningBound<N>;
  const Routine routine;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Ray<double>& ray = cases[i].ray;
    Number::all_proved = true;
    const auto answer =
        routine(in<Number>(in<N>(ray)), in<Number>(in<N>(std::get<S>(cases[i].shape))));
    answers[i] = proved<N>(answer, ray, Number::all_proved);
  }
}

template <class Routine, class N, template <class> class S>
void add_batch(Subject& subject, std::size_t shape, const S<double>*) {
  if constexpr (std::invocable<const Routine&, const Ray<N>&, const S<N>&>) {
    subject.answer[shape] = answer_batch<Routine, N, S<double>>;
    if constexpr (std::is_floating_point_v<N>)  // those have running bounds
      subject.prove[shape] = prove_batch<Routine, N, S<double>>;
  }
}

template <class Routine, class N>
Subject subject_of() {
  std::string name(Routine::name);
  name.append("/").append(format_of<N>.name);
  Subject made = {name, format_of<N>, {}};
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (add_batch<Routine, N>(made, I, static_cast<std::variant_alternative_t<I, Shape>*>(nullptr)),
     ...);
  }
  (std::make_index_sequence<shape_count>{});
  return made;
}

}  // namespace rayaudit
