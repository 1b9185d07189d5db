#include "app/transfer_json.h"

#include <fmt/format.h>

#include "base/text_format.h"

namespace haarlight {

using Json = nlohmann::ordered_json;

Json colorJson(const glm::vec3& color) {
  const auto number = [](float value) { return Json::parse(numberText(value)); };
  if (color.x == color.y && color.y == color.z) return number(color.x);
  return {number(color.x), number(color.y), number(color.z)};
}

Json transferJson(const DiffuseTransfer& transfer) {
  return {{"transfer_kind", transferKindName(transfer.kind)},
          {"order", transfer.order},
          {"channels", transfer.channels},
          {"vertices", transfer.vertices},
          {"rays_per_vertex", transfer.raysPerVertex},
          {"bounces", transfer.bounces},
          {"albedo", colorJson(transfer.albedo)},
          {"seed", transfer.seed},
          {"mesh_hash", fmt::format("{:016x}", transfer.meshHash)}};
}

}  // namespace haarlight
