#pragma once

#include <concepts>
#include <tuple>
#include <type_traits>

#include "audit/environment.hpp"
#include "audit/tally.hpp"

/// Every member of what a tally is made of, in order, as references: what is written and read
/// exactly. A struct that gains a member does not compile here until it is told.
namespace rayaudit {

template <class T, class S>
concept Plain = std::same_as<std::remove_const_t<T>, S>;

template <Plain<Vec3<double>> T>
auto parts(T& of) {
  auto& [x, y, z] = of;
  return std::tie(x, y, z);
}
template <Plain<Vec3<Real>> T>
auto parts(T& of) {
  auto& [x, y, z] = of;
  return std::tie(x, y, z);
}
template <Plain<Real> T>
auto parts(T& of) {
  auto& [high, middle, low, exponent] = of;
  return std::tie(high, middle, low, exponent);
}
template <Plain<Ray<double>> T>
auto parts(T& of) {
  auto& [origin, direction, t_min, t_max] = of;
  return std::tie(origin, direction, t_min, t_max);
}
template <Plain<Case> T>
auto parts(T& of) {
  auto& [ray, shape, extent] = of;
  return std::tie(ray, shape, extent);
}
template <Plain<Answer> T>
auto parts(T& of) {
  auto& [form, t, point, stage, signal] = of;
  return std::tie(form, t, point, stage, signal);
}
template <Plain<Judgement> T>
auto parts(T& of) {
  auto& [verdict, claim, touch, taken, crossing, ulps, relative, forced, own, condition, distance,
         side] = of;
  return std::tie(verdict, claim, touch, taken, crossing, ulps, relative, forced, own, condition,
                  distance, side);
}
template <Plain<replay::Step> T>
auto parts(T& of) {
  auto& [file, line, text, operation, compares, used, value, right, bound, defined, exact,
         exact_right, comparison, said, exactly, proved] = of;
  return std::tie(file, line, text, operation, compares, used, value, right, bound, defined, exact,
                  exact_right, comparison, said, exactly, proved);
}
template <Plain<Diagnosis> T>
auto parts(T& of) {
  auto& [cause, about, turned] = of;
  return std::tie(cause, about, turned);
}
template <Plain<Minimal> T>
auto parts(T& of) {
  auto& [question, answer, judgement, diagnosis, margin] = of;
  return std::tie(question, answer, judgement, diagnosis, margin);
}
template <Plain<Worst> T>
auto parts(T& of) {
  auto& [severity, place, question, answer, judgement, diagnosis, repeats, beyond_rounding,
         minimal] = of;
  return std::tie(severity, place, question, answer, judgement, diagnosis, repeats, beyond_rounding,
                  minimal);
}
template <Plain<CauseCount::Turned> T>
auto parts(T& of) {
  auto& [file, line, text, count] = of;
  return std::tie(file, line, text, count);
}
template <Plain<CauseCount::About> T>
auto parts(T& of) {
  auto& [cause, about, count] = of;
  return std::tie(cause, about, count);
}
template <Plain<CauseCount> T>
auto parts(T& of) {
  auto& [counts, turned, about] = of;
  return std::tie(counts, turned, about);
}
template <Plain<Outcome> T>
auto parts(T& of) {
  auto& [verdict, claim, count, worst, causes, beyond_rounding] = of;
  return std::tie(verdict, claim, count, worst, causes, beyond_rounding);
}
template <Plain<TouchCount> T>
auto parts(T& of) {
  auto& [taken, passed] = of;
  return std::tie(taken, passed);
}
template <Plain<MarginCurve::Step> T>
auto parts(T& of) {
  auto& [cases, wrong] = of;
  return std::tie(cases, wrong);
}
template <Plain<Certificate> T>
auto parts(T& of) {
  auto& [cases, certified, compared, wrong, looseness, proved, observed, first_wrong] = of;
  return std::tie(cases, certified, compared, wrong, looseness, proved, observed, first_wrong);
}
template <Plain<Tally> T>
auto parts(T& of) {
  auto& [cases, verdicts, outcomes, sides, touches, decided_by, bare, unasked, ulps, forced, own,
         distance, condition, proper_own, worst_ulps, worst_forced, worst_own, curve, certificate,
         stages] = of;
  return std::tie(cases, verdicts, outcomes, sides, touches, decided_by, bare, unasked, ulps,
                  forced, own, distance, condition, proper_own, worst_ulps, worst_forced, worst_own,
                  curve, certificate, stages);
}
template <Plain<Convention> T>
auto parts(T& of) {
  auto& [stances, inside, unit_direction, line, extent, stand, opening, segment, t_min, t_max] = of;
  return std::tie(stances, inside, unit_direction, line, extent, stand, opening, segment, t_min,
                  t_max);
}
template <Plain<Environment> T>
auto parts(T& of) {
  auto& [compiler, flags, processor, contraction, flush_to_zero, rounding, processors] = of;
  return std::tie(compiler, flags, processor, contraction, flush_to_zero, rounding, processors);
}

/// What knows its parts itself: shapes, histograms, curves.
template <class T>
auto parts(T& of) requires requires {
  std::tuple_size<decltype(of.parts())>::value;
}
{ return of.parts(); }

}  // namespace rayaudit
