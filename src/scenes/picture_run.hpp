#pragma once

#include <atomic>
#include <functional>

#include "audit/audit.hpp"
#include "scenes/scene_audit.hpp"

namespace rayaudit {

/// What to make of a scene.
struct PicturePlan {
  const Scene& scene;  ///< rounded to the subject's format
  const Subject& subject;
  Effects effects = {};
  Offset offset = {};
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one for each processor
  bool audited = true;
  bool exact = true;  ///< also the picture with every decision exact
  bool thorough = false;
  std::vector<Offset> offsets = {};  ///< to compare
};

/// Some whole rows of every picture there is.
struct Band {
  int first = 0, last = 0;  ///< rows from first to last - 1
  std::vector<Colour> pixels = {}, exact = {};
  std::vector<Sight> sights = {};  ///< where it is audited
};

struct Picture {
  SceneAccount account = {};
  bool whole = true;  ///< not stopped before its end
};

/// Traces and audits band by band. Finished bands are handed over from one thread at a time, in
/// their order from the top; so is progress, in pixels. Once `stop` is set, bands not begun are
/// left out. The same pictures and account for any number of threads.
Picture run_picture(const PicturePlan& plan, const std::function<void(const Band&)>& finished,
                    const std::function<void(Progress)>& tell = {},
                    const std::atomic<bool>* stop = nullptr);

}  // namespace rayaudit
