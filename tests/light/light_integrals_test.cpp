#include "light/light_integrals.h"

#include <numbers>

#include "cube/cube_map.h"
#include "light_test_support.h"

namespace haarlight::test {

namespace {

std::array<glm::dvec3, 4> patchOfFace(int face, double s0, double s1, double t0, double t1) {
  // s runs to the left as seen from the centre.
  return {cubeDirection({face, s1, t0}), cubeDirection({face, s0, t0}),
          cubeDirection({face, s0, t1}), cubeDirection({face, s1, t1})};
}

}  // namespace

TEST_CASE("the overlap of a rectangle in a face with the texels is exact") {
  // Columns 3.25 to 5.5 and rows 30.5 to 31.75 of every face.
  const auto border = [](double index) { return index / 16 - 1; };
  for (int face = 0; face < faceCount; ++face) {
    LightIntegrals integrals;
    integrals.addQuadrilateral(
        patchOfFace(face, border(3.25), border(5.5), border(30.5), border(31.75)), glm::dvec3(2.0));
    double total = 0;
    for (int texel = 0; texel < texelCount; ++texel) total += integrals.solidAngle[texel];
    CHECK(total == doctest::Approx(faceRectangleSolidAngle(border(3.25), border(5.5), border(30.5),
                                                           border(31.75)))
                       .epsilon(1e-12));
    const double middle = faceRectangleSolidAngle(border(4), border(5), border(31), border(31.75));
    const int texel = (face * faceSize + 31) * faceSize + 4;
    CHECK(integrals.solidAngle[texel] == doctest::Approx(middle).epsilon(1e-12));
    CHECK(integrals.radiance[texel].g == doctest::Approx(2 * middle).epsilon(1e-12));
  }
}

TEST_CASE("a patch around a corner of the cube is shared by three faces") {
  // The octant's corner (1, 1, 1) lies in the middle of a square seen from there.
  const glm::dvec3 corner = glm::normalize(glm::dvec3(1.0));
  const glm::dvec3 u = glm::normalize(glm::cross(corner, glm::dvec3(0, 1, 0)));
  const glm::dvec3 v = glm::cross(u, corner);
  const double half = 0.004;
  LightIntegrals integrals;
  integrals.addQuadrilateral({corner + half * (-u + v), corner + half * (u + v),
                              corner + half * (u - v), corner + half * (-u - v)},
                             glm::dvec3(1.0));
  double total = 0, shares[faceCount] = {};
  for (int texel = 0; texel < texelCount; ++texel) {
    total += integrals.solidAngle[texel];
    shares[texel / texelsPerFace] += integrals.solidAngle[texel];
  }
  CHECK(total == doctest::Approx(4 * std::asin(half * half / (1 + half * half))).epsilon(1e-9));
  for (const int face : {0, 2, 4}) CHECK(shares[face] > 0.3 * total);
  for (const int face : {1, 3, 5}) CHECK(shares[face] == 0);
}

}  // namespace haarlight::test
