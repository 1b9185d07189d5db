#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "mesh/mesh_file.h"
#include "motion/vertex_motion.h"

namespace haarlight {

struct AnimatedMesh {
  LoadedMesh mesh;
  std::unique_ptr<VertexMotion> motion;  ///< null when nothing moves
};

/// Loads the triangles of all meshes in the default scene of a glTF 2.0 file (.gltf, .glb) as one
/// mesh, in the scene's coordinates (right-handed, y up, metres), and how an animation moves it:
/// through nodes, skins and morph targets. `mesh` is the pose at second 0 of the animation, or the
/// file's own without one; `mesh.sourceVertices` counts through the vertices of all primitives.
///
/// `animation` is "" (the first one, if any), "none", a name, or a number from 0. Materials,
/// images, cameras and lights are passed over and need not exist; points and lines too, with a
/// warning. Triangles without area at second 0 are left out, as loadMesh does, and stay so.
///
/// Throws InputError when a file is missing or damaged, needs compressed buffers or another
/// extension that changes shapes, holds no triangle, or has no such animation; and for any size,
/// offset or number in it that does not fit.
AnimatedMesh loadGltf(const std::filesystem::path& path, const std::string& animation);

}  // namespace haarlight
