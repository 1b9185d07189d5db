#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "cube/bit_cube.h"
#include "cube/cube_image.h"
#include "haar/occlusion_transform.h"
#include "material/cosine_lobe.h"

namespace haarlight::benchmark {

/// What can be done with a light that stays and diffuse surfaces: the light times each lobe,
/// computed once, so that a sample needs a sum over two factors and not three. All sums run on all
/// threads in single precision and subtract what is blocked from the unshadowed radiance.

/// Light times lobe per texel; a sample's sum runs over its blocked texels.
class TexelProduct {
 public:
  /// For the lobes that occur in `lobes`.
  TexelProduct(const RadianceCube& light, std::span<const LobeBlend> lobes);

  std::vector<glm::vec3> radiance(std::span<const BitCube> cubes,
                                  std::span<const LobeBlend> lobes) const;

 private:
  struct Lobe {
    glm::vec4 unshadowed{0};
    std::vector<glm::vec4> texels;
  };
  std::vector<Lobe> lobes_;  ///< by lobe; without texels where it does not occur
};

/// Light times lobe in the Haar basis: a sample's sum is the dot product with the coefficients of
/// its occlusion.
class HaarProduct {
 public:
  /// Keeps, for each lobe, the six face means and the `terms` wavelets of the product that matter
  /// most: by magnitude times the root mean square 2^{-1.5 l} of an occlusion coefficient of level
  /// l (engine/shading_settings.h).
  HaarProduct(const RadianceCube& light, std::span<const LobeBlend> lobes, int terms);

  std::vector<glm::vec3> radiance(std::span<const OcclusionHaar> occlusion,
                                  std::span<const LobeBlend> lobes) const;

 private:
  struct Term {
    glm::vec4 coefficient;
    /// Where the occlusion's coefficient lies: in OcclusionHaar, or, of levels 3 and 4, block ·
    /// blockTableStride + place in the block's table.
    std::uint32_t place;
  };
  struct Lobe {
    glm::vec4 unshadowed{0};
    std::vector<Term> coarse, fine;
  };
  static Lobe cut(const std::vector<glm::dvec3>& product, int terms);

  std::vector<Lobe> lobes_;  ///< by lobe
};

}  // namespace haarlight::benchmark
