#pragma once

#include "scene/json_value.h"
#include "scene/scene_description.h"

namespace haarlight {

/// What no field can be blamed for alone: throws InputError with the place in `document`, from
/// which `scene` was read.
void checkTogether(const SceneDescription& scene, const JsonValue& document);

}  // namespace haarlight
