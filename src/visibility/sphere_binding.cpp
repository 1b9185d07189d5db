#include "visibility/sphere_binding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>

#include "base/canonical_order.h"

namespace haarlight {

namespace {

/// The entries of one sphere's list.
struct EntryList {
  std::span<const std::uint32_t> vertices;
  std::span<const glm::vec4> weights;
  std::span<const glm::vec4> positions;

  glm::vec3 vertex(std::size_t k) const { return glm::vec3(positions[vertices[k]]); }
};

glm::vec3 movedCenter(const EntryList& list) {
  const glm::vec3 origin = list.vertex(0);
  std::array<glm::vec3, partialSums> partials{};
  for (std::size_t k = 0; k < list.vertices.size(); ++k) {
    const glm::vec3 offset = list.vertex(k) - origin;
    glm::vec3& partial = partials[k % partialSums];
    for (int axis = 0; axis < 3; ++axis)
      partial[axis] = std::fma(list.weights[k].x, offset[axis], partial[axis]);
  }
  return origin + combineAsTree(partials, std::plus<>());
}

float movedRadius(const EntryList& list, const glm::vec3& center, const glm::vec2& factors) {
  std::array<float, partialSums> means{}, reaches{};
  for (std::size_t k = 0; k < list.vertices.size(); ++k) {
    const glm::vec3 d = list.vertex(k) - center;
    const float squared = std::fma(d.z, d.z, std::fma(d.y, d.y, d.x * d.x));
    float& mean = means[k % partialSums];
    float& reach = reaches[k % partialSums];
    mean = std::fma(list.weights[k].y, squared, mean);
    reach = std::max(reach, list.weights[k].z * squared);
  }
  const float mean = combineAsTree(means, std::plus<>());
  const float reach = combineAsTree(reaches, [](float a, float b) { return std::max(a, b); });
  return squareRoot(std::fma(factors.y, reach, factors.x * mean));
}

}  // namespace

void SphereBinding::add(std::span<const std::uint32_t> listVertices,
                        std::span<const glm::vec4> listWeights, const glm::vec2& factors) {
  vertices.insert(vertices.end(), listVertices.begin(), listVertices.end());
  weights.insert(weights.end(), listWeights.begin(), listWeights.end());
  while (vertices.size() % partialSums != 0) {
    vertices.push_back(listVertices.front());
    weights.emplace_back(0);
  }
  listStarts.push_back(std::uint32_t(vertices.size()));
  radiusFactors.push_back(factors);
}

void SphereBinding::append(const SphereBinding& other, std::uint32_t firstVertex) {
  const std::uint32_t firstEntry = listStarts.back();
  for (std::size_t i = 1; i < other.listStarts.size(); ++i)
    listStarts.push_back(firstEntry + other.listStarts[i]);
  for (const std::uint32_t vertex : other.vertices) vertices.push_back(firstVertex + vertex);
  weights.insert(weights.end(), other.weights.begin(), other.weights.end());
  radiusFactors.insert(radiusFactors.end(), other.radiusFactors.begin(), other.radiusFactors.end());
}

std::vector<Sphere> moveSpheres(const SphereBinding& binding,
                                std::span<const glm::vec4> positions) {
  std::vector<Sphere> spheres;
  spheres.reserve(binding.sphereCount());
  for (std::size_t i = 0; i < binding.sphereCount(); ++i) {
    const std::size_t first = binding.listStarts[i], count = binding.listStarts[i + 1] - first;
    const EntryList list{std::span(binding.vertices).subspan(first, count),
                         std::span(binding.weights).subspan(first, count), positions};
    const glm::vec3 center = movedCenter(list);
    spheres.push_back({center, movedRadius(list, center, binding.radiusFactors[i])});
  }
  return spheres;
}

float squareRoot(float x) {
  float inverse = std::bit_cast<float>(0x5f3759dfu - (std::bit_cast<std::uint32_t>(x) >> 1));
  const float halved = 0.5f * x;
  for (int step = 0; step < 3; ++step)
    inverse = inverse * std::fma(-(halved * inverse), inverse, 1.5f);
  const float root = x * inverse;
  return std::fma(std::fma(-root, root, x), 0.5f * inverse, root);
}

}  // namespace haarlight
