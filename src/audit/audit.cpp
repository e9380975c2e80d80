#include "audit/audit.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "audit/beyond_rounding.hpp"
#include "audit/minimise.hpp"
#include "audit/on_threads.hpp"

namespace rayaudit {
namespace {

/// Cases go through oracle, subject and judge in portions that stay in the nearest caches.
constexpr std::size_t portion = 128;

/// What audits have in common that share their cases: the same shape, family and format to draw in,
/// and asked alike. The truth of each case is found once for all of them. A subject elsewhere has
/// groups of its own.
struct Group {
  const Family* family;
  std::size_t shape;
  Format drawn_in;
  int bits;  ///< to which t must be known
  Convention asked_by;
  const Subject* elsewhere;
  std::vector<std::size_t> audits = {};

  bool takes(const Group& other) const {
    return family == other.family && shape == other.shape && drawn_in == other.drawn_in &&
           bits == other.bits && asked_by == other.asked_by && elsewhere == other.elsewhere;
  }
};

/// Of a convention only what changes the cases.
Convention asking(const Convention& convention) {
  Convention asked = convention;
  asked.stances = {};
  asked.inside = Convention::Inside::hit;
  return asked;
}

/// The bits of t that a subject's answers are judged by: those of the finest format that shares its
/// cases, so that it is told the same alone and among others.
int bits_of(const Subject& subject) {
  if (subject.format == float_format) return oracle::bits_for(float_format);
  const bool wide = subject.format.precision > long_double_format.precision;
  return oracle::bits_for(wide ? float128_format : long_double_format);
}

std::vector<Group> grouped(const Plan& plan, const std::vector<Audit>& audits) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < audits.size(); ++i) {
    const auto& [subject, family, shape, tally, most_ulps] = audits[i];
    const Group alone = {family,
                         shape,
                         plan.drawn_in ? *plan.drawn_in : subject->drawn_in(),
                         bits_of(*subject),
                         asking(convention_of(plan, *subject)),
                         subject->is_elsewhere ? subject : nullptr};
    auto place = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& group) { return group.takes(alone); });
    if (place == groups.end()) place = groups.insert(place, alone);
    place->audits.push_back(i);
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
                   plan.replay_of(audit.subject->name), convention_of(plan, *audit.subject));
}

/// One subject's part in a chunk.
struct Part {
  const Audit& audit;
  const replay::Replay* replay;
  Convention convention;
  Tally tally = {};
  std::vector<Suspect> suspects = {};
  Margins margins;

  Part(const Plan& plan, const Audit& of)
      : audit(of),
        replay(plan.replay_of(of.subject->name)),
        convention(convention_of(plan, *of.subject)),
        margins(of.subject->format, plan.thorough) {}

  /// A crash costs a process each time it is looked into: only the worst are.
  bool is_suspect(const Answer& answer, const Judgement& judgement) const {
    if (!answer.is_given()) return false;
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

/// Judges one subject's answers to a portion of cases, the first of them closely.
void judge_answers(const Plan& plan, std::span<Settled> settled, std::span<const Answer> answers,
                   std::uint64_t first, std::size_t close, Part& part) {
  for (std::size_t i = 0; i < settled.size(); ++i) {
    if (answers[i].form == Answer::Form::unasked) {
      ++part.tally.unasked;
      continue;
    }
    const Judgement judgement =
        judge(settled[i], answers[i], part.audit.subject->format, part.convention);
    const bool wrong = is_wrong(judgement.verdict);
    const double margin = wrong || i < close ? part.margins.of(settled[i]) : Judgement::unmeasured;
    if (i < close) part.tally.curve.add(margin, wrong);
    const bool beyond_rounding = wrong && plan.beside_textbook &&
                                 is_beyond_rounding(settled[i], answers[i], judgement, margin,
                                                    part.audit.subject->format, part.convention);
    part.tally.add(settled[i], answers[i], judgement, first + i, margin, beyond_rounding);
    if (plan.causes && part.is_suspect(answers[i], judgement))
      part.suspects.push_back({first + i, answers[i], judgement});
  }
}

/// Puts a portion of cases to every subject of a group, where they have not answered already.
void judge_portion(const Plan& plan, const Group& group, std::span<const Case> cases,
                   std::span<const Answer> answered, std::uint64_t first, std::size_t close,
                   std::vector<Part>& parts) {
  std::array<oracle::Truth, portion> truths;
  std::array<Answer, portion> answers;
  const std::size_t size = cases.size();
  oracle::truth(cases, {truths.data(), size}, group.bits);
  std::vector<Settled> settled;
  settled.reserve(size);
  for (std::size_t i = 0; i < size; ++i) settled.emplace_back(cases[i], truths[i]);
  for (Part& part : parts) {
    if (answered.empty())
      part.audit.subject->answer[group.shape](cases, {answers.data(), size});
    else
      std::copy(answered.begin(), answered.end(), answers.begin());
    judge_answers(plan, settled, {answers.data(), size}, first, close, part);
    if (plan.causes) prove_portion(cases.first(close), settled, first, part);
  }
}

/// The chunks of the plan's shard, of which there may be more than memory could list.
class Chunks {
 public:
  explicit Chunks(const Plan& plan) : plan_(plan) {
    const std::uint64_t all = (plan.cases + chunk_cases - 1) / chunk_cases;
    size_ = all > plan.shard ? (all - plan.shard - 1) / plan.shards + 1 : 0;
  }

  std::uint64_t size() const { return size_; }
  std::uint64_t operator[](std::uint64_t i) const { return plan_.shard + i * plan_.shards; }
  /// The cases of the count chunks from the i-th on: every one is full, but perhaps the last of
  /// all.
  std::uint64_t cases(std::uint64_t i, std::uint64_t count) const {
    const std::uint64_t end = i + count == 0 ? 0 : ((*this)[i + count - 1] + 1) * chunk_cases;
    return count * chunk_cases - (count > 0 && end > plan_.cases ? end - plan_.cases : 0);
  }

 private:
  const Plan& plan_;
  std::uint64_t size_ = 0;
};

std::size_t size_of_chunk(const Plan& plan, std::uint64_t chunk) {
  return std::min<std::uint64_t>(chunk_cases, plan.cases - chunk * chunk_cases);
}

/// Draws one chunk of a group's cases, as they are asked.
void draw_chunk(const Plan& plan, const Group& group, std::uint64_t chunk, std::span<Case> cases) {
  draw(*group.family, group.shape, group.drawn_in, plan.difficulty, plan.seed, chunk, cases);
  if (!poses(group.asked_by)) return;
  for (Case& question : cases) question = posed(question, group.asked_by, group.drawn_in);
}

/// Puts one chunk to a group's subjects, where they have not answered it already.
void judge_chunk(const Plan& plan, const Group& group, const std::vector<Audit>& audits,
                 std::uint64_t chunk, std::span<const Case> cases, std::span<const Answer> answers,
                 std::vector<SharedTally>& shared) {
  const std::uint64_t first = chunk * chunk_cases;
  std::vector<Part> parts;
  for (const std::size_t audit : group.audits) parts.emplace_back(plan, audits[audit]);
  for (std::size_t i = 0; i < cases.size(); i += portion) {
    const std::size_t size = std::min(portion, cases.size() - i);
    const std::size_t close = plan.thorough ? size : i == 0 ? std::min(close_a_chunk, size) : 0;
    judge_portion(plan, group, cases.subspan(i, size),
                  answers.empty() ? answers : answers.subspan(i, size), first + i, close, parts);
  }
  for (std::size_t s = 0; s < parts.size(); ++s) {
    parts[s].look_into_suspects(plan, cases, first);
    shared[group.audits[s]].merge(parts[s].tally);
  }
}

void run_chunk(const Plan& plan, const Group& group, const std::vector<Audit>& audits,
               std::uint64_t chunk, std::vector<SharedTally>& shared) {
  std::vector<Case> cases(size_of_chunk(plan, chunk));
  draw_chunk(plan, group, chunk, cases);
  judge_chunk(plan, group, audits, chunk, cases, {}, shared);
}

/// Asks a subject elsewhere several chunks at once, the count from the i-th on: each asking has its
/// price.
void run_elsewhere(const Plan& plan, const Group& group, const std::vector<Audit>& audits,
                   const Chunks& chunks, std::uint64_t i, std::uint64_t count,
                   std::vector<SharedTally>& shared) {
  std::vector<Case> cases(chunks.cases(i, count));
  std::vector<Answer> answers(cases.size());
  const auto each_chunk = [&](const auto& visit) {
    for (std::uint64_t k = 0; k < count; ++k)
      visit(chunks[i + k], k * chunk_cases, size_of_chunk(plan, chunks[i + k]));
  };
  each_chunk([&](std::uint64_t chunk, std::size_t place, std::size_t size) {
    draw_chunk(plan, group, chunk, std::span(cases).subspan(place, size));
  });
  group.elsewhere->answer[group.shape](cases, answers);
  each_chunk([&](std::uint64_t chunk, std::size_t place, std::size_t size) {
    judge_chunk(plan, group, audits, chunk, std::span(cases).subspan(place, size),
                std::span(answers).subspan(place, size), shared);
  });
}

/// Has a case that is asked again, alone, the same verdict? Only a subject elsewhere may differ.
bool shows_again(const Plan& plan, const Subject& subject, const Worst& worst) {
  if (!subject.is_elsewhere) return true;
  const Answer again = answer_one(subject, worst.question);
  if (again.form == Answer::Form::unasked) return true;  // for all that is known
  const Judgement judgement =
      judge(worst.question, again, subject.format, convention_of(plan, subject));
  return judgement.verdict == worst.judgement.verdict;
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

/// All that a subject elsewhere is asked, in order.
void run_all_elsewhere(const Plan& plan, const Subject& subject, const std::vector<Group>& groups,
                       const std::vector<Audit>& audits, const Chunks& chunks,
                       std::vector<SharedTally>& shared, Teller& teller) {
  constexpr std::uint64_t at_once = batch_elsewhere / chunk_cases;
  for (const Group& group : groups)
    for (std::uint64_t i = 0; group.elsewhere == &subject && i < chunks.size(); i += at_once) {
      const std::uint64_t count = std::min(at_once, chunks.size() - i);
      run_elsewhere(plan, group, audits, chunks, i, count, shared);
      teller.add(chunks.cases(i, count));
    }
}

}  // namespace

Convention convention_of(const Plan& plan, const Subject& subject) {
  return joined(plan.convention, subject.convention);
}

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

std::vector<Audit> gathered(const Plan& plan, const std::function<void(Progress)>& tell) {
  std::vector<Audit> audits = planned(plan);
  const Chunks chunks(plan);
  std::vector<Group> groups = grouped(plan, audits);
  // First come those that are one thread's work from end to end.
  std::vector<const Subject*> elsewhere;
  for (const Subject* subject : plan.subjects)
    if (subject->is_elsewhere) elsewhere.push_back(subject);
  const auto here = std::stable_partition(
      groups.begin(), groups.end(), [](const Group& group) { return group.elsewhere != nullptr; });
  std::vector<SharedTally> shared(audits.size());
  Teller teller(chunks.cases(0, chunks.size()) * audits.size(), tell);
  const auto groups_here = static_cast<std::uint64_t>(groups.end() - here);
  on_threads(plan.threads, elsewhere.size() + groups_here * chunks.size(), [&](std::uint64_t i) {
    if (i < elsewhere.size())
      return run_all_elsewhere(plan, *elsewhere[i], groups, audits, chunks, shared, teller);
    const std::uint64_t place = i - elsewhere.size();
    const Group& group = here[static_cast<std::ptrdiff_t>(place / chunks.size())];
    const std::uint64_t chunk = chunks[place % chunks.size()];
    run_chunk(plan, group, audits, chunk, shared);
    teller.add(size_of_chunk(plan, chunk) * group.audits.size());
  });
  for (std::size_t i = 0; i < audits.size(); ++i) audits[i].tally = std::move(shared[i].tally);
  teller.end();
  return audits;
}

void look_into_worst(const Plan& plan, Audit& audit) {
  const auto look_into = [&](Worst& worst) {
    worst.repeats = shows_again(plan, *audit.subject, worst);
    if (!worst.repeats)
      worst.diagnosis = {Cause::unknown};  // experiments would tell of their own answers only
    else
      worst.diagnosis = diagnosis_of(plan, audit, worst.question, worst.answer, worst.judgement);
  };
  for (Outcome& outcome : audit.tally.outcomes)
    if (is_wrong(outcome.verdict)) look_into(*outcome.worst);
  for (auto* worst : {&audit.tally.worst_ulps, &audit.tally.worst_forced, &audit.tally.worst_own})
    if (!plan.bounds.empty() && *worst) look_into(**worst);
}

void conclude(const Plan& plan, std::vector<Audit>& audits) {
  std::erase_if(audits, [](const Audit& audit) { return audit.tally.cases == 0; });
  if (!plan.causes) return;
  std::vector<const Subject*> subjects;
  subjects.reserve(audits.size());
  for (const Audit& audit : audits) subjects.push_back(audit.subject);
  in_turn(plan.threads, subjects, [&](std::size_t i) { look_into_worst(plan, audits[i]); });
  minimise(plan, audits);
}

std::vector<Audit> run(const Plan& plan, const std::function<void(Progress)>& tell) {
  std::vector<Audit> audits = gathered(plan, tell);
  conclude(plan, audits);
  return audits;
}

}  // namespace rayaudit
