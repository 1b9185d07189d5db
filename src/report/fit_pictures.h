#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "mesh/triangle_mesh.h"
#include "visibility/sphere.h"

namespace haarlight {

/// Mesh and spheres from one side, without perspective. The images are linear, ready for encodePng.
struct FitView {
  std::string name;  ///< "front", "side" or "top"
  Image mesh;
  Image spheres;      ///< each in a tint of its own
  Image silhouettes;  ///< the two laid over each other, in the colours of silhouetteColor
  double over = 0;    ///< area that only the spheres take up, as a part of the mesh's
  double under = 0;   ///< area that only the mesh takes up, as a part of it
};

struct FitPictures {
  /// Front (the viewer at +z, y up), side (at +x, y up) and top (at +y, z down), at one scale.
  std::vector<FitView> views;
  double pixelsPerUnit = 0;  ///< pixels per unit of the mesh's coordinates
};

/// What of mesh and spheres a place of a picture shows.
enum class Silhouette { neither, both, spheresOnly, meshOnly };

/// Its colour in FitView::silhouettes, as 8-bit sRGB.
glm::ivec3 silhouetteColor(Silhouette silhouette);

/// Draws mesh and spheres (in the mesh's coordinates) in square pictures of `size` pixels a side,
/// with four samples per pixel.
FitPictures drawFit(const TriangleMesh& mesh, std::span<const Sphere> spheres, int size = 360);

}  // namespace haarlight
