#include "light/image_environment.h"

#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "base/parallel.h"

namespace haarlight {

namespace {

/// The grid of cells that a picture's patches are cut into for integration.
class CellGrid {
 public:
  CellGrid(const Image& image, const Layout& layout, const glm::dmat3& rotation)
      : image_(image),
        layout_(layout),
        rotation_(rotation),
        patchSize_(layout.patchSize({image.width, image.height})) {
    constexpr double maximumDegrees = 0.7;
    const glm::dvec2 pixelDegrees = layout.patchDegrees() / glm::dvec2(patchSize_);
    cellsPerPixel_ = glm::ivec2(glm::ceil(pixelDegrees / maximumDegrees));
    cells_ = patchSize_ * cellsPerPixel_;
  }

  /// Rows of cells of all patches.
  int rowCount() const { return layout_.patchCount() * cells_.y; }

  void integrateRows(int begin, int end, LightIntegrals& integrals) const {
    std::vector<glm::dvec3> top(cells_.x + 1), bottom(cells_.x + 1);
    for (int row = begin; row < end; ++row) {
      const int patch = row / cells_.y, rowInPatch = row % cells_.y;
      if (row == begin || rowInPatch == 0) fillCorners(patch, rowInPatch, top);
      fillCorners(patch, rowInPatch + 1, bottom);
      integrateRow(patch, rowInPatch, top, bottom, integrals);
      std::swap(top, bottom);
    }
  }

 private:
  glm::dvec2 position(int column, int row) const {
    return glm::dvec2(column, row) / glm::dvec2(cells_);
  }

  void fillCorners(int patch, int row, std::vector<glm::dvec3>& corners) const {
    for (int column = 0; column <= cells_.x; ++column)
      corners[column] = rotation_ * layout_.direction({patch, position(column, row)});
  }

  void integrateRow(int patch, int row, const std::vector<glm::dvec3>& top,
                    const std::vector<glm::dvec3>& bottom, LightIntegrals& integrals) const {
    const glm::ivec2 origin = layout_.patchOrigin(patch, {image_.width, image_.height});
    for (int column = 0; column < cells_.x; ++column) {
      const glm::ivec2 pixel = origin + glm::ivec2(column, row) / cellsPerPixel_;
      const glm::dvec3 value(image_.at(pixel.x, pixel.y));
      integrals.addQuadrilateral({top[column], top[column + 1], bottom[column + 1], bottom[column]},
                                 value);
      integrals.sourcePower +=
          value * layout_.solidAngle(position(column, row), position(column + 1, row + 1));
    }
  }

  const Image& image_;
  const Layout& layout_;
  const glm::dmat3& rotation_;
  glm::ivec2 patchSize_, cellsPerPixel_, cells_;
};

}  // namespace

ImageEnvironment::ImageEnvironment(Image image, const std::string& layoutName, std::string name)
    : image_(std::move(image)), layout_(chooseLayout(layoutName, size())), name_(std::move(name)) {}

/// A pixel's value by its place in a patch; beside the patch, that of the nearest pixel there.
glm::vec3 ImageEnvironment::pixelValue(int patch, glm::ivec2 pixel) const {
  const glm::dvec2 patchSize(layout_.patchSize(size()));
  const glm::dvec2 center = (glm::dvec2(pixel) + 0.5) / patchSize;
  if (!layout_.covers(center)) {
    const PatchPoint place = layout_.locate(layout_.direction({patch, center}));
    patch = place.patch;
    pixel = glm::ivec2(
        glm::clamp(glm::floor(place.position * patchSize), glm::dvec2(0.0), patchSize - 1.0));
  }
  const glm::ivec2 at = layout_.patchOrigin(patch, size()) + pixel;
  return image_.at(at.x, at.y);
}

glm::vec3 ImageEnvironment::radiance(const glm::vec3& direction) const {
  const PatchPoint place = layout_.locate(direction);
  const glm::dvec2 continuous = place.position * glm::dvec2(layout_.patchSize(size())) - 0.5;
  const glm::ivec2 first(glm::floor(continuous));
  const glm::vec2 weight(continuous - glm::floor(continuous));
  const auto value = [&](int x, int y) {
    return pixelValue(place.patch, first + glm::ivec2(x, y));
  };
  return glm::mix(glm::mix(value(0, 0), value(1, 0), weight.x),
                  glm::mix(value(0, 1), value(1, 1), weight.x), weight.y);
}

std::string ImageEnvironment::description() const {
  return name_ + " (" + std::to_string(image_.width) + "×" + std::to_string(image_.height) + ", " +
         layout_.name() + ")";
}

LightIntegrals ImageEnvironment::integrate(const glm::dmat3& rotation) const {
  const CellGrid grid(image_, layout_, rotation);
  constexpr int maximumRanges = 32;
  const int rowsPerRange = (grid.rowCount() + maximumRanges - 1) / maximumRanges;
  std::vector<LightIntegrals> parts(maximumRanges);
  parallelFor(grid.rowCount(), rowsPerRange, [&](std::size_t begin, std::size_t end) {
    grid.integrateRows(int(begin), int(end), parts[begin / rowsPerRange]);
  });
  LightIntegrals total;
  for (const LightIntegrals& part : parts) total += part;
  return total;
}

}  // namespace haarlight
