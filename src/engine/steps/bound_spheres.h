#pragma once

#include "engine/steps/kernel_queue.h"
#include "visibility/sphere_binding.h"

namespace haarlight {

/// Spheres that follow vertices, on the device: moveSpheres reads and writes all of it.
class BoundSpheres {
 public:
  explicit BoundSpheres(KernelQueue& queue) : queue_(queue) {}

  void set(const SphereBinding& binding);
  /// Where they are when the vertices are at `positions`.
  std::vector<Sphere> move(std::span<const glm::vec4> positions);

 private:
  KernelQueue& queue_;
  std::size_t count_ = 0;
  GrowingBuffer listStarts_, vertices_, weights_, radiusFactors_;  ///< of the binding
  GrowingBuffer positions_, moved_;
};

}  // namespace haarlight
