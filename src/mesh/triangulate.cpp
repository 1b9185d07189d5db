#include "mesh/triangulate.h"

#include <glm/geometric.hpp>
#include <numeric>

namespace haarlight {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Newell's method: twice the area of the polygon's projections, also for one that is not flat.
glm::dvec3 areaVector(std::span<const glm::vec3> points) {
  glm::dvec3 sum(0);
  const glm::dvec3 origin = points[0];
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += glm::cross(glm::dvec3(points[i]) - origin,
                      glm::dvec3(points[(i + 1) % points.size()]) - origin);
  return sum;
}

class EarCutter {
 public:
  explicit EarCutter(std::span<const glm::vec3> points)
      : points_(points), normal_(areaVector(points)), remaining_(points.size()) {
    std::iota(remaining_.begin(), remaining_.end(), 0u);
  }

  std::vector<Triangle> run() {
    std::vector<Triangle> triangles;
    while (remaining_.size() > 3) {
      const std::size_t ear = findEar();
      triangles.push_back(around(ear));
      remaining_.erase(remaining_.begin() + std::ptrdiff_t(ear));
    }
    triangles.push_back({remaining_[0], remaining_[1], remaining_[2]});
    return triangles;
  }

 private:
  Triangle around(std::size_t at) const {
    const std::size_t count = remaining_.size();
    return {remaining_[(at + count - 1) % count], remaining_[at], remaining_[(at + 1) % count]};
  }

  double side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const glm::dvec3 origin = points_[a];
    return glm::dot(normal_,
                    glm::cross(glm::dvec3(points_[b]) - origin, glm::dvec3(points_[c]) - origin));
  }

  bool isEar(const Triangle& t) const {
    if (side(t[0], t[1], t[2]) <= 0) return false;
    for (const std::uint32_t p : remaining_) {
      if (p == t[0] || p == t[1] || p == t[2]) continue;
      if (side(t[0], t[1], p) >= 0 && side(t[1], t[2], p) >= 0 && side(t[2], t[0], p) >= 0)
        return false;
    }
    return true;
  }

  std::size_t findEar() const {
    for (std::size_t at = 1; at <= remaining_.size(); ++at)
      if (isEar(around(at % remaining_.size()))) return at % remaining_.size();
    return 1;
  }

  std::span<const glm::vec3> points_;
  glm::dvec3 normal_;
  std::vector<std::uint32_t> remaining_;
};

}  // namespace

std::vector<Triangle> triangulatePolygon(std::span<const glm::vec3> points) {
  if (points.size() < 3) return {};
  return EarCutter(points).run();
}

}  // namespace haarlight
