#pragma once

#include "image/image.h"
#include "light/sky_settings.h"

namespace haarlight {

/// Pictures of all skies (skyModels) on one sheet, each with its name: the hemisphere looking up,
/// the zenith in the middle, distance from it in proportion to the angle, the horizon at the rim,
/// +Z at the top and +X on the right, so that azimuth runs clockwise from the top. Radiance L is
/// shown as L / (2 + L), a third for a uniform sky. `side` in pixels, >= 1. Linear, ready for
/// writePng. Throws InputError as SkyEnvironment does.
Image skySheet(const SkySettings& settings, int side);

}  // namespace haarlight
