#pragma once

#include <cstdint>
#include <span>

#include "hard_shadow/surface_view.h"
#include "image/image.h"

namespace haarlight {

/// How the shadows of a picture differ from the reference's, in camera rays that meet a surface
/// which faces the light.
struct ShadowDifference {
  std::uint64_t inShadow = 0;  ///< by the reference
  std::uint64_t missing = 0;   ///< of these, those in light
  std::uint64_t extra = 0;     ///< in shadow, but not so by the reference

  void add(const SurfaceView& view, const ShadowLight& light, std::span<const std::uint8_t> answer,
           std::span<const std::uint8_t> reference);

  /// Of the shadow's area, as a part of it; 0 where both have none.
  double areaError() const;
  /// Of all that is wrong, as a part of the shadow's area.
  double wrongPart() const;
};

/// Adds a colour to the pixels of a picture in which an answer differs: red for shadow where the
/// reference has none, blue for shadow that is missing. The view is some of its rows, from camera
/// ray row `first` on.
void paintDifference(Image& picture, int first, int raysPerSide, const SurfaceView& view,
                     const ShadowLight& light, std::span<const std::uint8_t> answer,
                     std::span<const std::uint8_t> reference);

}  // namespace haarlight
