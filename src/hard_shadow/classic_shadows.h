#pragma once

#include <memory>
#include <span>
#include <vector>

#include "hard_shadow/surface_view.h"
#include "mesh_shadow/classic_volume.h"

namespace haarlight {

/// A scene's shadows by classic shadow volumes: one volume for every mesh that casts a shadow.
class ClassicShadows {
 public:
  /// All casters must be meshes; polygons have to stand in for solids. Throws InputError as
  /// LitMesh does, and for solids.
  ClassicShadows(std::span<const ShadowParticipant> participants, const ShadowLight& light);

  std::size_t faceCount() const;
  /// Bytes of all faces.
  std::size_t memory() const;

  /// Sets inShadow[i] to 1 where the view's point i faces away from the light or lies in a volume.
  void answer(const SurfaceView& view, std::span<std::uint8_t> inShadow) const;

 private:
  struct Caster {
    LitMesh mesh;
    ClassicVolume volume;

    Caster(const TriangleMesh& triangles, const ShadowLight& light)
        : mesh(triangles, light), volume(mesh) {}
  };

  ShadowLight light_;
  std::vector<std::unique_ptr<Caster>> casters_;
};

}  // namespace haarlight
