#include "scenes/bounding_tree.hpp"

#include <numeric>
#include <span>

namespace rayaudit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double size_of(const Vec3<double>& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// From c - extent to c + extent, and further: one number outward for the rounding, and without an
/// end where that is beyond what BoxTest reckons with.
Box around(const Vec3<double>& c, const Vec3<double>& extent) {
  const auto below = [](double x, double e) {
    const double low = std::nextafter(x - e, -infinity);
    return low >= -0x1p1000 ? std::min(low, 0x1p1000) : -infinity;
  };
  return {{below(c.x, extent.x), below(c.y, extent.y), below(c.z, extent.z)},
          {-below(-c.x, extent.x), -below(-c.y, extent.y), -below(-c.z, extent.z)}};
}

/// At least how far a disk goes to either side along each axis: r sqrt(1 - n_i^2 / |n|^2), as a
/// sum of squares, that cancels nothing; ten roundings are far from 2^-48, and what underflows in a
/// square from 2^-480.
Vec3<double> disk_extent(const Vec3<double>& normal, double radius) {
  const double r = std::fabs(radius), size = size_of(normal);
  if (!(size > 0 && size <= std::numeric_limits<double>::max())) return {r, r, r};
  const Vec3<double> n = normal / size;
  const double x = n.x * n.x, y = n.y * n.y, z = n.z * n.z, all = x + y + z;
  const auto extent = [&](double across) {
    const double most = r * (std::sqrt(across / all) * (1 + 0x1p-48) + 0x1p-480);
    return std::min(r, std::nextafter(most, infinity));
  };
  return {extent(y + z), extent(x + z), extent(x + y)};
}

Box both(const Box& a, const Box& b) {
  return {
      {std::min(a.least.x, b.least.x), std::min(a.least.y, b.least.y),
       std::min(a.least.z, b.least.z)},
      {std::max(a.most.x, b.most.x), std::max(a.most.y, b.most.y), std::max(a.most.z, b.most.z)}};
}

Box box(const Disk<double>& disk) {
  return around(disk.centre, disk_extent(disk.normal, disk.radius));
}
Box box(const Sphere<double>& sphere) {
  const double r = std::fabs(sphere.radius);
  return around(sphere.centre, {r, r, r});
}
/// Cylinder and cone, which caps make no larger.
template <class S>
Box box(const S& shape) {
  const auto& [base, end, radius] = shape;
  const Vec3<double> extent = disk_extent(end - base, radius);
  const bool is_pointed = S::labels[1] == "apex";
  return both(around(base, extent), around(end, is_pointed ? Vec3<double>{0, 0, 0} : extent));
}

constexpr std::array axes = {&Vec3<double>::x, &Vec3<double>::y, &Vec3<double>::z};

/// Where a box lies along an axis, for the sake of order alone.
double middle(const Box& box, double Vec3<double>::*axis) {
  const double found = box.least.*axis / 2 + box.most.*axis / 2;
  return std::isfinite(found) ? found : 0;
}

double Vec3<double>::*widest(const std::vector<Box>& boxes, std::span<const std::uint32_t> part) {
  double Vec3<double>::*found = axes[0];
  double most = -1;
  for (double Vec3<double>::*const axis : axes) {
    double low = infinity, high = -infinity;
    for (const std::uint32_t i : part) {
      low = std::min(low, middle(boxes[i], axis));
      high = std::max(high, middle(boxes[i], axis));
    }
    if (high - low > most) most = high - low, found = axis;
  }
  return found;
}

/// Halves the shapes at the median along the axis on which they are widest; the same everywhere,
/// since no two are alike in order.
std::size_t halve(const std::vector<Box>& boxes, std::span<std::uint32_t> part) {
  double Vec3<double>::*const axis = widest(boxes, part);
  std::sort(part.begin(), part.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double at = middle(boxes[a], axis), other = middle(boxes[b], axis);
    return at != other ? at < other : a < b;
  });
  return part.size() / 2;
}

}  // namespace

Box box_of(const Shape& shape) {
  return std::visit([](const auto& any) { return box(any); }, shape);
}

BoundingTree::BoundingTree(const std::vector<Shape>& shapes) {
  if (shapes.empty()) return;
  std::vector<Box> boxes(shapes.size());
  std::transform(shapes.begin(), shapes.end(), boxes.begin(), box_of);
  std::vector<std::uint32_t> order(shapes.size());
  std::iota(order.begin(), order.end(), 0U);

  nodes_.reserve(2 * shapes.size());
  nodes_.emplace_back();
  struct Pending {
    std::uint32_t node;
    std::span<std::uint32_t> shapes;
  };
  std::vector<Pending> parts = {{0, order}};
  while (!parts.empty()) {
    const Pending part = parts.back();
    parts.pop_back();
    Node& node = nodes_[part.node];
    node.box = boxes[part.shapes.front()];
    for (const std::uint32_t i : part.shapes) node.box = both(node.box, boxes[i]);
    node.is_leaf = part.shapes.size() == 1;
    node.first = node.is_leaf ? part.shapes.front() : static_cast<std::uint32_t>(nodes_.size());
    if (node.is_leaf) continue;
    const std::size_t half = halve(boxes, part.shapes);
    const std::uint32_t first = node.first;
    nodes_.resize(nodes_.size() + 2);
    parts.push_back({first, part.shapes.first(half)});
    parts.push_back({first + 1, part.shapes.subspan(half)});
  }
}

}  // namespace rayaudit
