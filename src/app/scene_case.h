#pragma once

#include <string>
#include <vector>

#include "render/progress.h"
#include "verify/cases/case.h"

namespace haarlight {

/// A built-in or other scene as a case for verification: its spheres and light, and what its camera
/// sees in a picture `width` pixels wide as receivers. Throws InputError.
verify::Case sceneCase(const std::string& scene, int width, const Progress& progress);

}  // namespace haarlight
