#include "subjects/twins.hpp"

#include <array>
#include <memory>
#include <optional>

#include "routines/routines.hpp"
#include "subjects/plugin_child.hpp"
#include "subjects/plugins.hpp"
#include "subjects/twin.hpp"

namespace rayaudit {
namespace {

namespace fs = std::filesystem;

/// A twin that says nothing for so long hangs.
constexpr std::chrono::milliseconds twin_patience = std::chrono::seconds(10);

struct Flags {
  std::string_view name, about;
};
constexpr std::array all_flags = {Flags{"fast_math", "-O3 -ffast-math"},
                                  Flags{"native", "-O3 -march=native -ffp-contract=fast"}};

std::string file_of(const Flags& flags) { return "rayaudit-" + std::string(flags.name) + ".so"; }

template <class Routine, class N>
Subject twin_of(const Flags& flags, const std::shared_ptr<PluginChild>& child) {
  Subject made = {
      twin_name<Routine>(flags.name) + '/' + std::string(format_of<N>.name), format_of<N>, {}};
  const auto add = [&](std::size_t shape) {
    made.timed[shape] = [child, name = made.name, shape](std::span<const Case> cases,
                                                         std::span<Answer> answers) {
      return child->answer(name, shape, cases, answers);
    };
    made.answer[shape] = made.timed[shape];
  };
  [&]<std::size_t... shape>(std::index_sequence<shape...>) {
    ((takes_shape<Routine, N, shape> ? add(shape) : void()), ...);
  }
  (std::make_index_sequence<shape_count>{});
  return made;
}

}  // namespace

std::vector<Subject> twins_beside(const fs::path& program) {
  std::vector<Subject> twins;
  for (const Flags& flags : all_flags) {
    const std::optional<fs::path> plugin = plugin_beside(program, flags.name);
    if (!plugin) continue;
    const auto child = std::make_shared<PluginChild>(program, *plugin, twin_patience);
    each_twin(Routines{}, [&]<class Routine, class N>() {
      twins.push_back(twin_of<Routine, N>(flags, child));
    });
  }
  return twins;
}

std::vector<Subject> twin_subjects() { return twins_beside(this_program); }

std::vector<Absent> absent_twins() {
  std::vector<Absent> absent;
  for (const Flags& flags : all_flags)
    if (!plugin_beside(this_program, flags.name))
      absent.push_back({"*+" + std::string(flags.name) + "/*", file_of(flags) + ", compiled with " +
                                                                   std::string(flags.about) +
                                                                   ", is not beside the program"});
  return absent;
}

}  // namespace rayaudit
