#include "engine/exponentiation_tables.h"

#include "base/parallel.h"
#include "engine/lobe_slots.h"
#include "sh/cube_basis.h"

namespace haarlight {

namespace {

/// Texels' lobes are weights of a mean over the 1024 texels of a face.
constexpr double lobeScale = 1.0 / texelsPerFace;

/// By texel: light times the mean of every y_k over the texel, channel by channel.
class LightTimesBasis {
 public:
  LightTimesBasis(const RadianceCube& light, int order)
      : size_(3 * std::size_t(shCoefficientCount(order))), products_(texelCount * size_) {
    const CubeBasis& basis = CubeBasis::shared(order);
    for (int texel = 0; texel < texelCount; ++texel) {
      const glm::dvec3 mean = glm::dvec3(light[texel]) * (lobeScale / texelSolidAngle(texel));
      const auto integrals = basis.integrals(texel);
      for (int channel = 0; channel < 3; ++channel)
        for (std::size_t k = 0; k < integrals.size(); ++k)
          products_[texel * size_ + channel * integrals.size() + k] = mean[channel] * integrals[k];
    }
  }

  /// Σ over texels of the lobe's weight · light · basis.
  std::vector<double> integrate(std::span<const double> lobe) const {
    std::vector<double> sums(size_);
    for (std::size_t texel = 0; texel < texelCount; ++texel) {
      const double weight = lobe[texel];
      if (weight == 0) continue;
      const double* own = &products_[texel * size_];
      for (std::size_t i = 0; i < size_; ++i) sums[i] += weight * own[i];
    }
    return sums;
  }

 private:
  std::size_t size_;
  std::vector<double> products_;
};

}  // namespace

ExponentiationTables buildExponentiationTables(const RadianceCube& light, int order,
                                               std::span<const double> lobeImportance) {
  ExponentiationTables tables{ShexpTables::shared(order), {}, {}};
  constexpr std::size_t row = ExponentiationTables::rowSize;
  const std::size_t count = shCoefficientCount(order);
  const LightTimesBasis products(light, order);
  const auto lobes = usedLobes(lobeImportance);
  tables.lobeSlots = assignSlots(lobes);
  tables.lightLobes.resize((lobes.size() + 1) * 3 * row);  // the last slot is black
  parallelFor(lobes.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const auto sums = products.integrate(cosineLobe(lobeNormal(lobes[slot])));
      for (std::size_t i = 0; i < sums.size(); ++i)
        tables.lightLobes[(slot * 3 + i / count) * row + i % count] = float(sums[i]);
    }
  });
  return tables;
}

}  // namespace haarlight
