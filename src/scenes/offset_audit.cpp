#include "scenes/offset_audit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/line_roots.hpp"

namespace rayaudit {
namespace {

/// Ulps along the normal are tried in powers of two, up to this many times the numbers themselves.
constexpr int most_normal = 3;

/// A meeting of a ray that leaves a surface by no offset: which root of the line it is, and of how
/// many.
struct Meeting {
  std::size_t ray;  ///< in the list of those that leave
  std::size_t primitive;
  Real t;
  int root, roots;
};

/// Where another offset moves a ray's start, the root of the same place in order tells whether the
/// start has passed the meeting. Lines with another number of roots are other rays past a
/// silhouette.
bool is_passed(const Meeting& meeting, const LineRoots& moved, const Ray<double>& ray) {
  return moved.count == meeting.roots && moved.t[meeting.root] <= ray.t_min;
}

class WaveOffsets {
 public:
  WaveOffsets(const SceneAuditing& auditing, const Wave& wave, SceneAccount& account)
      : auditing_(auditing), format_(auditing.subject.format), account_(account) {
    for (const SceneRay& ray : wave.rays)
      if (ray.from != SceneRay::nothing) leaving_.push_back(&ray);
    unmoved_ = begun_by({.kind = Offset::Kind::none, .amount = 0, .name = {}});
    for (std::size_t ray = 0; ray < leaving_.size(); ++ray)
      own_[shape_of(primitive_left(ray)).index()].push_back(ray);
  }

  void find_meetings();
  void compare(const Offset& offset, OffsetAccount& into) const;

 private:
  using RaysByShape = std::array<std::vector<std::size_t>, shape_count>;
  /// Rays and primitives by shape.
  struct Pairs {
    std::vector<Case> cases;
    std::vector<std::size_t> rays, primitives;
  };

  const Shape& shape_of(std::size_t primitive) const {
    return auditing_.scene.primitives[primitive].shape;
  }
  std::size_t primitive_left(std::size_t ray) const {
    return static_cast<std::size_t>(leaving_[ray]->from);
  }
  std::vector<Ray<double>> begun_by(const Offset& offset) const;
  std::array<Pairs, shape_count> candidates() const;
  void look_at_own(std::size_t ray, const Case& question, const oracle::Truth& truth);
  void keep_t_min(const Case& question, double length);
  void keep_contact(const Case& question, double t);
  void find_safe_offsets();
  void look_at_other(std::size_t ray, std::size_t primitive, const Case& question,
                     const oracle::Truth& truth);
  /// Calls see(ray, case, how far off) for each of those asked that, begun so, is told to meet the
  /// surface that it leaves where it leaves it.
  template <class See>
  void each_acne(const RaysByShape& asked, const std::vector<Ray<double>>& begun,
                 const See& see) const;
  void add_skipped(const std::vector<Ray<double>>& rays, Trouble& lost) const;
  void add_passed(const std::vector<Ray<double>>& rays, Trouble& lost) const;
  void lose(const Meeting& meeting, Trouble& lost) const;

  const SceneAuditing& auditing_;
  const Format& format_;
  SceneAccount& account_;
  std::vector<const SceneRay*> leaving_;
  std::vector<Ray<double>> unmoved_;  ///< of each, from its point as it is
  RaysByShape own_;                   ///< by the shape that they leave
  std::array<std::vector<Meeting>, shape_count> meetings_;
};

std::vector<Ray<double>> WaveOffsets::begun_by(const Offset& offset) const {
  std::vector<Ray<double>> begun;
  begun.reserve(leaving_.size());
  for (const SceneRay* ray : leaving_) {
    begun.push_back(departing(ray->departure, ray->ray.direction, offset, format_));
    begun.back().t_max = ray->ray.t_max;
  }
  return begun;
}

std::array<WaveOffsets::Pairs, shape_count> WaveOffsets::candidates() const {
  std::array<Pairs, shape_count> pairs;
  for (std::size_t ray = 0; ray < leaving_.size(); ++ray)
    for (const std::uint32_t primitive : auditing_.candidates(unmoved_[ray])) {
      if (static_cast<std::int32_t>(primitive) == leaving_[ray]->light) continue;
      Pairs& of_shape = pairs[shape_of(primitive).index()];
      of_shape.cases.push_back({unmoved_[ray], shape_of(primitive)});
      of_shape.rays.push_back(ray);
      of_shape.primitives.push_back(primitive);
    }
  return pairs;
}

void WaveOffsets::find_meetings() {
  for (const Pairs& pairs : candidates())
    each_truth(pairs.cases, format_, [&](std::size_t i, const oracle::Truth& truth) {
      if (truth.count == 0) return;
      if (pairs.primitives[i] == primitive_left(pairs.rays[i]))
        look_at_own(pairs.rays[i], pairs.cases[i], truth);
      else
        look_at_other(pairs.rays[i], pairs.primitives[i], pairs.cases[i], truth);
    });
  find_safe_offsets();
}

void WaveOffsets::look_at_own(std::size_t ray, const Case& question, const oracle::Truth& truth) {
  const LineRoots roots = line_roots(question, truth);
  const int departure = roots.departure();
  if (departure == LineRoots::none) return;
  const auto place = [&](const Real& t) { return roots.nearest(nearest<double>(t)); };
  const double t = roots.t[departure];
  if (t > 0 && place(truth.crossings()[0].t) == departure)
    keep_t_min(question, world_length(question.ray, t));
  const auto meet = [&](const Real& at) {
    keep_contact(question, nearest<double>(at));
    meetings_[question.shape.index()].push_back(
        {ray, primitive_left(ray), at, place(at), roots.count});
  };
  const oracle::Crossing* hit = truth.hit();
  if (hit != nullptr && place(hit->t) != departure) return meet(hit->t);
  // What comes after the departure's root, the truth does not tell.
  if (hit == nullptr || roots.count < 2 || !(roots.t[1 - departure] > t)) return;
  const oracle::Roots all = oracle::roots(question);
  for (const oracle::Root& root : all.roots())
    if (root.standing == oracle::Standing::later) meet(root.t);
}

void WaveOffsets::keep_t_min(const Case& question, double length) {
  SafeOffset& safe = account_.safe;
  if (length > safe.t_min) safe.t_min = length, safe.t_min_case = question;
}

void WaveOffsets::keep_contact(const Case& question, double t) {
  SafeOffset& safe = account_.safe;
  if (const double length = world_length(question.ray, t); length < safe.contact)
    safe.contact = length, safe.contact_case = question;
}

/// What the subject tells at departures is to be skipped too; and what it takes along the normal is
/// asked of it, by doubling, of those rays alone that still meet their surface; once none does, of
/// all again.
void WaveOffsets::find_safe_offsets() {
  SafeOffset& safe = account_.safe;
  RaysByShape left;
  each_acne(own_, unmoved_, [&](std::size_t ray, const Case& question, double off) {
    left[question.shape.index()].push_back(ray);
    keep_t_min(question, off);
  });
  const auto is_empty = [](const auto& rays) { return rays.empty(); };
  const auto still_met = [&](const RaysByShape& asked, const std::vector<Ray<double>>& begun) {
    RaysByShape met;
    each_acne(asked, begun, [&](std::size_t ray, const Case& question, double) {
      met[question.shape.index()].push_back(ray);
    });
    return met;
  };
  const double most = std::ldexp(1.0, format_.precision + most_normal);
  for (double ulps = 1;; ulps *= 2) {
    const auto some = std::ranges::find_if_not(left, is_empty);
    if (some == left.end()) return;
    if (ulps > safe.ulps)
      safe.ulps = ulps > most ? std::numeric_limits<double>::infinity() : ulps,
      safe.ulps_case = {unmoved_[some->front()], shape_of(primitive_left(some->front()))};
    if (ulps > most) return;
    const std::vector<Ray<double>> moved =
        begun_by({.kind = Offset::Kind::normal, .amount = ulps, .name = {}});
    left = still_met(left, moved);
    if (std::ranges::all_of(left, is_empty)) left = still_met(own_, moved);
  }
}

void WaveOffsets::look_at_other(std::size_t ray, std::size_t primitive, const Case& question,
                                const oracle::Truth& truth) {
  const oracle::Crossing* hit = truth.hit();
  if (hit == nullptr) return;
  const double t = nearest<double>(hit->t);
  keep_contact(question, t);
  const LineRoots roots = line_roots(question, truth);
  if (const int root = roots.nearest(t); root != LineRoots::none)
    meetings_[question.shape.index()].push_back({ray, primitive, hit->t, root, roots.count});
}

template <class See>
void WaveOffsets::each_acne(const RaysByShape& asked, const std::vector<Ray<double>>& begun,
                            const See& see) const {
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    if (asked[shape].empty()) continue;
    std::vector<Case> cases;
    cases.reserve(asked[shape].size());
    for (const std::size_t ray : asked[shape])
      cases.push_back({begun[ray], shape_of(primitive_left(ray))});
    std::vector<Answer> answers(cases.size());
    auditing_.subject.answer[shape](cases, answers);
    std::vector<Case> met;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < cases.size(); ++i)
      if (claimed_t(cases[i], answers[i])) met.push_back(cases[i]), places.push_back(i);
    each_truth(met, format_, [&](std::size_t i, const oracle::Truth& truth) {
      if (const auto off = self_intersection(met[i], truth, answers[places[i]]))
        see(asked[shape][places[i]], met[i], *off);
    });
  }
}

void WaveOffsets::lose(const Meeting& meeting, Trouble& lost) const {
  const Ray<double>& ray = unmoved_[meeting.ray];
  lost.add(world_length(ray, nearest<double>(meeting.t)), {ray, shape_of(meeting.primitive)});
}

void WaveOffsets::add_skipped(const std::vector<Ray<double>>& rays, Trouble& lost) const {
  for (const std::vector<Meeting>& of_shape : meetings_)
    for (const Meeting& meeting : of_shape)
      if (rayaudit::compare(meeting.t, real(rays[meeting.ray].t_min)) <= 0) lose(meeting, lost);
}

void WaveOffsets::add_passed(const std::vector<Ray<double>>& rays, Trouble& lost) const {
  for (const std::vector<Meeting>& of_shape : meetings_) {
    std::vector<Case> cases;
    std::vector<const Meeting*> moved;
    for (const Meeting& meeting : of_shape) {
      if (rays[meeting.ray].origin == unmoved_[meeting.ray].origin) continue;
      cases.push_back({rays[meeting.ray], shape_of(meeting.primitive)});
      moved.push_back(&meeting);
    }
    each_truth(cases, format_, [&](std::size_t i, const oracle::Truth& truth) {
      if (is_passed(*moved[i], line_roots(cases[i], truth), cases[i].ray)) lose(*moved[i], lost);
    });
  }
}

void WaveOffsets::compare(const Offset& offset, OffsetAccount& into) const {
  const std::vector<Ray<double>> rays = begun_by(offset);
  into.rays += rays.size();
  each_acne(own_, rays,
            [&](std::size_t, const Case& question, double off) { into.acne.add(off, question); });
  if (offset.kind == Offset::Kind::t_min)
    add_skipped(rays, into.lost_contact);
  else if (offset.kind != Offset::Kind::none)
    add_passed(rays, into.lost_contact);
}

}  // namespace

void audit_offsets(const SceneAuditing& auditing, const Wave& wave, SceneAccount& account) {
  WaveOffsets offsets(auditing, wave, account);
  offsets.find_meetings();
  for (std::size_t i = 0; i < auditing.offsets.size(); ++i)
    offsets.compare(auditing.offsets[i], account.offsets[i]);
}

}  // namespace rayaudit
