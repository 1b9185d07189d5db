#include "verify/cases/paper_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/tile_order.h"
#include "verify/cases/random_cases.h"

namespace haarlight::verify {

namespace {

constexpr int receiversPerSide = 128;
constexpr float planeSide = 8;

/// A point of the (2, 3) torus knot, as a height above the plane.
glm::vec3 knotPoint(double angle) {
  const double ring = 1.2 + 0.45 * std::cos(3 * angle);
  return {ring * std::cos(2 * angle), 1.9 + ring * std::sin(2 * angle), 0.45 * std::sin(3 * angle)};
}

}  // namespace

Case paperFrame(int spheres) {
  Case frame;
  frame.name = "paper's frame, " + std::to_string(spheres) + " spheres";
  for (int i = 0; i < spheres; ++i)
    frame.spheres.push_back({knotPoint(2 * std::numbers::pi * i / spheres), 0.25f});
  for (const std::uint32_t cell : tileOrder(receiversPerSide, receiversPerSide)) {
    const auto place = [](std::uint32_t index) {
      return planeSide * ((float(index) + 0.5f) / receiversPerSide - 0.5f);
    };
    frame.receivers.add({place(cell % receiversPerSide), 0, place(cell / receiversPerSide)},
                        {0, 1, 0});
  }
  frame.light = randomLight(1);
  return frame;
}

Budget budgetOf(Engine& engine) {
  const Case frame = paperFrame(128);
  engine.setShading(buildShadingTables(frame.light, {200, 2}, countLobes(frame.receivers.lobes)));
  engine.shade(frame.spheres, frame.receivers);
  const DeviceUse use = engine.deviceUse();
  Budget budget{use.memoryBytes, 0, use.itemsPerGroup};
  for (const DeviceUse::Kernel& kernel : use.kernels)
    budget.largestLocalBytes = std::max(budget.largestLocalBytes, kernel.localBytes);
  return budget;
}

}  // namespace haarlight::verify
