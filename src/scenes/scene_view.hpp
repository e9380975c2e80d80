#pragma once

#include <array>
#include <optional>

#include "scenes/scene_parameters.hpp"
#include "scenes/scene_transform.hpp"

namespace rayaudit {

/// What a Camera directive says; what it shows depends on the film too, which may come later.
struct SceneView {
  Projection projection = Projection::perspective;
  Affine to_world = {};
  double degrees = 90;  ///< of the shorter axis
  std::optional<double> aspect = {};
  std::optional<std::array<double, 4>> window = {};  ///< least x, most x, least y, most y
  Place place = {};
};

SceneView read_view(const Token& directive, const Token& name, Parameters& parameters,
                    const Affine& to_world);

/// Throws SceneError where no camera of ours shows that.
Camera camera(const SceneView& view, const Film& film);

Film read_film(const Token& name, Parameters& parameters);

}  // namespace rayaudit
