#include "report/sky_sheet.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "image/contact_sheet.h"
#include "light/sky_environment.h"

namespace haarlight {

namespace {

/// The three older skies, then the standard's fifteen.
constexpr std::size_t skiesInRow[] = {3, 5, 5, 5};

/// Where a place in the picture, from −1 to 1 to the right and up, looks to; it lies in the circle.
glm::vec3 fisheyeDirection(const glm::dvec2& place) {
  const double radius = glm::length(place), zenithDistance = radius * std::numbers::pi / 2;
  if (radius == 0) return {0, 1, 0};
  const glm::dvec2 side = std::sin(zenithDistance) / radius * place;
  return {side.x, std::cos(zenithDistance), side.y};
}

glm::vec3 pixelOf(const Environment& sky, glm::ivec2 pixel, int side) {
  constexpr int samplesPerSide = 3;
  glm::vec3 sum(0);
  for (int i = 0; i < samplesPerSide * samplesPerSide; ++i) {
    const glm::dvec2 sample =
        (glm::dvec2(i % samplesPerSide, i / samplesPerSide) + 0.5) / double(samplesPerSide);
    const glm::dvec2 place = (glm::dvec2(pixel) + sample) * (2.0 / side) - 1.0;
    if (glm::length(place) > 1) {
      sum += sheetBackground;
    } else {
      const glm::vec3 radiance = sky.radiance(fisheyeDirection({place.x, -place.y}));
      sum += radiance / (2.0f + radiance);
    }
  }
  return sum / float(samplesPerSide * samplesPerSide);
}

Image fisheyePicture(const Environment& sky, int side) {
  Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) image.at(x, y) = pixelOf(sky, {x, y}, side);
  return image;
}

std::string label(const SkyModel& model) {
  return model.name.substr(model.name.find(':') + 1);
}

Image rowOf(std::span<const SkyModel> models, const SkySettings& settings, int side) {
  std::vector<Image> pictures;
  for (const SkyModel& model : models)
    pictures.push_back(fisheyePicture(SkyEnvironment(model, settings), side));
  std::vector<LabelledImage> labelled;
  for (std::size_t i = 0; i < models.size(); ++i)
    labelled.push_back({label(models[i]), pictures[i]});
  return contactSheet(labelled);
}

}  // namespace

Image skySheet(const SkySettings& settings, int side) {
  std::span<const SkyModel> left = skyModels();
  Image sheet;
  for (const std::size_t count : skiesInRow) {
    const Image row = rowOf(left.first(count), settings, side);
    sheet = sheet.width == 0 ? row : stackSheets(sheet, row);
    left = left.subspan(count);
  }
  return sheet;
}

}  // namespace haarlight
