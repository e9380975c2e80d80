#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/case.hpp"

namespace rayaudit {

/// A box that holds a shape, rounded outward; infinite where numbers are.
struct Box {
  Vec3<double> least, most;
};
Box box_of(const Shape& shape);

/// May a ray meet a box within its range? Never no where it does, exactly; for any doubles
/// whatever. Distances to the planes of a box are off by three roundings, which a slack of 8 in
/// their last place covers (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013); an axis along which
/// numbers are so large or small that more could be lost (and NaN) keeps every box.
class BoxTest {
 public:
  explicit BoxTest(const Ray<double>& ray)
      : axes_{Axis(ray.origin.x, ray.direction.x), Axis(ray.origin.y, ray.direction.y),
              Axis(ray.origin.z, ray.direction.z)},
        near_(std::isnan(ray.t_min) ? -infinity : ray.t_min),
        far_(std::isnan(ray.t_max) ? infinity : ray.t_max) {}

  bool may_meet(const Box& box) const {
    double near = near_, far = far_;
    return axes_[0].clips(box.least.x, box.most.x, near, far) &&
           axes_[1].clips(box.least.y, box.most.y, near, far) &&
           axes_[2].clips(box.least.z, box.most.z, near, far) &&
           !(near - std::fabs(near) * slack - least > far + std::fabs(far) * slack + least);
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double slack = 0x1p-50, least = 0x1p-1000, largest = 0x1p1000;

  struct Axis {
    enum class Kind : unsigned char { ascending, descending, still, free };

    Kind kind = Kind::free;
    double origin, inverse;

    Axis(double o, double d) : origin(o), inverse(1 / d) {
      const double size = std::fabs(d);
      if (!(std::fabs(o) <= largest)) return;
      if (size == 0) kind = Kind::still;
      if (size >= 0x1p-500 && size <= 0x1p500) kind = d > 0 ? Kind::ascending : Kind::descending;
    }

    /// Narrows the range to where the ray is between two planes; no where it stays outside.
    bool clips(double low, double high, double& near, double& far) const {
      switch (kind) {
        case Kind::free:
          return true;
        case Kind::still:
          return low <= origin && origin <= high;
        case Kind::descending:
          std::swap(low, high);
          break;
        case Kind::ascending:
          break;
      }
      near = std::max(near, (low - origin) * inverse);
      far = std::min(far, (high - origin) * inverse);
      return true;
    }
  };

  std::array<Axis, 3> axes_;
  double near_, far_;
};

/// Boxes around boxes around shapes. Culling is conservative: no shape that the exact ray meets is
/// left out, for any doubles whatever.
///
/// No library does this here: Embree may not be there, and does not promise for shapes of a user's
/// own that its float boxes and distances are rounded outward; Boost's R-tree knows segments and
/// boxes, but no ray, and decides in rounded arithmetic.
class BoundingTree {
 public:
  explicit BoundingTree(const std::vector<Shape>& shapes);

  /// Calls visit(i) for every shape whose box the ray may meet within its range, each once, in an
  /// order that depends on the shapes alone.
  template <class Visit>
  void each_candidate(const Ray<double>& ray, const Visit& visit) const {
    if (nodes_.empty()) return;
    const BoxTest test(ray);
    std::array<std::uint32_t, most_depth> waiting;
    std::size_t count = 0;
    for (std::uint32_t place = 0;;) {
      const Node& node = nodes_[place];
      if (test.may_meet(node.box)) {
        if (node.is_leaf) {
          visit(node.first);
        } else {
          waiting[count++] = node.first + 1;
          place = node.first;
          continue;
        }
      }
      if (count == 0) return;
      place = waiting[--count];
    }
  }

  /// A box, and the shape or the two boxes in it.
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< the shape, or the place of the first child; the other is next
    bool is_leaf = false;
  };

 private:
  /// Every split halves: more than there are levels with 2^32 shapes.
  static constexpr std::size_t most_depth = 64;

  std::vector<Node> nodes_;
};

}  // namespace rayaudit
