#pragma once

#include "image/image.h"
#include "light/environment.h"
#include "light/layout.h"

namespace haarlight {

/// A light given by a picture of all directions. Pixels are finite and not negative.
///
/// The integrals take every pixel as constant over its part of the sphere, cut into cells of at
/// most 0.7° (a quarter of a texel) whose exact overlap with each texel is its weight: first-order
/// conservative remapping (P. W. Jones, Monthly Weather Review 127, 1999). As the cells tile the
/// sphere, the weights of a texel add up to its solid angle, so a constant picture gives constant
/// texels, and those of a cell to the cell's, so power is kept wherever the light is.
class ImageEnvironment final : public Environment {
 public:
  /// `name` is what the description calls it; `layoutName` as in chooseLayout, which throws.
  ImageEnvironment(Image image, const std::string& layoutName, std::string name);

  glm::vec3 radiance(const glm::vec3& direction) const override;
  std::string description() const override;
  LightIntegrals integrate(const glm::dmat3& rotation) const override;

 private:
  glm::vec3 pixelValue(int patch, glm::ivec2 pixel) const;
  glm::ivec2 size() const { return {image_.width, image_.height}; }

  Image image_;
  const Layout& layout_;
  std::string name_;
};

}  // namespace haarlight
