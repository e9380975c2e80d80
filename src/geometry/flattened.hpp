#pragma once

namespace rayaudit {

#ifdef __x86_64__
template <class Body>
[[gnu::noinline, gnu::flatten, gnu::target("avx2,fma")]] void run_flattened_with_fma(
    const Body& body) {
  body();
}
#endif
template <class Body>
[[gnu::noinline]] void run_as_it_is(const Body& body) {
  body();
}

/// Runs body with every call in it inlined, and so with __builtin_fma an instruction, where the
/// processor has it. The operations and what comes of them are the same.
template <class Body>
void run_flattened(const Body& body) {
#ifdef __x86_64__
  static const bool fused = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (fused) return run_flattened_with_fma(body);
#endif
  run_as_it_is(body);
}

}  // namespace rayaudit
