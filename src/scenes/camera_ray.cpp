#include "scenes/camera_ray.hpp"

#include "scenes/surface.hpp"

namespace rayaudit {

template <class N>
Ray<N> camera_ray(const Camera& camera, const Film& film, const std::array<double, 2>& place) {
  const N right = static_cast<N>((2 * place[0] / film.width - 1) * camera.half_width);
  const N up = static_cast<N>((1 - 2 * place[1] / film.height) * camera.half_height);
  const Vec3<N> eye = in<N>(camera.eye), forward = in<N>(camera.forward);
  const Vec3<N> aside = right * in<N>(camera.right) + up * in<N>(camera.up);
  if (camera.projection == Projection::orthographic) return {eye + aside, forward};
  return {eye, unit(forward + aside)};
}

template Ray<float> camera_ray(const Camera&, const Film&, const std::array<double, 2>&);
template Ray<double> camera_ray(const Camera&, const Film&, const std::array<double, 2>&);

}  // namespace rayaudit
