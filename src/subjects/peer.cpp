#include "subjects/peer.hpp"

#include <cmath>

#include "numbers/worn.hpp"
#include "routines/first_root.hpp"
#include "routines/textbook.hpp"

namespace rayaudit {
namespace {

/// The textbook without the conditions that give a shape its ends; of a cone that of the apex
/// counts, unless both nappes do.
template <bool both_nappes>
struct Endless {
  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    return Textbook::on_plane(ray, disk);
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    const std::optional<Roots<N>> roots = Textbook::on_lateral(ray, cylinder);
    if (!roots) return {};
    return first_root(ray, *roots);
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    const std::optional<Roots<N>> roots = Textbook::on_lateral(ray, cone);
    if (!roots) return {};
    if (both_nappes) return first_root(ray, *roots);
    const Vec3<N> w = cone.apex - cone.base;
    return first_root(ray, *roots, [&](const N& t) {
      const Vec3<N> p = ray.origin + t * ray.direction;
      return dot(p - cone.base, w) <= dot(w, w);
    });
  }
};

template <class Routine, class N>
Peer asked(const Case& question) {
  return std::visit(
      [&](const auto& shape) -> Peer {
        using Number = Worn<N>;
        const auto ray = in<Number>(in<N>(question.ray));
        const auto body = in<Number>(in<N>(shape));
        if constexpr (requires(const Routine& routine) { routine(ray, body); }) {
          Number::all_sure = true;
          const std::optional<Number> t = Routine()(ray, body);
          if (!t) return {Answer::miss(), Number::all_sure, 0};
          const double bound = static_cast<double>(t->bound);
          return {Answer::hit(real(t->value)), Number::all_sure && std::isfinite(bound), bound};
        } else {
          return {};
        }
      },
      question.shape);
}

template <class N>
Peer asked(const Case& question) {
  const bool has_ends = std::holds_alternative<Sphere<double>>(question.shape) ||
                        std::holds_alternative<CappedCylinder<double>>(question.shape) ||
                        std::holds_alternative<CappedCone<double>>(question.shape);
  if (has_ends || question.extent == Extent::bounded) return asked<Textbook, N>(question);
  return question.extent == Extent::both_nappes ? asked<Endless<true>, N>(question)
                                                : asked<Endless<false>, N>(question);
}

}  // namespace

Peer by_textbook(const Case& question, const Format& format) {
  if (format == float_format) return asked<float>(question);
  if (format == double_format) return asked<double>(question);
  return asked<long double>(question);
}

}  // namespace rayaudit
