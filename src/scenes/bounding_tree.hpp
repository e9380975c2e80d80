#pragma once

#include <cstdint>
#include <vector>

#include "geometry/case.hpp"

namespace rayaudit {

/// A box that holds a shape, rounded outward; infinite where numbers are.
struct Box {
  Vec3<double> least, most;
};
Box box_of(const Shape& shape);

/// Boxes around boxes around shapes. Culling is conservative: no shape that the exact ray meets is
/// left out, for any doubles whatever (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
class BoundingTree {
 public:
  explicit BoundingTree(const std::vector<Shape>& shapes);

  /// Calls visit(i) for every shape whose box the ray may meet within its range, each once, in an
  /// order that depends on the ray and the shapes alone.
  template <class Visit>
  void each_candidate(const Ray<double>& ray, const Visit& visit) const;

  /// A box, and the two boxes or the few shapes in it.
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< of shapes(), or the nearer child's place among nodes
    std::uint32_t count = 0;  ///< of shapes; 0: its children are at first and first + 1
  };

 private:
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> shapes_;
};

}  // namespace rayaudit
