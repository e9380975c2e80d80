#include <immintrin.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "subjects/module.hpp"

/// Subjects that each do one thing that a module should not.
namespace rayaudit {
namespace {

void answer_yes(const Case*, std::size_t count, Answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = Answer::yes();
}

void crash_at_13(const Case* cases, std::size_t count, Answer* answers) {
  volatile int* const nowhere = nullptr;
  for (std::size_t i = 0; i < count; ++i)
    if (cases[i].ray.origin.x == 13) *nowhere = 1;
  answer_yes(cases, count, answers);
}

void take_an_unknown_instruction(const Case*, std::size_t, Answer*) { __builtin_trap(); }

void hang(const Case*, std::size_t, Answer*) {
  while (true) pause();
}

void exit_with_3(const Case*, std::size_t, Answer*) { std::_Exit(3); }

void write_garbage(const Case*, std::size_t, Answer*) {
  const char garbage[100] = "this is no answer";
  if (write(STDIN_FILENO, garbage, sizeof garbage) < 0) std::abort();
}

void answer_no_known_form(const Case*, std::size_t, Answer* answers) {
  answers[0].form = static_cast<Answer::Form>(77);
}

void print(const Case* cases, std::size_t count, Answer* answers) {
  std::puts("printed by a module");
  std::fflush(stdout);
  answer_yes(cases, count, answers);
}

void round_upward_and_flush_to_zero(const Case* cases, std::size_t count, Answer* answers) {
  constexpr unsigned upward = 0x4000, flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  _mm_setcsr((_mm_getcsr() & ~0x6000U) | upward | flush_to_zero | denormals_are_zero);
  answer_yes(cases, count, answers);
}

/// t is how many descriptors are open, but for the one that counts them.
void count_descriptors(const Case*, std::size_t, Answer* answers) {
  const auto open = std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
  answers[0] = Answer::hit(real(static_cast<double>(open - 1)));
}

constexpr ModuleSubject on_spheres(const char* name, ModuleBatch batch) {
  return {name, "double", {nullptr, batch, nullptr, nullptr}};
}

constexpr ModuleSubject subjects[] = {
    on_spheres("yes", answer_yes),
    on_spheres("crashes", crash_at_13),
    on_spheres("traps", take_an_unknown_instruction),
    on_spheres("hangs", hang),
    on_spheres("exits", exit_with_3),
    on_spheres("garbles", write_garbage),
    on_spheres("formless", answer_no_known_form),
    on_spheres("prints", print),
    on_spheres("flushes", round_upward_and_flush_to_zero),
    on_spheres("descriptors", count_descriptors),
};

}  // namespace
}  // namespace rayaudit

extern "C" [[gnu::visibility("default")]] const rayaudit::Module* rayaudit_module() {
  using namespace rayaudit;
  static constexpr Module module = {module_version, sizeof(Case), sizeof(Answer),
                                    std::size(subjects), subjects};
  return &module;
}
