#include "reports/pasted_test.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/case_line.hpp"

namespace rayaudit {
namespace {

using oracle::Crossing;
using oracle::Kind;
using oracle::Truth;

/// The words of one format in C and C++.
struct Spelling {
  std::string_view type, suffix, absolute;
};
Spelling spelling(const Format& format, PastedAs as) {
  const bool is_c = as == PastedAs::c;
  if (format == float_format) return {"float", "f", is_c ? "fabsf" : "std::fabs"};
  if (format == double_format) return {"double", "", is_c ? "fabs" : "std::fabs"};
  return {"long double", "L", is_c ? "fabsl" : "std::fabs"};
}

std::string literal(const Real& x, const Spelling& in) {
  if (is_nan(x)) return "NAN";
  if (is_infinite(x)) return sign(x) < 0 ? "-INFINITY" : "INFINITY";
  std::string text;
  write(text, x);
  return text + std::string(in.suffix);
}
std::string literal(double x, const Spelling& in) { return literal(real(x), in); }

std::string declared(std::string_view name, const Vec3<double>& v, const Spelling& in) {
  return fmt::format("  const {} {}[3] = {{{}, {}, {}}};\n", in.type, name, literal(v.x, in),
                     literal(v.y, in), literal(v.z, in));
}
std::string declared(std::string_view name, double x, const Spelling& in) {
  return fmt::format("  const {} {} = {};\n", in.type, name, literal(x, in));
}

bool is_float(double x) { return std::isnan(x) || x == static_cast<double>(static_cast<float>(x)); }
bool is_float(const Vec3<double>& v) { return is_float(v.x) && is_float(v.y) && is_float(v.z); }

/// The way between two floats need not be a float, nor the radius of an angle that is one.
template <class Part>
Spelling spelling_of(const Part& part, const Spelling& in) {
  return in.suffix == "f" && !is_float(part) ? spelling(double_format, PastedAs::c) : in;
}

/// The function under test: `intersect_cylinder`, `intersect_unbounded_cylinder`.
std::string called(const Case& question) {
  const std::string_view extent = word(question.extent);
  return fmt::format("intersect_{}{}{}", extent, extent.empty() ? "" : "_", name(question.shape));
}

/// The numbers of the case, and the call with them.
std::string asked(const Case& question, const Spelling& in) {
  std::string text =
      declared("origin", question.ray.origin, in) +
      declared("direction", question.ray.direction, spelling_of(question.ray.direction, in)) +
      declared("t_min", question.ray.t_min, in) + declared("t_max", question.ray.t_max, in);
  std::string names = "origin, direction, t_min, t_max";
  std::visit(
      [&](const auto& shape) {
        std::size_t i = 0;
        const auto add = [&](const auto& part) {
          text += declared(shape.labels[i], part, spelling_of(part, in));
          (names += ", ") += shape.labels[i];
          ++i;
        };
        std::apply([&](const auto&... part) { (add(part), ...); }, shape.parts());
      },
      question.shape);
  return text + fmt::format("  {} t = 0;\n  const bool hit = {}({}, &t);  /* yours */\n", in.type,
                            called(question), names);
}

template <class N>
Real rounded(const Case& question, const Crossing& crossing, bool last) {
  return real(last ? oracle::rounded_last<N>(question, crossing)
                   : oracle::rounded<N>(question, crossing));
}
Real rounded(const Case& question, const Crossing& crossing, const Format& format, bool last) {
  if (format == float_format) return rounded<float>(question, crossing, last);
  if (format == double_format) return rounded<double>(question, crossing, last);
  return rounded<long double>(question, crossing, last);
}

/// How many ulps a t may be off; at a double root as many as half of its bits.
double ulps_granted(Settled& settled, int crossing, const Format& format) {
  if (settled.truth().crossings()[crossing].kind == Kind::within) return 4;
  const Real& forced = settled.sensitivity(crossing).forced;
  const Real& t = settled.truth().crossings()[crossing].t;
  const double condition = scaled(forced, spacing_exponent(t, format) - format.unit_exponent());
  return std::isfinite(condition) ? std::ceil(4 * (1 + condition))
                                  : std::ldexp(1, format.precision / 2);
}

/// What an answer may be.
struct Expectation {
  bool may_miss = true;
  std::vector<std::string> hits;  ///< conditions on t
};

std::string condition(Settled& settled, int place, const Format& format, const Spelling& in) {
  const Crossing& crossing = settled.truth().crossings()[place];
  const Case& question = settled.question();
  const Real t = rounded(question, crossing, format, false);
  if (!is_finite(t)) return "t == " + literal(t, in);
  const std::string off = fmt::format("{} * {}", literal(ulps_granted(settled, place, format), in),
                                      literal(Real{1, 0, 0, spacing_exponent(t, format)}, in));
  if (crossing.kind != Kind::within)
    return fmt::format("{}(t - {}) <= {}", in.absolute, literal(t, in), off);
  const std::string last = literal(rounded(question, crossing, format, true), in);
  return fmt::format("({} - {} <= t && t <= {} + {})", literal(t, in), off, last, off);
}

Expectation expectation(Settled& settled, const Format& format, const Convention& convention,
                        const Spelling& in) {
  if (convention.inside == Convention::Inside::start && comes_from_inside(settled))
    return {false, {"t == t_min"}};
  Expectation made;
  const Choices choices(settled, convention);
  for (const int i : choices.list()) made.hits.push_back(condition(settled, i, format, in));
  made.may_miss = choices.must < 0;
  return made;
}

std::string checked(std::string_view condition, PastedAs as) {
  constexpr std::array<std::string_view, 4> checks = {"BOOST_CHECK", "EXPECT_TRUE", "CHECK",
                                                      "assert"};
  return fmt::format("  {}(({}));\n", checks[static_cast<std::size_t>(as)], condition);
}

std::string checks(const Expectation& wanted, PastedAs as) {
  if (wanted.hits.empty()) return checked("!hit", as);
  if (!wanted.may_miss && wanted.hits.size() == 1)
    return checked("hit", as) + checked(wanted.hits[0], as);
  const std::string any = fmt::format("{}", fmt::join(wanted.hits, " || "));
  return wanted.may_miss ? checked(fmt::format("!hit || {}", any), as)
                         : checked("hit", as) + checked(any, as);
}

/// Of a case a number, the same everywhere (FNV-1a: draft-eastlake-fnv).
std::uint32_t number_of(std::string_view line) {
  std::uint32_t number = 2166136261U;
  for (const char letter : line) number = (number ^ static_cast<unsigned char>(letter)) * 16777619U;
  return number;
}

std::string head(const std::string& name, PastedAs as) {
  switch (as) {
    case PastedAs::boost:
      return fmt::format("BOOST_AUTO_TEST_CASE({}) {{\n", name);
    case PastedAs::gtest:
      return fmt::format("TEST(rayaudit, {}) {{\n", name);
    case PastedAs::catch2:
      return fmt::format("TEST_CASE(\"{}\") {{\n", name);
    case PastedAs::c:
      return fmt::format("static void {}(void) {{\n", name);
  }
  return {};
}

/// What the test includes, and the function it calls.
std::string preamble(const Case& question, PastedAs as, const Spelling& in) {
  constexpr std::array<std::string_view, 4> includes = {
      "#include <boost/test/unit_test.hpp>\n#include <cmath>",
      "#include <gtest/gtest.h>\n#include <cmath>",
      "#if __has_include(<catch2/catch_test_macros.hpp>)\n"
      "#include <catch2/catch_test_macros.hpp>\n#else\n#include <catch2/catch.hpp>\n#endif\n"
      "#include <cmath>",
      "#include <assert.h>\n#include <math.h>\n#include <stdbool.h>"};
  std::string parameters =
      fmt::format("const {0} origin[3], const {1} direction[3], {0} t_min, {0} t_max", in.type,
                  spelling_of(question.ray.direction, in).type);
  std::visit(
      [&](const auto& shape) {
        std::size_t i = 0;
        const auto add = [&](const auto& part) {
          if constexpr (requires { part.x; })
            parameters +=
                fmt::format(", const {} {}[3]", spelling_of(part, in).type, shape.labels[i]);
          else
            parameters += fmt::format(", {} {}", spelling_of(part, in).type, shape.labels[i]);
          ++i;
        };
        std::apply([&](const auto&... part) { (add(part), ...); }, shape.parts());
      },
      question.shape);
  return fmt::format(
      "{}\n\n/* Yours: true and t, in units of the direction, or false. */\n"
      "bool {}({}, {}* t);\n\n",
      includes[static_cast<std::size_t>(as)], called(question), parameters, in.type);
}

std::string truth_comment(Settled& settled) {
  const Truth& truth = settled.truth();
  if (truth.invalid != oracle::Invalid::no)
    return fmt::format("invalid ({}): no hit", name(truth.invalid));
  std::string text;
  for (const Crossing& crossing : truth.crossings()) {
    const oracle::Spelled t = oracle::spelled(settled.question(), crossing, 20);
    const std::string kind =
        crossing.kind == Kind::proper ? "hit" : "touch (" + std::string(name(crossing.kind)) + ")";
    text += fmt::format("{}{} at t = {}{}", text.empty() ? "" : ", then ", kind, t.decimals,
                        t.terminates ? "" : "...");
  }
  if (truth.hit() != nullptr) return text;
  return text.empty() ? "miss" : text + ", or a miss";
}

}  // namespace

std::string pasted_test(const Case& question, std::string_view why, PastedAs as,
                        const Format& format, const Convention& convention) {
  const Spelling in = spelling(format, as);
  const Truth truth = oracle::truth(question, oracle::bits_for(format));
  Settled settled(question, truth);
  const std::string line = case_line(question);
  const std::string test = fmt::format("{}_{:08x}", name(question.shape), number_of(line));
  std::string text = preamble(question, as, in) + fmt::format("/* {} */\n", line);
  if (!why.empty() && why.find("*/") == why.npos) text += fmt::format("/* {} */\n", why);
  text += fmt::format("/* The exact truth: {}. */\n", truth_comment(settled));
  text += head(test, as) + asked(question, in);
  return text + checks(expectation(settled, format, convention, in), as) + "}\n";
}

}  // namespace rayaudit
