#pragma once

#include <memory>
#include <span>
#include <vector>

#include "hard_shadow/shadow_participant.h"
#include "mesh/ray_scene.h"
#include "mesh_shadow/classic_volume.h"
#include "scene/camera.h"

namespace haarlight {

/// What some rows of a picture's pixels see, row by row.
struct SurfaceView {
  PixelView pixels;
  std::vector<ReceiverPoint> points;  ///< of each pixel; `nothing` where it sees none
  std::vector<double> depths;         ///< t of PixelView; infinite there
};

/// Finds what a picture's pixels see, with places on the surfaces in double precision.
class SurfaceViewer {
 public:
  /// A picture of width × height pixels with raysPerSide × raysPerSide camera rays each. Shapes
  /// must stay.
  SurfaceViewer(std::span<const ShadowParticipant> participants, const Camera& camera, int width,
                int height, int raysPerSide);

  /// Of the whole picture, with a pixel for each camera ray.
  const PixelView& pixels() const { return pixels_; }

  /// Uses all threads.
  SurfaceView rows(int first, int count) const;

 private:
  struct Sight {
    ReceiverPoint point;
    double depth;
  };
  Sight look(const glm::dvec3& direction) const;
  Sight onSolid(std::uint32_t object, const Solid& solid, const RayHit& hit,
                const glm::dvec3& direction) const;
  Sight onMesh(std::uint32_t object, const RayHit& hit, const glm::dvec3& direction) const;

  std::vector<ShadowParticipant> participants_;
  RayScene rays_;
  PixelView pixels_;
};

}  // namespace haarlight
