/// What truth and an audit cost, as ratios within one run: subject and oracle answer the same cases
/// in turn, round by round, and the medians are told.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "audit/environment.hpp"
#include "geometry/flattened.hpp"
#include "numbers/running_bound.hpp"
#include "oracle/lanes/lanes.hpp"
#include "routines/routines.hpp"
#include "subjects/certified.hpp"
#include "subjects/exact.hpp"
#include "tests/oracle/second_derivation/spherical_kernel.hpp"

using namespace rayaudit;

namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One line of the summary: a figure, and the limit that it is held to where one was asked for.
struct Line {
  std::string what;
  double value;
  std::optional<double> limit;
  bool at_most;
  std::string unit, remark = {};

  bool is_met() const { return !limit || (at_most ? value <= *limit : value >= *limit); }
};
std::vector<Line> summary;

/// A benchmark is run more than once until its length is found; the last run counts.
void conclude(const Line& line) {
  std::erase_if(summary, [&](const Line& other) { return other.what == line.what; });
  summary.push_back(line);
}

const Subject& subject_called(std::string_view name) {
  return *std::ranges::find(built_in_subjects(), name, &Subject::name);
}

const Subject& textbook() { return subject_called("textbook/double"); }

const Family& family_called(std::string_view id) {
  return *std::ranges::find(families(), id, &Family::id);
}

/// Many more cases than a processor can learn the branches of.
std::vector<Case> drawn(std::size_t shape, const Family& family,
                        const Format& format = double_format) {
  constexpr std::size_t chunks = 32;
  std::vector<Case> cases(chunks * chunk_cases);
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    draw(family, shape, format, {}, 1, chunk,
         std::span(cases).subspan(chunk * chunk_cases, chunk_cases));
  return cases;
}

/// Small whole numbers that make exact ties, of which the lattice has some.
std::vector<Case> short_ties(std::size_t shape) {
  constexpr std::size_t wanted = 4 * chunk_cases, most_chunks = 400;
  std::vector<Case> ties;
  std::vector<Case> cases(chunk_cases);
  for (std::size_t chunk = 0; chunk < most_chunks && ties.size() < wanted; ++chunk) {
    draw(family_called("lattice"), shape, double_format, {}, 1, chunk, cases);
    for (const Case& question : cases)
      if (oracle::truth(question).has_touch()) ties.push_back(question);
  }
  ties.resize(std::min(ties.size(), wanted) / chunk_cases * chunk_cases);
  return ties;
}

/// The share of each stage, in per cent.
std::string shares(const std::vector<std::uint64_t>& stages) {
  const double all = std::max<double>(1, std::accumulate(stages.begin(), stages.end(), 0.0));
  std::string words = "  (";
  for (std::size_t i = 0; i < stages.size(); ++i)
    words += fmt::format("{}{} {:.3g}%", i == 0 ? "" : ", ", name(static_cast<oracle::Stage>(i)),
                         100 * static_cast<double>(stages[i]) / all);
  return words + ")";
}

/// The median over rounds of what answer(cases) takes, chunk by chunk, beside the textbook in
/// double on the same cases; nanoseconds of either in the counters.
template <class Function>
double beside_textbook(benchmark::State& state, std::size_t shape, const std::vector<Case>& all,
                       const Function& answer) {
  std::vector<Answer> answers(chunk_cases);
  std::vector<double> subject_ns, other_ns, ratios;
  for (auto _ : state) {
    double subject_time = 0, other_time = 0;
    for (std::size_t i = 0; i < all.size(); i += chunk_cases) {
      const std::span cases = std::span(all).subspan(i, chunk_cases);
      const auto start = Clock::now();
      textbook().answer[shape](cases, answers);
      benchmark::DoNotOptimize(answers.data());
      const auto middle = Clock::now();
      answer(cases);
      other_time += seconds(middle);
      subject_time += std::chrono::duration<double>(middle - start).count();
    }
    const double a_case = 1e9 / static_cast<double>(all.size());
    subject_ns.push_back(subject_time * a_case);
    other_ns.push_back(other_time * a_case);
    ratios.push_back(other_time / subject_time);
    state.SetIterationTime(other_time);
  }
  state.counters["textbook_ns"] = median(subject_ns);
  state.counters["ns"] = median(other_ns);
  return median(ratios);
}

/// What truth costs, verdict and t, on cases of one kind.
void truth_beside_textbook(benchmark::State& state, const std::string& what, std::size_t shape,
                           const std::vector<Case>& all, std::optional<double> limit) {
  std::vector<oracle::Truth> truths(chunk_cases);
  std::vector<std::uint64_t> stages(oracle::stage_count);
  const double ratio = beside_textbook(state, shape, all, [&](std::span<const Case> cases) {
    oracle::truth(cases, truths);
    benchmark::DoNotOptimize(truths.data());
  });
  for (const Case& question : all)
    ++stages[static_cast<std::size_t>(oracle::truth(question).stage)];
  conclude({what, ratio, limit, true, "x textbook/double", shares(stages)});
}

/// CGAL's own ways to an answer, and the oracle as one of them.
void way_beside_textbook(benchmark::State& state, const std::string& what, std::size_t shape,
                         const Subject& way) {
  std::vector<Case> all = drawn(shape, family_called("anywhere"));
  all.resize(way.dear > 20 ? chunk_cases : all.size());
  std::vector<Answer> answers(chunk_cases);
  const double ratio = beside_textbook(state, shape, all, [&](std::span<const Case> cases) {
    way.answer[shape](cases, answers);
    benchmark::DoNotOptimize(answers.data());
  });
  conclude({what, ratio, {}, true, "x textbook/double"});
}

Plan plan_of(std::size_t shape, const Family& family, int threads, std::uint64_t chunks = 100) {
  return {.subjects = {&textbook()},
          .families = {&family},
          .shapes = {shape},
          .cases = chunks * chunk_cases,
          .seed = 1,
          .threads = threads};
}

/// Judged cases a second.
double rate(const Plan& plan) {
  const auto start = Clock::now();
  const std::vector<Audit> audits = run(plan);
  return static_cast<double>(plan.cases * audits.size()) / seconds(start);
}

void whole_audit(benchmark::State& state, std::size_t shape, const Family& family) {
  std::vector<double> rates;
  const Plan plan = plan_of(shape, family, 1);
  for (auto _ : state) {
    rates.push_back(rate(plan));
    state.SetIterationTime(static_cast<double>(plan.cases) / rates.back());
  }
  state.counters["cases/s"] = median(rates);
  const bool is_sphere = shape_names[shape] == "sphere";
  std::optional<double> limit;
  if (is_sphere && family.id == "anywhere") limit = 4'000;
  if (is_sphere && family.id == "grazing") limit = 2'000;
  conclude({fmt::format("audit, {} {}", shape_names[shape], family.id), median(rates) / 1000, limit,
            false, "thousand cases a second on a core"});
}

void two_threads(benchmark::State& state) {
  std::vector<double> one, two;
  const Plan alone = plan_of(1, family_called("anywhere"), 1, 1000);
  const Plan both = plan_of(1, family_called("anywhere"), 2, 1000);
  for (auto _ : state)
    for (int round = 0; round < 5; ++round) {
      one.push_back(rate(alone));
      two.push_back(rate(both));
    }
  const double gain = std::ranges::max(two) / std::ranges::max(one);
  state.counters["gain"] = gain;
  conclude({"audit on two threads", gain, 1.9, false, "x one, best of five rounds each"});
}

/// What answer(cases) costs beside a plain subject on the same cases *anywhere*, chunk by chunk.
template <class Function>
void beside_plain(benchmark::State& state, const std::string& what, const Subject& plain,
                  std::size_t shape, double limit, const Function& answer) {
  const std::vector<Case> all = drawn(shape, family_called("anywhere"), plain.drawn_in());
  std::vector<Answer> answers(chunk_cases);
  std::vector<double> ratios;
  for (auto _ : state) {
    double plain_time = 0, time = 0;
    for (std::size_t i = 0; i < all.size(); i += chunk_cases) {
      const std::span cases = std::span(all).subspan(i, chunk_cases);
      const auto start = Clock::now();
      plain.answer[shape](cases, answers);
      benchmark::DoNotOptimize(answers.data());
      const auto middle = Clock::now();
      answer(cases);
      time += seconds(middle);
      plain_time += std::chrono::duration<double>(middle - start).count();
    }
    ratios.push_back(time / plain_time);
    state.SetIterationTime(time);
  }
  state.counters["ratio"] = median(ratios);
  conclude({what, median(ratios), limit, true, "x " + plain.name});
}

template <class Function>
void add_beside_plain(const std::string& what, const std::string& plain, std::size_t shape,
                      double limit, const Function& answer) {
  benchmark::RegisterBenchmark(what.c_str(),
                               [=](benchmark::State& state) {
                                 beside_plain(state, what, subject_called(plain), shape, limit,
                                              answer);
                               })
      ->UseManualTime()
      ->MinTime(0.3);
}

struct BoundedHit {
  bool hit, proved;
  double t, error;
};

/// The routine in numbers with a running bound, as an audit runs it.
template <class Routine, class N, class S>
void answer_in_bounds(std::span<const Case> cases, std::span<BoundedHit> answers) {
  using Bound = RunningBound<N>;
  run_flattened([&] {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const ProofWatch<N> watch;
      const std::optional<Bound> t = Routine()(in<Bound>(in<N>(cases[i].ray)),
                                               in<Bound>(in<N>(*std::get_if<S>(&cases[i].shape))));
      answers[i] = {t.has_value(), watch.all_proved(), 0, 0};
      if (t) answers[i].t = static_cast<double>(t->value), answers[i].error = t->error();
    }
  });
}

template <class Routine, class N, class S>
void add_bound() {
  if constexpr (std::is_invocable_v<Routine, const Ray<double>&, const S&>) {
    const std::string plain = fmt::format("{}/{}", Routine::name, format_of<N>.name);
    const std::size_t shape = Shape(S()).index();
    add_beside_plain(fmt::format("bound, {} {}", S::name, plain), plain, shape, 5,
                     [](std::span<const Case> cases) {
                       std::vector<BoundedHit> answers(cases.size());
                       answer_in_bounds<Routine, N, S>(cases, answers);
                       benchmark::DoNotOptimize(answers.data());
                     });
  }
}

template <class Routine>
void add_bounds() {
  [&]<class... S>(const std::variant<S...>*) {
    (add_bound<Routine, float, S>(), ...);
    (add_bound<Routine, double, S>(), ...);
  }(static_cast<const Shape*>(nullptr));
}

void add_certified(std::size_t shape, const std::string& format, double limit) {
  const std::string best = shape_names[shape] == "disk" ? "division_free/" : "closest_approach/";
  const Subject& subject = subject_called("certified/" + format);
  add_beside_plain(fmt::format("{}, {}", subject.name, shape_names[shape]), best + format, shape,
                   limit, [&subject, shape](std::span<const Case> cases) {
                     std::vector<Answer> answers(cases.size());
                     subject.answer[shape](cases, answers);
                     benchmark::DoNotOptimize(answers.data());
                   });
}

void add_certified(std::size_t shape) {
  add_certified(shape, "float", 4);
  add_certified(shape, "double", 15);
  const bool is_disk = shape_names[shape] == "disk";
  add_beside_plain(fmt::format("certified to a bound, {}", shape_names[shape]),
                   is_disk ? "division_free/double" : "closest_approach/double", shape, 6,
                   [](std::span<const Case> cases) {
                     std::vector<Certified> answers(cases.size());
                     certify(cases, answers);
                     benchmark::DoNotOptimize(answers.data());
                   });
}

template <class Function>
void add(std::string_view what, std::size_t shape, std::string_view id, const Function& measure,
         double least_seconds) {
  const Family& family = family_called(id);
  if (family.draw[shape] == nullptr) return;
  benchmark::RegisterBenchmark(
      fmt::format("{}/{}/{}", what, shape_names[shape], id).c_str(),
      [=, &family](benchmark::State& state) { measure(state, shape, family); })
      ->UseManualTime()
      ->MinTime(least_seconds);
}

/// What was asked of a kind of cases: of each of the open shapes, for lanes of four and of eight.
struct Asked {
  double disk, sphere, cylinder, cone;

  std::optional<double> of(std::size_t shape) const {
    const std::array limits = {disk, sphere, cylinder, cone};
    return shape < limits.size() ? std::optional(limits[shape]) : std::nullopt;
  }
};
constexpr Asked anywhere_by_4 = {2, 1.5, 1.5, 1.5}, anywhere_by_8 = {1.4, 1.1, 1.1, 1.1};
constexpr Asked grazing_by_4 = {4.5, 2, 4.5, 4.5}, grazing_by_8 = {3, 1.5, 3, 3};
constexpr Asked ties_of_few_bits = {15, 10, 10, 15}, ties_of_all_bits = {25, 25, 40, 40};

void add_truth(std::size_t shape, std::string_view kind, std::optional<double> limit,
               const std::function<std::vector<Case>()>& make) {
  const std::string what = fmt::format("truth, {} {}", shape_names[shape], kind);
  benchmark::RegisterBenchmark(what.c_str(),
                               [=](benchmark::State& state) {
                                 const std::vector<Case> all = make();
                                 if (all.empty()) return state.SkipWithError("no such cases");
                                 truth_beside_textbook(state, what, shape, all, limit);
                               })
      ->UseManualTime()
      ->MinTime(0.3);
}

void add_truth(std::size_t shape) {
  const bool by_8 = oracle::widest_lanes() == oracle::Lanes::avx512;
  const auto add_family = [&](std::string_view id, std::optional<double> limit) {
    const Family& family = family_called(id);
    if (family.draw[shape] != nullptr)
      add_truth(shape, id, limit, [=, &family] { return drawn(shape, family); });
  };
  add_family("anywhere", (by_8 ? anywhere_by_8 : anywhere_by_4).of(shape));
  add_family("grazing", (by_8 ? grazing_by_8 : grazing_by_4).of(shape));
  add_truth(shape, "ties of few bits", ties_of_few_bits.of(shape),
            [=] { return short_ties(shape); });
  for (const auto* id : {"tangent", "rim", "apex", "parallel", "within", "surface"}) {
    const bool is_asked =
        std::string_view(id) == (shape_names[shape] == "disk" ? "rim" : "tangent");
    add_family(id, is_asked ? ties_of_all_bits.of(shape) : std::nullopt);
  }
}

void add_spherical_kernel() {
  constexpr std::size_t sphere = 1;
  const std::string what = "CGAL's exact spherical kernel, sphere anywhere";
  benchmark::RegisterBenchmark(
      what.c_str(),
      [=](benchmark::State& state) {
        std::vector<Case> all = drawn(sphere, family_called("anywhere"));
        all.resize(chunk_cases);
        const auto meet = [](std::span<const Case> cases) {
          benchmark::DoNotOptimize(meet_by_spherical_kernel(cases));
        };
        conclude({what, beside_textbook(state, sphere, all, meet), {}, true, "x textbook/double"});
      })
      ->UseManualTime()
      ->MinTime(0.2);
}

void add_ways(std::size_t shape) {
  static const std::vector<Subject> ways = exact_subjects();
  for (const Subject& way : ways) {
    const std::string what = fmt::format("{}, {} anywhere", way.name, shape_names[shape]);
    benchmark::RegisterBenchmark(
        what.c_str(),
        [=, &way](benchmark::State& state) { way_beside_textbook(state, what, shape, way); })
        ->UseManualTime()
        ->MinTime(0.2);
  }
}

void add_all() {
  for (std::size_t shape = 0; shape < shape_count; ++shape) add_truth(shape);
  for (std::size_t shape = 0; shape < 4; ++shape) add_ways(shape);
  add_spherical_kernel();
  add_bounds<ClosestApproach>();
  add_bounds<DivisionFree>();
  add_bounds<StableQuadratic>();
  add_bounds<Textbook>();
  for (std::size_t shape = 0; shape < shape_count; ++shape) add_certified(shape);
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    for (const auto* id : {"anywhere", "grazing", "tangent"})
      add("audit", shape, id, whole_audit, 1);
  benchmark::RegisterBenchmark("audit/two_threads", two_threads)->Iterations(1);
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  add_all();
  benchmark::RunSpecifiedBenchmarks();
  const Environment found = environment();
  fmt::print("\n{}, lanes of {}, {}\n", found.processor, name(oracle::widest_lanes()),
             found.compiler);
  bool all_met = true;
  for (const Line& line : summary) {
    all_met = all_met && line.is_met();
    const std::string asked =
        line.limit ? fmt::format(" (asked: {} {:g}){}", line.at_most ? "at most" : "at least",
                                 *line.limit, line.is_met() ? "" : "   NOT MET")
                   : "";
    fmt::print("{:44} {:8.2f} {}{}{}\n", line.what, line.value, line.unit, asked, line.remark);
  }
  return all_met ? 0 : 1;
}
