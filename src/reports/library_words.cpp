#include "reports/library_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <tuple>

#include "geometry/case_line.hpp"
#include "reports/declared.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/sentence.hpp"

namespace rayaudit {
namespace {

constexpr int shown_digits = 20;

std::string head(const LibraryFinding& finding, const Worst& shown, std::string_view build,
                 const Convention& stated) {
  const std::string words = declared(joined(stated, finding.subject->convention));
  std::string judge = fmt::format("rayaudit judge --format {}", finding.subject->format.name);
  if (!words.empty()) judge += " --convention " + words;
  std::string text;
  if (!finding.subject->about.empty()) text += fmt::format("// {}\n", finding.subject->about);
  text += fmt::format("// build: {}\n", build);
  text += fmt::format("// case: {}\n", case_line(shown.question));
  text += fmt::format("// exact: {}\n", exact_answer(shown.question, shown.answer.form));
  text += fmt::format("// observed: {}\n", printed(shown.answer));
  return text + fmt::format("// wrong by: {}\n", judge);
}

/// `(3 + sqrt(5)) / 2 = 2.618...`
std::string digits_of(const oracle::Spelled& t) {
  const std::string digits = t.decimals + (t.terminates ? "" : "...");
  return !t.closed_form || *t.closed_form == digits
             ? digits
             : fmt::format("{} = {}", *t.closed_form, digits);
}

/// A t^2 + B t + C along a ray.
struct Quadratic {
  double a, b, c;

  double discriminant() const { return b * b - 4 * a * c; }
};

/// Are all numbers of a case whole multiples of 1/16 and at most 16? Then the polynomials below
/// are exact in double.
bool is_followed(const Case& question) {
  bool all = true;
  each_number(question,
              [&](double x) { all = all && std::fabs(x) <= 16 && std::trunc(16 * x) == 16 * x; });
  return all;
}

/// The squared distance to the axis less that of the surface, times |w|^2.
template <class S>
Quadratic around_axis(const Ray<double>& ray, const S& shape) {
  const auto [base, tip] = std::tuple(std::get<0>(shape.parts()), std::get<1>(shape.parts()));
  const Vec3<double> d = ray.direction, v = ray.origin - base, w = tip - base;
  const double ww = dot(w, w), vw = dot(v, w), dw = dot(d, w), rr = shape.radius * shape.radius;
  Quadratic made = {dot(d, d) * ww - dw * dw, 2 * (dot(v, d) * ww - vw * dw),
                    dot(v, v) * ww - vw * vw};
  if constexpr (requires { shape.apex; }) {
    const double h = ww - vw;
    made = {ww * made.a - rr * dw * dw, ww * made.b + 2 * rr * h * dw, ww * made.c - rr * h * h};
  } else {
    made.c -= rr * ww;
  }
  return made;
}

std::string told(std::string_view of, const Quadratic& f) {
  return fmt::format(
      "The points o + t d on the {} have A t^2 + B t + C = 0 with A = {}, B = {}, C = {}; "
      "B^2 - 4 A C = {}.",
      of, f.a, f.b, f.c, f.discriminant());
}

std::string by_hand_of(const Ray<double>& ray, const Disk<double>& disk) {
  const double across = dot(ray.direction, disk.normal);
  const double above = dot(disk.centre - ray.origin, disk.normal);
  return fmt::format("The plane is met where t (d n) = (c - o) n: t {} = {}.", across, above);
}
std::string by_hand_of(const Ray<double>& ray, const Sphere<double>& sphere) {
  const Vec3<double> v = ray.origin - sphere.centre;
  return told("sphere", {dot(ray.direction, ray.direction), 2 * dot(v, ray.direction),
                         dot(v, v) - sphere.radius * sphere.radius});
}
template <class S>
std::string by_hand_of(const Ray<double>& ray, const S& shape) {
  return told("endless lateral surface", around_axis(ray, shape));
}

/// Where a hit lies. What is left of a coordinate by cancelling, which rounding t leaves, is 0.
std::string place_of(const Case& question, const oracle::Crossing& crossing) {
  const auto t = oracle::rounded<long double>(question, crossing);
  const auto coordinate = [&](long double from, long double step) -> double {
    const long double at = from + t * step;
    const bool is_left_over = std::fabs(at) <= 0x1p-60L * std::fabs(from);
    return is_left_over ? 0 : static_cast<double>(at);
  };
  const auto& [o, d] = std::tie(question.ray.origin, question.ray.direction);
  return fmt::format(", at {:.9g} {:.9g} {:.9g}", coordinate(o.x, d.x), coordinate(o.y, d.y),
                     coordinate(o.z, d.z));
}

}  // namespace

std::string afflicted(const LibraryFinding& finding, std::size_t most) {
  std::vector<std::string> words;
  for (const Afflicted& each : finding.families)
    if (words.size() < most)
      words.push_back(fmt::format("{} of {} in {}", figures::grouped(each.wrong),
                                  figures::grouped(each.cases), each.family));
  if (const std::size_t more = finding.families.size() - words.size(); more > 0)
    words.push_back(fmt::format("less of {} more", more));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string shares(const std::vector<Share>& shares, std::uint64_t of) {
  if (shares.size() == 1 && shares.front().count == of) return shares.front().of;
  std::vector<std::string> words;
  words.reserve(shares.size());
  for (const Share& each : shares)
    words.push_back(fmt::format("{}% {}", figures::percent(each.count, of), each.of));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string what(const LibraryFinding& finding) {
  const Worst shown = told_first(finding.example);
  std::string text(sentence(finding.verdict));
  if (finding.verdict == Verdict::wrong_root)
    if (const auto root = root_that_is_far(shown.question, shown.answer))
      text = fmt::format("a hit, but t is no root at all; the nearest is {:.6g}", *root);
  return text += sentence(finding.claim);
}

std::string exact_answer(const Case& question, Answer::Form beside) {
  const oracle::Truth truth = oracle::truth(question);
  std::string text;
  for (const oracle::Crossing& crossing : truth.crossings()) {
    if (crossing.kind == oracle::Kind::proper)
      return text + "hit " + digits_of(oracle::spelled(question, crossing, shown_digits)) +
             (beside == Answer::Form::at ? place_of(question, crossing) : "");
    text += crossing.kind == oracle::Kind::within
                ? "the ray lies in the surface: any finite t there, or "
                : fmt::format("a touch ({}), or ", name(crossing.kind));
  }
  return text + "miss";
}

std::string by_hand(const Case& question) {
  if (!is_followed(question)) return "";
  return std::visit([&](const auto& shape) { return by_hand_of(question.ray, shape); },
                    question.shape);
}

LibraryProgram headed(LibraryProgram shown_by, const LibraryFinding& finding,
                      const Convention& stated) {
  OutsideProgram& program = shown_by.program;
  program.text.insert(0, head(finding, shown_by.shown, program.build, stated));
  return shown_by;
}

}  // namespace rayaudit
