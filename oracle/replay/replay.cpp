#include "oracle/replay/replay.hpp"

#include <algorithm>
#include <array>

#include "oracle/replay/replay_of.hpp"
#include "routines/routines.hpp"

namespace rayaudit::replay {
namespace {

template <class... Routine>
std::array<Replay, sizeof...(Routine)> replays_of(const std::tuple<Routine...>&) {
  return {replay_made_of<Routine>()...};
}

}  // namespace

const Replay* replay_of(std::string_view subject) {
  static const auto replays = replays_of(Routines{});
  const std::size_t slash = subject.rfind('/');
  const std::string_view routine = subject.substr(0, slash);
  const auto is_its_number = [&](const Format& format) {
    return slash != subject.npos && format.name == subject.substr(slash + 1);
  };
  constexpr std::array watched = {float_format, double_format, long_double_format};
  if (std::ranges::none_of(watched, is_its_number)) return nullptr;
  const auto found = std::ranges::find(replays, routine, &Replay::routine);
  return found == replays.end() ? nullptr : &*found;
}

}  // namespace rayaudit::replay
