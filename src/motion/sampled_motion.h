#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "motion/vertex_motion.h"

namespace haarlight {

/// A motion known at some moments, with straight lines between them. Keeps the two frames it
/// interpolates between.
class SampledMotion : public VertexMotion {
 public:
  std::size_t vertexCount() const override { return vertexCount_; }
  double duration() const override { return seconds_.back(); }

  /// At the second of a frame, that frame to the bit.
  std::vector<glm::vec3> positions(double seconds) override;

 protected:
  /// `seconds` of the frames: at least one, from 0, increasing.
  SampledMotion(std::size_t vertexCount, std::vector<double> seconds);

  /// The frame from its file: vertexCount() positions, all within largestCoordinate.
  virtual std::vector<glm::vec3> readFrame(std::size_t frame) = 0;

 private:
  struct KeptFrame {
    std::size_t number = std::numeric_limits<std::size_t>::max();
    std::vector<glm::vec3> positions;
  };

  const std::vector<glm::vec3>& keptFrame(std::size_t frame);

  std::size_t vertexCount_;
  std::vector<double> seconds_;
  std::array<KeptFrame, 2> kept_;  ///< one with an even number and one with an odd number
};

/// Seconds of `count` frames that are `step` frames apart, the first at 0. Throws
/// std::invalid_argument unless step and framesPerSecond give increasing finite seconds.
std::vector<double> evenSeconds(std::size_t count, double step, double framesPerSecond);

}  // namespace haarlight
