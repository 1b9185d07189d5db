#include "report/orthographic_layer.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/scalar_constants.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "base/parallel.h"

namespace haarlight {

namespace {

constexpr std::size_t rowsPerTask = 16;

/// The grid of samples in the view's plane, around the middle of the view.
class Grid {
 public:
  Grid(const OrthographicView& view, int side)
      : side_(side), halfExtent_(view.halfExtent), cell_(2 * view.halfExtent / side) {}

  double x(int column) const { return (column + 0.5) * cell_ - halfExtent_; }
  double y(int row) const { return halfExtent_ - (row + 0.5) * cell_; }
  /// The first column or row beyond a coordinate that grows with them.
  int firstColumnFrom(double x) const { return clamped((x + halfExtent_) / cell_ - 0.5); }
  int firstRowBelow(double y) const { return clamped((halfExtent_ - y) / cell_ - 0.5); }

 private:
  int clamped(double position) const {
    return static_cast<int>(std::ceil(std::clamp(position, 0.0, double(side_))));
  }

  int side_;
  double halfExtent_, cell_;
};

/// Two lamps beside the viewer. `normal`: unit, in the view's axes (z towards the viewer).
glm::vec3 shaded(const glm::vec3& albedo, const glm::vec3& normal) {
  static const glm::vec3 key = glm::normalize(glm::vec3(-0.5f, 0.7f, 0.9f));
  static const glm::vec3 fill = glm::normalize(glm::vec3(0.8f, -0.2f, 0.6f));
  const auto cosine = [&](const glm::vec3& lamp) { return std::max(0.0f, glm::dot(normal, lamp)); };
  return albedo * (0.05f + 0.8f * cosine(key) + 0.2f * cosine(fill));
}

/// Hues a golden angle apart, so that neighbours in the list differ and none comes twice.
glm::vec3 tint(std::size_t index) {
  constexpr float goldenTurn = 0.61803399f;
  glm::vec3 color;
  for (int channel = 0; channel < 3; ++channel) {
    const float turn = static_cast<float>(index % 4096) * goldenTurn - float(channel) / 3;
    color[channel] = 0.6f + 0.2f * std::cos(2 * glm::pi<float>() * turn);
  }
  return color;
}

/// A sphere in the view's axes.
struct ViewedSphere {
  glm::dvec3 center;
  double radius;
};

/// Draws the spheres into rows [begin, end); `depths` holds the nearest hit of each sample so far.
class SpherePainter {
 public:
  SpherePainter(Layer& layer, const OrthographicView& view, int side)
      : layer_(layer),
        grid_(view, side),
        side_(side),
        depths_(layer.size(), -std::numeric_limits<double>::infinity()) {}

  void paint(const ViewedSphere& sphere, const glm::vec3& albedo, int begin, int end) {
    const glm::dvec3& c = sphere.center;
    const int last = std::min(end, grid_.firstRowBelow(c.y - sphere.radius));
    for (int row = std::max(begin, grid_.firstRowBelow(c.y + sphere.radius)); row < last; ++row) {
      const double y = grid_.y(row) - c.y;
      const double halfChord = std::sqrt(std::max(0.0, sphere.radius * sphere.radius - y * y));
      const int columns = grid_.firstColumnFrom(c.x + halfChord);
      for (int column = grid_.firstColumnFrom(c.x - halfChord); column < columns; ++column)
        paintSample(sphere, albedo, {grid_.x(column) - c.x, y}, std::size_t(row) * side_ + column);
    }
  }

 private:
  /// `offset`: of the sample from the sphere's centre.
  void paintSample(const ViewedSphere& sphere, const glm::vec3& albedo, const glm::dvec2& offset,
                   std::size_t sample) {
    const double z =
        std::sqrt(std::max(0.0, sphere.radius * sphere.radius - glm::dot(offset, offset)));
    const double depth = sphere.center.z + z;
    if (depth <= depths_[sample]) return;
    depths_[sample] = depth;
    layer_[sample] = {true, shaded(albedo, glm::vec3(glm::dvec3(offset, z) / sphere.radius))};
  }

  Layer& layer_;
  Grid grid_;
  int side_;
  std::vector<double> depths_;
};

}  // namespace

glm::dvec3 OrthographicView::toViewer() const {
  return glm::cross(right, up);
}

Layer meshLayer(const RayScene& scene, const OrthographicView& view, int side) {
  const Grid grid(view, side);
  const glm::dvec3 toViewer = view.toViewer();
  const glm::dvec3 start = view.center + 4 * view.halfExtent * toViewer;
  const auto inView = [&](const glm::vec3& v) {
    return glm::vec3(glm::dot(glm::dvec3(v), view.right), glm::dot(glm::dvec3(v), view.up),
                     glm::dot(glm::dvec3(v), toViewer));
  };
  Layer layer(std::size_t(side) * side);
  parallelFor(side, rowsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * side; i < end * side; ++i) {
      const int row = static_cast<int>(i / side), column = static_cast<int>(i % side);
      const glm::vec3 origin(start + grid.x(column) * view.right + grid.y(row) * view.up);
      const auto hit = scene.closestHit(origin, glm::vec3(-toViewer));
      if (!hit) continue;
      const float facing = inView(hit->geometricNormal).z < 0 ? -1.0f : 1.0f;
      layer[i] = {true, shaded(glm::vec3(0.7f), facing * inView(hit->shadingNormal))};
    }
  });
  return layer;
}

Layer sphereLayer(std::span<const Sphere> spheres, const OrthographicView& view, int side) {
  std::vector<ViewedSphere> viewed;
  for (const Sphere& sphere : spheres) {
    const glm::dvec3 offset = glm::dvec3(sphere.center) - view.center;
    viewed.push_back({{glm::dot(offset, view.right), glm::dot(offset, view.up),
                       glm::dot(offset, view.toViewer())},
                      sphere.radius});
  }
  Layer layer(std::size_t(side) * side);
  SpherePainter painter(layer, view, side);
  parallelFor(side, rowsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = 0; i < viewed.size(); ++i)
      painter.paint(viewed[i], tint(i), static_cast<int>(begin), static_cast<int>(end));
  });
  return layer;
}

}  // namespace haarlight
