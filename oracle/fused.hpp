#pragma once

#include <utility>

#include "geometry/flattened.hpp"
#include "geometry/shapes.hpp"

namespace rayaudit::oracle {

/// Calls f with the shape that it is, inlined where f is: a visit whose body takes on the
/// instruction set of its caller.
template <class F>
[[gnu::always_inline]] inline void with_shape(const Shape& shape, F&& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
    ((shape.index() == I ? f(*std::get_if<I>(&shape)) : void()), ...);
  }
  (std::make_index_sequence<shape_count>{});
}

/// Runs body, a callable that is inlined into its caller, with fused multiplications in hardware
/// where the processor has them. The operations, results and bounds are the same: only that
/// __builtin_fma is an instruction here and a call of the library there.
#ifdef __x86_64__
template <class Body>
[[gnu::noinline, gnu::target("avx2,fma")]] void run_with_fma(const Body& body) {
  body();
}
#endif
template <class Body>
[[gnu::noinline]] void run_without_fma(const Body& body) {
  body();
}
template <class Body>
void run_fused(const Body& body) {
#ifdef __x86_64__
  if (has_fused()) return run_with_fma(body);
#endif
  run_without_fma(body);
}

}  // namespace rayaudit::oracle
