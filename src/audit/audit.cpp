#include "audit/audit.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <tuple>

namespace rayaudit {
namespace {

/// Cases go through oracle, subject and judge in portions that stay in the nearest caches.
constexpr std::size_t portion = 128;

/// Audits that share their cases: the same shape, family and format to draw in. The truth of each
/// case is found once for all of them.
struct Group {
  const Family* family;
  std::size_t shape;
  Format drawn_in;
  std::vector<std::size_t> audits;

  /// To which t must be known: for the finest format that is asked such cases, whoever takes part.
  int bits() const {
    return oracle::bits_for(drawn_in == float_format ? float_format : long_double_format);
  }
};

std::vector<Group> grouped(const std::vector<Audit>& audits) {
  std::vector<Group> groups;
  std::map<std::tuple<const Family*, std::size_t, int>, std::size_t> places;
  for (std::size_t i = 0; i < audits.size(); ++i) {
    const auto& [subject, family, shape, tally] = audits[i];
    const Format& format = subject->drawn_in();
    const auto [place, is_new] =
        places.try_emplace({family, shape, format.precision}, groups.size());
    if (is_new) groups.push_back({family, shape, format, {}});
    groups[place->second].audits.push_back(i);
  }
  return groups;
}

/// A tally that many threads add to.
struct SharedTally {
  std::mutex mutex;
  Tally tally;

  void merge(const Tally& part) {
    const std::lock_guard lock(mutex);
    tally.merge(part);
  }
};

/// Puts a portion of cases to every subject of a group.
void judge_portion(const Plan& plan, const Group& group, const std::vector<Audit>& audits,
                   std::span<const Case> cases, std::uint64_t first, std::vector<Tally>& tallies) {
  std::array<oracle::Truth, portion> truths;
  std::array<Answer, portion> answers;
  const std::size_t size = cases.size();
  oracle::truth(cases, {truths.data(), size}, group.bits());
  std::vector<Settled> settled;
  settled.reserve(size);
  for (std::size_t i = 0; i < size; ++i) settled.emplace_back(cases[i], truths[i]);
  for (std::size_t s = 0; s < group.audits.size(); ++s) {
    const Subject& subject = *audits[group.audits[s]].subject;
    subject.answer[group.shape](cases, {answers.data(), size});
    for (std::size_t i = 0; i < size; ++i)
      tallies[s].add(settled[i], answers[i],
                     judge(settled[i], answers[i], subject.format, plan.convention), first + i);
  }
}

/// Draws one chunk of a group's cases and puts it to its subjects.
void run_chunk(const Plan& plan, const Group& group, const std::vector<Audit>& audits,
               std::uint64_t chunk, std::vector<SharedTally>& shared) {
  const std::uint64_t first = chunk * chunk_cases;
  std::vector<Case> cases(std::min<std::uint64_t>(chunk_cases, plan.cases - first));
  draw(*group.family, group.shape, group.drawn_in, plan.difficulty, plan.seed, chunk, cases);
  std::vector<Tally> tallies(group.audits.size());
  for (std::size_t i = 0; i < cases.size(); i += portion)
    judge_portion(plan, group, audits,
                  std::span(cases).subspan(i, std::min(portion, cases.size() - i)), first + i,
                  tallies);
  for (std::size_t s = 0; s < group.audits.size(); ++s) shared[group.audits[s]].merge(tallies[s]);
}

/// Counts judged cases and passes the count on, from one thread at a time.
class Teller {
 public:
  Teller(std::uint64_t all, const std::function<void(Progress)>& tell) : all_(all), tell_(tell) {}

  void add(std::uint64_t cases) {
    done_ += cases;
    if (!tell_) return;
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock) tell_({done_, all_});
  }
  void end() const {
    if (tell_) tell_({all_, all_});
  }

 private:
  std::uint64_t all_;
  const std::function<void(Progress)>& tell_;
  std::atomic<std::uint64_t> done_ = 0;
  std::mutex mutex_;
};

}  // namespace

std::vector<Audit> planned(const Plan& plan) {
  std::vector<Audit> audits;
  for (const Subject* subject : plan.subjects)
    for (const std::size_t shape : plan.shapes)
      for (const Family* family : plan.families)
        if (subject->answers(shape) && family->draw[shape] != nullptr)
          audits.push_back({subject, family, shape, {}});
  return audits;
}

std::vector<Audit> run(const Plan& plan, const std::function<void(Progress)>& tell) {
  std::vector<Audit> audits = planned(plan);
  const std::vector<Group> groups = grouped(audits);
  std::vector<SharedTally> shared(audits.size());
  const std::uint64_t chunks = (plan.cases + chunk_cases - 1) / chunk_cases;
  Teller teller(plan.cases * audits.size(), tell);
  // Unasked, TBB gives no more threads than there are processors.
  std::optional<tbb::global_control> allowed;
  if (plan.threads > 0) allowed.emplace(tbb::global_control::max_allowed_parallelism, plan.threads);
  tbb::task_arena arena(plan.threads > 0 ? plan.threads : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(std::uint64_t{0}, groups.size() * chunks, [&](std::uint64_t i) {
      const Group& group = groups[i / chunks];
      run_chunk(plan, group, audits, i % chunks, shared);
      const std::uint64_t first = i % chunks * chunk_cases;
      teller.add(std::min<std::uint64_t>(chunk_cases, plan.cases - first) * group.audits.size());
    });
  });
  teller.end();
  for (std::size_t i = 0; i < audits.size(); ++i) audits[i].tally = std::move(shared[i].tally);
  return audits;
}

}  // namespace rayaudit
