#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "visibility/sphere.h"

namespace haarlight {

/// How well spheres stand in for a mesh.
struct SphereMeasures {
  /// Part of the mesh's surface that lies in a sphere, 0 … 1.
  double coveredFraction = 0;
  /// E = Σ V(sphere outside the mesh) / V(mesh) (Wang et al. 2006); none when the mesh encloses no
  /// volume. Overlaps count once per sphere.
  std::optional<double> outsideVolumeRatio;
};

/// Spheres that stand in for a mesh as a blocker of light, in the mesh's own coordinates.
struct SphereSet {
  std::vector<Sphere> spheres;
  std::string meshName;
  std::uint64_t meshHash = 0;  ///< meshHash() of the mesh they were made for
  SphereMeasures measures;
  std::string method;      ///< how the spheres were found
  std::uint64_t seed = 0;  ///< of the random numbers in that
};

constexpr std::size_t maximumSphereCount = 65536;

/// Reads the JSON file that writeSphereSet writes. Throws InputError that names the field when one
/// is missing, has the wrong type or a value out of its range.
SphereSet readSphereSet(const std::filesystem::path& path);

/// Writes JSON: format, version, mesh (name, hash as hex digits), method, seed, measures, spheres
/// (center, radius). Every float comes back exactly. Throws InputError when the file cannot be
/// written.
void writeSphereSet(const std::filesystem::path& path, const SphereSet& set);

}  // namespace haarlight
