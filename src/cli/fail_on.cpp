#include "cli/fail_on.hpp"

#include <charconv>
#include <cmath>
#include <vector>

#include "cli/pieces.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

constexpr std::string_view max_ulp = "max_ulp";

double read_ulps(std::string_view text) {
  double ulps = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), ulps);
  if (fault != std::errc() || end != text.data() + text.size() || !(ulps >= 0))
    throw Error("--fail-on: max_ulp must be a number of ulps, got " + quotation(text));
  return ulps;
}

}  // namespace

FailOn read_fail_on(std::string_view text) {
  std::vector<std::string_view> known;
  for (std::uint8_t i = 0; i < verdict_count; ++i) known.push_back(name(Verdict{i}));
  known.push_back(max_ulp);
  FailOn fail_on;
  const auto named = pieces(text, ',');
  if (named.empty()) throw Error("--fail-on: expected a verdict, as in --fail-on false_hit");
  for (const std::string_view piece : named) {
    if (piece.starts_with("max_ulp=")) {
      fail_on.most_ulps = read_ulps(piece.substr(max_ulp.size() + 1));
      continue;
    }
    const auto place = std::find(known.begin(), known.end(), piece) - known.begin();
    if (place == static_cast<std::ptrdiff_t>(known.size()))
      throw Error("--fail-on: " + unknown_name("verdict", piece, known));
    if (piece == max_ulp) throw Error("--fail-on: max_ulp needs its limit, as in max_ulp=4");
    fail_on.verdicts[static_cast<std::size_t>(place)] = true;
  }
  return fail_on;
}

}  // namespace rayaudit
