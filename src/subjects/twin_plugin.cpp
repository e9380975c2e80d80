#include <string>
#include <vector>

#include "geometry/flat_case.hpp"
#include "rayaudit/plugin.h"
#include "routines/routines.hpp"
#include "subjects/twin.hpp"

/// The routines once more, under the flags of the plugin that this source is compiled into. All of
/// it is templates and inline: what it shared with the program would have the program's flags.
namespace rayaudit {
namespace {

/// Answers are misses before they are written.
void write(rayaudit_answer& answer, bool met) {
  if (met) answer.form = RAYAUDIT_YES;
}
template <class N>
void write(rayaudit_answer& answer, const std::optional<N>& t) {
  if (t) answer.form = RAYAUDIT_HIT, answer.t = *t;
}
template <class N>
void write(rayaudit_answer& answer, const std::optional<Vec3<N>>& point) {
  if (point) answer.form = RAYAUDIT_AT, answer.point = {point->x, point->y, point->z};
}

template <class Routine, class N, std::size_t shape>
void answer(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  const Routine routine;
  const auto each = [&]<template <class> class S>(const S<double>*) {
    for (std::size_t i = 0; i < count; ++i)
      write(answers[i], routine(in<N>(cases[i].ray), part<N, S>(cases[i])));
  };
  each(static_cast<std::variant_alternative_t<shape, Shape>*>(nullptr));
}

template <class Routine, class N, std::size_t shape>
constexpr rayaudit_batch batch_of() {
  if constexpr (takes_shape<Routine, N, shape>)
    return answer<Routine, N, shape>;
  else
    return nullptr;
}

template <class Routine, class N, std::size_t... shape>
rayaudit_subject twin_of(const std::string& name, std::index_sequence<shape...>) {
  return {name.c_str(), format_of<N>.name.data(), {}, batch_of<Routine, N, shape>()..., nullptr};
}

struct Twins {
  std::vector<std::string> names;
  std::vector<rayaudit_subject> subjects;
  rayaudit_plugin plugin = {};

  Twins() {
    names.reserve(2 * std::tuple_size_v<Routines>);  // they are pointed at
    each_twin(Routines{}, [this]<class Routine, class N>() {
      names.push_back(twin_name<Routine>(RAYAUDIT_TWIN));
      subjects.push_back(
          twin_of<Routine, N>(names.back(), std::make_index_sequence<shape_count>{}));
    });
    plugin = {RAYAUDIT_PLUGIN_VERSION,  sizeof(rayaudit_case), sizeof(rayaudit_answer),
              sizeof(rayaudit_subject), subjects.size(),       subjects.data()};
  }
};

}  // namespace
}  // namespace rayaudit

const rayaudit_plugin* rayaudit_plugin_entry() {
  static const rayaudit::Twins twins;
  return &twins.plugin;
}
