#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace haarlight {

/// How the vertices of a mesh move over time, in the mesh's own coordinates. The triangles stay.
class VertexMotion {
 public:
  virtual ~VertexMotion() = default;

  /// How many vertices positions() gives: those of the mesh it was made for, in its order.
  virtual std::size_t vertexCount() const = 0;

  /// Seconds after which nothing changes any more, >= 0 (before playback speeds it up, repeats it
  /// or lets it start later).
  virtual double duration() const = 0;

  /// Positions of all vertices at a time of the motion's own clock; before 0 as at 0, after
  /// duration() as at duration(). May read a file; keeps no more than a few frames in memory, and
  /// gives the same bits in whatever order times are asked for. Throws InputError with the file,
  /// the frame and the vertex where a position is NaN or beyond largestCoordinate
  /// (mesh/mesh_file.h), or when the file no longer holds what it held when it was opened.
  virtual std::vector<glm::vec3> positions(double seconds) = 0;
};

}  // namespace haarlight
