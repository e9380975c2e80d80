#include "oracle/self_check.hpp"

#include <array>
#include <string_view>

#include "geometry/case_line.hpp"
#include "oracle/environment.hpp"
#include "oracle/radical.hpp"
#include "oracle/stages.hpp"

namespace rayaudit::oracle {
namespace {

/// A case whose first crossing was worked out by hand; a miss where there is no t.
struct Proved {
  std::string_view line;
  Kind kind;
  std::optional<double> t;
};

constexpr std::array proved = {
    Proved{"sphere 0 0 0 1 ray 0 0 -3 0 0 1", Kind::proper, 2},
    Proved{"sphere 0 0 0 1 ray 0 1 -3 0 0 1", Kind::tangent, 3},
    Proved{"sphere 0 0 0 5 ray 3 0 0 0 2 0", Kind::proper, 2},
    Proved{"sphere 0 0 0 1 ray 0 0x1.0000000000001p+0 -3 0 0 1", Kind::proper, {}},
    Proved{"disk 0 0 0 0 1 0 5 ray 3 2 4 0 -4 0", Kind::rim, 0.5},
    Proved{"disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0", Kind::within, 2},
    Proved{"disk 0 0 0 0 1 0 1 ray -3 1 0 1 0 0", Kind::proper, {}},
    Proved{"cylinder 0 0 0 0 1 0 5 ray -9 0.5 4 2 0 0", Kind::proper, 3},
    Proved{"cylinder 0 0 0 0 1 0 1 ray -3 1 0 1 0 0", Kind::rim, 2},
    Proved{"cylinder 0 0 0 0 1 0 1 ray 1 -2 0 0 0.5 0", Kind::within, 4},
    Proved{"cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0", Kind::apex, 3},
    Proved{"cone 0 0 0 0 1 0 1 ray 0 -3 0 0 2 0", Kind::proper, 2},
    Proved{"cone 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0", Kind::proper, {}},
    Proved{"capped_cylinder 0 0 0 0 1 0 5 ray -9 0.5 4 2 0 0", Kind::proper, 3},
    Proved{"capped_cylinder 0 0 0 0 1 0 1 ray 0.5 3 0 0 -2 0", Kind::proper, 1},
    Proved{"capped_cylinder 0 0 0 0 1 0 1 ray -2 2 0 1 -1 0", Kind::proper, 1},
    Proved{"capped_cylinder 0 0 0 0 1 0 1 ray -2 0 0 1 1 0", Kind::rim, 1},
    Proved{"capped_cylinder 0 0 0 0 1 0 1 ray -3 1 0 1 0 0", Kind::within, 2},
    Proved{"capped_cylinder 0 0 0 0 1 0 1 ray 1.5 -2 0 0 1 0", Kind::proper, {}},
    Proved{"capped_cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0", Kind::apex, 3},
    Proved{"capped_cone 0 0 0 0 1 0 1 ray 0 3 0 0 -1 0", Kind::proper, 2},
    Proved{"capped_cone 0 0 0 0 1 0 1 ray 0.25 -3 0 0 2 0", Kind::proper, 1.5},
    Proved{"capped_cone 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0", Kind::proper, {}},
};

bool agrees(const Proved& known, std::span<const Crossing> found) {
  if (!known.t) return found.empty();
  return !found.empty() && found[0].kind == known.kind && compare(found[0].t, real(*known.t)) == 0;
}

}  // namespace

std::optional<std::string> self_check() {
  try {
    require_plain_arithmetic();
  } catch (const UnfitArithmetic& why) {
    return why.what();
  }
  if (!rounds_to_float({0.1, 0.2, 0.3}))
    return "this program was compiled without the rounding of double to float";
  for (const Proved& known : proved) {
    const Case question = read_case_line(known.line).question;
    const ExactRoots exact = exact_roots(question, false);
    std::array<Crossing, Truth::most_roots> crossings;
    for (int i = 0; i < exact.count; ++i)
      crossings[i] = {exact.listed[i].outlined.kind, value(exact.listed[i].t, 63), {}};
    if (!agrees(known, {crossings.data(), exact.count}))
      return "exact numbers settle a hand-proved case wrongly: " + std::string(known.line);
    const Truth found = truth(question);
    if (!agrees(known, found.crossings()))
      return "the oracle settles a hand-proved case wrongly: " + std::string(known.line);
  }
  return {};
}

}  // namespace rayaudit::oracle
