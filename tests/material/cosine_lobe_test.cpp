#include "material/cosine_lobe.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

using namespace haarlight;

namespace {

glm::vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

/// ∫ ρ̃ over the six unit squares: reflected share of a constant light of 1.
double whiteFurnace(const std::vector<double>& lobe) {
  double sum = 0;
  for (const double value : lobe) sum += value / texelsPerFace;
  return sum;
}

std::vector<double> blendedLobe(const glm::vec3& normal) {
  const LobeBlend blend = blendLobes(normal);
  std::vector<double> lobe(texelCount);
  for (int i = 0; i < 3; ++i) {
    const auto corner = cosineLobe(lobeNormal(int(blend.lobes[i])));
    for (int texel = 0; texel < texelCount; ++texel)
      lobe[texel] += blend.weights[i] * corner[texel];
  }
  return lobe;
}

}  // namespace

TEST_CASE("a white surface under a constant light of 1 reflects 1") {
  // Exact where the horizon runs between texels; elsewhere the texels it cuts count with their
  // mean, at most 0.05 % of the whole.
  CHECK(whiteFurnace(cosineLobe({0, 1, 0})) == doctest::Approx(1).epsilon(1e-12));
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i)
    CHECK(std::abs(whiteFurnace(cosineLobe(randomDirection(random))) - 1) < 5e-4);
}

TEST_CASE("grid normals are their own lobe") {
  for (int lobe = 0; lobe < lobeCount; ++lobe) {
    const LobeBlend blend = blendLobes(lobeNormal(lobe));
    CHECK(blend.weights[0] == doctest::Approx(1).epsilon(1e-6));
    CHECK(blend.weights[1] == 0);
    CHECK(blend.weights[2] == 0);
  }
  CHECK(blendLobes({0, 1, 0}).weights[0] == 1.0f);
}

TEST_CASE("blend weights are positive, the heaviest first, and give back the normal") {
  std::mt19937 random(2);
  for (int i = 0; i < 10000; ++i) {
    const glm::vec3 normal = randomDirection(random);
    const LobeBlend blend = blendLobes(normal);
    glm::dvec3 sum(0);
    for (int k = 0; k < 3; ++k) {
      REQUIRE(blend.weights[k] >= 0);
      sum += double(blend.weights[k]) * lobeNormal(int(blend.lobes[k]));
    }
    REQUIRE(blend.weights[0] >= blend.weights[1]);
    REQUIRE(blend.weights[1] >= blend.weights[2]);
    REQUIRE(glm::length(sum - glm::dvec3(normal)) < 1e-6);
  }
}

TEST_CASE("a blend equals the lobe of its normal wherever no corner's horizon passes") {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const glm::vec3 normal = randomDirection(random);
    const auto exact = cosineLobe(normal), blended = blendedLobe(normal);
    double excess = 0;
    for (int texel = 0; texel < texelCount; ++texel) {
      const double height = glm::dot(glm::dvec3(normal), texelDirection(texel));
      if (std::abs(height) > 0.18)  // the diagonal of the widest cell, 0.125·√2
        REQUIRE(blended[texel] == doctest::Approx(exact[texel]).epsilon(1e-6));
      excess += (blended[texel] - exact[texel]) / texelsPerFace;
    }
    // Convexity of max(0, ·): near the horizon a blend can only be brighter.
    CHECK(excess > -1e-6);
    CHECK(excess < 0.004);
  }
}

TEST_CASE("the table holds the lobes' Haar transforms") {
  for (const int lobe : {0, 40, 202, lobeCount - 1}) {
    const auto exact = haarForwardCube<double, double>(cosineLobe(lobeNormal(lobe)));
    const auto single = lobeHaar(lobe);
    for (int face = 0; face < faceCount; ++face)
      for (int i = 0; i < coefficientsPerFace; i += 13)
        CHECK(single[face].coefficients[i] == float(exact[face].coefficients[i]));
  }
}
