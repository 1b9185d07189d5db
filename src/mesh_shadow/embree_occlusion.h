#pragma once

#include <map>
#include <span>
#include <vector>

#include "mesh/occluder.h"
#include "mesh/ray_scene.h"
#include "shadow/occlusion_query.h"
#include "shadow/shadow_light.h"
#include "solids/axis_box.h"

namespace haarlight {

/// Rays against meshes by Embree, sixteen at a time, and against solids by their formulas. Rays are
/// sorted by caster, so that neighbouring cells' rays stay together. A ray starts a little before
/// its point, so that a mesh that touches the point stands in its way, whatever single precision
/// does. One that leaves a mesh does not; its point must lie off the surface
/// (ShadowObject::ownStart).
class EmbreeOcclusion final : public OcclusionQuery {
 public:
  /// ray.caster counts in `occluders`. Meshes are copied, solids must stay.
  EmbreeOcclusion(std::span<const Occluder> occluders, const ShadowLight& light);

  /// A shape that has changed, in the place of that one.
  void replace(std::uint32_t caster, const Occluder& shape);

  void answerHere(std::span<const OcclusionRay> rays,
                  std::span<std::uint8_t> blocked) const override;

 private:
  using Order = std::span<const std::uint32_t>;  ///< numbers of rays that ask about one caster

  struct Mesh {
    AxisBox bounds;
    RayScene rays;
  };

  Ray startBefore(const OcclusionRay& ray, const AxisBox& bounds) const;
  void castPacket(const Mesh& mesh, std::span<const OcclusionRay> rays, Order order,
                  std::span<std::uint8_t> blocked) const;
  void answerFor(std::uint32_t caster, std::span<const OcclusionRay> rays, Order order,
                 std::span<std::uint8_t> blocked) const;

  std::vector<Occluder> occluders_;
  std::map<std::uint32_t, Mesh> meshes_;  ///< by occluder
  ShadowLight light_;
};

}  // namespace haarlight
