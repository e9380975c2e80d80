#pragma once

#include <cstdint>
#include <optional>

#include "audit/audit.hpp"

namespace rayaudit {

/// A number that tells the cases of an audit from others: two audits of as many cases that have it
/// in common were asked the same. Nothing where the family draws none.
std::optional<std::uint64_t> drawn(const Plan& plan, const Audit& audit);

}  // namespace rayaudit
