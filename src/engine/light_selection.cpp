#include "engine/light_selection.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

namespace haarlight {

namespace {

struct RankedTerm {
  LightTerm term;
  double rank;
};

std::vector<RankedTerm> rankWavelets(const LightHaar& light, ShadingSettings::Ranking ranking,
                                     std::span<const double> lobe) {
  std::vector<RankedTerm> ranked;
  for (int face = 0; face < faceCount; ++face)
    for (int i = 1; i < coefficientsPerFace; ++i) {
      const Wavelet w = waveletAt(i);
      double rank = glm::length(light[face].coefficients[i]);
      if (ranking == ShadingSettings::Ranking::expectedContribution)
        rank *=
            lobe[face * meansPerFace + meanIndex(w.level, w.square)] * std::exp2(-1.5 * w.level);
      ranked.push_back({{face, i}, rank});
    }
  return ranked;
}

}  // namespace

void MeanLobe::add(const HaarCube<float>& lobe, double importance) {
  for (int face = 0; face < faceCount; ++face)
    for (int i = 0; i < meansPerFace; ++i)
      squares_[face * meansPerFace + i] += importance * lobe[face].means[i];
}

std::vector<LightTerm> selectLightTerms(const LightHaar& light, const ShadingSettings& settings,
                                        const MeanLobe& lobe) {
  auto ranked = rankWavelets(light, settings.ranking, lobe.squares());
  std::ranges::stable_sort(ranked, std::ranges::greater(), &RankedTerm::rank);
  ranked.resize(std::min<std::size_t>(settings.terms, ranked.size()));
  std::vector<LightTerm> terms;
  for (int face = 0; face < faceCount; ++face) terms.push_back({face, 0});
  for (const RankedTerm& one : ranked) terms.push_back(one.term);
  std::ranges::sort(terms, {}, [](const LightTerm& t) { return std::pair(t.face, t.coefficient); });
  return terms;
}

}  // namespace haarlight
