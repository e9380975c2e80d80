#include "rayaudit/oracle.h"

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstring>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "audit/judge.hpp"
#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "geometry/flat_case.hpp"
#include "reports/failure_text.hpp"
#include "subjects/flat_convention.hpp"

namespace rayaudit {
namespace {

static_assert(RAYAUDIT_EMPTY_RANGE == static_cast<int>(oracle::Invalid::empty_range));
static_assert(RAYAUDIT_WITHIN == static_cast<int>(oracle::Kind::within));
static_assert(RAYAUDIT_INVALID_MISHANDLED == static_cast<int>(Verdict::invalid_mishandled));
static_assert(RAYAUDIT_HUNG == static_cast<int>(Claim::hung));
static_assert(RAYAUDIT_BEYOND == static_cast<int>(Side::beyond));
static_assert(std::size(decltype(rayaudit_truth::crossings){}) >= oracle::Truth::most);

/// What a caller names that there is not.
struct NoneSuch {};

/// Plain arithmetic in this thread for as long as it lives: a program that is linked with
/// -ffast-math flushes subnormal numbers to zero, and another may round upward.
class PlainArithmetic {
 public:
  PlainArithmetic() {
    std::fegetenv(&kept_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~PlainArithmetic() { std::fesetenv(&kept_); }
  PlainArithmetic(const PlainArithmetic&) = delete;
  PlainArithmetic& operator=(const PlainArithmetic&) = delete;

 private:
  std::fenv_t kept_;
};

template <class Body>
[[gnu::noinline]] int returned(const Body& body) {
  return body();
}

/// What body returns, in plain arithmetic; nothing is thrown out of the library.
template <class Body>
int guarded(const Body& body) {
  const PlainArithmetic plain;
  try {
    return returned(body);
  } catch (const NoneSuch&) {
    return RAYAUDIT_NONE_SUCH;
  } catch (const std::bad_alloc&) {
    return RAYAUDIT_NO_MEMORY;
  } catch (...) {
    return RAYAUDIT_FAULT;
  }
}

Case case_of(const rayaudit_case& question) {
  if (question.shape < RAYAUDIT_DISK || question.shape > RAYAUDIT_CAPPED_CONE ||
      question.extent < RAYAUDIT_BOUNDED || question.extent > RAYAUDIT_BOTH_NAPPES)
    throw NoneSuch{};
  return from_flat(question);
}

Answer answer_of(const rayaudit_answer& answer) {
  const Answer made = from_flat(answer);
  if (!made.is_given()) throw NoneSuch{};
  return made;
}

Convention convention_of(const rayaudit_convention* convention) {
  if (convention == nullptr) return {};
  try {
    return from_flat(*convention);
  } catch (const Error&) {
    throw NoneSuch{};
  }
}

const Format& format_of_number(std::int32_t format) {
  switch (format) {
    case RAYAUDIT_DOUBLE:
      return double_format;
    case RAYAUDIT_FLOAT:
      return float_format;
    case RAYAUDIT_LONG_DOUBLE:
      return long_double_format;
    default:
      throw NoneSuch{};
  }
}

/// What an answer is held to, as we have it.
struct Allowed {
  const Format& format;
  Convention convention;
  double max_ulp;

  explicit Allowed(const rayaudit_allowed& allowed)
      : format(format_of_number(allowed.format)),
        convention(convention_of(&allowed.convention)),
        max_ulp(allowed.max_ulp) {}
};

Allowed held_to(const rayaudit_allowed* allowed) {
  return Allowed(allowed == nullptr ? rayaudit_allowed{} : *allowed);
}

/// Writes what has room, as snprintf does; the length of the whole.
int put(std::string_view text, char* to, std::size_t size) {
  if (to != nullptr && size > 0) {
    const std::size_t room = std::min(text.size(), size - 1);
    std::memcpy(to, text.data(), room);
    to[room] = '\0';
  }
  return static_cast<int>(text.size());
}

/// To so many bits every t is known, at the price of fewer.
constexpr int known_bits = 90;

/// The same, rounded to N by one operation, of all that a number known to so many bits can be; or
/// nothing, where that is not the same.
template <class N>
std::optional<N> quickly_rounded(const Real& t) {
  const double size = std::fabs(t.high);
  if (t.exponent != 0 || !(size > 0x1p-900 && size < 0x1p900)) return {};
  const auto alike = [](N low, N high) { return low == high ? std::optional(low) : std::nullopt; };
  if constexpr (std::is_same_v<N, float>) {
    const double slack = size * 0x1p-50;
    return alike(static_cast<float>(t.high - slack), static_cast<float>(t.high + slack));
  } else {
    const double rest = t.middle + t.low, slack = size * std::ldexp(4.0, -known_bits);
    const N high = t.high;
    return alike(high + static_cast<N>(rest - slack), high + static_cast<N>(rest + slack));
  }
}

template <class N>
N rounded_t(const Case& question, const oracle::Crossing& crossing) {
  const std::optional<N> quick = quickly_rounded<N>(crossing.t);
  return quick ? *quick : oracle::rounded<N>(question, crossing);
}

rayaudit_rounded rounded(const Case& question, const oracle::Crossing& crossing) {
  return {rounded_t<float>(question, crossing), rounded_t<double>(question, crossing),
          rounded_t<long double>(question, crossing)};
}

rayaudit_rounded rounded_last(const Case& question, const oracle::Crossing& crossing) {
  return {oracle::rounded_last<float>(question, crossing),
          oracle::rounded_last<double>(question, crossing),
          oracle::rounded_last<long double>(question, crossing)};
}

rayaudit_crossing flat(const Case& question, const oracle::Crossing& crossing) {
  const rayaudit_rounded t = rounded(question, crossing);
  const bool is_stretch = crossing.kind == oracle::Kind::within;
  return {static_cast<std::int32_t>(crossing.kind), t,
          is_stretch ? rounded_last(question, crossing) : t};
}

rayaudit_truth flat(const Case& question, const oracle::Truth& truth) {
  rayaudit_truth made = {};
  made.invalid = static_cast<std::int32_t>(truth.invalid);
  made.hit = truth.hit() != nullptr ? 1 : 0;
  made.count = truth.count;
  for (std::size_t i = 0; i < truth.count; ++i) made.crossings[i] = flat(question, truth.listed[i]);
  return made;
}

rayaudit_judgement flat(const Judgement& judgement, double margin) {
  rayaudit_judgement made = {};
  made.verdict = static_cast<std::int32_t>(judgement.verdict);
  made.claim = static_cast<std::int32_t>(judgement.claim);
  made.touch = judgement.touch ? static_cast<std::int32_t>(*judgement.touch) : 0;
  made.taken = judgement.taken ? 1 : 0;
  made.crossing = judgement.crossing;
  made.side = static_cast<std::int32_t>(judgement.side);
  made.ulps = judgement.ulps;
  made.relative = judgement.relative;
  made.forced = judgement.forced;
  made.own = judgement.own;
  made.distance = judgement.distance;
  made.margin = margin;
  return made;
}

void settle(std::span<const rayaudit_case> cases, rayaudit_truth* truths) {
  constexpr std::size_t portion = 1024;
  std::vector<Case> questions;
  std::vector<oracle::Truth> settled(std::min(portion, cases.size()));
  for (; !cases.empty(); cases = cases.subspan(questions.size())) {
    questions.clear();
    for (const rayaudit_case& question : cases.first(std::min(portion, cases.size())))
      questions.push_back(case_of(question));
    oracle::truth(questions, settled, known_bits);
    for (std::size_t i = 0; i < questions.size(); ++i) *truths++ = flat(questions[i], settled[i]);
  }
}

/// The name of an enumerator, null beyond the last.
template <class E>
const char* name_of(std::int32_t value, E last) {
  if (value < 0 || value > static_cast<std::int32_t>(last)) return nullptr;
  return name(static_cast<E>(value)).data();  // of a literal, so there is a 0 at its end
}

}  // namespace
}  // namespace rayaudit

using namespace rayaudit;

int rayaudit_truth_of(const rayaudit_case* question, rayaudit_truth* truth) {
  return rayaudit_truths(question, 1, truth);
}

int rayaudit_truths(const rayaudit_case* cases, size_t count, rayaudit_truth* truths) {
  return guarded([&] {
    settle({cases, count}, truths);
    return RAYAUDIT_DONE;
  });
}

int rayaudit_judge(const rayaudit_case* question, const rayaudit_answer* answer, int32_t format,
                   const rayaudit_convention* convention, rayaudit_judgement* judgement) {
  return guarded([&] {
    const Case asked = case_of(*question);
    const Format& in = format_of_number(format);
    const oracle::Truth truth = oracle::truth(asked, oracle::bits_for(in));
    Settled settled(asked, truth);
    const Judgement made = judge(settled, answer_of(*answer), in, convention_of(convention));
    *judgement = flat(made, std::ldexp(settled.reach(), in.precision));
    return RAYAUDIT_DONE;
  });
}

int rayaudit_posed(const rayaudit_case* question, int32_t format,
                   const rayaudit_convention* convention, rayaudit_case* made) {
  return guarded([&] {
    const Convention declared = convention_of(convention);
    *made = flat(posed(case_of(*question), declared, format_of_number(format)));
    return RAYAUDIT_DONE;
  });
}

int rayaudit_agrees(const rayaudit_case* question, const rayaudit_answer* answer,
                    const rayaudit_allowed* allowed) {
  return guarded([&] {
    const Allowed held = held_to(allowed);
    const Judgement judgement =
        judge(case_of(*question), answer_of(*answer), held.format, held.convention);
    return agrees(judgement, held.max_ulp) ? 1 : 0;
  });
}

int rayaudit_told(const rayaudit_case* question, const rayaudit_answer* answer,
                  const rayaudit_allowed* allowed, char* text, size_t size) {
  return guarded([&] {
    const Allowed held = held_to(allowed);
    return put(failure_text(case_of(*question), answer_of(*answer), held.format, held.convention,
                            held.max_ulp),
               text, size);
  });
}

int rayaudit_read_case(const char* line, rayaudit_case* question, rayaudit_answer* answer,
                       char* why, size_t size) {
  return guarded([&]() -> int {
    try {
      const CaseLine read = read_case_line(line);
      *question = flat(read.question);
      if (answer != nullptr) *answer = flat(read.answer.value_or(Answer::miss()));
      return RAYAUDIT_DONE;
    } catch (const Error& error) {
      put(error.what(), why, size);
      return RAYAUDIT_NO_LINE;
    }
  });
}

int rayaudit_write_case(const rayaudit_case* question, const rayaudit_answer* answer, char* line,
                        size_t size) {
  return guarded([&] {
    std::string text = case_line(case_of(*question));
    if (answer != nullptr) write(text += ' ', answer_of(*answer));
    return put(text, line, size);
  });
}

const char* rayaudit_verdict_name(int32_t verdict) {
  return name_of(verdict, Verdict::invalid_mishandled);
}
const char* rayaudit_claim_name(int32_t claim) { return name_of(claim, Claim::hung); }
const char* rayaudit_side_name(int32_t side) { return name_of(side, Side::beyond); }
const char* rayaudit_kind_name(int32_t kind) { return name_of(kind, oracle::Kind::within); }
const char* rayaudit_invalid_name(int32_t invalid) {
  return name_of(invalid, oracle::Invalid::empty_range);
}
const char* rayaudit_format_name(int32_t format) {
  constexpr std::array names = {"double", "float", "long_double"};
  return format < 0 || format > RAYAUDIT_LONG_DOUBLE ? nullptr
                                                     : names[static_cast<std::size_t>(format)];
}
const char* rayaudit_version(void) { return RAYAUDIT_VERSION; }
