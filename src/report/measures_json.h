#pragma once

#include <nlohmann/json.hpp>

#include "spheres/sphere_set.h"

namespace haarlight {

/// The measures of a sphere set by the names that commands and reports give them: covered_surface,
/// outside_volume_ratio, union_outside_ratio, uncovered_volume_ratio, silhouette_error (mean,
/// worst, over, under). Those that there are none of are left out.
nlohmann::ordered_json measuresJson(const SphereMeasures& measures);

}  // namespace haarlight
