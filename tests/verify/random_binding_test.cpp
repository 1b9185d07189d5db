#include "verify/cases/random_binding.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

using namespace haarlight;
using namespace haarlight::verify;

TEST_CASE("bound spheres keep to their bounds, and all that they can be occurs") {
  std::map<std::size_t, int> sphereCounts, listSizes;
  int whole = 0, farAway = 0, twins = 0, negative = 0, points = 0, means = 0, reaches = 0;
  for (std::size_t index = 0; index < 400; ++index) {
    const Case value = randomCase(1, index);
    const SphereBinding& binding = value.binding;
    REQUIRE(value.vertices.size() >= 1);
    REQUIRE(value.vertices.size() <= 3000);
    REQUIRE(binding.sphereCount() >= 1);
    REQUIRE(binding.sphereCount() <= 70);
    ++sphereCounts[binding.sphereCount()];
    whole += value.vertices.size() == 3000;
    for (std::size_t i = 1; i < value.vertices.size(); ++i)
      twins += value.vertices[i] == value.vertices[i - 1];
    farAway += std::abs(value.vertices[0].x) > 1e5f;
    for (const glm::vec4& weight : binding.weights) negative += weight.x < 0;
    for (const glm::vec2& factors : binding.radiusFactors) {
      means += factors.x > 0 && factors.y == 0;
      reaches += factors.x == 0 && factors.y > 0;
    }
    for (std::size_t i = 0; i < binding.sphereCount(); ++i)
      ++listSizes[binding.listStarts[i + 1] - binding.listStarts[i]];
    for (const auto& [center, radius] : moveSpheres(binding, value.vertices)) {
      REQUIRE(std::abs(center.x + center.y + center.z) < 1e7f);
      REQUIRE(radius >= 0);
      REQUIRE(radius < 1e3f);
      points += radius == 0;
    }
  }
  for (const std::size_t count : {1, 31, 32, 33, 64, 70}) CHECK(sphereCounts[count] >= 1);
  for (const std::size_t size : {32, 64, 96}) CHECK(listSizes[size] >= 50);
  CHECK(listSizes.rbegin()->first >= 3000);
  for (const int count : {whole, farAway, points, twins}) CHECK(count >= 10);
  for (const int count : {negative, means, reaches}) CHECK(count >= 500);
}
