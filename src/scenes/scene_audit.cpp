#include "scenes/scene_audit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "audit/audit.hpp"
#include "audit/margins.hpp"
#include "scenes/line_roots.hpp"
#include "scenes/offset_audit.hpp"
#include "scenes/seam_leaks.hpp"

namespace rayaudit {
namespace {

/// Margins are looked into closely for some cases of so many, as an audit of families does.
constexpr std::size_t chunk = chunk_cases;

/// Of the culled pairs of a wave about so many are settled at most.
constexpr std::uint64_t most_settled = 8'192;

/// Is the pixel one of those drawn by lot, one in so many? By multiplication with the golden ratio
/// (Knuth, The Art of Computer Programming 3, 6.4).
bool is_drawn(std::uint32_t pixel, std::uint64_t one_in) {
  const std::uint64_t lot = (pixel + std::uint64_t{1}) * 0x9e3779b97f4a7c15;
  return lot <= ~std::uint64_t{0} / one_in;
}

/// The questions of a wave as they are judged, one by one.
class WaveJudge {
 public:
  WaveJudge(const SceneAuditing& auditing, const Wave& wave, WaveAccount& account,
            std::uint32_t first_pixel, std::span<Sight> sights)
      : auditing_(auditing),
        format_(auditing.subject.format),
        wave_(wave),
        account_(account),
        first_pixel_(first_pixel),
        sights_(sights),
        leaks_(auditing.scene) {}

  void judge_all() {
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      Margins margins(format_, auditing_.thorough);
      each_truth(wave_.cases[shape], format_, [&](std::size_t i, const oracle::Truth& truth) {
        if (i % chunk == 0) margins = Margins(format_, auditing_.thorough);
        judge_one(shape, i, truth, margins);
      });
    }
    Margins margins(format_, auditing_.thorough);
    leaks_.count(wave_, margins, account_.leaks);
  }

 private:
  void judge_one(std::size_t shape, std::size_t i, const oracle::Truth& truth, Margins& margins) {
    const Case& question = wave_.cases[shape][i];
    const Answer& answer = wave_.answers[shape][i];
    ++account_.questions;
    if (answer.form == Answer::Form::unasked) {
      ++account_.tally.unasked;
      return;
    }
    Settled settled(question, truth);
    const Judgement judgement = judge(settled, answer, format_, auditing_.subject.convention);
    const auto& [ray, primitive] = wave_.pairs[shape][i];
    const SceneRay& asked = wave_.rays[ray];
    add(settled, answer, judgement, std::uint64_t{asked.pixel} << 32 | primitive, margins,
        auditing_.thorough || i % chunk < close_a_chunk);
    see(asked.pixel, judgement.verdict);
    leaks_.add(wave_, shape, i, truth, judgement);
    if (asked.from == static_cast<std::int32_t>(primitive))
      if (const auto off = self_intersection(question, truth, answer)) {
        account_.self_intersections.add(*off, question);
        see_met_again(asked.pixel);
      }
  }

  void add(Settled& settled, const Answer& answer, const Judgement& judgement, std::uint64_t place,
           Margins& margins, bool is_close) {
    const bool wrong = is_wrong(judgement.verdict);
    const double margin = wrong || is_close ? margins.of(settled) : Judgement::unmeasured;
    if (is_close) account_.tally.curve.add(margin, wrong);
    account_.tally.add(settled, answer, judgement, place, margin);
  }

  void see(std::uint32_t pixel, Verdict verdict) {
    Verdict& seen = sights_[pixel - first_pixel_].worst;
    if (is_worse_to_see(verdict, seen)) seen = verdict;
  }

  void see_met_again(std::uint32_t pixel) { sights_[pixel - first_pixel_].met_again = true; }

  const SceneAuditing& auditing_;
  const Format& format_;
  const Wave& wave_;
  WaveAccount& account_;
  std::uint32_t first_pixel_;
  std::span<Sight> sights_;
  SeamLeaks leaks_;
};

/// Settles what was culled of the rays that are drawn by lot.
class WaveCulling {
 public:
  WaveCulling(const SceneAuditing& auditing, const Wave& wave, Culling& account)
      : auditing_(auditing), wave_(wave), account_(account) {}

  void settle() {
    const std::uint64_t all = wave_.rays.size() * auditing_.scene.primitives.size();
    const std::uint64_t one_in =
        auditing_.thorough ? 1 : std::max<std::uint64_t>(16, all / most_settled);
    std::uint64_t asked = 0, never_asked = 0;
    for (const auto& of_shape : wave_.pairs) asked += of_shape.size();
    for (const SceneRay& ray : wave_.rays) never_asked += ray.light != SceneRay::nothing;
    account_.asked += asked;
    account_.culled += all - asked - never_asked;
    for (const SceneRay& ray : wave_.rays)
      if (is_drawn(ray.pixel, one_in)) leave_out(ray);
    for (std::vector<Case>& cases : culled_) settle(cases);
  }

 private:
  /// Lists the pairs that were culled of a ray.
  void leave_out(const SceneRay& ray) {
    const std::vector<std::uint32_t> kept = auditing_.candidates(ray.ray);
    std::vector<bool> is_culled(auditing_.scene.primitives.size(), true);
    for (const std::uint32_t primitive : kept) is_culled[primitive] = false;
    if (ray.light != SceneRay::nothing) is_culled[static_cast<std::size_t>(ray.light)] = false;
    for (std::size_t i = 0; i < is_culled.size(); ++i) {
      if (!is_culled[i]) continue;
      const Shape& shape = auditing_.scene.primitives[i].shape;
      std::vector<Case>& cases = culled_[shape.index()];
      cases.push_back({ray.ray, shape});
      if (cases.size() == chunk) settle(cases);
    }
  }

  void settle(std::vector<Case>& cases) {
    Margins margins(auditing_.subject.format, auditing_.thorough);
    account_.settled += cases.size();
    each_truth(cases, auditing_.subject.format, [&](std::size_t i, const oracle::Truth& truth) {
      if (truth.count == 0) return;
      Settled settled(cases[i], truth);
      account_.wrong.add(margins.of(settled), cases[i]);
    });
    cases.clear();
  }

  const SceneAuditing& auditing_;
  const Wave& wave_;
  Culling& account_;
  std::array<std::vector<Case>, shape_count> culled_;
};

/// What is kept of the other where it is more.
void keep_more(double& kept, std::optional<Case>& kept_case, double other,
               const std::optional<Case>& other_case) {
  if (other > kept) kept = other, kept_case = other_case;
}

void merge(SafeOffset& into, const SafeOffset& other) {
  keep_more(into.t_min, into.t_min_case, other.t_min, other.t_min_case);
  keep_more(into.ulps, into.ulps_case, other.ulps, other.ulps_case);
  if (other.contact < into.contact)
    into.contact = other.contact, into.contact_case = other.contact_case;
}

void merge(WaveAccount& into, const WaveAccount& other) {
  into.rays += other.rays;
  into.questions += other.questions;
  into.tally.merge(other.tally);
  into.self_intersections.merge(other.self_intersections);
  into.leaks.merge(other.leaks);
  into.nanoseconds += other.nanoseconds;
}

void merge(OffsetAccount& into, const OffsetAccount& other) {
  into.rays += other.rays;
  into.acne.merge(other.acne);
  into.lost_contact.merge(other.lost_contact);
}

void merge(Culling& into, const Culling& other) {
  into.asked += other.asked;
  into.culled += other.culled;
  into.settled += other.settled;
  into.wrong.merge(other.wrong);
}

/// How bad a verdict is to see, from 0.
int rank(Verdict verdict) {
  constexpr std::array order = {
      Verdict::right,      Verdict::touch,      Verdict::invalid_handled,
      Verdict::wrong_t,    Verdict::wrong_root, Verdict::false_hit,
      Verdict::false_miss, Verdict::not_finite, Verdict::invalid_mishandled,
      Verdict::timed_out,  Verdict::crashed};
  static_assert(order.size() == verdict_count);
  return static_cast<int>(std::find(order.begin(), order.end(), verdict) - order.begin());
}

}  // namespace

void Trouble::add(double how_bad, const Case& question) {
  if (std::isnan(how_bad)) how_bad = 0;
  ++count;
  if (!example || how_bad > severity) severity = how_bad, example = question;
}

void Trouble::merge(const Trouble& other) {
  count += other.count;
  if (other.example && (!example || other.severity > severity))
    severity = other.severity, example = other.example;
}

WaveAccount& SceneAccount::wave(Effect effect, int bounce) {
  const auto key = std::tuple(bounce, effect);
  const auto place = std::find_if(waves.begin(), waves.end(), [&](const WaveAccount& each) {
    return std::tie(each.bounce, each.effect) >= key;
  });
  if (place != waves.end() && std::tie(place->bounce, place->effect) == key) return *place;
  return *waves.insert(place, {.effect = effect, .bounce = bounce});
}

void SceneAccount::merge(const SceneAccount& other) {
  for (const WaveAccount& theirs : other.waves)
    rayaudit::merge(wave(theirs.effect, theirs.bounce), theirs);
  if (offsets.empty())
    offsets = other.offsets;
  else
    for (std::size_t i = 0; i < other.offsets.size(); ++i)
      rayaudit::merge(offsets[i], other.offsets[i]);
  rayaudit::merge(safe, other.safe);
  rayaudit::merge(culling, other.culling);
}

std::uint64_t SceneAccount::wrong() const {
  std::uint64_t sum = 0;
  for (const WaveAccount& each : waves) sum += each.tally.wrong();
  return sum;
}

void audit_wave(const SceneAuditing& auditing, const Wave& wave, SceneAccount& account,
                std::uint32_t first_pixel, std::span<Sight> sights) {
  if (account.offsets.empty())
    for (const Offset& offset : auditing.offsets) account.offsets.push_back({.offset = offset});
  WaveAccount& here = account.wave(wave.effect, wave.bounce);
  here.rays += wave.rays.size();
  here.nanoseconds += wave.nanoseconds;
  WaveJudge(auditing, wave, here, first_pixel, sights).judge_all();
  WaveCulling(auditing, wave, account.culling).settle();
  audit_offsets(auditing, wave, account);
}

bool is_worse_to_see(Verdict a, Verdict b) { return rank(a) > rank(b); }

void conclude(const SceneAuditing& auditing, SceneAccount& account) {
  const Plan plan = {.subjects = {&auditing.subject}, .families = {}, .shapes = {}};
  for (WaveAccount& wave : account.waves) {
    Audit audit = {&auditing.subject, nullptr, 0, std::move(wave.tally), {}};
    look_into_worst(plan, audit);
    wave.tally = std::move(audit.tally);
  }
}

}  // namespace rayaudit
