#pragma once

#include <optional>

#include "scenes/scene_parameters.hpp"
#include "scenes/scene_transform.hpp"

/// What directives of a scene's world say, in the space where they say it.
namespace rayaudit {

/// A shape about the z axis; none where it is one that pbrt has and rayaudit has not, with a note.
/// Throws SceneError for what is partial, flat or unknown.
std::optional<Shape> read_shape(const Token& name, Parameters& parameters);

/// Throws SceneError where pbrt has no such material; what shines in other ways than ours is taken
/// as matte, with a note.
Material read_material(const Token& directive, const Token& name, Parameters& parameters);

/// A light that is no shape, in the world; none where rayaudit has no such, with a note.
std::optional<Light> read_light(const Token& name, Parameters& parameters, const Affine& transform);

/// What a shape that is a light emits.
std::optional<Colour> read_area_light(const Token& name, Parameters& parameters);

}  // namespace rayaudit
