#include "oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

namespace haarlight::test {

namespace {

/// Directions of a face's middle, of s and of t: table 8.19 of the OpenGL 4.6 specification.
struct Face {
  glm::dvec3 middle, s, t;
};
constexpr std::array<Face, 6> faces{{{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                     {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                     {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                     {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                     {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}};

/// s or t at the centre of a column or row.
double centerOf(int index) {
  return (index + 0.5) / 16 - 1;
}

/// Direction through s and t of a face, not normalised.
glm::dvec3 directionAt(int face, double s, double t) {
  return faces[face].middle + s * faces[face].s + t * faces[face].t;
}

glm::dvec3 centerDirection(int texel) {
  return directionAt(texel / 1024, centerOf(texel % 32), centerOf(texel / 32 % 32));
}

bool isFloat(double value) {
  return double(float(value)) == value;
}

/// Whether a ≥ b, for values that float32 either holds or keeps apart by a multiple of its
/// rounding. `scale` is the size of the numbers that went into them.
bool isAtLeast(double a, double b, double scale) {
  if (!(isFloat(a) && isFloat(b)) && std::abs(a - b) < 1e-5 * scale)
    throw std::logic_error("rounding may decide a bit: choose numbers of fewer digits");
  return a >= b;
}

struct SeenSphere {
  glm::dvec3 toCenter;
  double distanceSquared, radiusSquared;
  /// Least value of (d sin α)² that the horizon rule takes away.
  double horizonLimit;
};

SeenSphere look(const Sphere& sphere, const glm::dvec3& position, const glm::dvec3& normal) {
  const glm::dvec3 d = glm::dvec3(sphere.center) - position;
  const double height = std::min(0.0, glm::dot(d, normal));
  if (!isFloat(d.x) || !isFloat(d.y) || !isFloat(d.z) || !isFloat(glm::dot(d, d)))
    throw std::logic_error("a distance is rounded: choose numbers of fewer digits");
  return {d, glm::dot(d, d), double(sphere.radius) * sphere.radius, 16 * height * height};
}

/// Face and texel by quotients, which are exact on borders.
std::uint32_t directionTexel(const glm::dvec3& d) {
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const int face = 2 * axis + (d[axis] > 0 ? 0 : 1);
  const double major = glm::dot(d, faces[face].middle);
  const auto index = [&](const glm::dvec3& along) {
    return std::min(31, int(std::floor((glm::dot(d, along) / major + 1) * 16)));
  };
  return std::uint32_t(face * 1024 + index(faces[face].t) * 32 + index(faces[face].s));
}

/// Largest bin with (bin/32)³ ≤ r'² = min(r², 1 − 16 (v·n)²).
std::uint32_t radiusBinOf(const SeenSphere& seen) {
  std::uint32_t bin = 0;
  for (std::uint32_t next = 1; next < 32; ++next) {
    const double bound = next * next * next / 32768.0;
    const double all = seen.distanceSquared;
    if (isAtLeast(seen.radiusSquared, bound * all, all) &&
        isAtLeast((1 - bound) * all, seen.horizonLimit, all))
      bin = next;
  }
  return bin;
}

/// dir·v ≥ cos α with both sides times |c| d and squared.
bool isBlocked(const glm::dvec3& c, const SeenSphere& seen) {
  const double cosineSquared =
      std::max({0.0, seen.distanceSquared - seen.radiusSquared, seen.horizonLimit});
  const double along = glm::dot(c, seen.toCenter), lengthSquared = glm::dot(c, c);
  if (!isAtLeast(along, 0, std::sqrt(seen.distanceSquared))) return false;
  return isAtLeast(along * along, lengthSquared * cosineSquared,
                   lengthSquared * seen.distanceSquared);
}

template <typename Predicate>
BitCube cubeWhere(const Predicate& blocked) {
  BitCube cube;
  for (int texel = 0; texel < 6144; ++texel)
    if (blocked(centerDirection(texel))) cube.rows[texel / 32] |= 1u << texel % 32;
  return cube;
}

/// Σ of a function times the bits of a face, in whole numbers.
template <typename Function>
int sumOver(const BitCube& cube, int face, const Function& function) {
  int sum = 0;
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 32; ++column)
      if (cube.rows[face * 32 + row] >> column & 1) sum += function(row, column);
  return sum;
}

/// The level's square that holds a texel, as row · side + column.
int squareAt(int level, int row, int column) {
  const int size = 32 >> level;
  return row / size * (1 << level) + column / size;
}

/// Sign of Ψ of a type (0: + left, 1: + top, 2: their product) on a texel of its square.
int signAt(int type, int level, int row, int column) {
  const int half = 16 >> level;
  const int horizontal = column / half % 2 ? -1 : 1, vertical = row / half % 2 ? -1 : 1;
  return type == 0 ? horizontal : type == 1 ? vertical : horizontal * vertical;
}

void fillFace(const BitCube& cube, int face, OcclusionHaar& occlusion) {
  occlusion.coefficients[face * 64] =
      float(sumOver(cube, face, [](int, int) { return 1; }) / 1024.0);
  int mean = face * 21, coefficient = face * 64 + 1;
  for (int level = 0; level < 3; ++level)
    for (int square = 0; square < 1 << 2 * level; ++square) {
      const auto within = [&](int row, int column) {
        return squareAt(level, row, column) == square ? 1 : 0;
      };
      const double area = 1024 >> 2 * level, height = 1 << level;
      occlusion.means[mean++] = float(sumOver(cube, face, within) / area);
      for (int type = 0; type < 3; ++type)
        occlusion.coefficients[coefficient++] =
            float(height / 1024 * sumOver(cube, face, [&](int row, int column) {
                    return within(row, column) * signAt(type, level, row, column);
                  }));
    }
}

std::uint16_t blockAt(const BitCube& cube, int block) {
  const int face = block / 64, top = block % 64 / 8 * 4, left = block % 8 * 4;
  int bits = 0;
  for (int i = 0; i < 16; ++i)
    bits |= int(cube.rows[face * 32 + top + i / 4] >> (left + i % 4) & 1) << i;
  return std::uint16_t(bits);
}

/// ∫ ω dω over a texel, by Gauss's rule of 4 × 4 points on the cube, where dω = ds dt / |c|³.
glm::dvec3 momentOf(int texel) {
  constexpr double places[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                               0.8611363115940526};
  constexpr double weights[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                0.3478548451374538};
  glm::dvec3 moment(0);
  for (int i = 0; i < 16; ++i) {
    const glm::dvec3 c = directionAt(texel / 1024, centerOf(texel % 32) + places[i % 4] / 32,
                                     centerOf(texel / 32 % 32) + places[i / 4] / 32);
    const double length = glm::length(c);
    moment += weights[i % 4] * weights[i / 4] / 1024 / (length * length * length * length) * c;
  }
  return moment;
}

const std::vector<glm::dvec3>& moments() {
  static const auto all = [] {
    std::vector<glm::dvec3> result;
    for (int texel = 0; texel < 6144; ++texel) result.push_back(momentOf(texel));
    return result;
  }();
  return all;
}

/// Normal of a tabulated lobe: nodes of a 17 × 17 grid on every face.
glm::dvec3 tabulatedNormal(std::uint32_t lobe) {
  const int face = int(lobe / 289), row = int(lobe / 17 % 17), column = int(lobe % 17);
  return glm::normalize(directionAt(face, column / 8.0 - 1, row / 8.0 - 1));
}

}  // namespace

std::uint32_t oracleTableEntry(const Sphere& sphere, const glm::dvec3& position,
                               const glm::dvec3& normal) {
  const SeenSphere seen = look(sphere, position, normal);
  return directionTexel(seen.toCenter) * 32 + radiusBinOf(seen);
}

BitCube oracleExactBitCube(std::span<const Sphere> spheres, const glm::dvec3& position,
                           const glm::dvec3& normal) {
  BitCube cube;
  for (const Sphere& sphere : spheres) {
    const SeenSphere seen = look(sphere, position, normal);
    cube |= cubeWhere([&](const glm::dvec3& c) { return isBlocked(c, seen); });
  }
  return cube;
}

BitCube oracleTableBitCube(std::span<const std::uint32_t> entries) {
  BitCube cube;
  for (const std::uint32_t entry : entries) {
    const glm::dvec3 v = glm::normalize(centerDirection(int(entry / 32)));
    const double middle = (entry % 32 + 0.5) / 32;  // of the bin; r² is its cube
    const double cosine = std::sqrt(1 - middle * middle * middle);
    cube |= cubeWhere([&](const glm::dvec3& c) {
      const double along = glm::dot(glm::normalize(c), v);
      if (std::abs(along - cosine) < 2e-7)
        throw std::logic_error("rounding may decide a bit of a mask: move the sphere");
      return along >= cosine;
    });
  }
  return cube;
}

OcclusionHaar oracleOcclusion(const BitCube& cube) {
  OcclusionHaar occlusion{};
  for (int face = 0; face < 6; ++face) fillFace(cube, face, occlusion);
  for (int block = 0; block < 384; ++block) occlusion.blocks[block] = blockAt(cube, block);
  return occlusion;
}

OracleRadiance oracleRadiance(const RadianceCube& light, const BitCube& cube,
                              const LobeBlend& lobes) {
  OracleRadiance radiance;
  for (int texel = 0; texel < 6144; ++texel) {
    double lobe = 0;
    for (int i = 0; i < 3; ++i)
      lobe += double(lobes.weights[i]) *
              std::max(0.0, glm::dot(tabulatedNormal(lobes.lobes[i]), moments()[texel]));
    const glm::dvec3 term = lobe / std::numbers::pi * glm::dvec3(light[texel]);
    radiance.unshadowed += term;
    if (!(cube.rows[texel / 32] >> texel % 32 & 1)) radiance.shadowed += term;
  }
  return radiance;
}

}  // namespace haarlight::test
