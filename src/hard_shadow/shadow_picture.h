#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hard_shadow/hard_shadow_method.h"
#include "image/image.h"
#include "shadow/punctual_light.h"

namespace haarlight {

/// Draws a scene under punctual lights: Lambertian surfaces, and a little light everywhere.
class ShadowPicture {
 public:
  /// `albedos` are the participants'. `raysPerSide` as for SurfaceViewer.
  ShadowPicture(int width, int height, int raysPerSide, std::vector<glm::dvec3> albedos,
                std::vector<PunctualLight> lights, const AxisBox& scene);

  /// Rows of camera rays from `first` on. inShadow[k] is light k's answer. With `cells`, every
  /// second cell of the octrees that is in shadow is drawn darker, where it has the size of a few
  /// pixels at least.
  void addRows(int first, const SurfaceView& view,
               std::span<const std::vector<std::uint8_t>> inShadow,
               const HardShadowMethod* cells = nullptr);

  /// Linear radiance.
  const Image& image() const { return image_; }

 private:
  glm::dvec3 radiance(const SurfaceView& view, std::size_t index,
                      std::span<const std::vector<std::uint8_t>> inShadow,
                      const HardShadowMethod* cells) const;

  int raysPerSide_;
  std::vector<glm::dvec3> albedos_;
  std::vector<PunctualLight> lights_;
  glm::dvec3 ambient_{0};  ///< irradiance
  Image image_;
};

}  // namespace haarlight
