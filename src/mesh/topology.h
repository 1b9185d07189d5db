#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// How the triangles of a mesh hang together. Vertices at the same position count as one, so that
/// seams in a file's vertices do not open a surface.
struct MeshTopology {
  std::size_t vertices = 0;  ///< distinct positions that triangles use
  std::size_t edges = 0;
  std::size_t boundaryEdges = 0;       ///< edges of one triangle
  std::size_t nonManifoldEdges = 0;    ///< edges of three triangles or more
  std::size_t misorientedEdges = 0;    ///< edges whose two triangles face opposite sides
  std::size_t duplicateTriangles = 0;  ///< triangles with the same vertices as an earlier one
  std::size_t components = 0;          ///< parts that share no vertex
  bool closed = false;                 ///< every edge belongs to exactly two triangles
};

MeshTopology measureTopology(const TriangleMesh& mesh);

}  // namespace haarlight
