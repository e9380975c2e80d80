#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/scene_run.hpp"

/// What all reports of a scene say, in the same words.
namespace rayaudit::scenes {

/// The wrong answers of one verdict and claim in all of a picture.
struct Finding {
  /// Those of one effect.
  struct Part {
    Effect effect;
    std::uint64_t count = 0;
  };

  Verdict verdict;
  Claim claim;
  std::uint64_t count = 0;
  std::vector<Part> parts = {};  ///< by effect
  const Worst* worst = nullptr;  ///< the one with the largest margin; points into the account
};

/// The findings of an account, worst first: by the power of two of the largest margin at which an
/// answer is wrong, up to defect_margin, then by their count. Conduct on invalid cases comes last.
std::vector<Finding> findings(const SceneAccount& account);

/// How often it occurs to the rays of which effect, and its worst case in words.
std::string where(const Finding& finding);

/// All waves as one, whose effect and bounce mean nothing.
WaveAccount sum(const SceneAccount& account);

/// An effect, and what it took.
struct EffectUse {
  const Calling* calling;
  bool is_on = false;  ///< in the plan
  std::uint64_t rays = 0;
  double nanoseconds = 0;
};
std::vector<EffectUse> uses(const SceneRun& run);

/// `on`, `off` or, where the scene calls for it all the same, `taken away`.
std::string_view state(const EffectUse& use);
/// Where in the file and why, or why not.
std::string reason(const EffectUse& use);

/// The command that shows a case to a subject, step by step.
std::string explain_line(const Case& question, const Subject& subject);

/// A count with its noun: `1 leak`, `12 leaks`.
std::string counted(std::uint64_t count, std::string_view noun);

/// What was made: scene, film, subject, offset, seed; a sentence without its full stop.
std::string title(const SceneRun& run);
/// By how much the shapes were rounded; empty where they were not.
std::string rounding(const SceneRun& run);
/// The smallest safe offset against the nearest contact; empty where no ray leaves a surface.
std::string safe_offset(const SceneAccount& account);
/// What the rows of the offsets are about, in sentences.
std::string about_offsets(const SceneAccount& account);
/// What came of the culled pairs that were settled; empty where none were.
std::string culling(const Culling& culling);
/// What is wrong of how much, and whether the picture is whole.
std::string summary(const SceneRun& run);

}  // namespace rayaudit::scenes
