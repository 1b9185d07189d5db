#pragma once

#include <filesystem>
#include <memory>

#include "mesh/mesh_file.h"
#include "motion/vertex_motion.h"

namespace haarlight {

/// Opens mesh files with numbers in their names ("walk_%04d.obj", see scene/numbered_files.h) as
/// frames, framesPerSecond of them a second, the one with the lowest number at second 0. They are
/// loaded when they are asked for, and only their positions count, so that normals may differ.
///
/// Throws InputError when there is no such file or one is missing in between; VertexMotion's
/// positions() also does when a file cannot be loaded, has changed, or has other vertices or
/// triangles than `mesh`.
std::unique_ptr<VertexMotion> openMeshSequence(const std::filesystem::path& pattern,
                                               const LoadedMesh& mesh, double framesPerSecond);

}  // namespace haarlight
