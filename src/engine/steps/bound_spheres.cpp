#include "engine/steps/bound_spheres.h"

namespace haarlight {

void BoundSpheres::set(const SphereBinding& binding) {
  count_ = binding.sphereCount();
  if (count_ == 0) return;
  queue_.upload(listStarts_, binding.listStarts);
  queue_.upload(vertices_, binding.vertices);
  queue_.upload(weights_, binding.weights);
  queue_.upload(radiusFactors_, binding.radiusFactors);
}

std::vector<Sphere> BoundSpheres::move(std::span<const glm::vec4> positions) {
  std::vector<Sphere> spheres(count_);
  if (spheres.empty()) return spheres;
  queue_.upload(positions_, positions);
  queue_.launch("moveSpheres", count_,
                {positions_, std::uint32_t(count_), listStarts_, vertices_, weights_,
                 radiusFactors_, queue_.roomForSamples(moved_, count_, sizeof(Sphere))});
  queue_.download(moved_, spheres);
  return spheres;
}

}  // namespace haarlight
