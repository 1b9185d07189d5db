#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "spheres/ball_fit.h"
#include "spheres/enclosing_ball.h"
#include "spheres/point_blocks.h"
#include "spheres/solid_grid.h"

namespace haarlight {

/// Balls that together cover given points, made to bulge as little as possible out of a solid.
///
/// The cost of a ball is its volume outside the solid. Points that several balls cover tie none of
/// them down, so a ball has to hold only the points that no other does. A cover is a value: a copy
/// can be changed and thrown away.
class SphereCover {
 public:
  /// One ball per group; `groups` holds one number below `groupCount` for each point.
  SphereCover(std::shared_ptr<const PointBlocks> points, std::span<const std::uint32_t> groups,
              std::size_t groupCount, const SolidGrid& solid);

  /// From now on, balls are placed more exactly, which takes twice as long.
  void polishFits() { polished_ = true; }
  bool polishesFits() const { return polished_; }

  /// Goes through the balls once: each moves to where it covers its points at the least cost.
  void refit();

  /// Splits the balls where that gains most until there are `count`; fewer where none gains.
  void splitUpTo(std::size_t count);

  /// Takes the ball `from` away, divides the ball `divided` in two, and lets the balls around both
  /// places settle.
  void teleport(std::size_t from, std::size_t divided);

  /// Also covers these points: the balls that are nearest in terms of volume grow.
  void addPoints(std::span<const glm::vec3> points);

  double cost() const;
  double cost(std::size_t ball) const { return costs_[ball]; }
  /// Part of the points in the ball that no other ball covers.
  double exclusiveShare(std::size_t ball) const;
  /// A radius below zero marks a ball without a task, after teleport.
  const std::vector<Ball>& balls() const { return balls_; }
  const std::shared_ptr<const PointBlocks>& points() const { return points_; }

 private:
  using PointList = std::vector<glm::vec3>;
  /// One ball made two.
  struct Split {
    std::size_t ball = 0;
    BallFit parts[2];
    double gain = 0;
  };

  BallFit fit(const PointList& points, const glm::dvec3& start) const {
    return fitAround(points, start, *solid_, polished_);
  }
  PointList pointsOnlyIn(std::size_t ball, std::uint64_t* checksum = nullptr) const;
  std::size_t cheapestToGrow(std::span<const std::size_t> among, const glm::vec3& point) const;
  std::vector<std::size_t> around(const std::vector<bool>& changed) const;
  void remove(std::size_t ball, std::vector<bool>& changed);
  Split trySplit(std::size_t ball) const;
  bool refit(std::size_t ball);
  void settle(std::vector<bool>& changed);
  void replace(std::size_t ball, const BallFit& by);
  void add(const BallFit& fit);
  void countCovers(const Ball& ball, int change);
  void removeEmptyBalls();

  std::shared_ptr<const PointBlocks> points_;
  const SolidGrid* solid_;
  bool polished_ = false;
  std::vector<Ball> balls_;  ///< a radius below zero marks a ball without a task
  std::vector<double> costs_;
  std::vector<std::uint64_t> fittedTo_;     ///< checksum of the points at a ball's last refit
  std::vector<std::uint16_t> coverCounts_;  ///< number of balls around each point
};

}  // namespace haarlight
