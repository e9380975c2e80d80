#include "scenes/seam_leaks.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "scenes/line_roots.hpp"

namespace rayaudit {
namespace {

/// A hit is near a crossing within this share of the seam's radius.
constexpr double near_share = 0x1p-8;

double first_t(const oracle::Truth& truth) { return nearest<double>(truth.crossings()[0].t); }

/// Two exact t that are no further apart than surfaces which meet in a rim of doubles are.
bool is_same(double t, double other) { return std::fabs(t - other) <= 0x1p-30 * std::fabs(other); }

/// Of crossings at one t: is one proper, so that the ray cannot pass by convention?
bool is_proper_at(const oracle::Truth& truth, double t) {
  return std::ranges::any_of(truth.crossings(), [&](const oracle::Crossing& crossing) {
    return crossing.kind == oracle::Kind::proper && is_same(nearest<double>(crossing.t), t);
  });
}

}  // namespace

SeamLeaks::SeamLeaks(const Scene& scene) : scene_(scene) {
  if (scene.seams.empty()) return;
  is_in_seam_.resize(scene.primitives.size());
  for (const auto& [disk, wall] : scene.seams) is_in_seam_[disk] = is_in_seam_[wall] = true;
}

void SeamLeaks::add(const Wave& wave, std::size_t shape, std::size_t place,
                    const oracle::Truth& truth, const Judgement& judgement) {
  const auto& [ray, primitive] = wave.pairs[shape][place];
  if (is_in_seam_.empty() || !is_in_seam_[primitive]) return;
  const Answer& answer = wave.answers[shape][place];
  const bool is_open = is_wrong(judgement.verdict) || judgement.verdict == Verdict::touch;
  const bool is_first_told =
      judgement.crossing == 0 && answer.form != Answer::Form::miss &&
      (!is_wrong(judgement.verdict) || judgement.verdict == Verdict::wrong_t);
  asked_.push_back({primitive, ray, shape, place, truth, is_open, is_first_told,
                    answer.form == Answer::Form::yes, claimed_t(wave.cases[shape][place], answer)});
}

const SeamLeaks::Asked* SeamLeaks::find(std::size_t primitive, std::uint32_t ray) const {
  const auto key = std::tuple(primitive, ray);
  const auto found = std::lower_bound(asked_.begin(), asked_.end(), key,
                                      [](const Asked& asked, const auto& sought) {
                                        return std::tie(asked.primitive, asked.ray) < sought;
                                      });
  if (found == asked_.end() || std::tie(found->primitive, found->ray) != key) return nullptr;
  return &*found;
}

bool SeamLeaks::leaks_through(const Wave& wave, const Seam& seam, const Asked& first,
                              const Asked* other) const {
  const double t = first_t(first.truth);
  const bool both = other != nullptr && other->truth.count > 0 && is_same(first_t(other->truth), t);
  if (!is_proper_at(first.truth, t) && !both) return false;
  const Case& question = wave.cases[first.shape][first.place];
  const double radius = std::get<Disk<double>>(scene_.primitives[seam.disk].shape).radius;
  const auto is_told_near = [&](const Asked& asked) {
    if (asked.says_yes) return true;
    return asked.told && world_length(question.ray, *asked.told - t) <= near_share * radius;
  };
  if (first.is_first_told || is_told_near(first)) return false;
  if (other != nullptr && ((both && other->is_first_told) || is_told_near(*other))) return false;
  // Not to meet the surface again where it is left is no leak.
  if (wave.rays[first.ray].from != static_cast<std::int32_t>(first.primitive)) return true;
  const LineRoots roots = line_roots(question, first.truth);
  return roots.nearest(t) != roots.departure();
}

void SeamLeaks::look_at(const Wave& wave, const Seam& seam, std::uint32_t ray, Margins& margins,
                        Trouble& leaks) const {
  const Asked *first = find(seam.disk, ray), *other = find(seam.wall, ray);
  const auto meets = [](const Asked* asked) { return asked != nullptr && asked->truth.count > 0; };
  if (!meets(first) || (meets(other) && first_t(other->truth) < first_t(first->truth)))
    std::swap(first, other);
  if (!meets(first) || !leaks_through(wave, seam, *first, other)) return;
  const Case& question = wave.cases[first->shape][first->place];
  Settled settled(question, first->truth);
  leaks.add(margins.of(settled), question);
}

void SeamLeaks::count(const Wave& wave, Margins& margins, Trouble& leaks) {
  std::sort(asked_.begin(), asked_.end(), [](const Asked& a, const Asked& b) {
    return std::tie(a.primitive, a.ray) < std::tie(b.primitive, b.ray);
  });
  const auto each_open = [&](std::size_t primitive, const auto& visit) {
    const auto first = std::partition_point(asked_.begin(), asked_.end(), [&](const Asked& asked) {
      return asked.primitive < primitive;
    });
    for (auto asked = first; asked != asked_.end() && asked->primitive == primitive; ++asked)
      if (asked->is_open) visit(asked->ray);
  };
  for (const Seam& seam : scene_.seams) {
    each_open(seam.disk, [&](std::uint32_t ray) { look_at(wave, seam, ray, margins, leaks); });
    each_open(seam.wall, [&](std::uint32_t ray) {
      const Asked* disk = find(seam.disk, ray);
      if (disk == nullptr || !disk->is_open) look_at(wave, seam, ray, margins, leaks);
    });
  }
}

}  // namespace rayaudit
