#pragma once

#include "scenes/scene_audit.hpp"

namespace rayaudit {

/// Begins every ray of a wave that leaves a surface anew, by each offset, and adds to the account
/// what comes of it: see OffsetAccount and SafeOffset.
void audit_offsets(const SceneAuditing& auditing, const Wave& wave, SceneAccount& account);

}  // namespace rayaudit
