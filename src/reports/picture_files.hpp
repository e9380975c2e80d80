#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "reports/png_file.hpp"
#include "scenes/picture_run.hpp"

namespace rayaudit {

/// The pictures that a scene gives, each a file: NAME.png, NAME-exact.png, NAME-difference.png,
/// NAME-verdicts.png; those that the plan has.
class PictureFiles {
 public:
  /// Throws Error where one cannot be written.
  PictureFiles(const std::filesystem::path& folder, const std::string& name,
               const PicturePlan& plan);

  /// In order from the top. Throws Error.
  void write(const Band& band);
  /// Ends them all; rows that were not written are black. Throws Error.
  void close();

  /// Of the picture, the exact one, their difference, the map of verdicts, from 0; empty where the
  /// plan has none.
  const std::filesystem::path& path(std::size_t i) const { return paths_[i]; }

 private:
  std::vector<std::filesystem::path> paths_;
  std::vector<PngFile> files_;
};

/// Of a linear colour what a screen shows: clipped, with sRGB's curve (IEC 61966-2-1).
PngFile::Pixel shown(const Colour& colour);
/// The difference of two, as black where there is none: brighter the larger, visible from 1/255 on.
PngFile::Pixel shown_difference(const Colour& a, const Colour& b);
/// The colour of the worst verdict where that is wrong, else of a surface that was met again; else
/// of a verdict that is not wrong, of `right` the picture itself, pale.
PngFile::Pixel shown(const Sight& sight, const Colour& colour);
inline constexpr PngFile::Pixel met_again_colour = {86, 180, 233};

/// What the colours of a map of verdicts mean, in the order of the verdicts: of `right` one of many
/// greys.
struct LegendEntry {
  Verdict verdict;
  PngFile::Pixel colour;
};
std::span<const LegendEntry> legend();

}  // namespace rayaudit
