/// What truth and an audit cost, as ratios within one run: subject and oracle answer the same cases
/// in turn, round by round, and the medians are told.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "audit/environment.hpp"
#include "geometry/flattened.hpp"
#include "numbers/running_bound.hpp"
#include "routines/routines.hpp"
#include "subjects/certified.hpp"

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

/// One line of the summary: a figure, and the limit that it is held to.
struct Line {
  std::string what;
  double value, limit;
  bool at_most;
  std::string unit;

  bool is_met() const { return at_most ? value <= limit : value >= limit; }
};
std::vector<Line> summary;

/// A benchmark is run more than once until its length is found; the last run counts.
void conclude(const Line& line) {
  std::erase_if(summary, [&](const Line& other) { return other.what == line.what; });
  summary.push_back(line);
}

/// Nanoseconds that textbook/double takes for a sphere *anywhere*, measured first; limits in
/// microseconds are for a core where it takes ten.
double sphere_ns = 0;

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

void truth_beside_textbook(benchmark::State& state, std::size_t shape, const Family& family) {
  const std::vector<Case> all = drawn(shape, family);
  std::vector<oracle::Truth> truths(chunk_cases);
  std::vector<Answer> answers(chunk_cases);
  std::vector<double> subject_ns, truth_ns, ratios;
  std::int64_t exact = 0;
  for (auto _ : state) {
    double subject_time = 0, truth_time = 0;
    exact = 0;
    for (std::size_t i = 0; i < all.size(); i += chunk_cases) {
      const std::span cases = std::span(all).subspan(i, chunk_cases);
      const auto start = Clock::now();
      textbook().answer[shape](cases, answers);
      benchmark::DoNotOptimize(answers.data());
      const auto middle = Clock::now();
      oracle::truth(cases, truths);
      benchmark::DoNotOptimize(truths.data());
      truth_time += seconds(middle);
      subject_time += std::chrono::duration<double>(middle - start).count();
      exact += std::ranges::count(truths, oracle::Stage::exact, &oracle::Truth::stage);
    }
    const double a_case = 1e9 / static_cast<double>(all.size());
    subject_ns.push_back(subject_time * a_case);
    truth_ns.push_back(truth_time * a_case);
    ratios.push_back(truth_time / subject_time);
    state.SetIterationTime(truth_time);
  }
  state.counters["textbook_ns"] = median(subject_ns);
  state.counters["truth_ns"] = median(truth_ns);
  state.counters["ratio"] = median(ratios);
  state.counters["exact"] = static_cast<double>(exact) / static_cast<double>(all.size());
  const std::string what = fmt::format("truth, {} {}", shape_names[shape], family.id);
  if (family.id == "anywhere") {
    if (shape_names[shape] == "sphere") sphere_ns = median(subject_ns);
    conclude({what, median(ratios), 10, true, "x textbook/double"});
  } else {
    const bool curved_side = shape_names[shape] == "cylinder" || shape_names[shape] == "cone";
    const double scale = sphere_ns > 0 ? 10 / sphere_ns : 1;
    conclude({what, median(truth_ns) * scale / 1000, curved_side ? 6 : 1.5, true,
              "us where textbook/double takes 10 ns"});
  }
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
  conclude({fmt::format("audit, {} {}", shape_names[shape], family.id), median(rates) / 1000,
            family.id == "anywhere" ? 500.0 : 100.0, false, "thousand cases a second on a core"});
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
  conclude({"audit on two threads", gain, 1.8, false, "x one, best of five rounds each"});
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

void add_all() {
  constexpr std::size_t sphere = 1;
  add("truth", sphere, "anywhere", truth_beside_textbook, 0.5);
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    for (const auto* id : {"anywhere", "tangent", "rim", "apex", "parallel", "within", "surface"})
      if (shape != sphere || std::string_view(id) != "anywhere")
        add("truth", shape, id, truth_beside_textbook, 0.5);
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
  fmt::print("\n{}, {}\n", found.processor, found.compiler);
  bool all_met = true;
  for (const auto& [what, value, limit, at_most, unit] : summary) {
    const Line line{what, value, limit, at_most, unit};
    all_met = all_met && line.is_met();
    fmt::print("{:44} {:8.2f} {} (asked: {} {:g}){}\n", what, value, unit,
               at_most ? "at most" : "at least", limit, line.is_met() ? "" : "   NOT MET");
  }
  return all_met ? 0 : 1;
}
