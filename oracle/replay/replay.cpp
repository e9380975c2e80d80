#include "oracle/replay/replay.hpp"

#include <algorithm>

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
  const std::string_view routine = subject.substr(0, subject.rfind('/'));
  const auto found = std::ranges::find(replays, routine, &Replay::routine);
  return found == replays.end() ? nullptr : &*found;
}

}  // namespace rayaudit::replay
