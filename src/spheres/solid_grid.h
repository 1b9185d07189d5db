#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "spheres/enclosing_ball.h"

namespace haarlight {

/// The solid that a mesh encloses, as inside/outside values in the cells of a grid, made to answer
/// quickly how much of a ball lies outside.
///
/// Rays along the rows of the grid, in the three directions of its axes and both ways, vote on each
/// cell, so that a mesh with some holes still has an inside. An open surface without an inside
/// gives an empty solid.
class SolidGrid {
 public:
  /// `cells`: number of cells along the longest side of the mesh's bounding box.
  SolidGrid(const TriangleMesh& mesh, int cells);

  /// Volume of the ball outside the solid. Each row of cells adds the part of its chord that lies
  /// outside, to fractions of a cell.
  double outsideVolume(const Ball& ball) const;

  /// Volume of all cells inside.
  double volume() const;

  /// Up to `count` points spread evenly over the cells inside.
  std::vector<glm::vec3> insidePoints(std::size_t count) const;

 private:
  void vote(const class RayScene& scene, int axis, std::vector<std::uint8_t>& votes) const;
  void sumRows(const std::vector<std::uint8_t>& votes);
  std::size_t cellIndex(const glm::ivec3& cell) const;
  glm::dvec3 cellCenter(const glm::ivec3& cell) const;
  double insideLength(int y, int z, double begin, double end) const;

  glm::dvec3 lower_;
  double cellSize_;
  glm::ivec3 size_;
  /// For every row along x, the number of inside cells before each cell boundary.
  std::vector<std::uint16_t> insideBefore_;
};

}  // namespace haarlight
