#include "families/anywhere.hpp"
#include "families/closed.hpp"
#include "families/degenerate.hpp"
#include "families/family.hpp"
#include "families/near.hpp"
#include "families/odd.hpp"
#include "families/proportion.hpp"

namespace rayaudit {
namespace {

using namespace drawing;

constexpr Difficulty ulps_off = {0, 10, 30, "2^k ulps off"};

// clang-format off
/// id, about, strength, difficulty; and what draws disk, sphere, cylinder and cone, and the closed ones.
constexpr Family table[] = {
    {"anywhere", "nothing special; near half of the rays hit", Strength::anywhere, {},
     {anywhere<Disk>, anywhere<Sphere>, anywhere<Cylinder>, anywhere<Cone>,
      closed<anywhere<Cylinder>>, closed<anywhere<Cone>>}},
    {"grazing", "impact parameter r(1 +- 2^-k)", Strength::near,
     Difficulty{1, 22, 51, "radius off by 2^-k of it"},
     {grazing<Disk>, grazing<Sphere>, grazing<Cylinder>, grazing<Cone>,
      closed<grazing<Cylinder>>, closed<grazing<Cone>>}},
    {"tangent", "in the tangent plane of a surface point", Strength::degenerate, {},
     {nullptr, tangent<Sphere>, tangent<Cylinder>, tangent<Cone>,
      closed<tangent<Cylinder>>, closed<tangent<Cone>>}},
    {"tangent-near", "tangent: one number 2^k ulps off", Strength::near, ulps_off,
     {nullptr, near<tangent<Sphere>>, near<tangent<Cylinder>>, near<tangent<Cone>>,
      near<closed<tangent<Cylinder>>>, near<closed<tangent<Cone>>>}},
    {"rim", "through the rim, of a closed shape an edge", Strength::degenerate, {},
     {rim<Disk>, nullptr, rim<Cylinder>, rim<Cone>,
      edge<Cylinder>, edge<Cone>}},
    {"rim-near", "rim: one number 2^k ulps off", Strength::near, ulps_off,
     {near<rim<Disk>>, nullptr, near<rim<Cylinder>>, near<rim<Cone>>,
      near<edge<Cylinder>>, near<edge<Cone>>}},
    {"apex", "through the apex, most from outside the cone", Strength::degenerate, {},
     {nullptr, nullptr, nullptr, apex<Cone>,
      nullptr, closed<apex<Cone>>}},
    {"apex-near", "apex: one number 2^k ulps off", Strength::near, ulps_off,
     {nullptr, nullptr, nullptr, near<apex<Cone>>,
      nullptr, near<closed<apex<Cone>>>}},
    {"parallel", "to plane, axis, generator or cap", Strength::degenerate, {},
     {parallel<Disk>, nullptr, parallel<Cylinder>, parallel<Cone>,
      closed_parallel<Cylinder>, closed_parallel<Cone>}},
    {"parallel-near", "turned from parallel by 2^-k", Strength::near,
     Difficulty{1, 24, 53, "angle 2^-k"},
     {parallel_near<Disk>, nullptr, parallel_near<Cylinder>, parallel_near<Cone>,
      closed<parallel_near<Cylinder>>, closed<parallel_near<Cone>>}},
    {"perpendicular", "to the axis; along the normal of the disk", Strength::degenerate, {},
     {perpendicular<Disk>, nullptr, perpendicular<Cylinder>, perpendicular<Cone>,
      closed<perpendicular<Cylinder>>, closed<perpendicular<Cone>>}},
    {"within", "in the plane of disk or cap, along a generator", Strength::degenerate, {},
     {within<Disk>, nullptr, within<Cylinder>, within<Cone>,
      closed_within<Cylinder>, closed_within<Cone>}},
    {"within-near", "within: one number 2^k ulps off", Strength::near, ulps_off,
     {near<within<Disk>>, nullptr, near<within<Cylinder>>, near<within<Cone>>,
      near<closed_within<Cylinder>>, near<closed_within<Cone>>}},
    {"inside", "the origin inside the shape", Strength::anywhere, {},
     {nullptr, inside<Sphere>, inside<Cylinder>, inside<Cone>,
      closed<inside<Cylinder>>, closed<inside<Cone>>}},
    {"surface", "the ray begins exactly on the surface", Strength::degenerate, {},
     {surface<Disk>, surface<Sphere>, surface<Cylinder>, surface<Cone>,
      closed_surface<Cylinder>, closed_surface<Cone>}},
    {"surface-near", "the origin 2^k ulps off the surface; an eye 2 above a planet", Strength::near,
     ulps_off,
     {surface_near<Disk>, surface_near<Sphere>, surface_near<Cylinder>, surface_near<Cone>,
      closed_surface_near<Cylinder>, closed_surface_near<Cone>}},
    {"spawned", "the origin a surface point rounded to the format", Strength::near, {},
     {spawned<Disk>, spawned<Sphere>, spawned<Cylinder>, spawned<Cone>,
      closed_spawned<Cylinder>, closed_spawned<Cone>}},
    {"far", "the origin 2^k radii away", Strength::anywhere,
     Difficulty{1, 24, 53, "distance 2^k radii"},
     {far<Disk>, far<Sphere>, far<Cylinder>, far<Cone>,
      closed<far<Cylinder>>, closed<far<Cone>>}},
    {"placement", "everything 1e6 to 1e8 from the world origin", Strength::anywhere,
     Difficulty{3, 16, 45, "2^k sizes from the world origin"},
     {placement<Disk>, placement<Sphere>, placement<Cylinder>, placement<Cone>,
      closed<placement<Cylinder>>, closed<placement<Cone>>}},
    {"slender", "much higher than wide", Strength::anywhere,
     Difficulty{1, 20, 20, "height 2^k radii"},
     {nullptr, nullptr, slender<Cylinder>, slender<Cone>,
      closed<slender<Cylinder>>, closed<slender<Cone>>}},
    {"flat", "much wider than high", Strength::anywhere,
     Difficulty{1, 16, 45, "height 2^-k radii"},
     {nullptr, nullptr, flat<Cylinder>, flat<Cone>,
      closed<flat<Cylinder>>, closed<flat<Cone>>}},
    {"length", "directions far from unit length", Strength::anywhere,
     Difficulty{1, 120, 1000, "|d| about 2^k or 2^-k"},
     {length<Disk>, length<Sphere>, length<Cylinder>, length<Cone>,
      closed<length<Cylinder>>, closed<length<Cone>>}},
    {"unit", "directions normalised in the format", Strength::anywhere, {},
     {unit<Disk>, unit<Sphere>, unit<Cylinder>, unit<Cone>,
      closed<unit<Cylinder>>, closed<unit<Cone>>}},
    {"axis", "directions along the coordinate axes, with negative zeros", Strength::anywhere, {},
     {axis<Disk>, axis<Sphere>, axis<Cylinder>, axis<Cone>,
      closed<axis<Cylinder>>, closed<axis<Cone>>}},
    {"scale", "huge and tiny numbers, to the limits of the format", Strength::anywhere,
     Difficulty{1, 137, 1062, "numbers times 2^k or 2^-k"},
     {scale<Disk>, scale<Sphere>, scale<Cylinder>, scale<Cone>,
      closed<scale<Cylinder>>, closed<scale<Cone>>}},
    {"behind", "all crossings at t < 0", Strength::anywhere, {},
     {behind<Disk>, behind<Sphere>, behind<Cylinder>, behind<Cone>,
      closed<behind<Cylinder>>, closed<behind<Cone>>}},
    {"lattice", "small whole numbers and halves, much through the world origin", Strength::anywhere,
     {},
     {lattice<Disk>, lattice<Sphere>, lattice<Cylinder>, lattice<Cone>,
      closed<lattice<Cylinder>>, closed<lattice<Cone>>}},
    {"invalid", "no case at all, each in its way", Strength::anywhere, {},
     {invalid<Disk>, invalid<Sphere>, invalid<Cylinder>, invalid<Cone>,
      closed<invalid<Cylinder>>, closed<invalid<Cone>>}},
};
// clang-format on

}  // namespace

std::span<const Family> families() { return table; }

void draw(const Family& family, std::size_t shape, const Format& format,
          std::optional<int> difficulty, std::uint64_t seed, std::uint64_t chunk,
          std::span<Case> cases) {
  const auto asked = family.difficulty ? difficulty : std::nullopt;
  Random random(seed, family.id, shape_names[shape], format, asked, chunk);
  const auto k = [&]() -> int {
    if (asked || !family.difficulty) return asked.value_or(0);
    return static_cast<int>(
        random.whole(family.difficulty->least, family.difficulty->most(format)));
  };
  for (Case& question : cases) question = family.draw[shape](random, format, k());
}

}  // namespace rayaudit
