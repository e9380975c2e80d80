#pragma once

namespace rayaudit {

/// Does the processor have fused multiplications?
inline bool has_fused() {
#ifdef __x86_64__
  static const bool fused = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return fused;
#else
  return false;
#endif
}

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
  if (has_fused()) return run_flattened_with_fma(body);
#endif
  run_as_it_is(body);
}

}  // namespace rayaudit
