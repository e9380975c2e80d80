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

const Subject& textbook() {
  return *std::ranges::find(built_in_subjects(), "textbook/double", &Subject::name);
}

const Family& family_called(std::string_view id) {
  return *std::ranges::find(families(), id, &Family::id);
}

/// Many more cases than a processor can learn the branches of.
std::vector<Case> drawn(std::size_t shape, const Family& family) {
  constexpr std::size_t chunks = 32;
  std::vector<Case> cases(chunks * chunk_cases);
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    draw(family, shape, double_format, {}, 1, chunk,
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
    fmt::print("{:28} {:8.2f} {} (asked: {} {:g}){}\n", what, value, unit,
               at_most ? "at most" : "at least", limit, line.is_met() ? "" : "   NOT MET");
  }
  return all_met ? 0 : 1;
}
