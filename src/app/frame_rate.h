#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "render/radiance_method.h"

namespace haarlight {

/// Shades the samples as frames again and again for about a second and reports the median:
/// frames per second and seconds by stage. Upload, kernels and read-back count, loading does not.
nlohmann::ordered_json measureFrameRate(RadianceMethod& method,
                                        std::span<const SurfaceSample> samples);

}  // namespace haarlight
