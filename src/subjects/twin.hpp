#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <variant>

#include "geometry/format.hpp"
#include "geometry/ray.hpp"
#include "geometry/shapes.hpp"

/// What program and plugin must say alike of a routine's twin under other flags.
namespace rayaudit {

/// As in `textbook+native`; its subject is `textbook+native/float`.
template <class Routine>
std::string twin_name(std::string_view flags) {
  return std::string(Routine::name) + '+' + std::string(flags);
}

template <class Routine, class N, std::size_t shape>
inline constexpr bool takes_shape = []<template <class> class S>(const S<double>*) {
  return std::invocable<const Routine&, const Ray<N>&, const S<N>&>;
}(static_cast<std::variant_alternative_t<shape, Shape>*>(nullptr));

/// Calls visit.template operator()<Routine, N>() for each twin, in the order of the list. There are
/// none in long double: x87 has no fused multiplication and no wider registers to gain from, and
/// who takes it does not take it for speed.
template <class V, class... Routine>
void each_twin(const std::tuple<Routine...>&, V&& visit) {
  ((visit.template operator()<Routine, float>(), visit.template operator()<Routine, double>()),
   ...);
}

}  // namespace rayaudit
