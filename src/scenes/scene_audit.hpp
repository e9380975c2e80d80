#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "audit/tally.hpp"
#include "scenes/tracer.hpp"

namespace rayaudit {

/// How often something happened to rays, and the case that shows it worst.
struct Trouble {
  std::uint64_t count = 0;
  double severity = 0;  ///< of the example; what it is in, its owner says
  std::optional<Case> example = {};

  void add(double severity, const Case& question);
  void merge(const Trouble& other);
};

/// The rays of one effect and bounce, all their questions settled by the oracle.
struct WaveAccount {
  Effect effect;
  int bounce;
  std::uint64_t rays = 0, questions = 0;
  Tally tally = {};
  /// A ray that leaves a surface and is answered, within its range, to meet it again where it left
  /// it; in the distance, in world units.
  Trouble self_intersections = {};
  /// A ray whose first exact crossing with two surfaces that leave no gap is told of neither; in
  /// the margin of the miss, in u.
  Trouble leaks = {};
  double nanoseconds = 0;  ///< no part of what is the same in every run
};

/// What an offset would make of all rays that leave a surface: of each as it was, but begun by
/// this offset.
struct OffsetAccount {
  Offset offset;
  std::uint64_t rays = 0;
  Trouble acne = {};  ///< self-intersections, as above
  /// The first meetings with each surface (also a true second one with its own) that the ray from
  /// the rounded point has, exactly, and the ray by this offset has not, for it begins beyond them;
  /// in the distance, in world units.
  Trouble lost_contact = {};
};

/// What no offset may be less or more than, in this picture.
struct SafeOffset {
  /// The least t_min, in world units, that skips every departure: the largest root there, exact or
  /// as the subject tells it.
  double t_min = 0;
  /// The first power of two that, as an offset along the normal in ulps of the largest coordinate,
  /// keeps every ray of its wave from being told to meet its surface again; 0 where none was by no
  /// offset, infinite where none keeps. Of several waves the largest, not asked of the others anew.
  double ulps = 0;
  std::optional<Case> t_min_case = {}, ulps_case = {};
  /// The nearest true meeting of a ray that leaves a surface, but for the departure itself: an
  /// offset beyond it loses contact. Infinite where there is none.
  double contact = std::numeric_limits<double>::infinity();
  std::optional<Case> contact_case = {};
};

/// Pairs of a ray and a shape that were not asked since their boxes do not meet; of a share of the
/// rays each is settled exactly, of one in sixteen, of fewer where shapes are many.
struct Culling {
  std::uint64_t asked = 0, settled = 0;  ///< pairs that were asked, and culled ones settled
  Trouble wrong = {};                    ///< culled, though they meet; in the margin, in u
  std::uint64_t culled = 0;              ///< all pairs that were
};

/// All that the audit of a picture tells. Merging is exact but for nanoseconds; in order it is the
/// same to the byte for any number of threads.
struct SceneAccount {
  std::vector<WaveAccount> waves = {};  ///< those that occurred, by bounce, then effect
  std::vector<OffsetAccount> offsets = {};
  SafeOffset safe = {};
  Culling culling = {};

  WaveAccount& wave(Effect effect, int bounce);
  void merge(const SceneAccount& other);
  std::uint64_t wrong() const;
};

/// How to audit a picture.
struct SceneAuditing {
  const Scene& scene;
  const Subject& subject;
  /// The shapes that a ray is asked for: Tracer::candidates.
  std::function<std::vector<std::uint32_t>(const Ray<double>&)> candidates;
  std::span<const Offset> offsets;  ///< to compare
  /// Every culled pair, and not those of one ray in sixteen; every margin.
  bool thorough = false;
};

/// What of the answers to a pixel's rays is worst to see.
struct Sight {
  Verdict worst = Verdict::right;
  bool met_again = false;  ///< a ray is told to meet the surface that it leaves where it leaves it

  friend bool operator==(const Sight&, const Sight&) = default;
};

/// Settles all questions of a wave and adds to the account what the answers are, and to the sight
/// of each pixel, from `first_pixel` on, what is worse than what stands there.
void audit_wave(const SceneAuditing& auditing, const Wave& wave, SceneAccount& account,
                std::uint32_t first_pixel, std::span<Sight> sights);

/// The order of verdicts in a picture: is a worse to see than b? From right, touch on to crashed.
bool is_worse_to_see(Verdict a, Verdict b);

/// At the end: causes of the worst of each outcome.
void conclude(const SceneAuditing& auditing, SceneAccount& account);

}  // namespace rayaudit
