#include <cmath>
#include <cstdio>

#include "engine/devices.h"

/// One receiver under a constant light, with exact visibility and no blocker, reflects 1.
int main() {
  using namespace haarlight;
  Receivers receivers;
  receivers.add({0, 0, 0}, {0, 1, 0});
  RadianceCube light;
  for (auto& texel : light.texels) texel = glm::vec3(1);
  const auto engine = makeEngine({.engine = "reference"}, nullptr);
  engine->setShading(buildShadingTables(light, {}, countLobes(receivers.lobes)));
  const float radiance = engine->shade({}, receivers)[0].x;
  std::printf("%g\n", radiance);
  return std::abs(radiance - 1) < 1e-5f ? 0 : 1;
}
