#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "spheres/enclosing_ball.h"
#include "spheres/point_blocks.h"
#include "spheres/solid_grid.h"

namespace haarlight {

/// Balls that together cover given points, made to bulge as little as possible out of a solid.
///
/// The cost of a ball is its volume outside the solid. Every change keeps all points covered and,
/// but for addPoints, lowers the sum of the costs. The result does not depend on the number of
/// threads.
class SphereCover {
 public:
  /// Starts with one ball per group; `groups` holds one number below `groupCount` for each point.
  SphereCover(std::span<const glm::vec3> points, std::span<const std::uint32_t> groups,
              std::size_t groupCount, const SolidGrid& solid);

  /// Goes through the balls once: each moves to where it covers the points that no other ball
  /// covers at the least cost. Balls that nothing needs disappear.
  void refit();

  /// Splits the balls where that gains most until there are `count`.
  void splitUpTo(std::size_t count);

  /// Goes through the balls once: where merging two neighbours loses less than splitting another
  /// ball gains, does both; where merging gains, it needs no split.
  void exchange();

  /// Also covers these points: the balls that are nearest in terms of volume grow.
  void addPoints(std::span<const glm::vec3> points);

  double cost() const;
  const std::vector<Ball>& balls() const { return balls_; }

 private:
  using PointList = std::vector<glm::vec3>;
  struct Fit {
    Ball ball;
    double cost = 0;
  };
  /// One ball made two.
  struct Split {
    std::size_t ball = 0;
    Fit parts[2];
    double gain = 0;
  };
  /// Two balls made one.
  struct Merge {
    std::size_t first = 0, second = 0;
    Fit whole;
    double loss = 0;
  };

  Fit fit(const PointList& points, const glm::dvec3& start) const;
  Fit descend(const PointList& points, const glm::dvec3& start) const;
  Fit fitAround(const PointList& points, const glm::dvec3& center) const;
  /// The points that no other ball covers.
  PointList pointsOnlyIn(std::size_t ball) const;
  PointList pointsOnlyIn(std::size_t first, std::size_t second) const;
  std::size_t cheapestToGrow(const glm::vec3& point) const;
  Split trySplit(std::size_t ball) const;
  Merge tryMerge(std::size_t ball) const;
  void apply(const Split& split);
  void replace(std::size_t ball, const Fit& by);
  void add(const Fit& fit);
  void countCovers(const Ball& ball, int change);
  void removeEmptyBalls();

  PointBlocks points_;
  const SolidGrid& solid_;
  std::vector<Ball> balls_;  ///< a radius below zero marks a ball without a task
  std::vector<double> costs_;
  std::vector<std::uint16_t> coverCounts_;  ///< number of balls around each point
};

}  // namespace haarlight
