#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/ray_scene.h"
#include "visibility/sphere.h"

namespace haarlight {

/// A view without perspective: the unit vectors to the right and up in the picture, and the middle
/// and half the side of the square that it shows.
struct OrthographicView {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0};
  glm::dvec3 center{0};
  double halfExtent = 1;

  /// Unit vector towards the viewer.
  glm::dvec3 toViewer() const;
};

/// One point of a square grid in a view, at the middle of its cell.
struct LayerSample {
  bool hit = false;
  glm::vec3 color{0};  ///< linear; where something is hit
};

/// Samples row by row, `side` in each, from the top left.
using Layer = std::vector<LayerSample>;

/// What a view shows of a scene of triangles, in light grey whichever side they turn to the viewer.
Layer meshLayer(const RayScene& scene, const OrthographicView& view, int side);

/// What a view shows of spheres, each in a tint of its own.
Layer sphereLayer(std::span<const Sphere> spheres, const OrthographicView& view, int side);

}  // namespace haarlight
