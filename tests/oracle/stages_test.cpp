#include "oracle/stages.hpp"

#include "oracle/lanes/lanes.hpp"
#include "oracle/prepared.hpp"
#include "oracle/radical.hpp"
#include "tests/families/drawn.hpp"
#include "tests/oracle/closed.hpp"
#include "tests/oracle/dyadic.hpp"

using namespace rayaudit;
using oracle::ExactRoot;
using oracle::ExactRoots;
using oracle::Kind;
using oracle::Outline;
using oracle::Outlined;
using oracle::Stage;
using oracle::Standing;
using oracle::Truth;

namespace {

constexpr std::size_t chunks = 2;  ///< of 1,024 cases, of every family, shape and format

template <class H>
void each_valid_case(H&& holds) {
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "invalid") return;
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
      require_each(family, shape, format,
                   closed_too(drawn(family, shape, format, {}, chunk, chunk_cases / one_in)),
                   holds);
    // Without ends, once.
    for (const Extent extent : {Extent::unbounded, Extent::both_nappes}) {
      std::vector<Case> cases = drawn(family, shape, format, {}, chunks, 200 / one_in);
      for (Case& question : cases) question.extent = extent;
      require_each(family, shape, format, cases, holds);
    }
  });
}

bool is_same(const Outlined& a, const Outlined& b) {
  return a.which == b.which && a.standing == b.standing && a.kind == b.kind && a.patch == b.patch;
}

/// The case as the first stage is asked it: with its exponents near 0 where they are not.
Case moderate(const Case& question) {
  return oracle::is_moderate(question) ? question : oracle::scaled(question).question;
}

Outline by_intervals(const Case& question) {
  const Case* asked = &question;
  Outline outline;
  oracle::outline_by_intervals({&asked, 1}, {&outline, 1});
  return outline;
}

/// Does an outline that is sure list what exact numbers find, root for root?
bool is_confirmed(const Outline& outline, const ExactRoots& to_first, const ExactRoots& all) {
  if (outline.count > all.count) return false;
  int crossings = 0;
  for (int i = 0; i < outline.count; ++i) {
    const Outlined& root = outline.listed[i];
    if (!is_same(root, all.listed[i].outlined)) return false;
    if (root.standing != Standing::acceptable) continue;
    if (crossings == to_first.count || !is_same(root, to_first.listed[crossings].outlined))
      return false;
    ++crossings;
  }
  const bool ended = crossings > 0 && to_first.listed[crossings - 1].outlined.kind == Kind::proper;
  return crossings == to_first.count && (ended || outline.count == all.count);
}

bool agrees_with_exact_numbers(const Case& question, const Outline& outline) {
  return outline.unsure || is_confirmed(outline, oracle::exact_roots(question, false),
                                        oracle::exact_roots(question, true));
}

}  // namespace

BOOST_AUTO_TEST_CASE(intervals_are_unsure_or_agree_with_exact_numbers) {
  each_valid_case([](const Case& question) {
    return agrees_with_exact_numbers(question, by_intervals(moderate(question)));
  });
}

BOOST_AUTO_TEST_CASE(intervals_never_err_on_cases_of_any_size) {
  for (const std::string_view id : {"scale", "length", "far"})
    for (std::size_t shape = 0; shape < shape_count; ++shape)
      if (family_of(id).draw[shape])
        require_each(family_of(id), shape, double_format,
                     drawn(family_of(id), shape, double_format), [](const Case& question) {
                       return agrees_with_exact_numbers(question, by_intervals(question));
                     });
}

BOOST_AUTO_TEST_CASE(the_truth_is_what_exact_numbers_find) {
  each_valid_case([](const Case& question) {
    const Truth truth = oracle::truth(question);
    const ExactRoots exact = oracle::exact_roots(question, false);
    if (truth.count != exact.count) return false;
    for (int i = 0; i < truth.count; ++i)
      if (truth.listed[i].kind != exact.listed[i].outlined.kind) return false;
    return true;
  });
}

namespace {

/// Is x within 2^-bits of the root, of which a value is known to 150 bits? An infinite one is
/// itself.
bool is_known(const Real& x, const oracle::Radical& root, int bits) {
  const Real value = oracle::value(root, 150);
  if (std::isinf(value.high)) return x.high == value.high;
  const Dyadic exact = exactly(value);
  const Dyadic slack = times_power(size(exact), -149);
  return times_power(size(exactly(x) - exact), bits) <= size(exact) + slack;
}

bool has_t_to(const Case& question, const ExactRoots& exact, int bits) {
  const Truth truth = oracle::truth(question, bits);
  for (int i = 0; i < truth.count; ++i) {
    const ExactRoot& root = exact.listed[i];
    if (!is_known(truth.listed[i].t, root.t, bits)) return false;
    if (!is_known(truth.listed[i].t_last, root.t_last, bits)) return false;
  }
  return truth.count == exact.count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_t_is_known_to_the_bits_asked_for) {
  each_valid_case([](const Case& question) {
    const ExactRoots exact = oracle::exact_roots(question, false);
    return has_t_to(question, exact, 34) && has_t_to(question, exact, 63) &&
           has_t_to(question, exact, 74) && has_t_to(question, exact, 123);
  });
}

namespace {

/// The numbers of a radical in a type that is not the oracle's.
struct Plain {
  Dyadic p, d, q;
};

/// Its leading double in turn, each taken off the rest.
Dyadic exactly(CGAL::Mpzf x) {
  Dyadic sum;
  while (x.sign() != 0) {
    const double part = x.to_double();
    sum = sum + Dyadic(part);
    x = x - CGAL::Mpzf(part);
  }
  return sum;
}

/// Does the root lie between x - 2^-bits |x| and x + 2^-bits |x|?
bool encloses(const Real& x, int bits, const oracle::Radical& root) {
  Plain plain{exactly(root.p), exactly(root.d), exactly(root.q)};
  const int e = plain.q.sign() * root.e;
  if (plain.q.sign() < 0) plain.p = -plain.p, plain.q = -plain.q;
  const Dyadic t = times_power(rayaudit::exactly(x), -root.exponent);
  const Dyadic slack = times_power(size(t), -bits);
  // The sign of e sqrt(d) - r, r = y q - p.
  const auto sign_beside = [&](const Dyadic& y) {
    const Dyadic r = y * plain.q - plain.p;
    if (e == 0) return -r.sign();
    if (r.sign() != e) return plain.d.sign() == 0 ? -r.sign() : e;
    return e * (plain.d - r * r).sign();
  };
  return sign_beside(t - slack) >= 0 && sign_beside(t + slack) <= 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_value_of_a_root_encloses_it) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "invalid" || family.id == "scale" || family.id == "length") return;
    require_each(family, shape, format, drawn(family, shape, format, {}, 9, 250 / one_in),
                 [](const Case& question) {
                   const ExactRoots exact = oracle::exact_roots(question, true);
                   for (int i = 0; i < exact.count; ++i)
                     for (const int bits : {34, 63, 123, 150}) {
                       const oracle::Radical& root = exact.listed[i].t;
                       if (!encloses(oracle::value(root, bits), bits - 1, root)) return false;
                     }
                   return true;
                 });
  });
}

BOOST_AUTO_TEST_CASE(the_other_roots_that_a_truth_tells_are_those_of_the_line) {
  std::size_t told = 0;
  each_valid_case([&](const Case& question) {
    const Truth truth = oracle::truth(question);
    if (!truth.others_known) return true;
    const oracle::Roots roots = oracle::roots(question, 150);
    std::vector<Real> others;
    for (const oracle::Root& root : roots.roots())
      if (root.standing != Standing::acceptable) others.push_back(root.t);
    if (others.size() != truth.others().size()) return false;
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (!is_finite(truth.others()[i])) return false;
      if (!agree(rayaudit::exactly(truth.others()[i]), rayaudit::exactly(others[i]), 59))
        return false;
    }
    told += truth.other_count;
    return true;
  });
  BOOST_TEST(told > 10'000 / one_in);
}

BOOST_AUTO_TEST_CASE(lanes_and_intervals_decide_nearly_all_that_is_nothing_special) {
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    for (const Format& format : {float_format, double_format}) {
      if (!family_of("anywhere").draw[shape]) continue;
      const double decided = share(
          closed_too(drawn(family_of("anywhere"), shape, format)),
          [](const Case& question) { return oracle::truth(question).stage < Stage::integers; });
      BOOST_TEST(decided > 0.99, shape_names[shape] << ' ' << format.name << ' ' << decided);
    }
}

BOOST_AUTO_TEST_CASE(the_stage_that_decided_is_named_as_it_was) {
  each_valid_case([](const Case& question) {
    // Exponents that lie too far apart leave no room for intervals.
    const bool in_reach = oracle::is_moderate(question) || oracle::scaled(question).exact;
    const bool by_interval = in_reach && !by_intervals(moderate(question)).unsure;
    oracle::InIntegers found;
    const bool by_integers =
        in_reach &&
        settle_in_integers(moderate(question), oracle::widths_of_integers.back(), false, found);
    const Stage stage = oracle::truth(question).stage;
    if (stage == Stage::lanes || stage == Stage::wide_lanes) return oracle::fits_lanes(question);
    if (stage == Stage::interval) return by_interval;
    return stage == Stage::integers ? by_integers : !by_interval && !by_integers;
  });
}

BOOST_AUTO_TEST_CASE(a_batch_is_settled_like_its_cases_one_by_one) {
  std::vector<Case> mixed;
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    for (const Case& question : drawn(family, shape, format, {}, 0, 7)) mixed.push_back(question);
  });
  std::vector<Truth> truths(mixed.size());
  oracle::truth(mixed, truths);
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    const Truth alone = oracle::truth(mixed[i]);
    bool same = alone.invalid == truths[i].invalid && alone.stage == truths[i].stage &&
                alone.count == truths[i].count;
    for (int j = 0; same && j < alone.count; ++j)
      same = alone.listed[j].kind == truths[i].listed[j].kind &&
             alone.listed[j].t == truths[i].listed[j].t;
    if (!same) BOOST_ERROR(case_line(mixed[i]));
  }
}
