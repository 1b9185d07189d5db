#include "engine/transfer_tables.h"

#include <algorithm>
#include <stdexcept>

namespace haarlight {

std::uint32_t rowsPerReceiver(std::span<const RowBlend> blends) {
  const bool single = std::ranges::all_of(
      blends, [](const RowBlend& b) { return b.weights.y == 0 && b.weights.z == 0; });
  return single ? 1 : 3;
}

void requireTransfer(int order, std::size_t rowCount, const TransferLights& lights,
                     const TransferReceivers& receivers) {
  const auto require = [](bool condition, const char* what) {
    if (!condition) throw std::invalid_argument(what);
  };
  require(lights.order == order, "transfer and light are of different orders");
  require(lights.count() > 0, "transfer needs a light");
  require(receivers.lightWeights.size() == receivers.size() * lights.count(),
          "every receiver of transfer needs a weight for every light");
  const auto exist = [&](const RowBlend& blend) {
    return std::max({blend.rows.x, blend.rows.y, blend.rows.z}) < rowCount;
  };
  require(std::ranges::all_of(receivers.blends, exist),
          "a receiver names a row of transfer that does not exist");
}

}  // namespace haarlight
