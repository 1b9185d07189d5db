#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/polygon_soup.h"
#include "mesh/triangle_mesh.h"

namespace haarlight {

/// A triangle mesh made from polygons, and what was noticed on the way.
struct SoupMesh {
  TriangleMesh mesh;
  std::vector<std::uint32_t> sourceVertices;  ///< the polygon soup's vertex of each mesh vertex
  std::size_t degenerateTriangles = 0;        ///< left out, as they have no area
  std::size_t badNormals = 0;                 ///< vertices whose given normal cannot be used
  std::size_t unusedVertices = 0;
};

/// Cuts the polygons into triangles and gives every vertex one unit normal: the one of its corners,
/// where the soup has normals, or a computed one. A vertex whose corners have different normals is
/// repeated, at the end of the list.
SoupMesh meshOfSoup(const PolygonSoup& soup);

}  // namespace haarlight
