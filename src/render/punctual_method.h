#pragma once

#include <memory>

#include "hard_shadow/level_of_detail.h"
#include "render/radiance_method.h"

namespace haarlight {

/// Adds the light of the scene's punctual lights, with hard shadows, to what a method computes.
/// Their octrees follow the scene: when it moves, only those are built anew that can differ.
std::unique_ptr<RadianceMethod> withPunctualLights(std::unique_ptr<RadianceMethod> method,
                                                   const Scene& scene, const LevelOfDetail& detail);

/// The same with a ray for every sample and light instead of octrees, for references.
std::unique_ptr<RadianceMethod> withExactPunctualLights(std::unique_ptr<RadianceMethod> method,
                                                        const Scene& scene);

}  // namespace haarlight
