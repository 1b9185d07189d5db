#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "hard_shadow/level_of_detail.h"
#include "scene/scene_description.h"

namespace haarlight {

/// Of the command line: a largest edge such as 0.02 in world units, or depth=N. Throws InputError.
LevelOfDetail parseDetail(const std::string& text);

/// What an option says, else the scene, whose box is given.
LevelOfDetail detailOf(const std::string& option, const ShadingDescription& shading,
                       const AxisBox& scene);

/// As parseDetail would have it.
std::string textOf(const LevelOfDetail& detail);

/// Lights that the command line puts in the place of a scene's.
struct PunctualLightOptions {
  std::vector<std::string> pointLights, directionalLights;  ///< "X,Y,Z"
};

void addPunctualLightOptions(CLI::App& command, PunctualLightOptions& options);

/// All lights of the options shine equally on what the camera looks at. Throws InputError.
void applyPunctualLights(const PunctualLightOptions& options, SceneDescription& scene);

}  // namespace haarlight
