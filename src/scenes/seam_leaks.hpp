#pragma once

#include <optional>
#include <vector>

#include "audit/judge.hpp"
#include "audit/margins.hpp"
#include "scenes/scene_audit.hpp"

namespace rayaudit {

/// What a wave is told of the surfaces that leave no gap between them, to find the rays that pass.
class SeamLeaks {
 public:
  explicit SeamLeaks(const Scene& scene);

  /// A question of the wave, at its place in the list of its shape, and what became of it.
  void add(const Wave& wave, std::size_t shape, std::size_t place, const oracle::Truth& truth,
           const Judgement& judgement);
  /// Adds the rays that pass, once all questions of the wave were added.
  void count(const Wave& wave, Margins& margins, Trouble& leaks);

 private:
  /// A question to one of those surfaces.
  struct Asked {
    std::size_t primitive;
    std::uint32_t ray;
    std::size_t shape, place;
    oracle::Truth truth;
    bool is_open;        ///< its answer is not simply right
    bool is_first_told;  ///< its answer is the first crossing
    bool says_yes;       ///< and not where
    std::optional<double> told;
  };

  const Asked* find(std::size_t primitive, std::uint32_t ray) const;
  void look_at(const Wave& wave, const Seam& seam, std::uint32_t ray, Margins& margins,
               Trouble& leaks) const;
  bool leaks_through(const Wave& wave, const Seam& seam, const Asked& first,
                     const Asked* other) const;

  const Scene& scene_;
  std::vector<bool> is_in_seam_;  ///< by primitive; empty where there is no seam
  std::vector<Asked> asked_;
};

}  // namespace rayaudit
