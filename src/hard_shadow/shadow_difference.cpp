#include "hard_shadow/shadow_difference.h"

namespace haarlight {

namespace {

double part(std::uint64_t count, std::uint64_t whole) {
  return count == 0 ? 0 : double(count) / double(whole);
}

/// Whether the answer for a point of the view counts, as surfaces that face away are dark anyway.
bool counts(const ReceiverPoint& point, const ShadowLight& light) {
  return point.object != ReceiverPoint::nothing && facesLight(point, light);
}

}  // namespace

void ShadowDifference::add(const SurfaceView& view, const ShadowLight& light,
                           std::span<const std::uint8_t> answer,
                           std::span<const std::uint8_t> reference) {
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    if (!counts(view.points[i], light)) continue;
    inShadow += reference[i];
    missing += reference[i] && !answer[i];
    extra += answer[i] && !reference[i];
  }
}

double ShadowDifference::areaError() const {
  return part(extra, inShadow) - part(missing, inShadow);
}

double ShadowDifference::wrongPart() const {
  return part(extra + missing, inShadow);
}

void paintDifference(Image& picture, int first, int raysPerSide, const SurfaceView& view,
                     const ShadowLight& light, std::span<const std::uint8_t> answer,
                     std::span<const std::uint8_t> reference) {
  const glm::vec3 extraColor(1, 0.1f, 0.05f), missingColor(0.1f, 0.3f, 1);
  const float weight = 1 / float(raysPerSide * raysPerSide);
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    if (answer[i] == reference[i] || !counts(view.points[i], light)) continue;
    const int row = first + int(i) / view.pixels.width, column = int(i) % view.pixels.width;
    picture.at(column / raysPerSide, row / raysPerSide) +=
        weight * (answer[i] ? extraColor : missingColor);
  }
}

}  // namespace haarlight
