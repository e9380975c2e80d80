#include "oracle/lanes/lanes.hpp"

#include <cmath>

#include "oracle/checked.hpp"
#include "oracle/prepared.hpp"
#include "tests/families/drawn.hpp"

using namespace rayaudit;
using oracle::InLanes;
using oracle::Lanes;
using oracle::Truth;
using oracle::Words;

namespace {

constexpr std::array every_width = {Lanes::portable, Lanes::avx2, Lanes::avx512};

/// Cases of one shape in lanes, and what was said of each.
struct Asked {
  std::vector<Case> cases;
  std::vector<Truth> truths;
  std::vector<bool> settled, doubtful;

  Asked(std::vector<Case> given, int bits, Words words, Lanes lanes)
      : cases(std::move(given)),
        truths(cases.size()),
        settled(cases.size()),
        doubtful(cases.size()) {
    for (std::size_t i = 0; i < cases.size(); i += oracle::most_in_lanes) {
      const std::size_t count = std::min(oracle::most_in_lanes, cases.size() - i);
      std::vector<const Case*> asked;
      std::vector<Truth*> told;
      for (std::size_t j = i; j < i + count; ++j)
        asked.push_back(&cases[j]), told.push_back(&truths[j]);
      const InLanes found = settle_in_lanes(asked, told, bits, words, lanes);
      for (std::size_t j = 0; j < count; ++j) {
        settled[i + j] = (found.settled >> j & 1U) != 0;
        doubtful[i + j] = (found.doubtful >> j & 1U) != 0;
      }
    }
  }

  std::size_t count() const { return std::ranges::count(settled, true); }
};

/// Requires that exact numbers say what lanes say, and counts what was held.
void confirm(const Asked& asked, int bits, std::size_t& held) {
  for (std::size_t i = 0; i < asked.cases.size(); i += one_in) {
    if (!asked.settled[i]) continue;
    held += one_in;
    BOOST_REQUIRE_NO_THROW(oracle::confirm(asked.cases[i], asked.truths[i], bits));
  }
}

template <class V>
void each_drawing_in_lanes(V&& visit) {
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    if (oracle::fits_lanes(drawn(family, shape, format, {}, 0, 1)[0])) visit(family, shape, format);
  });
}

/// The same cases in units of their own: lengths, directions and normals times powers of two that
/// may be enormous, and components apart from one another.
std::vector<Case> in_wild_units(std::vector<Case> cases, int spread) {
  int k = 0;
  const auto power = [&](int most) {
    return std::ldexp(1.0, (k++ * 7919) % (2 * most + 1) - most);
  };
  for (Case& question : cases) {
    const double length = power(spread), along = power(spread), normal = power(spread);
    const auto times = [](Vec3<double>& v, double by) { v.x *= by, v.y *= by, v.z *= by; };
    times(question.ray.origin, length);
    times(question.ray.direction, along);
    question.ray.t_min *= length / along;
    question.ray.t_max *= length / along;
    std::visit(
        [&](auto& shape) {
          std::size_t i = 0;
          const auto scale = [&](auto& part) {
            const double by = shape.kinds[i++] == Part::vector ? normal : length;
            if constexpr (requires { part.x; })
              times(part, by);
            else
              part *= by;
          };
          std::apply([&](auto&... part) { (scale(part), ...); }, shape.parts());
        },
        question.shape);
  }
  return cases;
}

/// A range that begins or ends near where the ray meets the shape.
std::vector<Case> with_ranges(std::vector<Case> cases) {
  int k = 0;
  for (Case& question : cases) {
    const Truth truth = oracle::truth(question);
    if (truth.invalid != oracle::Invalid::no || truth.count == 0) continue;
    const double t = nearest<double>(truth.crossings()[0].t);
    const double off = std::ldexp(1.0, -(k % 54));
    if (k++ % 2 == 0)
      question.ray.t_min = t * (k % 3 == 0 ? 1 - off : 1 + off);
    else
      question.ray.t_max = t * (k % 3 == 0 ? 1 - off : 1 + off);
  }
  return cases;
}

bool is_same(const Truth& a, const Truth& b) {
  if (a.invalid != b.invalid || a.stage != b.stage || a.count != b.count) return false;
  if (a.others_known != b.others_known || a.other_count != b.other_count) return false;
  for (int i = 0; i < a.count; ++i)
    if (a.listed[i].kind != b.listed[i].kind || a.listed[i].patch != b.listed[i].patch ||
        !(a.listed[i].t == b.listed[i].t))
      return false;
  for (int i = 0; i < a.other_count; ++i)
    if (!(a.other_roots[i] == b.other_roots[i])) return false;
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_numbers_confirm_what_lanes_decide) {
  std::size_t held = 0;
  each_drawing_in_lanes([&](const Family& family, std::size_t shape, const Format& format) {
    for (const Words words : {Words::two, Words::three})
      for (const int bits : {34, 63, 74})
        for (std::uint64_t chunk = 0; chunk < 2; ++chunk)
          confirm(Asked(drawn(family, shape, format, {}, 2 * chunk + static_cast<unsigned>(bits)),
                        bits, words, oracle::widest_lanes()),
                  bits, held);
  });
  BOOST_TEST(held > 1'500'000);
  BOOST_TEST_MESSAGE(held << " decisions held");
}

BOOST_AUTO_TEST_CASE(exact_numbers_confirm_them_in_wild_units_and_ranges) {
  std::size_t held = 0, wild = 0;
  each_drawing_in_lanes([&](const Family& family, std::size_t shape, const Format& format) {
    for (const Words words : {Words::two, Words::three}) {
      const auto cases = drawn(family, shape, format, {}, 50);
      const auto confirmed = [&](std::vector<Case> made, std::size_t& count) {
        confirm(Asked(std::move(made), 63, words, oracle::widest_lanes()), 63, count);
      };
      confirmed(with_ranges(cases), held);
      for (const int spread : {20, 200, 480}) confirmed(in_wild_units(cases, spread), wild);
    }
  });
  BOOST_TEST(held > 200'000);
  BOOST_TEST(wild > 400'000);
}

BOOST_AUTO_TEST_CASE(every_width_says_the_same_to_the_bit) {
  each_drawing_in_lanes([&](const Family& family, std::size_t shape, const Format& format) {
    for (const Words words : {Words::two, Words::three}) {
      const auto cases = drawn(family, shape, format, {}, 7, 301);  // the last lanes are not full
      const Asked portable(cases, 63, words, Lanes::portable);
      for (const Lanes lanes : every_width) {
        if (!has(lanes)) continue;
        const Asked asked(cases, 63, words, lanes);
        BOOST_REQUIRE(asked.settled == portable.settled);
        BOOST_REQUIRE(asked.doubtful == portable.doubtful);
        for (std::size_t i = 0; i < cases.size(); ++i)
          BOOST_REQUIRE_MESSAGE(!asked.settled[i] || is_same(asked.truths[i], portable.truths[i]),
                                name(lanes) << ": " << case_line(cases[i]));
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(lanes_decide_nearly_all_that_is_no_tie) {
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    const auto decided = [&](std::string_view id, Words words, int bits) {
      const Asked asked(drawn(family_of(id), shape, double_format), bits, words,
                        oracle::widest_lanes());
      return static_cast<double>(asked.count()) / chunk_cases;
    };
    BOOST_TEST(decided("anywhere", Words::two, 63) == 1);
    BOOST_TEST(decided("anywhere", Words::two, 74) > 0.999);
    if (!family_of("grazing").draw[shape]) continue;
    BOOST_TEST(decided("grazing", Words::three, 63) > 0.98, shape_names[shape]);
    BOOST_TEST(decided("grazing", Words::three, 74) > 0.95, shape_names[shape]);
  }
}

BOOST_AUTO_TEST_CASE(what_is_invalid_or_a_tie_is_left) {
  for (const auto* id : {"invalid", "tangent", "rim", "apex", "within"})
    for (std::size_t shape = 0; shape < shape_count; ++shape)
      for (const Words words : {Words::two, Words::three}) {
        if (!family_of(id).draw[shape]) continue;
        const Asked asked(drawn(family_of(id), shape, double_format), 63, words,
                          oracle::widest_lanes());
        for (std::size_t i = 0; i < asked.cases.size(); ++i) {
          const Truth truth = oracle::truth(asked.cases[i]);
          if (truth.invalid == oracle::Invalid::no && !truth.has_touch()) continue;
          BOOST_REQUIRE_MESSAGE(!asked.settled[i], case_line(asked.cases[i]));
        }
      }
}

BOOST_AUTO_TEST_CASE(a_truth_that_is_not_is_not_confirmed) {
  const Case question = read_case_line("sphere 0.1 0.2 0.3 1 ray 0 0 -3 0.1 0 1").question;
  const Truth truth = oracle::truth(question);
  BOOST_REQUIRE(truth.count == 1);
  BOOST_CHECK_NO_THROW(oracle::confirm(question, truth, 63));
  const auto refused = [&](const auto& spoil, std::string_view part) {
    Truth other = truth;
    spoil(other);
    BOOST_CHECK_EXCEPTION(oracle::confirm(question, other, 63), oracle::Disagreement,
                          [&](const oracle::Disagreement& why) {
                            const std::string_view told = why.what();
                            return told.find(part) != std::string_view::npos &&
                                   told.find(case_line(question)) != std::string_view::npos;
                          });
  };
  refused([](Truth& t) { t.count = 0; }, "how many crossings");
  refused([](Truth& t) { t.listed[0].kind = oracle::Kind::tangent; }, "where the ray crosses");
  refused([](Truth& t) { t.listed[0].t.middle += t.listed[0].t.high * 0x1p-62; },
          "where the ray crosses");
  refused([](Truth& t) { t.other_roots[0].high *= 1 + 0x1p-50; }, "the other roots");
  refused([](Truth& t) { t.invalid = oracle::Invalid::radius; }, "whether the case is valid");
}
