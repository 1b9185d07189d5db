#pragma once

#include <memory>
#include <string>
#include <vector>

#include "light/environment.h"
#include "light/sky_settings.h"

namespace haarlight {

/// Names of the lights that need no file, all of which give a floor (normal +Y) an irradiance of
/// about π:
///
/// `builtin:lamps`: six round lamps of 1.2° to 9° radius in warm and cold colours, the brightest
/// 42° above the horizon, over a dim bluish sky and dark ground; shadows both sharp and soft.
/// `builtin:sky`: a glow 55° wide in radius around the sun over a bright sky; soft shadows only.
/// `builtin:constant`: radiance 1 from everywhere.
/// The skies of skyModels (light/sky_model.h), unless their zenith's radiance is given.
std::vector<std::string> builtinLightNames();

/// The light of one of these names; `skySettings` are for skies. Throws InputError that lists the
/// names for any other, and as SkyEnvironment does.
std::unique_ptr<const Environment> makeBuiltinLight(const std::string& name,
                                                    const SkySettings& skySettings = {});

}  // namespace haarlight
