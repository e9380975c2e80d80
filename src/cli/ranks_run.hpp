#pragma once

#include <string>

#include "cli/ranks.hpp"
#include "reports/shard.hpp"

namespace rayaudit {

/// What all cases of a plan tell, each rank having run its shard: on the first rank that of all,
/// not concluded; on the others nothing. Throws Refusal on all where they do not run the same.
ShardSum gathered_by(Ranks& ranks, const Plan& plan, const std::string& command);

}  // namespace rayaudit
