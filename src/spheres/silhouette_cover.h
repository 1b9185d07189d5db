#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "spheres/silhouette_view.h"
#include "spheres/surface_receivers.h"

namespace haarlight {

/// Balls seen against a mesh from all views: how many balls block each pixel, and how wrong that is
/// on the whole.
///
/// The error of a view is the solid angle where exactly one of "a ball blocks" and "the mesh
/// blocks" holds, as part of the mesh's; the error here is the mean over the views. A value: a copy
/// can be changed and thrown away. A ball with a radius below zero is none.
class SilhouetteCover {
 public:
  using Views = std::vector<SilhouetteView>;
  explicit SilhouetteCover(std::shared_ptr<const Views> views,
                           std::shared_ptr<const SurfaceReceivers> receivers = nullptr);

  double error() const { return error_; }
  const std::vector<Ball>& balls() const { return balls_; }

  void add(const Ball& ball);
  void replace(std::size_t index, const Ball& ball);

  /// By how much the error falls with one more ball.
  double gainOf(const Ball& ball) const;
  /// By how much the error rises without the ball.
  double lossOf(std::size_t index) const;

  /// Moves and resizes the ball by Powell's method to where the error is least, the other balls
  /// staying, to a part of its radius; the result is a proposal, found with pixels that count in
  /// part.
  Ball refined(std::size_t index, double smallestStep = 0.01) const;

 private:
  template <typename Function>
  double sumOver(const Ball& ball, const Function& function) const;

  double selfBlocking(const Ball& ball) const;

  std::shared_ptr<const Views> views_;
  std::shared_ptr<const SurfaceReceivers> receivers_;
  std::vector<Ball> balls_;
  std::vector<std::vector<std::uint16_t>> counts_;  ///< of balls around each pixel of each view
  double error_ = 1;
};

}  // namespace haarlight
