#include "motion/deformers.h"

#include <cmath>
#include <glm/trigonometric.hpp>
#include <stdexcept>

namespace haarlight {

namespace {

/// sin(x) / x, which needs no series near 0: there sin(x) is x to the last bit.
double sinc(double x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

/// 1 − cos(x) without cancellation.
double versine(double x) {
  const double sine = std::sin(x / 2);
  return 2 * sine * sine;
}

/// Where points lie relative to the middle of a box, and how high along one of its axes.
class BoxFrame {
 public:
  BoxFrame(const BoundingBox& box, int axis)
      : middle_((glm::dvec3(box.lower) + glm::dvec3(box.upper)) / 2.0),
        length_(double(box.upper[axis]) - double(box.lower[axis])),
        axis_(axis) {}

  glm::dvec3 fromMiddle(const glm::vec3& point) const { return glm::dvec3(point) - middle_; }

  /// −½ at the lower end, ½ at the upper; 0 everywhere in a box without length.
  double height(const glm::dvec3& fromMiddle) const {
    return length_ > 0 ? fromMiddle[axis_] / length_ : 0;
  }

 private:
  glm::dvec3 middle_;
  double length_;
  int axis_;
};

/// Adds shift(point, angle) to each point, where the angle is the part of `degrees` at its height.
/// Shifts, and not places, keep points to the bit where nothing happens.
template <typename Shift>
std::vector<glm::vec3> shifted(std::span<const glm::vec3> positions, const BoundingBox& box,
                               Axis axis, double degrees, const Shift& shift) {
  std::vector<glm::vec3> result(positions.begin(), positions.end());
  if (degrees == 0) return result;
  const BoxFrame frame(box, int(axis));
  for (glm::vec3& position : result) {
    const glm::dvec3 point = frame.fromMiddle(position);
    position = glm::dvec3(position) + shift(point, glm::radians(degrees) * frame.height(point));
  }
  return result;
}

}  // namespace

std::vector<glm::vec3> twisted(std::span<const glm::vec3> positions, const BoundingBox& box,
                               Axis axis, double degrees) {
  const int u = (int(axis) + 1) % 3, v = (int(axis) + 2) % 3;
  return shifted(positions, box, axis, degrees, [&](const glm::dvec3& point, double angle) {
    glm::dvec3 shift(0);
    shift[u] = -point[u] * versine(angle) - point[v] * std::sin(angle);
    shift[v] = point[u] * std::sin(angle) - point[v] * versine(angle);
    return shift;
  });
}

std::vector<glm::vec3> bent(std::span<const glm::vec3> positions, const BoundingBox& box, Axis axis,
                            Axis towards, double degrees) {
  if (axis == towards) throw std::invalid_argument("a line cannot be bent towards itself");
  const int along = int(axis), aside = int(towards);
  return shifted(positions, box, axis, degrees, [&](const glm::dvec3& point, double angle) {
    // The arc from the middle to this height has the length point[along] and turns by `angle`; its
    // chord turns by half of that.
    const double chord = point[along] * sinc(angle / 2);
    glm::dvec3 shift(0);
    shift[along] = chord * std::cos(angle / 2) - point[along] - point[aside] * std::sin(angle);
    shift[aside] = chord * std::sin(angle / 2) - point[aside] * versine(angle);
    return shift;
  });
}

}  // namespace haarlight
