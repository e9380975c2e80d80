#include "audit/audit.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <tuple>

#include "oracle/replay/replay.hpp"

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
  int bits;  ///< to which t must be known
  std::vector<std::size_t> audits;
};

/// The bits of t that a subject's answers are judged by: those of the finest format that shares its
/// cases, so that it is told the same alone and among others.
int bits_of(const Subject& subject) {
  if (subject.format == float_format) return oracle::bits_for(float_format);
  const bool wide = subject.format.precision > long_double_format.precision;
  return oracle::bits_for(wide ? float128_format : long_double_format);
}

std::vector<Group> grouped(const Plan& plan, const std::vector<Audit>& audits) {
  std::vector<Group> groups;
  std::map<std::tuple<const Family*, std::size_t, int, int>, std::size_t> places;
  for (std::size_t i = 0; i < audits.size(); ++i) {
    const auto& [subject, family, shape, tally, most_ulps] = audits[i];
    const Format& format = plan.drawn_in ? *plan.drawn_in : subject->drawn_in();
    const int bits = bits_of(*subject);
    const auto [place, is_new] =
        places.try_emplace({family, shape, format.precision, bits}, groups.size());
    if (is_new) groups.push_back({family, shape, format, bits, {}});
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

/// An answer whose cause may be looked for.
struct Suspect {
  std::uint64_t place;  ///< which case of the audit it answers
  Answer answer;
  Judgement judgement;
};

/// A number that depends on seed and place alone, and on every bit of both (the finalizer of
/// SplitMix64: Steele, Lea & Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
std::uint64_t lot(std::uint64_t seed, std::uint64_t place) {
  std::uint64_t x = seed + place * 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// Those to be replayed: of each chunk some few, drawn by lot.
void draw_lots(std::vector<Suspect>& suspects, std::uint64_t seed) {
  if (suspects.size() <= replays_a_chunk) return;
  std::partial_sort(
      suspects.begin(), suspects.begin() + replays_a_chunk, suspects.end(),
      [&](const Suspect& a, const Suspect& b) { return lot(seed, a.place) < lot(seed, b.place); });
  suspects.resize(replays_a_chunk);
}

/// Finds the cause of an answer, from nothing but the case and what was said.
Diagnosis diagnosis_of(const Plan& plan, const Audit& audit, const Case& question,
                       const Answer& answer, const Judgement& judgement) {
  const oracle::Truth truth = oracle::truth(question, oracle::bits_for(audit.subject->format));
  Settled settled(question, truth);
  // A right answer is mended where its error is, by half of it where no more is held.
  std::optional<double> most_ulps;
  if (!is_wrong(judgement.verdict)) most_ulps = audit.most_ulps.value_or(judgement.ulps / 2);
  return diagnosis({settled, answer, judgement, most_ulps}, *audit.subject,
                   replay::replay_of(audit.subject->name), plan.convention);
}

/// One subject's part in a chunk.
struct Part {
  const Audit& audit;
  const replay::Replay* replay;
  Tally tally = {};
  std::vector<Suspect> suspects = {};
  std::size_t slow_margins = 0;

  explicit Part(const Audit& of) : audit(of), replay(replay::replay_of(of.subject->name)) {}

  /// The margin of a case in u of the subject's format; NaN for an invalid one, and where it would
  /// take long and this has been so too often in the chunk.
  double margin(const Plan& plan, Settled& settled) {
    const std::optional<double> quick = settled.quick_reach();
    if (!quick && !plan.thorough && ++slow_margins > slow_margins_a_chunk)
      return Judgement::unmeasured;
    return std::ldexp(quick ? *quick : settled.reach(), audit.subject->format.precision);
  }

  bool is_suspect(const Judgement& judgement) const {
    return is_wrong(judgement.verdict) || (audit.most_ulps && judgement.ulps > *audit.most_ulps);
  }

  void look_into_suspects(const Plan& plan, std::span<const Case> cases, std::uint64_t first) {
    if (!plan.thorough) draw_lots(suspects, plan.seed);
    for (const auto& [place, answer, judgement] : suspects)
      tally.outcome(judgement.verdict, judgement.claim)
          .causes.add(diagnosis_of(plan, audit, cases[place - first], answer, judgement));
  }
};

/// Runs a portion of cases with error bounds.
void prove_portion(std::span<const Case> cases, std::span<Settled> settled, std::uint64_t first,
                   Part& part) {
  const Subject& subject = *part.audit.subject;
  const auto& prove = subject.prove[part.audit.shape];
  if (!prove || part.replay == nullptr) return;
  std::array<Proved, portion> proofs;
  prove(cases, {proofs.data(), cases.size()});
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (settled[i].truth().invalid == oracle::Invalid::no)
      part.tally.certificate.add(settled[i], proofs[i], *part.replay, subject.format, first + i);
}

/// Puts a portion of cases to every subject of a group, the first of them closely.
void judge_portion(const Plan& plan, const Group& group, std::span<const Case> cases,
                   std::uint64_t first, std::size_t close, std::vector<Part>& parts) {
  std::array<oracle::Truth, portion> truths;
  std::array<Answer, portion> answers;
  const std::size_t size = cases.size();
  oracle::truth(cases, {truths.data(), size}, group.bits);
  std::vector<Settled> settled;
  settled.reserve(size);
  for (std::size_t i = 0; i < size; ++i) settled.emplace_back(cases[i], truths[i]);
  for (Part& part : parts) {
    const Subject& subject = *part.audit.subject;
    subject.answer[group.shape](cases, {answers.data(), size});
    for (std::size_t i = 0; i < size; ++i) {
      const Judgement judgement = judge(settled[i], answers[i], subject.format, plan.convention);
      const bool wrong = is_wrong(judgement.verdict);
      const double margin =
          wrong || i < close ? part.margin(plan, settled[i]) : Judgement::unmeasured;
      if (i < close) part.tally.curve.add(margin, wrong);
      part.tally.add(settled[i], answers[i], judgement, first + i, margin);
      if (plan.causes && part.is_suspect(judgement))
        part.suspects.push_back({first + i, answers[i], judgement});
    }
    if (plan.causes) prove_portion(cases.first(close), settled, first, part);
  }
}

/// Draws one chunk of a group's cases and puts it to its subjects.
void run_chunk(const Plan& plan, const Group& group, const std::vector<Audit>& audits,
               std::uint64_t chunk, std::vector<SharedTally>& shared) {
  const std::uint64_t first = chunk * chunk_cases;
  std::vector<Case> cases(std::min<std::uint64_t>(chunk_cases, plan.cases - first));
  draw(*group.family, group.shape, group.drawn_in, plan.difficulty, plan.seed, chunk, cases);
  std::vector<Part> parts;
  for (const std::size_t audit : group.audits) parts.emplace_back(audits[audit]);
  for (std::size_t i = 0; i < cases.size(); i += portion) {
    const std::size_t size = std::min(portion, cases.size() - i);
    const std::size_t close = plan.thorough ? size : i == 0 ? std::min(close_a_chunk, size) : 0;
    judge_portion(plan, group, std::span(cases).subspan(i, size), first + i, close, parts);
  }
  for (std::size_t s = 0; s < parts.size(); ++s) {
    parts[s].look_into_suspects(plan, cases, first);
    shared[group.audits[s]].merge(parts[s].tally);
  }
}

/// Finds the cause of every worst case that reports tell of: of wrong answers, and where a subject
/// is held to bounds also of its largest errors.
void look_into_worst(const Plan& plan, Audit& audit) {
  const auto look_into = [&](Worst& worst) {
    worst.diagnosis = diagnosis_of(plan, audit, worst.question, worst.answer, worst.judgement);
  };
  for (Outcome& outcome : audit.tally.outcomes)
    if (is_wrong(outcome.verdict)) look_into(*outcome.worst);
  for (auto* worst : {&audit.tally.worst_ulps, &audit.tally.worst_forced, &audit.tally.worst_own})
    if (!plan.bounds.empty() && *worst) look_into(**worst);
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
          audits.push_back({subject, family, shape, {}, {}});
  if (plan.bounds.empty()) return audits;
  std::erase_if(audits, [&](const Audit& audit) { return !is_named(audit, plan.bounds); });
  for (Audit& audit : audits) audit.most_ulps = most_ulps(audit, plan.bounds);
  return audits;
}

std::vector<Audit> run(const Plan& plan, const std::function<void(Progress)>& tell) {
  std::vector<Audit> audits = planned(plan);
  const std::vector<Group> groups = grouped(plan, audits);
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
  for (std::size_t i = 0; i < audits.size(); ++i) audits[i].tally = std::move(shared[i].tally);
  if (plan.causes)
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, audits.size(),
                        [&](std::size_t i) { look_into_worst(plan, audits[i]); });
    });
  teller.end();
  return audits;
}

}  // namespace rayaudit
