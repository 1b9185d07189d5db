#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/mesh_measures.h"

namespace haarlight {

/// Places from which receivers look at an object: in all directions alike, at distances from its
/// bounding box's centre that are spread evenly between two multiples of half the box's diagonal.
struct ViewpointRange {
  double nearest = 1.1;
  double farthest = 4;
};

/// `count` viewpoints: directions on a spherical Fibonacci lattice turned by `seed`, distances by
/// the golden ratio, so that any part of the directions has all distances.
std::vector<glm::dvec3> viewpointsAround(const BoundingBox& box, std::size_t count,
                                         std::uint64_t seed, const ViewpointRange& range = {});

/// A right-handed basis whose third column is the unit vector (Duff et al. 2017).
glm::dmat3 basisAround(const glm::dvec3& z);

/// `count` unit vectors spread evenly over the cap of directions whose cosine with `axis` is at
/// least `cosine`, on a Fibonacci lattice turned by `turn`, 0 … 1.
std::vector<glm::dvec3> directionsInCap(const glm::dvec3& axis, double cosine, std::size_t count,
                                        double turn);

}  // namespace haarlight
