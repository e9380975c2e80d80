#include "subjects/certified.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "geometry/flattened.hpp"
#include "numbers/running_bound.hpp"
#include "numbers/wide_bound.hpp"
#include "oracle/truth.hpp"
#include "routines/closest_approach.hpp"
#include "routines/division_free.hpp"

namespace rayaudit {
namespace {

template <class S>
struct Best {
  using Routine = ClosestApproach;
};
template <>
struct Best<Disk<double>> {
  using Routine = DivisionFree;
};

/// What a stage proves of a case: nothing, a miss, or a hit from t + below to t + above.
struct Proof {
  enum class Form : std::uint8_t { none, miss, hit };

  Form form = Form::none;
  double t = 0, below = 0, above = 0;
};

double low(double) { return 0; }
double low(const DoubleDouble& x) { return x.low; }

template <class N>
Proof proof_of(const RunningBound<N>& t) {
  if (!t.is_bounded()) return {};
  const double middle = low(t.value) + t.off;
  const double slack = t.slack() * (1 + 0x1p-50) + std::fabs(middle) * (t.most > 0 ? 0x1p-50 : 0);
  return {Proof::Form::hit, static_cast<double>(t.value), middle - slack, middle + slack};
}

template <class N, class S>
Proof proof(const Case& question) {
  const S& shape = *std::get_if<S>(&question.shape);
  // A routine meets a shape of negative size too.
  if (!(shape.radius > 0)) return {};
  using Bound = RunningBound<N>;
  const ProofWatch<N> watch;
  const std::optional<Bound> t =
      typename Best<S>::Routine()(in<Bound>(question.ray), in<Bound>(shape));
  if (!watch.all_proved()) return {};
  return t ? proof_of(*t) : Proof{Proof::Form::miss};
}

template <class N, class S>
void prove(std::span<const Case> cases, std::span<const std::size_t> places,
           std::span<Proof> proofs) {
  run_flattened([&] {
    for (std::size_t i = 0; i < places.size(); ++i) proofs[i] = proof<N, S>(cases[places[i]]);
  });
}

/// The t of a hit in the format of N, if it is the same wherever the exact one lies.
template <class N>
std::optional<N> rounded(const Proof& hit) {
  double least = hit.t + hit.below, most = hit.t + hit.above;
  if constexpr (std::is_same_v<N, float>) {
    // Rounded twice, a number beside the middle of two floats may end on the wrong one.
    if (hit.below != 0 || hit.above != 0) {
      least -= std::fabs(least) * 0x1p-52 + 0x1p-900;
      most += std::fabs(most) * 0x1p-52 + 0x1p-900;
    }
  }
  const N t = static_cast<N>(least);
  if (t != static_cast<N>(most)) return {};
  return t;
}

/// Answers with t rounded correctly to N.
template <class N>
struct Rounded {
  static bool settle(const Proof& proof, Answer& answer) {
    answer.form = Answer::Form::miss;
    if (proof.form != Proof::Form::hit) return proof.form == Proof::Form::miss;
    const std::optional<N> t = rounded<N>(proof);
    if (t) write(answer, *t);
    return t.has_value();
  }
  static void settle(const Case& question, const oracle::Crossing* hit, Answer& answer) {
    answer.form = Answer::Form::miss;
    if (hit) write(answer, oracle::rounded<N>(question, *hit));
  }

 private:
  static void write(Answer& answer, N t) {
    answer.form = Answer::Form::hit;
    answer.t = real(t);
  }
};

/// Answers with any bound that is finite.
struct Bounded {
  static bool settle(const Proof& proof, Certified& answer) {
    const double error = std::fmax(std::fabs(proof.below), std::fabs(proof.above));
    answer = {proof.form == Proof::Form::hit, proof.t, error, 0};
    return proof.form != Proof::Form::none;
  }
  static void settle(const Case& question, const oracle::Crossing* hit, Certified& answer) {
    answer = {hit != nullptr, 0, 0, 0};
    if (!hit) return;
    answer.t = oracle::rounded<double>(question, *hit);
    answer.error = std::fabs(answer.t) * 0x1p-52 + std::numeric_limits<double>::denorm_min();
  }
};

/// Proves what the cases in places allow in N, and keeps the places of the rest.
template <class Rule, class N, class S, class A>
void settle_in(std::span<const Case> cases, std::span<A> answers, std::vector<std::size_t>& places,
               std::uint8_t stage) {
  std::vector<Proof> proofs(places.size());
  prove<N, S>(cases, places, proofs);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    A& answer = answers[places[i]];
    if (!Rule::settle(proofs[i], answer)) places[kept++] = places[i];
    answer.stage = stage;
  }
  places.resize(kept);
}

template <class Rule, class A>
void settle_exactly(std::span<const Case> cases, std::span<A> answers,
                    std::span<const std::size_t> places) {
  std::vector<Case> questions;
  for (const std::size_t place : places) questions.push_back(cases[place]);
  std::vector<oracle::Truth> truths(places.size());
  oracle::truth(questions, truths);
  for (std::size_t i = 0; i < places.size(); ++i) {
    Rule::settle(questions[i], truths[i].hit(), answers[places[i]]);
    answers[places[i]].stage = 3;
  }
}

template <class Rule, class S, class A>
void settle(std::span<const Case> cases, std::span<A> answers) {
  std::vector<std::size_t> places(cases.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  settle_in<Rule, double, S>(cases, answers, places, 1);
  if (!places.empty()) settle_in<Rule, DoubleDouble, S>(cases, answers, places, 2);
  if (!places.empty()) settle_exactly<Rule>(cases, answers, places);
}

template <class N>
Subject certified() {
  return {"certified/" + std::string(format_of<N>.name),
          format_of<N>,
          {settle<Rounded<N>, Disk<double>, Answer>, settle<Rounded<N>, Sphere<double>, Answer>,
           settle<Rounded<N>, Cylinder<double>, Answer>, settle<Rounded<N>, Cone<double>, Answer>,
           settle<Rounded<N>, CappedCylinder<double>, Answer>,
           settle<Rounded<N>, CappedCone<double>, Answer>}};
}

}  // namespace

Subject certified_float() { return certified<float>(); }
Subject certified_double() { return certified<double>(); }

void certify(std::span<const Case> cases, std::span<Certified> answers) {
  if (cases.empty()) return;
  std::visit([&]<class S>(const S&) { settle<Bounded, S>(cases, answers); }, cases[0].shape);
}

}  // namespace rayaudit
