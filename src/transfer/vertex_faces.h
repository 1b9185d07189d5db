#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// Which triangles meet at each vertex. Vertices at the same position count as one, so that the
/// faces across a crease, whose vertices have normals of their own, are found, too.
class VertexFaces {
 public:
  /// Coordinates must be finite.
  explicit VertexFaces(const TriangleMesh& mesh);

  /// The triangles with a corner at the vertex's position, ascending; none for a vertex that no
  /// triangle uses.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const;

 private:
  static constexpr std::uint32_t unused = ~0u;

  std::vector<std::uint32_t> positionOf_;  ///< by vertex: the number of its position
  std::vector<std::uint32_t> begin_;       ///< by position, and the end
  std::vector<std::uint32_t> triangles_;
};

}  // namespace haarlight
