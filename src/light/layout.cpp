#include "light/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "cube/cube_map.h"
#include "light/light_integrals.h"

namespace haarlight {

namespace {

constexpr double pi = std::numbers::pi;

class LatLongLayout final : public Layout {
 public:
  std::string name() const override { return "latlong"; }
  bool fits(int width, int height) const override { return width == 2 * height; }
  std::string requirement() const override { return "twice as wide as high"; }
  glm::dvec2 patchDegrees() const override { return {360, 180}; }

  glm::dvec3 direction(const PatchPoint& point) const override {
    const double longitude = pi * (1 - 2 * point.position.x), polar = pi * point.position.y;
    const double radius = std::sin(polar);
    return {radius * std::sin(longitude), std::cos(polar), radius * std::cos(longitude)};
  }

  PatchPoint locate(const glm::dvec3& d) const override {
    const double longitude = std::atan2(d.x, d.z), polar = std::atan2(std::hypot(d.x, d.z), d.y);
    return {0, {0.5 - longitude / (2 * pi), polar / pi}};
  }

  double solidAngle(glm::dvec2 lower, glm::dvec2 upper) const override {
    return 2 * pi * (upper.x - lower.x) * (std::cos(pi * lower.y) - std::cos(pi * upper.y));
  }
};

/// One face of a cube in a cross: the cell it lies in and its axes in the picture.
struct CrossFace {
  glm::ivec2 cell;
  glm::dvec3 center, right, up;
};

constexpr glm::dvec3 axisX{1, 0, 0}, axisY{0, 1, 0}, axisZ{0, 0, 1};

class CrossLayout final : public Layout {
 public:
  CrossLayout(std::string name, glm::ivec2 cells, const CrossFace& back)
      : name_(std::move(name)), cells_(cells), faces_{CrossFace{{1, 0}, axisY, axisX, axisZ},
                                                      CrossFace{{0, 1}, -axisX, -axisZ, axisY},
                                                      CrossFace{{1, 1}, -axisZ, axisX, axisY},
                                                      CrossFace{{2, 1}, axisX, axisZ, axisY},
                                                      CrossFace{{1, 2}, -axisY, axisX, -axisZ},
                                                      back} {}

  std::string name() const override { return name_; }
  bool fits(int width, int height) const override {
    return width % cells_.x == 0 && width / cells_.x * cells_.y == height;
  }
  std::string requirement() const override {
    return std::to_string(cells_.x) + " by " + std::to_string(cells_.y) + " square faces";
  }
  int patchCount() const override { return int(faces_.size()); }
  glm::ivec2 patchSize(glm::ivec2 picture) const override { return picture / cells_; }
  glm::ivec2 patchOrigin(int patch, glm::ivec2 picture) const override {
    return faces_[patch].cell * patchSize(picture);
  }
  /// At a face's centre an angle is 2/(π/2) times as large as on average.
  glm::dvec2 patchDegrees() const override { return {115, 115}; }

  glm::dvec3 direction(const PatchPoint& point) const override {
    const CrossFace& face = faces_[point.patch];
    const double a = 2 * point.position.x - 1, b = 1 - 2 * point.position.y;
    return glm::normalize(face.center + a * face.right + b * face.up);
  }

  PatchPoint locate(const glm::dvec3& d) const override {
    const auto face = std::max_element(
        faces_.begin(), faces_.end(), [&](const CrossFace& first, const CrossFace& second) {
          return glm::dot(first.center, d) < glm::dot(second.center, d);
        });
    const double depth = glm::dot(face->center, d);
    const double a = glm::dot(face->right, d) / depth, b = glm::dot(face->up, d) / depth;
    return {int(face - faces_.begin()), {(a + 1) / 2, (1 - b) / 2}};
  }

  double solidAngle(glm::dvec2 lower, glm::dvec2 upper) const override {
    return faceRectangleSolidAngle(2 * lower.x - 1, 2 * upper.x - 1, 2 * lower.y - 1,
                                   2 * upper.y - 1);
  }

 private:
  std::string name_;
  glm::ivec2 cells_;
  std::array<CrossFace, 6> faces_;
};

class AngularLayout final : public Layout {
 public:
  std::string name() const override { return "angular"; }
  bool fits(int width, int height) const override { return width == height; }
  std::string requirement() const override { return "square"; }
  glm::dvec2 patchDegrees() const override { return {360, 360}; }

  glm::dvec3 direction(const PatchPoint& point) const override {
    const glm::dvec2 place = centered(point.position);
    const double radius = glm::length(place);
    if (radius >= 1) return axisZ;
    if (radius == 0) return -axisZ;
    const double factor = std::sin(pi * radius) / radius;
    return {factor * place.x, factor * place.y, -std::cos(pi * radius)};
  }

  PatchPoint locate(const glm::dvec3& d) const override {
    const double side = std::hypot(d.x, d.y);
    if (side == 0) return {0, d.z < 0 ? glm::dvec2(0.5, 0.5) : glm::dvec2(1, 0.5)};
    const double factor = std::atan2(side, -d.z) / pi / side;
    return {0, {(1 + factor * d.x) / 2, (1 - factor * d.y) / 2}};
  }

  bool covers(glm::dvec2 position) const override { return glm::length(centered(position)) < 1; }

  double solidAngle(glm::dvec2 lower, glm::dvec2 upper) const override {
    const auto corner = [&](double x, double y) { return direction({0, {x, y}}); };
    return haarlight::solidAngle({corner(lower.x, lower.y), corner(upper.x, lower.y),
                                  corner(upper.x, upper.y), corner(lower.x, upper.y)});
  }

 private:
  /// x to the right and y up, from −1 to 1.
  static glm::dvec2 centered(glm::dvec2 position) {
    return {2 * position.x - 1, 1 - 2 * position.y};
  }
};

std::array<const Layout*, 4> allLayouts() {
  static const LatLongLayout latLong;
  static const CrossLayout vertical("vcross", {3, 4}, {{1, 3}, axisZ, axisX, -axisY});
  static const CrossLayout horizontal("hcross", {4, 3}, {{3, 1}, axisZ, -axisX, axisY});
  static const AngularLayout angular;
  return {&latLong, &vertical, &horizontal, &angular};
}

std::string listOfLayouts() {
  std::string list;
  for (const Layout* layout : allLayouts())
    list += (list.empty() ? "" : ", ") + layout->name() + " (" + layout->requirement() + ")";
  return list;
}

}  // namespace

bool Layout::covers(glm::dvec2 position) const {
  return position.x >= 0 && position.x <= 1 && position.y >= 0 && position.y <= 1;
}

const Layout& chooseLayout(const std::string& name, glm::ivec2 picture) {
  const std::string size = std::to_string(picture.x) + "×" + std::to_string(picture.y) + " pixels";
  for (const Layout* layout : allLayouts()) {
    const bool fits = layout->fits(picture.x, picture.y);
    if (name.empty() ? fits : name == layout->name()) {
      if (fits) return *layout;
      throw InputError("a light of " + size + " cannot have the layout " + name + ", which is " +
                       layout->requirement());
    }
  }
  if (name.empty())
    throw InputError("a light of " + size + " has no known layout: " + listOfLayouts());
  throw InputError("there is no light layout \"" + name + "\": " + listOfLayouts());
}

}  // namespace haarlight
