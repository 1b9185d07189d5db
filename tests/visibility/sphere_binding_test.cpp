#include "visibility/sphere_binding.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

using namespace haarlight;

namespace {

std::uint32_t bitsOf(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

/// For numbers of one sign.
std::int64_t ulpsApart(float a, float b) {
  return std::abs(std::int64_t(bitsOf(a)) - std::int64_t(bitsOf(b)));
}

struct BoundSpheres {
  SphereBinding binding;
  std::vector<glm::vec4> vertices;

  std::vector<Sphere> moved() const { return moveSpheres(binding, vertices); }
};

/// Spheres that follow random vertices, with weights for centres that sum to 1.
BoundSpheres randomSpheres(std::mt19937& random, int sphereCount) {
  std::uniform_real_distribution<float> coordinate(-1, 1), weight(-1, 3), share(0, 2);
  BoundSpheres bound;
  for (int i = 0; i < 150; ++i)
    bound.vertices.emplace_back(coordinate(random), coordinate(random), coordinate(random), 0);
  for (int i = 0; i < sphereCount; ++i) {
    const int size = 1 + int(random() % 99);
    std::vector<std::uint32_t> list;
    std::vector<glm::vec4> weights;
    float sum = 0;
    for (int k = 0; k < size; ++k) {
      list.push_back(std::uint32_t(random() % bound.vertices.size()));
      weights.emplace_back(weight(random) / float(size), share(random) / float(size), k % 3 == 0,
                           0);
      sum += weights.back().x;
    }
    weights.front().x += 1 - sum;
    bound.binding.add(list, weights, {i % 3 == 0 ? 0.0f : 1.5f, i % 3 == 1 ? 0.0f : 0.75f});
  }
  return bound;
}

/// The definition, in double and in one plain order.
glm::dvec4 movedInDouble(const BoundSpheres& bound, std::size_t sphere) {
  const SphereBinding& binding = bound.binding;
  const std::size_t first = binding.listStarts[sphere], end = binding.listStarts[sphere + 1];
  const auto vertex = [&](std::size_t k) {
    return glm::dvec3(bound.vertices[binding.vertices[k]]);
  };
  glm::dvec3 center = vertex(first);
  for (std::size_t k = first; k < end; ++k)
    center += double(binding.weights[k].x) * (vertex(k) - vertex(first));
  double mean = 0, reach = 0;
  for (std::size_t k = first; k < end; ++k) {
    const glm::dvec3 d = vertex(k) - center;
    mean += double(binding.weights[k].y) * glm::dot(d, d);
    reach = std::max(reach, double(binding.weights[k].z) * glm::dot(d, d));
  }
  const glm::dvec2 factors(binding.radiusFactors[sphere]);
  return {center, std::sqrt(factors.x * mean + factors.y * reach)};
}

/// Four corners of a regular tetrahedron around (3, −2, 5), at √3 from it.
BoundSpheres tetrahedron(const glm::vec2& factors) {
  BoundSpheres bound;
  for (const glm::vec3& corner :
       {glm::vec3(1, 1, 1), glm::vec3(1, -1, -1), glm::vec3(-1, 1, -1), glm::vec3(-1, -1, 1)})
    bound.vertices.emplace_back(glm::vec3(3, -2, 5) + corner, 0);
  bound.binding.add(std::vector<std::uint32_t>{0, 1, 2, 3},
                    std::vector<glm::vec4>(4, {0.25f, 0.25f, 1, 0}), factors);
  return bound;
}

void checkSphere(const Sphere& sphere, const glm::vec3& center, float radius) {
  CHECK(sphere.center == center);
  CHECK(sphere.radius == radius);
}

}  // namespace

TEST_CASE("square roots: the nearest float from 2^-102 on, within 1 ULP from 2^-126 on") {
  const std::uint32_t least = bitsOf(0x1p-126f),
                      largest = bitsOf(std::numeric_limits<float>::max());
  std::int64_t worst = 0;
  int wrong = 0;
  const std::uint32_t step = (largest - least) / 2'000'000;
  for (std::uint32_t bits = least; bits <= largest; bits += step) {
    const float x = std::bit_cast<float>(bits), root = squareRoot(x);
    worst = std::max(worst, ulpsApart(root, std::sqrt(x)));
    wrong += x >= 0x1p-102f && root != std::sqrt(x);
  }
  CHECK(worst <= 1);
  CHECK(wrong == 0);
}

TEST_CASE("square roots of every float in 1 … 4 are the nearest ones") {
  int wrong = 0;
  for (float x = 1; x < 4; x = std::nextafter(x, 4.0f)) wrong += squareRoot(x) != std::sqrt(x);
  CHECK(wrong == 0);
}

TEST_CASE("square roots of 0 and of whole squares are exact, and those of powers of four") {
  CHECK(bitsOf(squareRoot(0)) == 0);
  for (int n = 1; n <= 4096; ++n) REQUIRE(squareRoot(float(n) * float(n)) == float(n));
  for (int exponent = -126; exponent <= 126; exponent += 2)
    REQUIRE(squareRoot(std::ldexp(1.0f, exponent)) == std::ldexp(1.0f, exponent / 2));
}

TEST_CASE("square roots next to 0 stay next to 0") {
  float least = 1, largest = 0;
  for (std::uint32_t bits = 1; bits < bitsOf(0x1p-126f); ++bits) {
    const float root = squareRoot(std::bit_cast<float>(bits));
    least = std::min(least, root);
    largest = std::max(largest, root);
  }
  CHECK(least >= 0);
  CHECK(largest < 0x1p-50f);
}

TEST_CASE("spheres are moved as the formulas say, in double") {
  std::mt19937 random(1);
  const BoundSpheres bound = randomSpheres(random, 60);
  const auto moved = bound.moved();
  REQUIRE(moved.size() == 60);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const glm::dvec4 expected = movedInDouble(bound, i);
    CHECK(glm::distance(glm::dvec3(moved[i].center), glm::dvec3(expected)) < 3e-6);
    CHECK(std::abs(double(moved[i].radius) - expected.w) < 3e-6);
  }
}

TEST_CASE("spheres at rest, by the mean and by the reach of their vertices") {
  // The corners' squared distances are 3.
  checkSphere(tetrahedron({3, 0}).moved()[0], {3, -2, 5}, 3);
  checkSphere(tetrahedron({0, 3}).moved()[0], {3, -2, 5}, 3);
  checkSphere(tetrahedron({1, 2}).moved()[0], {3, -2, 5}, 3);
  checkSphere(tetrahedron({0, 0}).moved()[0], {3, -2, 5}, 0);
}

TEST_CASE("spheres follow a translation, a quarter turn and a scaling without rounding") {
  for (const glm::vec2& factors : {glm::vec2(3, 0), glm::vec2(0, 3)}) {
    BoundSpheres moved = tetrahedron(factors), turned = moved, doubled = moved, tripled = moved;
    for (glm::vec4& v : moved.vertices) v += glm::vec4(1 << 20, -0.25f, 96, 7);
    for (glm::vec4& v : turned.vertices) v = {-v.y, v.x, v.z, 0};
    for (glm::vec4& v : doubled.vertices) v *= 2.0f;
    for (glm::vec4& v : tripled.vertices) v *= 3.0f;
    checkSphere(moved.moved()[0], {3 + (1 << 20), -2.25f, 101}, 3);
    checkSphere(turned.moved()[0], {2, 3, 5}, 3);
    checkSphere(doubled.moved()[0], {6, -4, 10}, 6);
    checkSphere(tripled.moved()[0], {9, -6, 15}, 9);
  }
}

TEST_CASE("doubling all coordinates doubles spheres exactly, whatever they follow") {
  std::mt19937 random(2);
  BoundSpheres bound = randomSpheres(random, 40);
  const auto before = bound.moved();
  for (glm::vec4& vertex : bound.vertices) vertex *= 2.0f;
  const auto after = bound.moved();
  for (std::size_t i = 0; i < before.size(); ++i)
    checkSphere(after[i], 2.0f * before[i].center, 2 * before[i].radius);
}

TEST_CASE("only vertices of the reach hold the radius of spheres by reach") {
  BoundSpheres bound;
  bound.vertices = {{0, 0, 0, 0}, {3, 4, 0, 0}, {0, 0, 100, 0}};
  bound.binding.add(std::vector<std::uint32_t>{0, 1, 2},
                    std::vector<glm::vec4>{{1, 0, 1, 0}, {0, 0, 1, 0}, {0, 0, 0, 0}}, {0, 1});
  checkSphere(bound.moved()[0], {0, 0, 0}, 5);
  bound.vertices[1] = {0, 8, 6, 0};
  bound.vertices[2] = {1e6f, 0, 0, 0};
  checkSphere(bound.moved()[0], {0, 0, 0}, 10);
}

TEST_CASE("vertices that coincide give a point") {
  BoundSpheres bound;
  bound.vertices.assign(5, {0.1f, -1e6f, 7, 0});
  bound.binding.add(
      std::vector<std::uint32_t>{4, 0, 1},
      std::vector<glm::vec4>{{-0.3f, 0.4f, 1, 0}, {0.6f, 0.3f, 1, 0}, {0.7f, 0.3f, 1, 0}}, {2, 2});
  checkSphere(bound.moved()[0], {0.1f, -1e6f, 7}, 0);
}

TEST_CASE("lists are filled up to whole groups of 32 with entries that add nothing") {
  SphereBinding binding;
  for (const std::size_t size : {1, 31, 32, 33, 64, 65}) {
    std::vector<std::uint32_t> list(size, 8);
    list.front() = 6;
    binding.add(list, std::vector<glm::vec4>(size, glm::vec4(1)), {1, 1});
  }
  CHECK(binding.listStarts == std::vector<std::uint32_t>{0, 32, 64, 96, 160, 224, 320});
  CHECK(binding.sphereCount() == 6);
  REQUIRE(binding.vertices.size() == 320);
  REQUIRE(binding.weights.size() == 320);
  for (const std::size_t filling : {1, 31, 63, 129, 159, 289, 319}) {
    CHECK(binding.vertices[filling] == 6);
    CHECK(binding.weights[filling] == glm::vec4(0));
  }
  for (const std::size_t entry : {0, 62, 95, 128, 223, 288})
    CHECK(binding.weights[entry] == glm::vec4(1));
}

TEST_CASE("appended bindings move as each did on its own") {
  std::mt19937 random(3);
  const BoundSpheres first = randomSpheres(random, 5), second = randomSpheres(random, 9);
  BoundSpheres both;
  for (const BoundSpheres* part : {&first, &second}) {
    both.binding.append(part->binding, std::uint32_t(both.vertices.size()));
    both.vertices.insert(both.vertices.end(), part->vertices.begin(), part->vertices.end());
  }
  both.binding.append({}, 0);
  const auto moved = both.moved(), expectedFirst = first.moved(), expectedSecond = second.moved();
  REQUIRE(moved.size() == 14);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Sphere& expected = i < 5 ? expectedFirst[i] : expectedSecond[i - 5];
    checkSphere(moved[i], expected.center, expected.radius);
  }
}

TEST_CASE("no bound spheres are moved to none") {
  CHECK(moveSpheres({}, {}).empty());
}
