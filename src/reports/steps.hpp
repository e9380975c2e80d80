#pragma once

#include <string>

#include "audit/cost.hpp"

namespace rayaudit {

/// What a step of accuracy costs and brings, in a sentence without its full stop.
std::string told(const Step& step);

/// A count per million as a whole number, or as `< 1` where it is one of more than a million.
std::string whole(double per_million);

/// Wrong answers per million, as people read it: `3,120`, or `0, < 732` where none of few is wrong.
std::string per_million(const Accuracy& accuracy);

}  // namespace rayaudit
