#include <concepts>
#include <optional>

#include "routines/routines.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {
namespace {

// What a routine returns says what it answers: only yes, a t, or a point.
Answer answer_of(bool met) { return met ? Answer::yes() : Answer::miss(); }

template <class N>
Answer answer_of(const std::optional<N>& t) {
  return t ? Answer::hit(real(*t)) : Answer::miss();
}

template <class N>
Answer answer_of(const std::optional<Vec3<N>>& point) {
  return point ? Answer::at({real(point->x), real(point->y), real(point->z)}) : Answer::miss();
}

template <class Routine, class N, class S>
void answer_batch(std::span<const Case> cases, std::span<Answer> answers) {
  const Routine routine;
  for (std::size_t i = 0; i < cases.size(); ++i)
    answers[i] = answer_of(routine(in<N>(cases[i].ray), in<N>(std::get<S>(cases[i].shape))));
}

template <class Routine, class N, template <class> class S>
void add_batch(Subject& subject, std::size_t shape, const S<double>*) {
  if constexpr (std::invocable<const Routine&, const Ray<N>&, const S<N>&>)
    subject.answer[shape] = answer_batch<Routine, N, S<double>>;
}

template <class Routine, class N>
Subject subject() {
  Subject made = {
      std::string(Routine::name) + '/' + std::string(format_of<N>.name), format_of<N>, {}};
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (add_batch<Routine, N>(made, I, static_cast<std::variant_alternative_t<I, Shape>*>(nullptr)),
     ...);
  }
  (std::make_index_sequence<shape_count>{});
  return made;
}

template <class... Routine>
std::vector<Subject> subjects_of(const std::tuple<Routine...>&) {
  std::vector<Subject> made;
  ((made.push_back(subject<Routine, float>()), made.push_back(subject<Routine, double>()),
    made.push_back(subject<Routine, long double>())),
   ...);
  return made;
}

}  // namespace

const std::vector<Subject>& built_in_subjects() {
  static const std::vector<Subject> subjects = subjects_of(Routines{});
  return subjects;
}

}  // namespace rayaudit
