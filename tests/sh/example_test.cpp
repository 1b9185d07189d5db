// The documentation's example comes first, as a user's file would have it.
#include <glm/vec3.hpp>

#include "sh/cube_basis.h"
#include "sh/rotation.h"
#include "sh/window.h"
#include "sh/zonal.h"

/// Irradiance at a normal under a light that has been turned: nine coefficients instead of 6,144
/// texels.
glm::vec3 irradiance(const haarlight::RadianceCube& light, const glm::dmat3& turn,
                     const glm::vec3& normal) {
  using namespace haarlight;
  constexpr int order = 3;
  const ShVector<glm::vec3> radiance = projectToSh(order, light);
  const ShVector<glm::vec3> soft = applyWindow(radiance, ShWindow::lanczos, 2 * order);
  const ShVector<glm::vec3> turned = ShRotation(turn, order)(soft);
  const auto factors = convolutionFactors(clampedCosineZonal(order));
  return evaluate(scaleBands(turned, factors), normal);
}

#include <doctest/doctest.h>

#include "test_support.h"

TEST_CASE("the documentation's example gives pi times a constant radiance") {
  haarlight::RadianceCube light;
  for (glm::vec3& texel : light.texels) texel = {1, 2, 3};
  const glm::vec3 result = irradiance(light, glm::dmat3(1), {0, 1, 0});
  for (int channel = 0; channel < 3; ++channel)
    CHECK(result[channel] == doctest::Approx(std::acos(-1.0) * (channel + 1)).epsilon(1e-6));
}

TEST_CASE("the documentation shows this example, word for word") {
  const std::string page =
      haarlight::test::readFile(HAARLIGHT_SOURCE "/docs/spherical_harmonics.md");
  const std::string file = haarlight::test::readFile(HAARLIGHT_SOURCE "/tests/sh/example_test.cpp");
  const std::string opening = "```cpp\n";
  const auto begin = page.find(opening), end = page.find("```\n", begin + 1);
  REQUIRE(end != std::string::npos);
  const auto example = page.substr(begin + opening.size(), end - begin - opening.size());
  CHECK(example.size() > 500);
  CHECK(file.find(example) != std::string::npos);
}
