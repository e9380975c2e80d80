#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "audit/judge.hpp"

namespace rayaudit {

/// What a test is written for: a framework, or plain C with its assert.
enum class PastedAs { boost, gtest, catch2, c };
inline constexpr std::array<std::string_view, 4> pasted_names = {"boost", "gtest", "catch2", "c"};

/// A test to paste: a case with its exact expectation, in hexadecimal numbers of float, double or
/// long double, for a function of the user's that is named `intersect_SHAPE` in it. A t is held to
/// four times an ulp and what rounding the numbers of the case once would do to it, at a double
/// root to half of its bits; what the convention leaves open may be either.
std::string pasted_test(const Case& question, std::string_view why, PastedAs as,
                        const Format& format, const Convention& convention);

}  // namespace rayaudit
