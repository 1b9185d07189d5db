#include "verify/cases/random_binding.h"

#include <algorithm>
#include <array>
#include <cmath>

// As in random_spheres.cpp, no expression draws twice, but for braces, and only IEEE-exact
// operations are used.

namespace haarlight::verify {

namespace {

/// Often few, so that a case is quick; at times the counts around the sizes of groups.
int randomSphereCount(PortableRandom& random) {
  constexpr std::array special{1, 31, 32, 33, 64, 70};
  return random.below(8) ? 1 + random.below(12)
                         : special[std::size_t(random.below(int(special.size())))];
}

int randomVertexCount(PortableRandom& random) {
  constexpr std::array special{1, 2, 3, 3000};
  return random.below(6) ? 1 + random.below(300)
                         : special[std::size_t(random.below(int(special.size())))];
}

int randomListSize(PortableRandom& random, int vertices) {
  constexpr std::array special{1, 31, 32, 33, 64, 65};
  if (random.below(4) == 0) return special[std::size_t(random.below(int(special.size())))];
  return random.below(16) ? 1 + random.below(100) : vertices;
}

/// 0, or 1 … 10⁶ along each axis.
glm::vec3 randomOffset(PortableRandom& random) {
  constexpr std::array scales{0.0f, 1.0f, 1e3f, 1e6f};
  const float scale = scales[std::size_t(random.below(int(scales.size())))];
  return scale * glm::vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

std::vector<glm::vec4> randomVertices(PortableRandom& random, bool denormal) {
  const float extent = denormal ? std::ldexp(1.0f, random.below(73) - 133) : 1.0f;
  const glm::vec3 offset = denormal ? glm::vec3(0) : randomOffset(random);
  const int count = randomVertexCount(random);
  std::vector<glm::vec4> vertices;
  while (int(vertices.size()) < count) {
    const glm::vec3 local{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const bool repeats = !vertices.empty() && random.below(8) == 0;
    vertices.push_back(repeats ? vertices[std::size_t(random.below(int(vertices.size())))]
                               : glm::vec4(offset + extent * local, 0));
  }
  return vertices;
}

glm::vec2 randomRadiusFactors(PortableRandom& random) {
  const int kind = random.below(3);
  const float mean = random.uniform(0.25f, 4), reach = random.uniform(0.25f, 4);
  return {kind == 0 ? 0 : mean, kind == 1 ? 0 : reach};
}

void addSphere(PortableRandom& random, int vertexCount, SphereBinding& binding) {
  const int size = randomListSize(random, vertexCount);
  const float share = 1 / float(size);
  std::vector<std::uint32_t> vertices;
  std::vector<glm::vec4> weights;
  for (int i = 0; i < size; ++i) {
    vertices.push_back(std::uint32_t(random.below(vertexCount)));
    const float forCenter = share * random.uniform(-1, 3), forMean = share * random.uniform(0, 2);
    weights.emplace_back(forCenter, forMean, random.below(2), 0);
  }
  binding.add(vertices, weights, randomRadiusFactors(random));
}

}  // namespace

void addRandomBinding(PortableRandom& random, bool denormal, Case& value) {
  value.vertices = randomVertices(random, denormal);
  for (int count = randomSphereCount(random); count > 0; --count)
    addSphere(random, int(value.vertices.size()), value.binding);
}

}  // namespace haarlight::verify
