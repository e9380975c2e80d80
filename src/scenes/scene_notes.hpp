#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "scenes/read_scene.hpp"

namespace rayaudit {

/// What is skipped in a scene file: each sentence once, where it first applies, with how often.
class SceneNotes {
 public:
  explicit SceneNotes(Strictness strictness) : strictness_(strictness) {}

  /// Throws SceneError where the reader is strict.
  void skip(const Place& place, const std::string& what);
  std::vector<Skipped> told() const;

 private:
  /// Sentences beyond these are only counted.
  static constexpr std::size_t most = 1000;

  Strictness strictness_;
  std::vector<Skipped> skipped_;
  std::vector<std::size_t> times_;
  std::unordered_map<std::string, std::size_t> where_;
  std::size_t untold_ = 0;
  Place first_untold_ = {};
};

}  // namespace rayaudit
