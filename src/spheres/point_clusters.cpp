#include "spheres/point_clusters.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "base/parallel.h"
#include "mesh/random.h"

namespace haarlight {

namespace {

constexpr int rounds = 5;

float squaredDistance(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 d = a - b;
  return glm::dot(d, d);
}

std::vector<glm::vec3> farthestPoints(std::span<const glm::vec3> points, std::size_t count,
                                      std::uint64_t seed) {
  std::vector<float> distances(points.size(), std::numeric_limits<float>::max());
  std::vector<glm::vec3> chosen;
  std::size_t next = Random(seed).next() % points.size();
  while (chosen.size() < count) {
    chosen.push_back(points[next]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      distances[i] = std::min(distances[i], squaredDistance(points[i], chosen.back()));
      if (distances[i] > distances[next]) next = i;
    }
  }
  return chosen;
}

void assign(std::span<const glm::vec3> points, std::span<const glm::vec3> centers,
            std::vector<std::uint32_t>& groups) {
  parallelFor(points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto nearest = std::min_element(
          centers.begin(), centers.end(), [&](const glm::vec3& a, const glm::vec3& b) {
            return squaredDistance(points[i], a) < squaredDistance(points[i], b);
          });
      groups[i] = static_cast<std::uint32_t>(nearest - centers.begin());
    }
  });
}

void moveToMeans(std::span<const glm::vec3> points, std::span<const std::uint32_t> groups,
                 std::vector<glm::vec3>& centers) {
  std::vector<glm::dvec3> sums(centers.size(), glm::dvec3(0));
  std::vector<double> counts(centers.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    sums[groups[i]] += glm::dvec3(points[i]);
    ++counts[groups[i]];
  }
  for (std::size_t g = 0; g < centers.size(); ++g)
    if (counts[g] > 0) centers[g] = glm::vec3(sums[g] / counts[g]);
}

}  // namespace

std::vector<std::uint32_t> clusterPoints(std::span<const glm::vec3> points, std::size_t count,
                                         std::uint64_t seed) {
  std::vector<std::uint32_t> groups(points.size());
  if (points.empty()) return groups;
  std::vector<glm::vec3> centers = farthestPoints(points, count, seed);
  for (int round = 0; round < rounds; ++round) {
    assign(points, centers, groups);
    moveToMeans(points, groups, centers);
  }
  assign(points, centers, groups);
  return groups;
}

}  // namespace haarlight
