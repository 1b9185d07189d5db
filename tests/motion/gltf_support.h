#pragma once

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "gltf_builder.h"
#include "motion/gltf_mesh.h"
#include "test_support.h"

namespace haarlight::test {

/// Loads `content` from a file of that name.
inline AnimatedMesh loadGltfText(const std::string& content, const std::string& animation = "",
                                 const std::string& name = "model.gltf") {
  const TemporaryFolder folder;
  writeFile(folder / name, content);
  return loadGltf(folder / name, animation);
}

inline AnimatedMesh load(const GltfBuilder& builder, const std::string& animation = "") {
  return loadGltfText(builder.gltf(), animation);
}

/// Loads the file twice, embedded and as .glb, and requires that both give the same at `seconds`.
inline std::vector<glm::vec3> positionsAt(const GltfBuilder& builder, double seconds) {
  const AnimatedMesh embedded = load(builder),
                     binary = loadGltfText(builder.glb(), "", "model.glb");
  REQUIRE(embedded.motion);
  REQUIRE(binary.motion);
  const std::vector<glm::vec3> positions = embedded.motion->positions(seconds);
  CHECK(binary.motion->positions(seconds) == positions);
  return positions;
}

inline void checkNear(const glm::vec3& actual, const glm::vec3& expected) {
  INFO(actual.x << " " << actual.y << " " << actual.z << " instead of " << expected.x << " "
                << expected.y << " " << expected.z);
  CHECK(glm::length(actual - expected) <= 1e-6f);
}

}  // namespace haarlight::test
