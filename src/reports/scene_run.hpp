#pragma once

#include <array>
#include <optional>
#include <string>

#include "audit/environment.hpp"
#include "reports/report.hpp"
#include "scenes/picture_run.hpp"

namespace rayaudit {

/// A picture that was made, and what its audit told: all that its reports are written from.
struct SceneRun {
  std::string version;
  const PicturePlan& plan;
  const Picture& picture;
  std::array<Calling, effect_count> callings;
  /// By how much the world's shapes were rounded to the subject's format, and which most.
  double most_moved = 0;
  std::string moved_shape = {};  ///< where it stands in the file
  Environment environment;
  std::string command = {};
  /// The files of the pictures that were written, for a page to show; empty ones were not.
  std::string picture_file = {}, exact_file = {}, difference_file = {}, verdict_file = {};
};

std::string write_scene_table(const SceneRun& run, const Look& look);
std::string write_scene_json(const SceneRun& run, const Look& look);
std::string write_scene_html(const SceneRun& run, const Look& look);

std::span<const ReportOf<SceneRun>> scene_reports();

}  // namespace rayaudit
