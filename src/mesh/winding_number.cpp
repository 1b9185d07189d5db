#include "mesh/winding_number.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "base/parallel.h"
#include "mesh/mesh_measures.h"

namespace haarlight {

namespace {

constexpr std::size_t leafSize = 8;

/// A group is far when the point's distance is this many of its radii.
constexpr float farDistance = 2;

glm::vec3 next(const glm::vec3& v) {
  return {v.y, v.z, v.x};
}
glm::vec3 last(const glm::vec3& v) {
  return {v.z, v.x, v.y};
}

/// Half the solid angle of a triangle seen from the origin, positive from its inner side.
float halfSolidAngle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const float lengthA = glm::length(a), lengthB = glm::length(b), lengthC = glm::length(c);
  return std::atan2(glm::dot(a, glm::cross(b, c)),
                    lengthA * lengthB * lengthC + glm::dot(a, b) * lengthC +
                        glm::dot(b, c) * lengthA + glm::dot(c, a) * lengthB);
}

}  // namespace

struct WindingNumber::Builder {
  explicit Builder(WindingNumber& result) : tree(result) {}

  void addNode(std::size_t begin, std::size_t end) {
    const std::size_t index = tree.nodes_.size();
    Node& node = tree.nodes_.emplace_back();
    node.begin = static_cast<std::uint32_t>(begin);
    node.end = static_cast<std::uint32_t>(end);
    node.leaf = end - begin <= leafSize;
    if (!node.leaf) {
      const std::size_t middle = splitInTwo(begin, end);
      addNode(begin, middle);
      addNode(middle, end);
    }
    tree.nodes_[index].next = static_cast<std::uint32_t>(tree.nodes_.size());
  }

  void measure(Node& node) const {
    const std::span triangles(&tree.triangles_[node.begin], node.end - node.begin);
    glm::dvec3 weighted(0), vectorArea(0);
    double area = 0;
    for (const Triangle& t : triangles) {
      const glm::vec3 own = vectorAreaOf(t);
      vectorArea += own;
      area += glm::length(own);
      weighted += double(glm::length(own)) * glm::dvec3(centerOf(t));
    }
    node.vectorArea = vectorArea;
    node.center = area > 0 ? glm::vec3(weighted / area) : centerOf(triangles[0]);
    addMoments(triangles, node);
  }

  static void addMoments(std::span<const Triangle> triangles, Node& node) {
    float squaredRadius = 0;
    for (const Triangle& t : triangles) {
      const glm::vec3 a = t.a - node.center, b = t.b - node.center, c = t.c - node.center;
      // The mean over the middles of the sides is exact for polynomials of degree two.
      for (const glm::vec3& middle : {(a + b) / 2.0f, (b + c) / 2.0f, (c + a) / 2.0f})
        addPoint(vectorAreaOf(t) / 3.0f, middle, node);
      for (const glm::vec3& corner : {a, b, c})
        squaredRadius = std::max(squaredRadius, glm::dot(corner, corner));
    }
    node.squaredFar = farDistance * farDistance * squaredRadius;
  }

  static void addPoint(const glm::vec3& n, const glm::vec3& d, Node& node) {
    const glm::vec3 dNext = next(d), dLast = last(d), nNext = next(n), nLast = last(n);
    node.squares += n * d;
    node.products += (nNext * dLast + nLast * dNext) / 2.0f;
    node.cubes += n * d * d;
    node.squaresByNext += d * (2.0f * n * dNext + d * nNext) / 3.0f;
    node.squaresByLast += d * (2.0f * n * dLast + d * nLast) / 3.0f;
    node.product += glm::dot(n, dNext * dLast) / 3;
  }

  /// At the median centre along the longest side of the centres' box.
  std::size_t splitInTwo(std::size_t begin, std::size_t end) {
    glm::vec3 lower = centerOf(tree.triangles_[begin]), upper = lower;
    for (std::size_t i = begin; i < end; ++i) {
      lower = glm::min(lower, centerOf(tree.triangles_[i]));
      upper = glm::max(upper, centerOf(tree.triangles_[i]));
    }
    const glm::vec3 size = upper - lower;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return tree.triangles_.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(begin), at(middle), at(end), [axis](const Triangle& s, const Triangle& t) {
      return centerOf(s)[axis] < centerOf(t)[axis];
    });
    return middle;
  }

  static glm::vec3 centerOf(const Triangle& t) { return (t.a + t.b + t.c) / 3.0f; }
  static glm::vec3 vectorAreaOf(const Triangle& t) {
    return glm::cross(t.b - t.a, t.c - t.a) / 2.0f;
  }

  WindingNumber& tree;
};

WindingNumber::WindingNumber(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return;
  const BoundingBox box = boundingBox(mesh);
  const glm::dvec3 size = glm::dvec3(box.upper) - glm::dvec3(box.lower);
  const double largest = std::max({size.x, size.y, size.z});
  origin_ = glm::dvec3(box.lower) + size / 2.0;
  if (largest > 0) scale_ = 1 / largest;
  const auto local = [&](std::uint32_t vertex) {
    return glm::vec3((glm::dvec3(mesh.positions[vertex]) - origin_) * scale_);
  };
  triangles_.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
    triangles_.push_back({local(t.x), local(t.y), local(t.z)});
  nodes_.reserve(4 * triangles_.size() / leafSize);
  Builder builder(*this);
  builder.addNode(0, triangles_.size());
  parallelFor(nodes_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) builder.measure(nodes_[i]);
  });
}

inline float WindingNumber::groupAngle(const Node& node, const glm::vec3& toCenter,
                                       float squaredDistance) const {
  const glm::vec3 r = toCenter, rNext = next(r), rLast = last(r), rr = r * r;
  const float inverseSquare = 1 / squaredDistance;
  const float first =
      node.squares.x + node.squares.y + node.squares.z -
      3 * inverseSquare * (glm::dot(node.squares, rr) + 2 * glm::dot(node.products, rNext * rLast));
  const glm::vec3 trace = node.cubes + last(node.squaresByNext) + next(node.squaresByLast);
  const float cubic = glm::dot(node.cubes, rr * r) + 6 * node.product * r.x * r.y * r.z +
                      3 * glm::dot(node.squaresByNext, rr * rNext) +
                      3 * glm::dot(node.squaresByLast, rr * rLast);
  const float second = inverseSquare * (15 * inverseSquare * cubic - 9 * glm::dot(trace, r)) / 2;
  return (glm::dot(node.vectorArea, r) + first + second) * inverseSquare * std::sqrt(inverseSquare);
}

float WindingNumber::operator()(const glm::vec3& point) const {
  const glm::vec3 from((glm::dvec3(point) - origin_) * scale_);
  float sum = 0;
  for (std::size_t i = 0; i < nodes_.size();) {
    const Node& node = nodes_[i];
    const glm::vec3 toCenter = node.center - from;
    const float squaredDistance = glm::dot(toCenter, toCenter);
    const bool isFar = squaredDistance > node.squaredFar;
    if (isFar) {
      sum += groupAngle(node, toCenter, squaredDistance);
    } else if (node.leaf) {
      for (std::uint32_t k = node.begin; k < node.end; ++k)
        sum += 2 * halfSolidAngle(triangles_[k].a - from, triangles_[k].b - from,
                                  triangles_[k].c - from);
    }
    i = isFar || node.leaf ? node.next : i + 1;
  }
  return sum / (4 * std::numbers::pi_v<float>);
}

}  // namespace haarlight
