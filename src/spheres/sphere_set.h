#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/fit_objective.h"
#include "visibility/sphere.h"

namespace haarlight {

/// How far the outline of a sphere set is from that of its mesh, as parts of the solid angle of the
/// mesh: the solid angle where exactly one of "a sphere blocks" and "the mesh blocks" holds.
struct SilhouetteError {
  double mean = 0;   ///< over all viewpoints
  double worst = 0;  ///< over all viewpoints
  double over = 0;   ///< mean of the part that only the spheres block
  double under = 0;  ///< mean of the part that only the mesh blocks; mean = over + under
};

/// How well spheres stand in for a mesh. Volumes are parts of the mesh's volume, and none when the
/// mesh encloses no volume.
struct SphereMeasures {
  /// Part of the mesh's surface that lies in a sphere, 0 … 1.
  double coveredFraction = 0;
  /// E = Σ V(S_i − T) / V(T) (Wang et al. 2006). Overlaps count once per sphere.
  std::optional<double> outsideVolumeRatio;
  /// V(∪S_i − T) / V(T): what the set as a whole blocks too much.
  std::optional<double> unionOutsideRatio;
  /// V(T − ∪S_i) / V(T): what it leaves out.
  std::optional<double> uncoveredVolumeRatio;
  /// None in sets written before format version 2.
  std::optional<SilhouetteError> silhouette;
};

/// Spheres that stand in for a mesh as a blocker of light, in the mesh's own coordinates.
struct SphereSet {
  std::vector<Sphere> spheres;
  std::string meshName;
  std::uint64_t meshHash = 0;  ///< meshHash() of the mesh they were made for
  FitObjective objective = FitObjective::cover;
  SphereMeasures measures;
  std::string method;      ///< how the spheres were found
  std::uint64_t seed = 0;  ///< of the random numbers in that
};

constexpr std::size_t maximumSphereCount = 65536;

/// Reads the JSON file that writeSphereSet writes, of format version 1 or 2. Throws InputError that
/// names the field when one is missing, has the wrong type or a value out of its range.
SphereSet readSphereSet(const std::filesystem::path& path);

/// Writes JSON: format, version, mesh (name, hash as hex digits), objective, method, seed,
/// measures, spheres (center, radius). Every float comes back exactly. Throws InputError when the
/// file cannot be written.
void writeSphereSet(const std::filesystem::path& path, const SphereSet& set);

}  // namespace haarlight
