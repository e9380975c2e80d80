#include "scenes/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "scenes/read_scene.hpp"

namespace rayaudit {
namespace {

constexpr double most_gap = 0x1p-16;

double in_format(double x, const Format& format) {
  return format.precision <= float_format.precision ? static_cast<double>(static_cast<float>(x))
                                                    : x;
}

double largest(const Vec3<double>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Rounds the parts of a shape; how much that moved them at most.
class Rounding {
 public:
  explicit Rounding(const Format& format) : format_(format) {}

  void operator()(Vec3<double>& v) {
    const Vec3<double> before = v;
    v = {in_format(v.x, format_), in_format(v.y, format_), in_format(v.z, format_)};
    moved(largest(v - before), largest(before));
  }
  void operator()(double& x) {
    const double before = x;
    x = in_format(x, format_);
    moved(std::abs(x - before), std::abs(before));
  }
  double most_moved() const { return most_; }

 private:
  void moved(double by, double of) {
    if (by > 0) most_ = std::max(most_, by / of);
  }

  const Format& format_;
  double most_ = 0;
};

/// Throws SceneError where rounding leaves no shape.
void require_shape(const Primitive& primitive, const Format& format) {
  std::visit(
      [&](const auto& shape) {
        const auto refuse = [&](std::string_view why) {
          throw SceneError(primitive.place,
                           fmt::format("a {} that {} in {}", shape.name, why, format.name));
        };
        if (!(shape.radius > 0)) refuse("has the radius 0");
        std::apply(
            [&](const auto&... part) {
              const auto check = [&](const auto& p) {
                if constexpr (requires { p.x; }) {
                  if (!std::isfinite(largest(p))) refuse("overflows");
                } else if (!std::isfinite(p)) {
                  refuse("overflows");
                }
              };
              (check(part), ...);
            },
            shape.parts());
        if constexpr (requires { shape.base; })
          if (std::get<0>(shape.parts()) == std::get<1>(shape.parts()))
            refuse("has one point for both its ends");
      },
      primitive.shape);
}

/// An end of a cylinder, or the base of a cone.
struct End {
  Vec3<double> centre, axis;
  double radius;
};

std::vector<End> ends(const Shape& shape) {
  if (const auto* cone = std::get_if<Cone<double>>(&shape))
    return {{cone->base, cone->apex - cone->base, cone->radius}};
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape)) {
    const Vec3<double> axis = cylinder->top - cylinder->base;
    return {{cylinder->base, axis, cylinder->radius}, {cylinder->top, axis, cylinder->radius}};
  }
  return {};
}

Vec3<double> direction(const Vec3<double>& v) {
  const Vec3<double> scaled = v / largest(v);
  return scaled / std::sqrt(dot(scaled, scaled));
}

bool closes(const Disk<double>& disk, const End& end) {
  const double gap = most_gap * end.radius;
  return std::abs(disk.radius - end.radius) <= gap && largest(disk.centre - end.centre) <= gap &&
         largest(cross(direction(disk.normal), direction(end.axis))) <= most_gap;
}

/// Disks by about where their centres are and how large they are.
class DiskPlaces {
 public:
  void add(const Disk<double>& disk, std::size_t index) {
    std::vector<std::size_t>& cell = cells_[key(disk.centre, std::ilogb(disk.radius))];
    // More than that in one place lie on each other, and one closes what the others do.
    if (cell.size() < 16) cell.push_back(index);
  }

  /// Calls visit(index) for every disk that an end may have.
  template <class Visit>
  void near(const End& end, const Visit& visit) const {
    const double gap = most_gap * end.radius;
    const int least = std::ilogb(end.radius - gap), most = std::ilogb(end.radius + gap);
    for (int size = least; size <= most; ++size) {
      const Cell low = cell_of(end.centre - Vec3<double>{gap, gap, gap}, size);
      const Cell high = cell_of(end.centre + Vec3<double>{gap, gap, gap}, size);
      // Beyond 2^52 cells from the origin, neighbours are equal or no seam.
      for (int corner = 0; corner < 8; ++corner) {
        const auto pick = [&](int axis) { return ((corner >> axis & 1) != 0 ? high : low)[axis]; };
        bool is_new = true;
        for (int axis = 0; axis < 3; ++axis)
          is_new = is_new && ((corner >> axis & 1) == 0 || low[axis] != high[axis]);
        if (!is_new) continue;
        const auto cell = cells_.find({pick(0), pick(1), pick(2), static_cast<double>(size)});
        if (cell == cells_.end()) continue;
        for (const std::size_t index : cell->second) visit(index);
      }
    }
  }

 private:
  using Cell = std::array<double, 3>;
  using Key = std::array<double, 4>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::size_t hash = 0;
      for (const double part : key) hash = (hash ^ std::hash<double>{}(part)) * 0x9e3779b97f4a7c15u;
      return hash ^ hash >> 32;
    }
  };

  /// A cell is eight gaps or more wide: what is near an end lies in at most two of each axis.
  static Cell cell_of(const Vec3<double>& point, int size) {
    const auto along = [&](double x) { return std::floor(std::ldexp(x, 13 - size)); };
    return {along(point.x), along(point.y), along(point.z)};
  }
  static Key key(const Vec3<double>& centre, int size) {
    const Cell cell = cell_of(centre, size);
    return {cell[0], cell[1], cell[2], static_cast<double>(size)};
  }

  std::unordered_map<Key, std::vector<std::size_t>, Hash> cells_;
};

}  // namespace

Rounded rounded(Scene scene, const Format& format) {
  Rounded result = {std::move(scene)};
  for (std::size_t i = 0; i < result.scene.primitives.size(); ++i) {
    Primitive& primitive = result.scene.primitives[i];
    Rounding round(format);
    std::visit(
        [&](auto& shape) { std::apply([&](auto&... part) { (round(part), ...); }, shape.parts()); },
        primitive.shape);
    require_shape(primitive, format);
    if (round.most_moved() > result.most_moved) {
      result.most_moved = round.most_moved();
      result.primitive = i;
    }
  }
  return result;
}

std::vector<Seam> seams(const std::vector<Primitive>& primitives) {
  DiskPlaces places;
  for (std::size_t i = 0; i < primitives.size(); ++i)
    if (const auto* disk = std::get_if<Disk<double>>(&primitives[i].shape)) places.add(*disk, i);
  std::vector<Seam> found;
  for (std::size_t wall = 0; wall < primitives.size(); ++wall)
    for (const End& end : ends(primitives[wall].shape))
      places.near(end, [&](std::size_t disk) {
        if (closes(std::get<Disk<double>>(primitives[disk].shape), end))
          found.push_back({disk, wall});
      });
  return found;
}

}  // namespace rayaudit
