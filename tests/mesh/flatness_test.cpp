#include "mesh/flatness.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mesh/random.h"
#include "mesh/test_meshes.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("planes and lines are told from thin solids, wherever they lie") {
  const TriangleMesh thin = box({0, 0, 0}, {1, 1, 1e-3f}), grid = groundGrid(1, 8);
  TriangleMesh unused = grid;
  unused.positions.emplace_back(0, 5, 0);
  CHECK(liesInPlane(unused));
  const TriangleMesh line{{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}, {}, {{0, 1, 2}}};
  const TriangleMesh point{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {}, {{0, 1, 2}}};
  CHECK(liesInPlane(line));
  CHECK(liesInPlane(point));
  CHECK(liesInPlane({}));
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    const glm::vec3 axis = glm::vec3(x, y, z) + 0.1f;
    const float scale = std::pow(10.0f, static_cast<float>(i % 7 - 3));
    const glm::vec3 offset = i % 2 ? scale * 1e3f * axis : glm::vec3(0);
    const glm::mat4 place =
        glm::scale(glm::rotate(glm::translate(glm::mat4(1), offset), static_cast<float>(i), axis),
                   glm::vec3(scale));
    CHECK(liesInPlane(transformed(grid, place)));
    CHECK_FALSE(liesInPlane(transformed(sphereAt({0, 0, 0}, 1), place)));
    CHECK_FALSE(
        liesInPlane(transformed(thin, glm::scale(place, glm::vec3(1, 1, i % 2 ? 10.0f : 1.0f)))));
  }
}
