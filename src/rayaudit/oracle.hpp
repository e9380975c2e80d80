#ifndef RAYAUDIT_ORACLE_HPP
#define RAYAUDIT_ORACLE_HPP

/// The exact oracle for tests in C++17: link rayaudit::oracle.
///
///     using namespace rayaudit;
///     const Case question = question_of(ray({0, 0.5, -3}, {0, 0, 1}), sphere({0, 0, 0}, 1));
///     truth(question).t<float>();               // 0x1.112614p+1, correctly rounded
///     judge(hit(2.125f), question).verdict;     // Verdict::right
///     assert(agrees(question, mine(question)));  // mine answers std::optional<float>, say
///
/// Test frameworks are told what is wrong by boost_test.hpp, gtest.hpp and catch2.hpp. What is
/// defined here hands on to the C functions of oracle.h and computes nothing, so that the flags of
/// whoever includes it mean nothing to the oracle.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "oracle.h"

namespace rayaudit {
inline namespace face {  // no symbol of a program that includes this has a name of the library's

using Vec3 = rayaudit_vec3;
using Ray = rayaudit_ray;
using Disk = rayaudit_disk;
using Sphere = rayaudit_sphere;
using Cylinder = rayaudit_cylinder;
using Cone = rayaudit_cone;
/// Of C one type with cylinder and cone; here others, so that a question is told apart.
struct CappedCylinder {
  Vec3 base, top;
  double radius;
};
struct CappedCone {
  Vec3 base, apex;
  double radius;
};
using Case = rayaudit_case;
using Crossing = rayaudit_crossing;
using Convention = rayaudit_convention;

/// The numbers of the enumerators are those of oracle.h, where each is explained.
enum class Format : std::int32_t { in_double, in_float, in_long_double };
/// How much of the surface of a disk, cylinder or cone is asked about.
enum class Extent : std::int32_t { bounded, unbounded, both_nappes };
enum class Invalid : std::int32_t {
  no,
  nan,
  infinite,
  zero_direction,
  zero_normal,
  zero_axis,
  radius,
  empty_range
};
enum class Kind : std::int32_t { proper, tangent, rim, apex, start, end, within };
enum class Verdict : std::int32_t {
  right,
  touch,
  false_hit,
  false_miss,
  wrong_root,
  wrong_t,
  not_finite,
  crashed,
  timed_out,
  invalid_handled,
  invalid_mishandled
};
enum class Claim : std::int32_t {
  none,
  no_root,
  nan,
  infinite,
  behind,
  past,
  clipped,
  mirrored,
  later,
  declined,
  parallel,
  centre,
  origin,
  garbage,
  ended,
  hung
};
enum class Side : std::int32_t { unknown, before, on, beyond };

inline const char* name(Format format) { return rayaudit_format_name(static_cast<int>(format)); }
inline const char* name(Invalid invalid) {
  return rayaudit_invalid_name(static_cast<int>(invalid));
}
inline const char* name(Kind kind) { return rayaudit_kind_name(static_cast<int>(kind)); }
inline const char* name(Verdict verdict) {
  return rayaudit_verdict_name(static_cast<int>(verdict));
}
inline const char* name(Claim claim) { return rayaudit_claim_name(static_cast<int>(claim)); }
inline const char* name(Side side) { return rayaudit_side_name(static_cast<int>(side)); }

/// Throws where a function of oracle.h failed; else what it returned.
inline int checked(int returned) {
  if (returned == RAYAUDIT_NO_MEMORY) throw std::bad_alloc();
  if (returned == RAYAUDIT_NONE_SUCH)
    throw std::invalid_argument("rayaudit: no such shape, form, format or stance");
  if (returned < 0) throw std::runtime_error("rayaudit: the oracle failed");
  return returned;
}

/// The text that tell(text, size) writes as snprintf does.
template <class Tell>
std::string text_of(const Tell& tell) {
  std::string text(static_cast<std::size_t>(checked(tell(nullptr, 0))), '\0');
  tell(&text[0], text.size() + 1);
  return text;
}

inline Ray ray(Vec3 origin, Vec3 direction, double t_min = 0,
               double t_max = std::numeric_limits<double>::infinity()) {
  return {origin, direction, t_min, t_max};
}
inline Disk disk(Vec3 centre, Vec3 normal, double radius) { return {centre, normal, radius}; }
inline Sphere sphere(Vec3 centre, double radius) { return {centre, radius}; }
inline Cylinder cylinder(Vec3 base, Vec3 top, double radius) { return {base, top, radius}; }
inline Cone cone(Vec3 base, Vec3 apex, double radius) { return {base, apex, radius}; }
inline CappedCylinder capped_cylinder(Vec3 base, Vec3 top, double radius) {
  return {base, top, radius};
}
inline CappedCone capped_cone(Vec3 base, Vec3 apex, double radius) { return {base, apex, radius}; }

/// Do they meet, and where first?
inline Case question_of(const Ray& ray, const Disk& disk, Extent extent = Extent::bounded) {
  Case question = {ray, RAYAUDIT_DISK, static_cast<int>(extent), {}};
  question.is.disk = disk;
  return question;
}
inline Case question_of(const Ray& ray, const Sphere& sphere) {
  Case question = {ray, RAYAUDIT_SPHERE, RAYAUDIT_BOUNDED, {}};
  question.is.sphere = sphere;
  return question;
}
inline Case question_of(const Ray& ray, const Cylinder& cylinder, Extent extent = Extent::bounded) {
  Case question = {ray, RAYAUDIT_CYLINDER, static_cast<int>(extent), {}};
  question.is.cylinder = cylinder;
  return question;
}
inline Case question_of(const Ray& ray, const Cone& cone, Extent extent = Extent::bounded) {
  Case question = {ray, RAYAUDIT_CONE, static_cast<int>(extent), {}};
  question.is.cone = cone;
  return question;
}
inline Case question_of(const Ray& ray, const CappedCylinder& cylinder) {
  Case question = {ray, RAYAUDIT_CAPPED_CYLINDER, RAYAUDIT_BOUNDED, {}};
  question.is.capped_cylinder = {cylinder.base, cylinder.top, cylinder.radius};
  return question;
}
inline Case question_of(const Ray& ray, const CappedCone& cone) {
  Case question = {ray, RAYAUDIT_CAPPED_CONE, RAYAUDIT_BOUNDED, {}};
  question.is.capped_cone = {cone.base, cone.apex, cone.radius};
  return question;
}
/// Of a case line; throws std::invalid_argument, which says why it is none.
inline Case question_of(const std::string& line) {
  Case question = {};
  char why[512] = "";
  const int returned = rayaudit_read_case(line.c_str(), &question, nullptr, why, sizeof why);
  if (returned == RAYAUDIT_NO_LINE) throw std::invalid_argument(why);
  checked(returned);
  return question;
}
inline std::string case_line(const Case& question) {
  return text_of([&](char* text, std::size_t size) {
    return rayaudit_write_case(&question, nullptr, text, size);
  });
}

template <class N>
struct FormatOf;
template <>
struct FormatOf<float> : std::integral_constant<Format, Format::in_float> {};
template <>
struct FormatOf<double> : std::integral_constant<Format, Format::in_double> {};
template <>
struct FormatOf<long double> : std::integral_constant<Format, Format::in_long_double> {};

/// What is said of a case, and the format that it was worked out in.
struct Answer {
  rayaudit_answer said;
  Format format;

  explicit Answer(const rayaudit_answer& answer, Format in = Format::in_double)
      : said(answer), format(in) {}
  /// They meet, or not; no word of where. Of nothing else that would do for a bool.
  template <class B, std::enable_if_t<std::is_same_v<B, bool>, int> = 0>
  Answer(B yes, Format in = Format::in_double)
      : said(yes ? rayaudit_yes() : rayaudit_miss()), format(in) {}
  /// They meet at t, or not.
  template <class N, class = decltype(FormatOf<N>::value)>
  Answer(const std::optional<N>& t)
      : said(t ? rayaudit_hit_long(*t) : rayaudit_miss()), format(FormatOf<N>::value) {}
};

template <class N, class = decltype(FormatOf<N>::value)>
Answer hit(N t) {
  return Answer(rayaudit_hit_long(t), FormatOf<N>::value);
}
inline Answer miss(Format in = Format::in_double) { return Answer(rayaudit_miss(), in); }
/// They meet at a point.
template <class N, class = decltype(FormatOf<N>::value)>
Answer at(N x, N y, N z) {
  return Answer(rayaudit_at_long(x, y, z), FormatOf<N>::value);
}
/// What a function says that returns whether they meet and writes t.
template <class N, class = decltype(FormatOf<N>::value)>
Answer hit_if(bool met, N t) {
  return met ? hit(t) : miss(FormatOf<N>::value);
}

template <class N>
N in(const rayaudit_rounded& exact) {
  if constexpr (std::is_same_v<N, float>) {
    return exact.in_float;
  } else if constexpr (std::is_same_v<N, double>) {
    return exact.in_double;
  } else {
    return exact.in_long_double;
  }
}

/// The crossings up to and including the first proper one, in order along the ray. Right is that
/// hit, or a miss where there is none; a touch before it may be taken or passed by.
struct Truth {
  Invalid invalid = Invalid::no;
  std::vector<Crossing> crossings;
  std::optional<Crossing> hit;  ///< the last of them, where it is proper

  /// t of the hit, correctly rounded; nothing where the truth is a miss.
  template <class N = double>
  std::optional<N> t() const {
    return hit ? std::optional<N>(in<N>(hit->t)) : std::nullopt;
  }
};

inline Truth truth_of(const rayaudit_truth& truth) {
  Truth made;
  made.invalid = static_cast<Invalid>(truth.invalid);
  made.crossings.assign(truth.crossings, truth.crossings + truth.count);
  if (truth.hit != 0) made.hit = made.crossings.back();
  return made;
}

inline Truth truth(const Case& question) {
  rayaudit_truth truth;
  checked(rayaudit_truth_of(&question, &truth));
  return truth_of(truth);
}
/// Of many at once, in the least time each.
inline std::vector<Truth> truths(const std::vector<Case>& questions) {
  std::vector<rayaudit_truth> flat(questions.size());
  checked(rayaudit_truths(questions.data(), questions.size(), flat.data()));
  std::vector<Truth> made;
  made.reserve(flat.size());
  for (const rayaudit_truth& each : flat) made.push_back(truth_of(each));
  return made;
}

/// One answer held against the truth; the numbers, NaN where not measured, are those of oracle.h.
struct Judgement {
  Verdict verdict;
  Claim claim;
  std::optional<Kind> touch;  ///< that was on offer
  bool taken;                 ///< the answer took it
  Side side;
  double ulps, relative, forced, own, distance, margin;
};

/// Of a convention, stances towards touches and inside count.
inline Judgement judge(const Answer& answer, const Case& question,
                       const Convention& convention = {}) {
  rayaudit_judgement flat;
  checked(
      rayaudit_judge(&question, &answer.said, static_cast<int>(answer.format), &convention, &flat));
  return {static_cast<Verdict>(flat.verdict),
          static_cast<Claim>(flat.claim),
          flat.touch != 0 ? std::optional(static_cast<Kind>(flat.touch)) : std::nullopt,
          flat.taken != 0,
          static_cast<Side>(flat.side),
          flat.ulps,
          flat.relative,
          flat.forced,
          flat.own,
          flat.distance,
          flat.margin};
}

/// The case as it is to be asked under a convention; posed already, it stays as it is.
inline Case posed(const Case& question, const Convention& convention,
                  Format format = Format::in_double) {
  Case made;
  checked(rayaudit_posed(&question, static_cast<int>(format), &convention, &made));
  return made;
}

/// What an answer is held to.
struct Allowed {
  double max_ulp = 0;  ///< of t, where above 0; a correctly rounded t has at most 0.5
  Convention convention = {};
};

/// How a test framework's own kind of result is made of an agreement; see gtest.hpp.
template <class Result>
struct ToldAs;

/// Is an answer not wrong, and its t within what is allowed? Tells what is, in lines.
class Agreement {
 public:
  Agreement(const Case& question, const Answer& answer, const Allowed& allowed)
      : question_(question),
        said_(answer.said),
        allowed_{allowed.max_ulp, static_cast<int>(answer.format), allowed.convention},
        holds_(checked(rayaudit_agrees(&question_, &said_, &allowed_)) != 0) {}

  explicit operator bool() const { return holds_; }
  template <class Result, class = decltype(ToldAs<Result>::of(std::declval<const Agreement&>()))>
  operator Result() const {
    return ToldAs<Result>::of(*this);
  }

  std::string text() const {
    return text_of([this](char* text, std::size_t size) {
      return rayaudit_told(&question_, &said_, &allowed_, text, size);
    });
  }
  friend std::ostream& operator<<(std::ostream& to, const Agreement& agreement) {
    return to << '\n' << agreement.text();
  }

 private:
  Case question_;
  rayaudit_answer said_;
  rayaudit_allowed allowed_;
  bool holds_;
};

inline Agreement agrees(const Case& question, const Answer& answer, const Allowed& allowed = {}) {
  return {question, answer, allowed};
}

}  // namespace face
}  // namespace rayaudit

#endif
