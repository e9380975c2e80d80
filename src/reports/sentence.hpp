#pragma once

#include <string_view>

#include "audit/judge.hpp"

/// Verdicts and claims for those who do not know the words yet.
namespace rayaudit {

/// What a wrong verdict is.
std::string_view sentence(Verdict verdict);
/// What there is at the place that is claimed: what follows the sentence of the verdict, or
/// nothing.
std::string_view sentence(Claim claim);

}  // namespace rayaudit
