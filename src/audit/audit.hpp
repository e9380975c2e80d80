#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "audit/bound.hpp"
#include "audit/margins.hpp"
#include "audit/tally.hpp"
#include "families/family.hpp"
#include "oracle/replay/replay.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// What to audit: every subject on every shape that it answers and every family that draws it.
struct Plan {
  std::vector<const Subject*> subjects;
  std::vector<const Family*> families;
  std::vector<std::size_t> shapes;
  std::uint64_t cases = 0;  ///< for each subject, shape and family
  std::uint64_t seed = 0;
  std::optional<int> difficulty = {};
  /// What is stated of the subjects' conventions, before what each declares itself.
  Convention convention = {};
  /// What the subjects are held to; where to anything, only what these name is audited.
  std::vector<Bound> bounds = {};
  /// Margins, proofs and causes of every case, and not of a share: of each chunk of 1,024 cases the
  /// margins and proofs of the first close_a_chunk, and the causes of replays_a_chunk wrong
  /// answers.
  bool thorough = false;
  /// Draw all cases in this format, whatever the subjects' own.
  std::optional<Format> drawn_in = {};
  /// Look for the causes of wrong answers, and prove right ones? Else only verdicts, errors and
  /// margins are wanted.
  bool causes = true;
  /// Is each wrong answer held beside the textbook's in the same format, to tell what rounding does
  /// not excuse (beyond_rounding.hpp)? Of that the minimal cases are then looked for.
  bool beside_textbook = false;
  int threads = 0;  ///< 0: one for each processor
  /// The replay of a subject by its name, null where it has none.
  std::function<const replay::Replay*(std::string_view)> replay_of = replay::replay_of;
  /// Only the chunks i with i % shards == shard are run: the same cases whoever runs the others.
  std::uint64_t shard = 0, shards = 1;
};

/// What a subject is held to in a plan.
Convention convention_of(const Plan& plan, const Subject& subject);

/// So many cases of each chunk are looked at closely, the first: no case depends on its place.
inline constexpr std::size_t close_a_chunk = 32;
/// So many wrong answers of each chunk are replayed, chosen by the seed, where there are more.
inline constexpr std::size_t replays_a_chunk = 2;

/// One subject on one shape and family.
struct Audit {
  const Subject* subject;
  const Family* family;
  std::size_t shape;
  Tally tally;
  /// The most ulps that a right answer may be off by, where the subject is held to any; beyond, its
  /// cause is looked for too.
  std::optional<double> most_ulps = {};
};

/// How far a run has come, in judged cases.
struct Progress {
  std::uint64_t done, all;
};

/// The audits of a plan before they are run, in the order of the lists: subject, shape, family.
/// Empty where nothing in the plan fits together.
std::vector<Audit> planned(const Plan& plan);

/// Runs the plan; the result is the same for any number of threads. Progress is told now and then,
/// from one thread at a time. An audit whose subject was not asked at all, since it crashed or hung
/// too often before, is left out.
std::vector<Audit> run(const Plan& plan, const std::function<void(Progress)>& tell = {});

/// Its two parts. What all cases of a shard told, each of these audits as it was planned; audits of
/// several shards merge, in any order.
std::vector<Audit> gathered(const Plan& plan, const std::function<void(Progress)>& tell = {});
/// And what is then asked about the worst of all: causes, and whether it shows again.
void conclude(const Plan& plan, std::vector<Audit>& audits);
/// Of one audit: the cause of every worst case that reports tell of, of wrong answers, and where a
/// subject is held to bounds also of its largest errors; and whether each shows again.
void look_into_worst(const Plan& plan, Audit& audit);

}  // namespace rayaudit
