#include "render/object_spheres.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "mesh/mesh_measures.h"
#include "scene/names.h"
#include "spheres/fit_spheres.h"

namespace haarlight {

namespace fs = std::filesystem;

namespace {

fs::path cachedSetFile(const TriangleMesh& mesh, int count, FitObjective objective) {
  const fs::path folder = cacheFolder();
  if (folder.empty()) return {};
  return folder /
         fmt::format("spheres-2-{:016x}-{}-{}.json", meshHash(mesh), nameOf(objective), count);
}

std::optional<SphereSet> readCachedSet(const fs::path& file, const TriangleMesh& mesh) {
  std::error_code error;
  if (file.empty() || !fs::exists(file, error)) return std::nullopt;
  try {
    SphereSet set = readSphereSet(file);
    if (set.meshHash == meshHash(mesh)) return set;
  } catch (const InputError&) {  // a damaged cache file is as good as none
  }
  return std::nullopt;
}

SphereSet fitOrReuse(const TriangleMesh& mesh, int count, FitObjective objective,
                     const std::string& name, const Progress& progress) {
  const fs::path file = cachedSetFile(mesh, count, objective);
  if (auto set = readCachedSet(file, mesh)) return *set;
  SphereFitOptions options;
  options.objective = objective;
  if (progress)
    options.progress = [&](const FitProgress& fit) {
      progress(fmt::format("fitting {} spheres to {}", count, name), fit.finished);
    };
  SphereSet set;
  try {
    set = fitSpheres(mesh, std::size_t(count), options).set;
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what() + ", or set castsShadow to false");
  }
  set.meshName = name;
  try {
    if (!file.empty()) fs::create_directories(file.parent_path());
    if (!file.empty()) writeSphereSet(file, set);
  } catch (const std::exception&) {  // no cache: the next start fits again
  }
  return set;
}

/// Largest factor by which a matrix stretches along one of the mesh's axes.
float largestScale(const glm::mat4& matrix) {
  float scale = 0;
  for (int axis = 0; axis < 3; ++axis)
    scale = std::max(scale, glm::length(glm::vec3(matrix[axis])));
  return scale;
}

bool scalesUniformly(const TransformDescription& transform) {
  const glm::dvec3 scale = glm::abs(transform.scale);
  return scale.x == scale.y && scale.y == scale.z;
}

/// A sphere in its own stead.
SphereSet exactSet(const SphereShape& sphere, const ObjectDescription& description,
                   const TriangleMesh& mesh) {
  SphereSet set;
  set.spheres = {{glm::vec3(0), float(sphere.radius)}};
  set.meshName = description.name;
  set.meshHash = meshHash(mesh);
  set.objective = description.objective;
  set.measures = {1, 0, 0, 0, SilhouetteError{}};
  set.method = "the solid itself";
  return set;
}

}  // namespace

ObjectSpheres spheresOf(const ObjectDescription& description, const ObjectPose& pose,
                        std::vector<std::string>& warnings, const Progress& progress) {
  if (const int* count = std::get_if<int>(&description.spheres)) {
    const auto* sphere =
        description.solid ? std::get_if<SphereShape>(&*description.solid) : nullptr;
    if (sphere) return {exactSet(*sphere, description, pose.local), pose.local};
    const TriangleMesh& mesh = scalesUniformly(description.transform) ? pose.local : pose.world;
    return {fitOrReuse(mesh, *count, description.objective, description.name, progress), mesh};
  }
  const fs::path& file = std::get<fs::path>(description.spheres);
  SphereSet set = readSphereSet(file);
  if (set.meshHash == meshHash(pose.loaded)) return {std::move(set), pose.loaded};
  if (set.meshHash != meshHash(pose.local))
    warnings.push_back(fmt::format("{} was made for another mesh than {}", file.string(),
                                   description.solid ? description.name : description.mesh));
  return {std::move(set), pose.local};
}

std::vector<Sphere> transformed(std::vector<Sphere> spheres, const glm::mat4& matrix) {
  const float scale = largestScale(matrix);
  for (Sphere& sphere : spheres)
    sphere = {glm::vec3(matrix * glm::vec4(sphere.center, 1)), sphere.radius * scale};
  return spheres;
}

}  // namespace haarlight
