#include "engine/shading_tables.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/error.h"
#include "base/parallel.h"
#include "haar/occlusion_transform.h"

namespace haarlight {

namespace {

using LightHaar = HaarCube<glm::dvec3>;

/// The lobes that occur among the receivers, in the order of their slots, and how often.
struct UsedLobe {
  int lobe;
  double importance;
  HaarCube<float> haar;
};

std::vector<UsedLobe> transformUsedLobes(std::span<const double> importance) {
  std::vector<UsedLobe> used;
  for (int lobe = 0; lobe < lobeCount; ++lobe)
    if (importance[lobe] > 0) used.push_back({lobe, importance[lobe], {}});
  parallelFor(used.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) used[i].haar = lobeHaar(used[i].lobe);
  });
  return used;
}

std::vector<std::uint32_t> assignSlots(std::span<const UsedLobe> lobes) {
  std::vector<std::uint32_t> slots(lobeCount, std::uint32_t(lobes.size()));
  for (std::size_t slot = 0; slot < lobes.size(); ++slot)
    slots[lobes[slot].lobe] = std::uint32_t(slot);
  return slots;
}

/// A light term: coefficient 0 is the Φ of the face.
struct LightTerm {
  int face;
  int coefficient;
};

int levelOf(int coefficient) {
  return coefficient == 0 ? 0 : waveletAt(coefficient).level;
}

TermDetail detailOf(int coefficient) {
  const int level = levelOf(coefficient);
  return level < coarseLevels ? coarseTerm : level == coarseLevels ? blockTerm : quarterTerm;
}

bool isComplete(const ShadingSettings& settings) {
  return settings.terms >= waveletCount;
}

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

/// Mean over the receivers of psum(p) for every square: face · 341 + mean index.
std::vector<double> meanLobe(std::span<const UsedLobe> lobes) {
  std::vector<double> mean(faceCount * meansPerFace);
  for (const UsedLobe& lobe : lobes)
    for (int face = 0; face < faceCount; ++face)
      for (int i = 0; i < meansPerFace; ++i)
        mean[face * meansPerFace + i] += lobe.importance * lobe.haar[face].means[i];
  return mean;
}

/// The wavelets to keep, the most important of all faces, in order of face and coefficient. `lobe`
/// is the receivers' mean lobe.
std::vector<LightTerm> selectWavelets(const LightHaar& light, const ShadingSettings& settings,
                                      std::span<const double> lobe) {
  struct Ranked {
    LightTerm term;
    double rank;
  };
  std::vector<Ranked> ranked;
  for (int face = 0; face < faceCount; ++face)
    for (int i = 1; i < coefficientsPerFace; ++i) {
      const Wavelet w = waveletAt(i);
      double rank = glm::length(light[face].coefficients[i]);
      if (settings.ranking == ShadingSettings::Ranking::expectedContribution)
        rank *=
            lobe[face * meansPerFace + meanIndex(w.level, w.square)] * std::exp2(-1.5 * w.level);
      ranked.push_back({{face, i}, rank});
    }
  std::ranges::stable_sort(ranked, std::ranges::greater(), &Ranked::rank);
  ranked.resize(std::min<std::size_t>(settings.terms, ranked.size()));
  std::vector<LightTerm> terms;
  for (const Ranked& r : ranked) terms.push_back(r.term);
  std::ranges::sort(terms, {}, [](const LightTerm& t) { return std::pair(t.face, t.coefficient); });
  return terms;
}

/// Block of the sample that holds a square of level 3 or 4, and the square's quarter of it.
struct BlockPlace {
  int block;
  int quarter;
};

BlockPlace blockOf(int face, const Wavelet& w) {
  if (w.level == coarseLevels) return {face * blocksPerFace + w.square, 0};
  const int side = squaresPerSide(w.level), row = w.square / side, column = w.square % side;
  return {face * blocksPerFace + row / 2 * blocksPerSide + column / 2, row % 2 * 2 + column % 2};
}

std::uint32_t lightPlace(const LightTerm& term) {
  const Wavelet w = term.coefficient == 0 ? Wavelet{0, 0, 0} : waveletAt(term.coefficient);
  if (w.level < coarseLevels) {
    const int mean = term.face * coarseMeansPerFace + meanIndex(w.level, w.square);
    const int first =
        term.face * coarseCoefficientsPerFace + coefficientIndex(w.level, w.square, 0);
    return std::uint32_t(mean) << 16 | std::uint32_t(first);
  }
  const auto [block, quarter] = blockOf(term.face, w);
  return w.level == coarseLevels ? block : block * 4 + quarter;
}

/// Factors of the occlusion's three coefficients and mean on the term's square.
glm::vec4 lightWeight(const HaarFace<float>& lobe, int coefficient) {
  if (coefficient == 0) return {0, 0, 0, lobe.coefficients[0]};
  const Wavelet w = waveletAt(coefficient);
  const int a = (w.type + 1) % 3, b = (w.type + 2) % 3;
  const float height = float(squaresPerSide(w.level));
  glm::vec4 weight;
  weight[w.type] = lobe.mean(w.level, w.square);
  weight[a] = height * lobe.coefficient({w.level, w.square, b});
  weight[b] = height * lobe.coefficient({w.level, w.square, a});
  weight.w = lobe.coefficients[coefficient];
  return weight;
}

/// Zero terms fill a list up to a multiple of 32.
constexpr LightTerm padding{0, -1};

std::size_t padded(std::size_t count) {
  return (count + partialSums - 1) / partialSums * partialSums;
}

/// Φ of every face and the wavelets, in the lists of the summation order.
std::vector<LightTerm> arrangeLightTerms(std::span<const LightTerm> wavelets,
                                         std::array<std::uint32_t, termDetails>& listEnds) {
  std::vector<LightTerm> terms;
  for (int face = 0; face < faceCount; ++face) terms.push_back({face, 0});
  for (const TermDetail detail : {coarseTerm, blockTerm, quarterTerm}) {
    std::ranges::copy_if(wavelets, std::back_inserter(terms), [&](const LightTerm& term) {
      return detailOf(term.coefficient) == detail;
    });
    terms.resize(padded(terms.size()), padding);
    listEnds[detail] = std::uint32_t(terms.size());
  }
  return terms;
}

void addLightTerms(ShadingTables& tables, const LightHaar& light, std::span<const UsedLobe> lobes,
                   std::span<const LightTerm> wavelets) {
  const auto terms = arrangeLightTerms(wavelets, tables.lightListEnds);
  for (const LightTerm& term : terms) {
    const bool real = term.coefficient >= 0;
    tables.lightPlaces.push_back(real ? lightPlace(term) : 0);
    tables.lightCoefficients.emplace_back(
        real ? light[term.face].coefficients[term.coefficient] : glm::dvec3(0), 0.0);
  }
  tables.lightWeights.resize((lobes.size() + 1) * terms.size());  // the last slot is black
  parallelFor(lobes.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      for (std::size_t i = 0; i < terms.size(); ++i)
        if (terms[i].coefficient >= 0)
          tables.lightWeights[slot * terms.size() + i] =
              lightWeight(lobes[slot].haar[terms[i].face], terms[i].coefficient);
  });
}

std::uint32_t lobePlace(int face, int coefficient) {
  const Wavelet w = waveletAt(coefficient);
  const std::uint32_t mean = face * meansPerFace + meanIndex(w.level, w.square);
  if (w.level < coarseLevels) return mean << 16 | (face * coarseCoefficientsPerFace + coefficient);
  const auto [block, quarter] = blockOf(face, w);
  const int slot = w.level == coarseLevels ? 1 + w.type : 4 + 3 * quarter + w.type;
  return mean << 16 | (block * blockTableStride + slot);
}

void addLobeTerms(ShadingTables& tables, const HaarCube<float>& lobe) {
  const int levels = isComplete(tables.settings) ? haarLevels : coarseLevels;
  for (const TermDetail detail : {coarseTerm, blockTerm, quarterTerm}) {
    for (int face = 0; face < faceCount; ++face)
      for (int i = 1; i < firstCoefficient(levels); ++i) {
        const float value = lobe[face].coefficients[i];
        if (detailOf(i) != detail || value == 0) continue;
        tables.lobePlaces.push_back(lobePlace(face, i));
        tables.lobeValues.push_back(value);
      }
    tables.lobePlaces.resize(padded(tables.lobePlaces.size()), 0);
    tables.lobeValues.resize(tables.lobePlaces.size(), 0);
    tables.lobeListStarts.push_back(std::uint32_t(tables.lobePlaces.size()));
  }
}

glm::vec4 unshadowedRadiance(const LightHaar& light, const HaarCube<float>& lobe) {
  glm::dvec3 sum(0);
  for (int face = 0; face < faceCount; ++face)
    for (int i = 0; i < coefficientsPerFace; ++i)
      sum += light[face].coefficients[i] * double(lobe[face].coefficients[i]);
  return {glm::vec3(sum), 0};
}

}  // namespace

ShadingTables buildShadingTables(const RadianceCube& light, const ShadingSettings& settings,
                                 std::span<const double> lobeImportance) {
  check(settings);
  const LightHaar lightHaar = transformLight(light);
  ShadingTables tables;
  tables.settings = settings;
  const auto lobes = transformUsedLobes(lobeImportance);
  tables.lobeSlots = assignSlots(lobes);
  addLightTerms(tables, lightHaar, lobes, selectWavelets(lightHaar, settings, meanLobe(lobes)));
  tables.lobeListStarts.push_back(0);
  for (const UsedLobe& lobe : lobes) {
    addLobeTerms(tables, lobe.haar);
    tables.unshadowed.push_back(unshadowedRadiance(lightHaar, lobe.haar));
  }
  tables.lobeListStarts.insert(tables.lobeListStarts.end(), termDetails,
                               tables.lobeListStarts.back());
  tables.unshadowed.emplace_back(0);
  for (const auto& face : lightHaar)
    for (const glm::dvec3& mean : face.means) tables.lightMeans.emplace_back(mean, 0.0);
  return tables;
}

std::vector<double> countLobes(std::span<const LobeBlend> lobes) {
  std::vector<double> counts(lobeCount);
  for (const LobeBlend& blend : lobes)
    for (int i = 0; i < 3; ++i) counts[blend.lobes[i]] += blend.weights[i];
  return counts;
}

}  // namespace haarlight
