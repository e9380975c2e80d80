#include "cli/case_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "geometry/case_line.hpp"
#include "oracle/margin.hpp"
#include "reports/figures.hpp"

namespace rayaudit {
namespace {

using oracle::Crossing;
using oracle::Kind;
using oracle::Truth;

constexpr int shown_digits = 40;

template <class N>
std::string shown(const Vec3<N>& v, std::string (*show)(const N&)) {
  return "(" + show(v.x) + ", " + show(v.y) + ", " + show(v.z) + ")";
}
std::string shown(const double& x) { return fmt::format("{}", x); }
std::string shown(const Vec3<double>& v) { return shown<double>(v, shown); }

std::string shape_text(const Shape& any, Extent extent) {
  return std::visit(
      [&](const auto& shape) {
        std::string text;
        std::size_t i = 0;
        const auto add = [&](const auto& part) {
          text += fmt::format("{}{} {}", i == 0 ? "" : "  ", shape.labels[i], shown(part));
          ++i;
        };
        std::apply([&](const auto&... part) { (add(part), ...); }, shape.parts());
        if (extent != Extent::bounded) (text += "  ") += word(extent);
        return row(shape.name, text);
      },
      any);
}

std::string ray_text(const Ray<double>& ray) {
  return row("ray", fmt::format("origin {}  direction {}  range ({}, {})", shown(ray.origin),
                                shown(ray.direction), ray.t_min, ray.t_max));
}

/// `t = (3 + sqrt(5)) / 2` and below it the digits and the nearest double.
std::string t_text(std::string_view label, const oracle::Spelled& t, double nearest_double) {
  const std::string indent(17, ' ');
  std::string text;
  if (t.closed_form) text += fmt::format("{}{}\n", label, *t.closed_form);
  const std::string digits = t.decimals + (t.terminates ? "" : "...");
  if (!t.closed_form || digits != *t.closed_form)
    text += fmt::format("{}{}\n", t.closed_form ? indent + "  = " : std::string(label), digits);
  std::string hex;
  write(hex, nearest_double);
  return text + fmt::format("{}  nearest double {} = {}\n", indent, nearest_double, hex);
}

std::string crossing_text(const Case& question, const Crossing& crossing) {
  const bool proper = crossing.kind == Kind::proper;
  const std::string what = proper ? "hit" : "touch, " + std::string(name(crossing.kind));
  std::string text =
      t_text(fmt::format("  {:<15}t = ", what), oracle::spelled(question, crossing, shown_digits),
             oracle::rounded<double>(question, crossing));
  if (crossing.kind == Kind::within)
    text += t_text(fmt::format("  {:<15}t = ", "  ... up to"),
                   oracle::spelled_last(question, crossing, shown_digits),
                   oracle::rounded_last<double>(question, crossing));
  return text;
}

std::string other_root_text(const oracle::Root& root) {
  return fmt::format("  {:<15}t = {}\n", name(root.standing), shown(root.t, double_format));
}

/// What a move by the margin would turn.
std::string sentence(const oracle::Margin& margin) {
  const std::string what = [&]() -> std::string {
    switch (margin.sign) {
      case oracle::Sign::discriminant:
        return "whether the line meets the surface";
      case oracle::Sign::start:
        return "whether the ray begins before it";
      case oracle::Sign::end:
        return "whether the ray ends before it";
      case oracle::Sign::side:
        return "whether it lies inside the rim";
      default:
        return "";
    }
  }();
  return margin.together > 1 ? what + ", with others" : what;
}

std::string_view reason(oracle::Invalid invalid) {
  static constexpr std::array<std::string_view, 8> reasons = {
      "",
      "a number is NaN",
      "a number is infinite",
      "the direction is 0",
      "the normal is 0",
      "base and top are the same point",
      "the radius is not above 0",
      "the range is empty",
  };
  return reasons[static_cast<std::size_t>(invalid)];
}

/// How far from another truth, in u of each format, and what would turn first.
std::string margin_text(const Case& question, const Truth& truth) {
  const oracle::Margin margin = oracle::margin(question, truth);
  if (margin.sign == oracle::Sign::touch) return row("margin", "0, for there is a touch");
  if (std::isinf(margin.reach)) return row("margin", "none: no move changes the truth");
  const auto in = [&](const Format& format) {
    return figures::magnitude(std::ldexp(margin.reach, format.precision));
  };
  return row("margin",
             fmt::format("{} u in float, {} in double, {} in long double: {}", in(float_format),
                         in(double_format), in(long_double_format), sentence(margin)));
}

}  // namespace

std::string row(std::string_view label, std::string_view text) {
  return fmt::format("{:<10}{}\n", label, text);
}

std::string shown(const Real& x, const Format& format) {
  if (format == float_format) return fmt::format("{}", nearest<float>(x));
  if (format == double_format) return fmt::format("{}", nearest<double>(x));
  return fmt::format("{}", nearest<long double>(x));
}

std::string question_text(const Case& question) {
  return shape_text(question.shape, question.extent) + ray_text(question.ray);
}

std::string_view words_of(oracle::Stage stage) {
  constexpr std::array<std::string_view, oracle::stage_count> words = {
      "numbers of two words", "numbers of three words", "intervals", "integers", "exact numbers"};
  return words[static_cast<std::size_t>(stage)];
}

std::string truth_text(const Case& question, const Truth& truth) {
  if (truth.invalid != oracle::Invalid::no)
    return row("truth", fmt::format("none, the case is invalid: {}", reason(truth.invalid)));
  std::string text =
      row("truth",
          fmt::format("{}{} (decided by {})", truth.hit() ? "a hit" : "a miss",
                      truth.has_touch() ? ", or the touch before it, as convention has it" : "",
                      words_of(truth.stage)));
  for (const Crossing& crossing : truth.crossings()) text += crossing_text(question, crossing);
  text += margin_text(question, truth);
  std::string others;
  const oracle::Roots roots = oracle::roots(question);
  for (const oracle::Root& root : roots.roots())
    if (root.standing != oracle::Standing::acceptable) others += other_root_text(root);
  return others.empty() ? text : text + "other roots, no answers:\n" + others;
}

}  // namespace rayaudit
