#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "engine/transfer_tables.h"
#include "render/moving_scene.h"
#include "render/progress.h"
#include "render/surface_sample.h"

namespace haarlight {

/// Order of transfer that is computed where nobody says another.
inline constexpr int defaultTransferOrder = 5;

/// Diffuse transfer of all vertices of a scene: those of its objects one after another, then those
/// of the receiver's grid (render/receiver_grid.h). Directions are those of the world.
struct SceneTransfer {
  TransferRows rows;
  std::vector<std::uint32_t> firstRows;  ///< by object; at the end, that of the receiver
  std::vector<bool> holdsAlbedo;         ///< likewise: whether rows include the albedo
  std::vector<std::string> warnings;     ///< one line each
};

/// Reads transfer from files where there are any for an object, and computes the rest on all
/// threads: shadows of all objects that cast them, and no reflections, as at the moment that the
/// scene shows. The receiver blocks nothing, as for the other methods.
///
/// A file is for the mesh of an object as it was loaded (which moved, turned and scaled evenly is
/// the same), or for the whole scene (wholeSceneMesh()). Where its light was not reflected, the
/// scene's albedo counts, else the file's. `files`: for any of the objects that they fit;
/// description.objects[].transfer: for that object. `order`: of all rows; nothing: the largest of
/// the files, else defaultTransferOrder.
///
/// Throws InputError when a file cannot be read, fits nothing, or its object has been deformed, and
/// when an object is a solid.
SceneTransfer makeSceneTransfer(const SceneDescription& description, const MovingScene& scene,
                                std::span<const std::filesystem::path> files,
                                std::optional<int> order, const Progress& progress = {});

/// All vertices of a scene in one mesh, in the order of SceneTransfer; the triangles are those of
/// objects that cast shadows. Throws InputError when an object is a solid.
TriangleMesh wholeSceneMesh(const Scene& scene);

}  // namespace haarlight
