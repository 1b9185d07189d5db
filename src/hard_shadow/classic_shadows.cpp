#include "hard_shadow/classic_shadows.h"

#include "base/error.h"
#include "base/parallel.h"

namespace haarlight {

ClassicShadows::ClassicShadows(std::span<const ShadowParticipant> participants,
                               const ShadowLight& light, ClassicVolume::Sides sides)
    : light_(light) {
  checkLight(light);
  for (const ShadowParticipant& participant : participants) {
    if (!participant.castsShadow) continue;
    const auto* mesh = std::get_if<const TriangleMesh*>(&participant.shape);
    if (!mesh) throw InputError("classic shadow volumes are for polygons");
    casters_.push_back(std::make_unique<Caster>(**mesh, light, sides));
  }
}

std::size_t ClassicShadows::faceCount() const {
  std::size_t count = 0;
  for (const auto& caster : casters_) count += caster->volume.faceCount();
  return count;
}

std::size_t ClassicShadows::memory() const {
  return faceCount() * ClassicVolume::bytesPerFace();
}

void ClassicShadows::answer(const SurfaceView& view, std::span<std::uint8_t> inShadow) const {
  std::vector<std::int32_t> counts(view.points.size());
  bool isAllDark = false;  // as no volume is there behind a triangle that the light lies on
  for (const auto& caster : casters_) {
    caster->volume.addCounts(view.pixels, view.depths, counts);
    isAllDark |= caster->mesh.holdsLight();
  }
  parallelFor(counts.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const ReceiverPoint& point = view.points[i];
      inShadow[i] = point.object != ReceiverPoint::nothing &&
                    (isAllDark || counts[i] > 0 || !facesLight(point, light_));
    }
  });
}

}  // namespace haarlight
