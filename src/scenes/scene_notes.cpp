#include "scenes/scene_notes.hpp"

namespace rayaudit {

void SceneNotes::skip(const Place& place, const std::string& what) {
  if (strictness_ == Strictness::strict) throw SceneError(place, what);
  const auto known = where_.find(what);
  if (known != where_.end()) {
    ++times_[known->second];
  } else if (skipped_.size() < most) {
    where_.emplace(what, skipped_.size());
    skipped_.push_back({place, what});
    times_.push_back(1);
  } else if (untold_++ == 0) {
    first_untold_ = place;
  }
}

std::vector<Skipped> SceneNotes::told() const {
  std::vector<Skipped> told = skipped_;
  for (std::size_t i = 0; i < told.size(); ++i)
    if (times_[i] > 1) told[i].what += " (" + std::to_string(times_[i]) + " times)";
  if (untold_ > 0)
    told.push_back({first_untold_, "from here on " + std::to_string(untold_) +
                                       " more things that are not supported are skipped"});
  return told;
}

}  // namespace rayaudit
