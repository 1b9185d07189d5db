#include "material/cosine_lobe.h"

#include <algorithm>
#include <array>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace haarlight {

namespace {

const std::vector<glm::dvec3>& texelMoments() {
  static const auto moments = [] {
    std::vector<glm::dvec3> all(texelCount);
    for (int texel = 0; texel < texelCount; ++texel) all[texel] = texelMoment(texel);
    return all;
  }();
  return moments;
}

int lobeIndex(int face, int row, int column) {
  return (face * lobeGridNodes + row) * lobeGridNodes + column;
}

struct WeightedLobe {
  int lobe;
  double weight;
};

/// Lobes and weights w with Σ w_i · corners_i = normal, the heaviest first. What rounding leaves of
/// a zero is cut off, so that a grid normal is its own lobe alone.
std::array<WeightedLobe, 3> weighCorners(const std::array<int, 3>& corners,
                                         const glm::dvec3& normal) {
  const glm::dmat3 columns(lobeNormal(corners[0]), lobeNormal(corners[1]), lobeNormal(corners[2]));
  const glm::dvec3 weights = glm::inverse(columns) * normal;
  std::array<WeightedLobe, 3> weighted;
  for (int i = 0; i < 3; ++i) weighted[i] = {corners[i], weights[i] < 2e-6 ? 0.0 : weights[i]};
  std::ranges::stable_sort(weighted, std::ranges::greater(), &WeightedLobe::weight);
  return weighted;
}

/// Corners of the triangle that holds the place (x, y) in [0, 16]² of a face's grid: each cell is
/// cut along the diagonal from its top-left to its bottom-right corner.
std::array<int, 3> gridTriangle(int face, double x, double y) {
  const int column = std::min(int(x), lobeGridCells - 1), row = std::min(int(y), lobeGridCells - 1);
  const bool upper = x - column > y - row;
  return {lobeIndex(face, row, column), lobeIndex(face, row + 1, column + 1),
          upper ? lobeIndex(face, row, column + 1) : lobeIndex(face, row + 1, column)};
}

HaarCube<float> singlePrecision(const HaarCube<double>& cube) {
  HaarCube<float> result;
  for (int face = 0; face < faceCount; ++face) {
    std::ranges::copy(cube[face].coefficients, result[face].coefficients.begin());
    std::ranges::copy(cube[face].means, result[face].means.begin());
  }
  return result;
}

}  // namespace

std::vector<double> cosineLobe(const glm::dvec3& normal) {
  std::vector<double> lobe(texelCount);
  const double scale = texelsPerFace / std::numbers::pi;
  for (int texel = 0; texel < texelCount; ++texel)
    lobe[texel] = scale * std::max(0.0, glm::dot(normal, texelMoments()[texel]));
  return lobe;
}

glm::dvec3 lobeNormal(int lobe) {
  const int face = lobe / (lobeGridNodes * lobeGridNodes);
  const int row = lobe / lobeGridNodes % lobeGridNodes, column = lobe % lobeGridNodes;
  const double cell = 2.0 / lobeGridCells;
  return glm::normalize(cubeDirection({face, column * cell - 1, row * cell - 1}));
}

LobeBlend blendLobes(const glm::vec3& normal) {
  const FacePoint place = projectToCube(normal);
  const auto corners = gridTriangle(place.face, (place.s + 1) * lobeGridCells / 2,
                                    (place.t + 1) * lobeGridCells / 2);
  const auto weighted = weighCorners(corners, normal);
  LobeBlend blend{};
  for (int i = 0; i < 3; ++i) {
    blend.lobes[i] = weighted[i].lobe;
    blend.weights[i] = float(weighted[i].weight);
  }
  return blend;
}

HaarCube<float> lobeHaar(int lobe) {
  return singlePrecision(haarForwardCube<double, double>(cosineLobe(lobeNormal(lobe))));
}

}  // namespace haarlight
