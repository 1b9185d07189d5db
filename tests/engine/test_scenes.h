#pragma once

/// Random scenes and engines shared by the tests of this room.

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "engine/devices.h"
#include "engine/kernel_device.h"
#include "visibility/visibility_kind.h"

namespace haarlight::test {

struct TestScene {
  std::vector<Sphere> spheres;
  Receivers receivers;
  RadianceCube light;
};

/// Spheres that follow vertices.
struct TestBinding {
  SphereBinding binding;
  std::vector<glm::vec4> vertices;
};

/// Spheres that follow some of 200 vertices in a cube of side 2, up to 1,000 from the origin: lists
/// of 1 … 100 entries, weights of both signs, radii from means, from reaches and from both.
TestBinding randomBinding(unsigned seed, int sphereCount);

/// Spheres of all kinds (grazing, huge, tiny, coincident, behind, around a receiver, far away,
/// exactly along an axis), receivers with any normal, and a light of a dim sky and a few lamps.
TestScene randomScene(unsigned seed, int receiverCount = 8);

/// The sphere table, read or built once per process.
std::shared_ptr<const SphereTable> sharedSphereTable();

std::unique_ptr<Engine> referenceEngine(VisibilityKind visibility = VisibilityKind::exact);

/// Whether the engine has a device here; else a line "SKIPPED: …" has been printed.
bool haveDevice(const std::string& engine);

/// An engine in a shape (0: what suits the device); null, after a line "SKIPPED: …", when it has no
/// device here.
std::unique_ptr<Engine> testEngine(const std::string& name,
                                   VisibilityKind visibility = VisibilityKind::exact,
                                   const KernelShape& shape = {0, 0});

/// Tables for a scene.
ShadingTables tablesFor(const TestScene& scene, int terms, int levels);

}  // namespace haarlight::test
