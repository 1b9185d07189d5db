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
/// cell; where they do not agree, as behind holes, the winding number decides. An open surface
/// without an inside gives an empty solid. Above the grid stands a pyramid: a cell of level k + 1
/// holds the mean of eight of level k, so that large balls cost no more than small ones.
class SolidGrid {
 public:
  /// `cells`: number of cells along the longest side of the mesh's bounding box.
  SolidGrid(const TriangleMesh& mesh, int cells);

  /// The level at which a ball of the radius is about `cells` cells wide to each side, or level 0
  /// where even that is too coarse.
  int levelFor(double radius, double cells) const;

  /// Volume of the ball outside the solid. Each row of cells of the level adds the part of its
  /// chord that lies outside, to fractions of a cell. Continuous in centre and radius but for rows
  /// that come and go at the ball's rim.
  double outsideVolume(const Ball& ball, int level = 0) const;

  /// Volume of all cells inside.
  double volume() const;

  /// Up to `count` points spread evenly over the cells inside.
  std::vector<glm::vec3> insidePoints(std::size_t count) const;

 private:
  struct Level {
    double cellSize;
    glm::ivec3 size;
    /// For every row along x, the summed inside parts before each cell boundary; the last twice, so
    /// that interpolation needs no special case at the end.
    std::vector<float> insideBefore;

    float insideLength(int y, int z, float begin, float end) const;
  };

  void vote(const class RayScene& scene, int axis, std::vector<std::uint8_t>& votes) const;
  void settleVotes(const TriangleMesh& mesh, std::vector<std::uint8_t>& votes) const;
  void addLevel(const std::vector<float>& inside, const glm::ivec3& size, double cellSize);
  std::size_t cellIndex(const glm::ivec3& cell) const;
  glm::dvec3 cellCenter(const glm::ivec3& cell) const;

  glm::dvec3 lower_;
  double cellSize_;
  glm::ivec3 size_;
  std::vector<Level> levels_;
};

}  // namespace haarlight
