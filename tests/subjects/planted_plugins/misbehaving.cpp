#include <immintrin.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "rayaudit/plugin.h"

/// Subjects that each do one thing that a plugin should not, most of them where a ray begins at 13.
namespace {

void say_yes(const rayaudit_case*, size_t count, rayaudit_answer* answers) {
  for (size_t i = 0; i < count; ++i) answers[i] = rayaudit_yes();
}

/// Says yes to all, but does something else first where a ray begins at 13.
template <void (*instead)()>
void at_13(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  for (size_t i = 0; i < count; ++i)
    if (cases[i].ray.origin.x == 13) instead();
  say_yes(cases, count, answers);
}

/// Does it whatever the case.
template <void (*instead)()>
void always(const rayaudit_case*, size_t, rayaudit_answer*) {
  instead();
}

void crash() { std::raise(SIGSEGV); }
void trap() { __builtin_trap(); }
void complain() {
  std::fputs("planted complaint\n", stderr);
  std::abort();
}
void hang() {
  while (true) pause();
}
void leave() { std::exit(3); }
void throw_up() { throw std::runtime_error("planted"); }
void close_all() {
  for (int descriptor = 0; descriptor < 64; ++descriptor) close(descriptor);
  hang();
}
void write_garbage() {
  const char garbage[100] = "this is no answer";
  for (int descriptor = 3; descriptor < 64; ++descriptor)
    if (write(descriptor, garbage, sizeof garbage) < 0) continue;
}
/// Its own child holds what it has open, and outlives it.
void leave_a_child() {
  if (fork() == 0) hang();
  std::raise(SIGSEGV);
}
/// Crashes where the file that CRASHED names is not there; then it is.
void crash_once() {
  const char* file = std::getenv("CRASHED");
  if (file == nullptr || std::filesystem::exists(file)) return;
  std::fclose(std::fopen(file, "w"));
  crash();
}

void crash_in_batches(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  if (count >= 5) crash();
  say_yes(cases, count, answers);
}

void hang_in_batches(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  if (count >= 5) hang();
  say_yes(cases, count, answers);
}

void take_a_millisecond(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  usleep(static_cast<useconds_t>(1000 * count));
  say_yes(cases, count, answers);
}

void say_nothing(const rayaudit_case*, size_t, rayaudit_answer*) {}

void answer_no_known_form(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  say_yes(cases, count, answers);
  for (size_t i = 0; i < count; ++i)
    if (cases[i].ray.origin.x == 13) answers[i].form = 77;
}

void print(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  std::puts("printed by a plugin");
  std::fflush(stdout);
  say_yes(cases, count, answers);
}

/// Yes where standard input is at its end.
void read_input(const rayaudit_case*, size_t, rayaudit_answer* answers) {
  char letter = 0;
  if (read(STDIN_FILENO, &letter, 1) == 0) answers[0] = rayaudit_yes();
}

void round_upward_and_flush_to_zero(const rayaudit_case* cases, size_t count,
                                    rayaudit_answer* answers) {
  constexpr unsigned upward = 0x4000, flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  _mm_setcsr((_mm_getcsr() & ~0x6000U) | upward | flush_to_zero | denormals_are_zero);
  say_yes(cases, count, answers);
}

/// t is how many descriptors are open, but for the one that counts them.
void count_descriptors(const rayaudit_case*, size_t, rayaudit_answer* answers) {
  const auto open = std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
  answers[0] = rayaudit_hit(static_cast<double>(open - 1));
}

/// t is the process.
void tell_process(const rayaudit_case*, size_t count, rayaudit_answer* answers) {
  for (size_t i = 0; i < count; ++i) answers[i] = rayaudit_hit(getpid());
}

constexpr rayaudit_subject on_spheres(const char* name, rayaudit_batch batch) {
  return {name, "double", {}, nullptr, batch, nullptr, nullptr, nullptr, nullptr, nullptr};
}
constexpr rayaudit_subject on_all(const char* name, rayaudit_batch batch) {
  return {name, "double", {}, batch, batch, batch, batch, nullptr, nullptr, nullptr};
}

constexpr rayaudit_subject subjects[] = {
    on_spheres("yes", say_yes),
    on_spheres("crashes", at_13<crash>),
    on_spheres("traps", at_13<trap>),
    on_spheres("hangs", at_13<hang>),
    on_spheres("exits", at_13<leave>),
    on_spheres("throws", at_13<throw_up>),
    on_spheres("closes", at_13<close_all>),
    on_spheres("garbles", at_13<write_garbage>),
    on_spheres("leaves_a_child", at_13<leave_a_child>),
    on_spheres("crashes_once", always<crash_once>),
    on_spheres("crashes_in_batches", crash_in_batches),
    on_spheres("hangs_in_batches", hang_in_batches),
    on_spheres("slow", take_a_millisecond),
    on_spheres("says_nothing", say_nothing),
    on_spheres("formless", answer_no_known_form),
    on_spheres("prints", print),
    on_spheres("reads", read_input),
    on_spheres("flushes", round_upward_and_flush_to_zero),
    on_spheres("descriptors", count_descriptors),
    on_spheres("process", tell_process),
    on_all("always_crashes", always<crash>),
    on_all("always_hangs", always<hang>),
    on_all("always_complains", always<complain>),
};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
