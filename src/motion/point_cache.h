#pragma once

#include <filesystem>
#include <memory>

#include "mesh/mesh_file.h"
#include "motion/vertex_motion.h"

namespace haarlight {

/// Opens a file of vertex positions, told apart by the extension, for a mesh whose file has as many
/// vertices as the cache has points. Frames are read when they are asked for.
///
/// .pc2 (little-endian): "POINTCACHE2\0", int32 version 1, int32 points, float32 start, float32
/// rate, int32 samples, then samples × points × 3 float32. Sample i stands at frame start + i ·
/// rate; its second is i · rate / framesPerSecond, so that the first is at 0.
///
/// .mdd (big-endian): int32 frames, int32 points, float32 seconds[frames], then frames × points × 3
/// float32. The seconds are the file's own, less the first.
///
/// Throws InputError when the file is missing, damaged, of another kind, larger or smaller than its
/// counts make it, or made for a mesh with another number of vertices.
std::unique_ptr<VertexMotion> openPointCache(const std::filesystem::path& path,
                                             const LoadedMesh& mesh, double framesPerSecond);

}  // namespace haarlight
