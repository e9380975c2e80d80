#pragma once

#include <optional>
#include <string>

namespace rayaudit::oracle {

/// Holds hand-proved cases against both stages of the oracle, and looks at this thread's
/// arithmetic. Nothing where all is well, else one sentence that tells what was found.
std::optional<std::string> self_check();

}  // namespace rayaudit::oracle
