#include "verify/cases/random_spheres.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "visibility/sphere_bin.h"

// The order in which numbers are drawn must be the same with every compiler. So no expression draws
// twice, but for braces, which C++ evaluates from left to right; and only IEEE-exact operations are
// used.

namespace haarlight::verify {

namespace {

float dot(const glm::vec3& a, const glm::vec3& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

float lengthOf(const glm::vec3& v) {
  return std::sqrt(dot(v, v));
}

/// Moves a positive number by at most 3 steps of float32.
float nudged(float value, PortableRandom& random) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) + std::uint32_t(random.below(7)) -
                              3);
}

/// Between 2^low and 2^high, all magnitudes alike.
float anyMagnitude(PortableRandom& random, int low, int high) {
  const float significand = random.uniform(1, 2);
  return std::ldexp(significand, low + random.below(high - low));
}

float randomSign(PortableRandom& random) {
  return random.below(2) ? 1.0f : -1.0f;
}

/// ½, 1, … 8.
float shortLength(PortableRandom& random) {
  return std::ldexp(1.0f, random.below(5) - 1);
}

/// A vector to a sphere's centre at an everyday distance.
glm::vec3 everydayVector(PortableRandom& random) {
  const float distance = random.uniform(0.05f, 5);
  return distance * randomDirection(random);
}

Sphere tinySphere(PortableRandom& random, const Viewpoint& view) {
  const glm::vec3 toCenter = everydayVector(random);
  return {view.position + toCenter, anyMagnitude(random, -40, -10)};
}

Sphere grazingSphere(PortableRandom& random, const Viewpoint& view) {
  const glm::vec3 center = view.position + everydayVector(random);
  return {center, nudged(lengthOf(center - view.position), random)};
}

/// sin²α = 1 − (c·v)², c the direction of a texel's centre.
Sphere sphereWithRimThroughTexel(PortableRandom& random, const Viewpoint& view) {
  const auto texel = glm::vec3(texelDirection(random.below(texelCount)));
  const glm::vec3 toCenter = everydayVector(random);
  const float along = dot(texel, toCenter);
  const glm::vec3 center = along < 0 ? view.position - toCenter : view.position + toCenter;
  const float radiusSquared = dot(toCenter, toCenter) - along * along;
  return {center, nudged(std::sqrt(std::max(radiusSquared, 1e-8f)), random)};
}

Sphere sphereOnTangentPlane(PortableRandom& random, const Viewpoint& view) {
  const glm::vec3 center = view.position + everydayVector(random);
  const float height = dot(center - view.position, view.normal);
  return {center, nudged(std::max(std::abs(height), 1e-3f), random)};
}

/// Sines of the depth are 0 … 0.3; the horizon rule ends at ¼.
Sphere sphereBelowHorizon(PortableRandom& random, const Viewpoint& view) {
  const glm::vec3 any = randomDirection(random);
  const glm::vec3 sideways = any - dot(any, view.normal) * view.normal;
  const glm::vec3 tangent = sideways / std::max(lengthOf(sideways), 1e-6f);
  const float sine = random.below(2) ? nudged(0.25f, random) : random.uniform(0, 0.3f);
  const float distance = random.uniform(0.1f, 5);
  const float cosine = std::sqrt(1 - sine * sine);
  const glm::vec3 toCenter = distance * (cosine * tangent - sine * view.normal);
  return {view.position + toCenter, distance * random.uniform(0.2f, 3)};
}

Sphere sphereAroundSample(PortableRandom& random, const Viewpoint& view) {
  const float radius = random.uniform(0.1f, 2);
  const float distance = radius * random.uniform(0.001f, 1);
  return {view.position + distance * randomDirection(random), radius};
}

Sphere sphereAtSample(PortableRandom& random, const Viewpoint& view) {
  return {view.position, random.uniform(0.1f, 2)};
}

/// Up to 2⁵⁰, about 10¹⁵: as the ground, beside the sample, or around it.
Sphere hugeSphere(PortableRandom& random, const Viewpoint& view) {
  const float distance = anyMagnitude(random, 13, 50);
  const bool isGround = random.below(3) == 0;
  const glm::vec3 direction = isGround ? -view.normal : randomDirection(random);
  const float radius =
      random.below(2) ? nudged(distance, random) : distance * random.uniform(0.001f, 2);
  return {view.position + distance * direction, radius};
}

/// The square of the distance or of the radius is infinite, not both: their difference is a number.
Sphere overflowingSphere(PortableRandom& random, const Viewpoint& view) {
  if (random.below(2))
    return {view.position + everydayVector(random), anyMagnitude(random, 64, 100)};
  const float distance = anyMagnitude(random, 65, 67);
  return {view.position + distance * randomDirection(random), random.uniform(1, 1e5f)};
}

/// Sums of two or three squares overflow, or do not.
Sphere almostOverflowingSphere(PortableRandom& random, const Viewpoint& view) {
  const float distance = anyMagnitude(random, 63, 65);
  return {view.position + distance * randomDirection(random), random.uniform(1, 1e5f)};
}

using SphereMaker = Sphere (*)(PortableRandom&, const Viewpoint&);

Sphere sphereAlongAxis(PortableRandom& random, const Viewpoint& view) {
  const float distance = shortLength(random);
  return {view.position + distance * randomAxis(random), distance * random.uniform(0.01f, 1.2f)};
}

glm::vec3 randomEdge(PortableRandom& random) {
  glm::vec3 edge{randomSign(random), randomSign(random), randomSign(random)};
  edge[random.below(3)] = 0;
  return edge;
}

Sphere sphereAlongEdge(PortableRandom& random, const Viewpoint& view) {
  const float scale = shortLength(random);
  return {view.position + scale * randomEdge(random), scale * random.uniform(0.01f, 1.6f)};
}

Sphere sphereAlongCorner(PortableRandom& random, const Viewpoint& view) {
  const glm::vec3 corner{randomSign(random), randomSign(random), randomSign(random)};
  const float scale = shortLength(random);
  return {view.position + scale * corner, scale * random.uniform(0.01f, 2)};
}

/// At s and t of whole 32nds: even ones are borders of texels, odd ones centres.
Sphere sphereAlongTexelPlace(PortableRandom& random, const Viewpoint& view, int parity) {
  const int face = random.below(faceCount);
  const double s = (2 * random.below(faceSize) + parity - faceSize) / double(faceSize);
  const double t = (2 * random.below(faceSize) + parity - faceSize) / double(faceSize);
  const float scale = shortLength(random);
  return {view.position + scale * glm::vec3(cubeDirection({face, s, t})),
          scale * random.uniform(0.001f, 1.2f)};
}

Sphere sphereAlongTexelBorder(PortableRandom& random, const Viewpoint& view) {
  return sphereAlongTexelPlace(random, view, 0);
}

Sphere sphereAlongTexelCenter(PortableRandom& random, const Viewpoint& view) {
  return sphereAlongTexelPlace(random, view, 1);
}

/// R² = (bin/32)³ d² has roots of few digits where bin = 2 q², d a whole number, R = q³ d / 64, and
/// where bin = q² and d = √2 e, R = q³ e / 128.
Sphere sphereOnBinBound(PortableRandom& random, const Viewpoint& view) {
  const float scale = shortLength(random);
  if (random.below(2)) {
    const auto q = float(1 + random.below(3));
    return {view.position + scale * randomAxis(random), q * q * q * scale / 64};
  }
  const auto q = float(1 + random.below(5));
  return {view.position + scale * randomEdge(random), q * q * q * scale / 128};
}

Sphere sphereNearBinBound(PortableRandom& random, const Viewpoint& view) {
  const glm::vec3 center = view.position + everydayVector(random);
  const float bound = radiusBinBound(1 + random.below(radiusBins - 1));
  return {center, nudged(std::sqrt(bound) * lengthOf(center - view.position), random)};
}

double lengthSquared(const glm::dvec3& v) {
  return (v.x * v.x + v.y * v.y) + v.z * v.z;
}

Sphere smallSphereWithExactRim(PortableRandom& random, const glm::vec3& normal) {
  glm::dvec3 texel = texelDirection(random.below(texelCount));
  if (dot(glm::vec3(texel), normal) < 0) texel = -texel;  // the centre of a texel too
  const float distance = random.uniform(0.5f, 4);
  const glm::vec3 aside = 0.1f * randomDirection(random);
  const glm::dvec3 center(distance * (glm::vec3(texel) + aside));
  const double along = (center.x * texel.x + center.y * texel.y) + center.z * texel.z;
  const double radiusSquared = lengthSquared(center) - along * along;
  return {center, float(std::sqrt(std::max(radiusSquared, 1e-8)))};
}

Sphere smallSphereOnExactBinBound(PortableRandom& random) {
  const glm::dvec3 center(everydayVector(random));
  const double bound = radiusBinBound(1 + random.below(8));
  return {center, float(std::sqrt(bound * lengthSquared(center)))};
}

constexpr SphereMaker anyMakers[] = {
    ordinarySphere,     ordinarySphere, ordinarySphere,       tinySphere,
    grazingSphere,      hugeSphere,     sphereOnTangentPlane, sphereBelowHorizon,
    sphereAroundSample, sphereAtSample, sphereNearBinBound,   sphereWithRimThroughTexel};

constexpr SphereMaker alignedMakers[] = {sphereAlongAxis,        sphereAlongEdge,
                                         sphereAlongCorner,      sphereAlongTexelBorder,
                                         sphereAlongTexelCenter, sphereOnBinBound};

}  // namespace

glm::vec3 randomDirection(PortableRandom& random) {
  glm::vec3 d;
  do {
    d = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  } while (lengthOf(d) < 0.1f || lengthOf(d) > 1);
  return d / lengthOf(d);
}

glm::vec3 randomAxis(PortableRandom& random) {
  glm::vec3 axis(0);
  const float sign = randomSign(random);
  axis[random.below(3)] = sign;
  return axis;
}

Sphere anySphere(PortableRandom& random, const Viewpoint& view) {
  if (random.below(150) == 0) return overflowingSphere(random, view);
  return anyMakers[random.below(std::size(anyMakers))](random, view);
}

Sphere alignedSphere(PortableRandom& random, const Viewpoint& view) {
  return alignedMakers[random.below(std::size(alignedMakers))](random, view);
}

Sphere smallSphereOnBound(PortableRandom& random, const glm::vec3& normal) {
  return random.below(2) ? smallSphereWithExactRim(random, normal)
                         : smallSphereOnExactBinBound(random);
}

Sphere denormalSphere(PortableRandom& random) {
  const float distance = anyMagnitude(random, -133, -60);
  const glm::vec3 center =
      distance * (random.below(2) ? randomAxis(random) : randomDirection(random));
  switch (random.below(3)) {
    case 0:
      return {center, nudged(distance, random)};
    case 1:
      return {center, anyMagnitude(random, -133, -60)};
    default:
      return {center, random.uniform(0.1f, 2)};
  }
}

Sphere ordinarySphere(PortableRandom& random, const Viewpoint& view) {
  const glm::vec3 toCenter = everydayVector(random);
  return {view.position + toCenter, random.uniform(0.05f, 1.5f)};
}

Sphere farSphere(PortableRandom& random, const Viewpoint& view) {
  switch (random.below(4)) {
    case 0:
      return hugeSphere(random, view);
    case 1:
      return overflowingSphere(random, view);
    default:
      return almostOverflowingSphere(random, view);
  }
}

}  // namespace haarlight::verify
