#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "rayaudit/plugin.h"

/// A plugin that stands for a library: rayaudit-embree.so, say. It does what FLAW in the
/// environment names, when it is loaded or when it is asked.
namespace {

bool has(const char* flaw) {
  const char* named = std::getenv("FLAW");
  return named != nullptr && std::strcmp(named, flaw) == 0;
}

void hang() {
  while (true) pause();
}

void spheres(const rayaudit_case*, size_t count, rayaudit_answer* answers) {
  if (has("aborts")) std::abort();
  if (has("throws")) throw std::runtime_error("planted");
  if (has("hangs")) hang();
  if (has("prints")) std::printf("printed by a library\n"), std::fflush(stdout);
  for (size_t i = 0; i < count; ++i) answers[i] = rayaudit_yes();
}

bool is_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

/// Is it asked what it declares: upright along z, two points that are floats?
bool is_as_declared(const rayaudit_case& question) {
  const auto& [base, top, radius] = question.is.cylinder;
  const auto& [from, way, t_min, t_max] = question.ray;
  const bool is_upright = base.x == 0 && base.y == 0 && top.x == 0 && top.y == 0 && top.z > 0 &&
                          base.z == -top.z && is_float(top.z) && is_float(radius);
  return is_upright && t_min == 0 && t_max == 1 && question.extent == RAYAUDIT_UNBOUNDED &&
         is_float(from.x + way.x) && is_float(from.y + way.y) && is_float(from.z + way.z);
}

void cylinders(const rayaudit_case* cases, size_t count, rayaudit_answer*) {
  for (size_t i = 0; i < count; ++i)
    if (!is_as_declared(cases[i])) std::raise(SIGSEGV);
}

rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.extent = RAYAUDIT_UNBOUNDED, made.stand = RAYAUDIT_UPRIGHT_Z, made.segment = 1;
  if (has("contradicts itself")) made.unit_direction = 1;
  if (has("leans")) made.stand = RAYAUDIT_ANYWHERE, made.opening = RAYAUDIT_BY_ANGLE;
  if (has("extends further")) made.extent = 3;
  return made;
}

}  // namespace

const rayaudit_plugin* rayaudit_plugin_entry(void) {
  static rayaudit_subject subject = {};
  static rayaudit_plugin plugin = {RAYAUDIT_PLUGIN_VERSION,
                                   sizeof(rayaudit_case),
                                   sizeof(rayaudit_answer),
                                   sizeof(rayaudit_subject),
                                   1,
                                   &subject};
  subject.name = has("calls itself otherwise") ? "other" : "embree_planted";
  subject.format = "float";
  subject.convention = declared();
  subject.sphere = spheres, subject.cylinder = cylinders;
  subject.about = "Planted 1.0";
  if (has("is of another version")) plugin.version = 7;
  if (has("aborts as it is loaded")) std::abort();
  if (has("hangs as it is loaded")) hang();
  return &plugin;
}
