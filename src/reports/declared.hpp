#pragma once

#include <string>

#include "audit/audit.hpp"

namespace rayaudit {

/// What a convention declares, in the words of `--convention`: `tangent=hit,inside=miss`; empty
/// where that is nothing.
std::string declared(const Convention& convention);

/// What each subject of a run declares itself, one to a line; empty where none does.
std::string write_declared(const std::vector<Audit>& audits);

}  // namespace rayaudit
