#pragma once

#include <nlohmann/json.hpp>

#include "transfer/diffuse_transfer.h"

namespace haarlight {

/// A number where all channels are the same, else three, each in the shortest text of its float32.
nlohmann::ordered_json colorJson(const glm::vec3& color);

/// What a transfer says about itself.
nlohmann::ordered_json transferJson(const DiffuseTransfer& transfer);

}  // namespace haarlight
