#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "render/progress.h"
#include "render/radiance_method.h"
#include "scene/camera.h"

namespace haarlight {

/// A rendered picture.
struct RenderedImage {
  /// Linear radiance.
  Image radiance;
  /// Diffuse reflectance and shading normal of what is seen; 0 where nothing is.
  Image albedo;
  Image normal;
  /// 1 where every camera ray of the pixel met a surface, else 0.
  std::vector<std::uint8_t> surfaceMask;
  /// Camera rays that met a surface: samples that were shaded.
  std::size_t surfaceSamples = 0;
};

/// Camera rays of a pixel are the centres of so many × so many cells: samplesPerPixel rounded up to
/// a square number.
int raysPerPixelSide(const ImageDescription& image);

/// Camera rays against the scene's objects and its receiver plane.
class ScreenSampler {
 public:
  ScreenSampler(const Scene& scene, const CameraDescription& camera, const ImageDescription& image);
  ~ScreenSampler();
  ScreenSampler(const ScreenSampler&) = delete;
  ScreenSampler& operator=(const ScreenSampler&) = delete;

  /// One sample for every 8×8 pixels, to rank light terms by.
  std::vector<SurfaceSample> overview() const;

  /// Computes the picture row block by row block.
  RenderedImage render(RadianceMethod& method, const Progress& progress = {}) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace haarlight
