#include "report/fit_pictures.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "image/tonemap.h"
#include "mesh/mesh_measures.h"
#include "report/orthographic_layer.h"
#include "spheres/unit_frame.h"

namespace haarlight {

namespace {

constexpr int samplesPerSide = 2;  ///< of a pixel
constexpr double margin = 1.04;    ///< around what is seen

struct Side {
  const char* name;
  glm::dvec3 right, up;
};
constexpr std::array sides{Side{"front", {1, 0, 0}, {0, 1, 0}}, Side{"side", {0, 0, -1}, {0, 1, 0}},
                           Side{"top", {1, 0, 0}, {0, 0, -1}}};

glm::vec3 linearColor(Silhouette silhouette) {
  const glm::vec3 encoded = glm::vec3(silhouetteColor(silhouette)) / 255.0f;
  return {linearFromSrgb(encoded.r), linearFromSrgb(encoded.g), linearFromSrgb(encoded.b)};
}

Silhouette silhouetteOf(const LayerSample& mesh, const LayerSample& sphere) {
  if (mesh.hit) return sphere.hit ? Silhouette::both : Silhouette::meshOnly;
  return sphere.hit ? Silhouette::spheresOnly : Silhouette::neither;
}

/// A view of the middle of mesh and spheres that shows all of them from every side.
OrthographicView viewOfAll(const TriangleMesh& mesh, std::span<const Sphere> spheres) {
  const BoundingBox box = boundingBox(mesh);
  glm::dvec3 lower = box.lower, upper = box.upper;
  for (const Sphere& sphere : spheres) {
    const glm::dvec3 center = sphere.center, radius(sphere.radius);
    lower = glm::min(lower, center - radius);
    upper = glm::max(upper, center + radius);
  }
  const glm::dvec3 half = (upper - lower) / 2.0;
  return {.center = (lower + upper) / 2.0,
          .halfExtent = margin * std::max({half.x, half.y, half.z})};
}

/// Each pixel is the mean over its samples of color(sample's index in a layer).
template <typename Color>
Image imageOf(int size, const Color& color) {
  Image image(size, size);
  const int side = size * samplesPerSide;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      image.at(x / samplesPerSide, y / samplesPerSide) +=
          color(std::size_t(y) * side + x) / float(samplesPerSide * samplesPerSide);
  return image;
}

Image imageOf(int size, const Layer& layer) {
  const glm::vec3 background = linearColor(Silhouette::neither);
  return imageOf(size, [&](std::size_t i) { return layer[i].hit ? layer[i].color : background; });
}

FitView viewOf(const char* name, const Layer& mesh, const Layer& spheres, int size) {
  std::array<std::size_t, 4> counts{};
  std::array<glm::vec3, 4> colors;
  for (int i = 0; i < 4; ++i) colors[i] = linearColor(Silhouette(i));
  FitView view{name, imageOf(size, mesh), imageOf(size, spheres), {}};
  view.silhouettes = imageOf(size, [&](std::size_t i) {
    const auto silhouette = std::size_t(silhouetteOf(mesh[i], spheres[i]));
    ++counts[silhouette];
    return colors[silhouette];
  });
  const auto count = [&](Silhouette silhouette) { return double(counts[std::size_t(silhouette)]); };
  const double meshArea = std::max(1.0, count(Silhouette::both) + count(Silhouette::meshOnly));
  view.over = count(Silhouette::spheresOnly) / meshArea;
  view.under = count(Silhouette::meshOnly) / meshArea;
  return view;
}

}  // namespace

glm::ivec3 silhouetteColor(Silhouette silhouette) {
  switch (silhouette) {
    case Silhouette::both:
      return {92, 96, 104};
    case Silhouette::spheresOnly:
      return {226, 120, 28};
    case Silhouette::meshOnly:
      return {28, 104, 208};
    case Silhouette::neither:
      break;
  }
  return {214, 214, 210};
}

FitPictures drawFit(const TriangleMesh& mesh, std::span<const Sphere> spheres, int size) {
  const UnitFrame frame(mesh);  // rays are float32
  const TriangleMesh unitMesh = frame.toUnit(mesh);
  const std::vector<Sphere> unitSpheres = frame.toUnit(spheres);
  const RayScene scene(unitMesh);
  OrthographicView view = viewOfAll(unitMesh, unitSpheres);
  FitPictures pictures;
  pictures.pixelsPerUnit = size / (2 * view.halfExtent) * frame.scale();
  const int side = size * samplesPerSide;
  for (const Side& direction : sides) {
    view.right = direction.right;
    view.up = direction.up;
    pictures.views.push_back(viewOf(direction.name, meshLayer(scene, view, side),
                                    sphereLayer(unitSpheres, view, side), size));
  }
  return pictures;
}

}  // namespace haarlight
