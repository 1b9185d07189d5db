#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "motion/gltf_scene.h"

namespace haarlight {

/// The positions of all vertices of a scene at a second of its animation, in the scene's
/// coordinates: morph targets, then the node's transform or the joints' (glTF 2.0, section 3.7).
/// Throws InputError at a coordinate that is NaN or beyond largestCoordinate (mesh/mesh_file.h).
std::vector<glm::vec3> gltfPositions(const GltfScene& scene, double seconds);

/// Their normals, of any length, and zero where the file gives none; empty when it has none at all.
std::vector<glm::vec3> gltfNormals(const GltfScene& scene, double seconds);

}  // namespace haarlight
