#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "hard_shadow/level_of_detail.h"
#include "scene/scene_description.h"

namespace haarlight {

/// Of the command line: a largest edge such as 0.02 in world units, or depth=N. Throws InputError.
LevelOfDetail parseDetail(const std::string& text);

/// That of a scene, and how parseDetail would have it.
LevelOfDetail detailOf(const ShadingDescription& shading);
std::string textOf(const LevelOfDetail& detail);
void setShadowDetail(const LevelOfDetail& detail, ShadingDescription& shading);

/// Lights that the command line puts in the place of a scene's.
struct PunctualLightOptions {
  std::vector<std::string> pointLights, directionalLights;  ///< "X,Y,Z"
};

void addPunctualLightOptions(CLI::App& command, PunctualLightOptions& options);

/// All lights of the options shine equally on what the camera looks at. Throws InputError.
void applyPunctualLights(const PunctualLightOptions& options, SceneDescription& scene);

}  // namespace haarlight
