#pragma once

#include <memory>
#include <string>
#include <vector>

#include "light/environment.h"
#include "light/sky_settings.h"

namespace haarlight {

struct LoadedLight {
  std::unique_ptr<const Environment> environment;
  std::vector<std::string> warnings;  ///< one line each
};

/// A built-in light (a name that starts with "builtin:", see builtinLightNames) or a picture of all
/// directions, Radiance HDR or OpenEXR, in the layout named (`latlong`, `vcross`, `hcross`,
/// `angular`; empty: by its aspect ratio). `skySettings` are for skies among the built-in lights.
/// Throws InputError as makeBuiltinLight, readImage and chooseLayout do, or when a layout is asked
/// of a built-in light.
LoadedLight loadLight(const std::string& nameOrPath, const std::string& layoutName = "",
                      const SkySettings& skySettings = {});

}  // namespace haarlight
