#include "engine/shading_tables.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/parallel.h"
#include "engine/light_selection.h"
#include "engine/lobe_slots.h"
#include "haar/occlusion_transform.h"

namespace haarlight {

namespace {

void check(const ShadingSettings& settings) {
  if (settings.terms < 0 || settings.terms > maximumTerms)
    throw InputError("the number of terms must be 0 to " + std::to_string(maximumTerms) + ", not " +
                     std::to_string(settings.terms));
  if (settings.levels != 1 && settings.levels != 2)
    throw InputError("levels must be 1 or 2, not " + std::to_string(settings.levels));
}

LightHaar transformLight(const RadianceCube& light) {
  std::vector<glm::dvec3> texels(light.texels.begin(), light.texels.end());
  return haarForwardCube<glm::dvec3, double>(texels);
}

/// Some lobes at a time are in memory: all of them take 42 MB.
MeanLobe meanOf(std::span<const int> lobes, std::span<const double> importance) {
  constexpr std::size_t block = 64;
  std::vector<HaarCube<float>> transformed(std::min(block, lobes.size()));
  MeanLobe mean;
  for (std::size_t first = 0; first < lobes.size(); first += block) {
    const std::size_t count = std::min(block, lobes.size() - first);
    parallelFor(count, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) transformed[i] = lobeHaar(lobes[first + i]);
    });
    for (std::size_t i = 0; i < count; ++i) mean.add(transformed[i], importance[lobes[first + i]]);
  }
  return mean;
}

/// Block of the sample that holds a square of level 3 or 4, and the square's quarter of it.
struct BlockPlace {
  std::uint32_t block;
  std::uint32_t quarter;
};

BlockPlace blockOf(const Square& square) {
  const int first = square.face * blocksPerFace;
  if (square.level == coarseLevels) return {std::uint32_t(first + square.square), 0};
  const int side = squaresPerSide(square.level);
  const int row = square.square / side, column = square.square % side;
  return {std::uint32_t(first + row / 2 * blocksPerSide + column / 2),
          std::uint32_t(row % 2 * 2 + column % 2)};
}

void addPlaces(ShadingTables& tables, const SquareList& squares) {
  tables.squareListEnds = squares.ends();
  tables.squarePlaces.resize(squares.size());
  tables.blockSquares.assign(5 * blockCount, ShadingTables::absentSquare);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const Square& square = squares[i];
    if (square.level < coarseLevels) continue;
    const auto [block, quarter] = blockOf(square);
    const bool isBlock = square.level == coarseLevels;
    tables.squarePlaces[i] = isBlock ? block : block * 4 + quarter;
    tables.blockSquares[5 * block + (isBlock ? 0 : 1 + quarter)] = std::uint32_t(i);
  }
}

glm::dvec3 unshadowedRadiance(const LightHaar& light, const HaarCube<float>& lobe) {
  glm::dvec3 sum(0);
  for (int face = 0; face < faceCount; ++face)
    for (int i = 0; i < coefficientsPerFace; ++i)
      sum += light[face].coefficients[i] * double(lobe[face].coefficients[i]);
  return sum;
}

void setLobe(ShadingTables& tables, std::size_t slot, const RoundedLobe& lobe) {
  std::ranges::copy(lobe.weights,
                    tables.weights.begin() + std::ptrdiff_t(slot * tables.squareCount()));
  tables.unshadowed[slot] = lobe.unshadowed;
  tables.scales[slot] = lobe.scale;
}

}  // namespace

glm::vec3 ShadingTables::unshadowedRadiance(std::size_t slot) const {
  return glm::vec3(glm::ivec3(unshadowed[slot])) * glm::vec3(scales[slot]);
}

ShadingTables buildShadingTables(const RadianceCube& light, const ShadingSettings& settings,
                                 std::span<const double> lobeImportance) {
  check(settings);
  const LightHaar lightHaar = transformLight(light);
  const auto lobes = usedLobes(lobeImportance);
  const auto terms = selectLightTerms(lightHaar, settings, meanOf(lobes, lobeImportance));
  const SquareList squares(terms, settings);

  ShadingTables tables;
  tables.settings = settings;
  tables.lobeSlots = assignSlots(lobes);
  addPlaces(tables, squares);
  const std::size_t slots = lobes.size() + 1;  // the last one is black
  tables.weights.resize(slots * squares.size());
  tables.unshadowed.assign(slots, glm::uvec4(0));
  tables.scales.assign(slots, {1, 1, 1, 0});
  parallelFor(lobes.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const HaarCube<float> lobe = lobeHaar(lobes[slot]);
      const auto weights = gatherBySquares(squares, settings, lightHaar, terms, lobe);
      setLobe(tables, slot,
              roundWeights(squares, weights, haarlight::unshadowedRadiance(lightHaar, lobe)));
    }
  });
  return tables;
}

std::vector<double> countLobes(std::span<const LobeBlend> lobes) {
  std::vector<double> counts(lobeCount);
  for (const LobeBlend& blend : lobes)
    for (int i = 0; i < 3; ++i) counts[blend.lobes[i]] += blend.weights[i];
  return counts;
}

}  // namespace haarlight
