#include "render/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "base/file.h"
#include "light/load_light.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_measures.h"
#include "mesh/mesh_transform.h"
#include "scene/names.h"
#include "scene/transform.h"
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

void moveSpheres(std::vector<Sphere>& spheres, const glm::mat4& matrix) {
  const float scale = largestScale(matrix);
  for (Sphere& sphere : spheres)
    sphere = {glm::vec3(matrix * glm::vec4(sphere.center, 1)), sphere.radius * scale};
}

bool scalesUniformly(const TransformDescription& transform) {
  const glm::dvec3 scale = glm::abs(transform.scale);
  return scale.x == scale.y && scale.y == scale.z;
}

/// Spheres in world coordinates. A set is made for the mesh as loaded, so that its pose does not
/// matter; where the pose stretches the mesh unevenly, it is made for the mesh as posed.
SphereSet worldSpheres(const ObjectDescription& description, const TriangleMesh& loaded,
                       const TriangleMesh& posed, const glm::mat4& matrix, Scene& scene,
                       const Progress& progress) {
  if (const int* count = std::get_if<int>(&description.spheres)) {
    if (!scalesUniformly(description.transform))
      return fitOrReuse(posed, *count, description.objective, description.name, progress);
    SphereSet set = fitOrReuse(loaded, *count, description.objective, description.name, progress);
    moveSpheres(set.spheres, matrix);
    return set;
  }
  const fs::path& file = std::get<fs::path>(description.spheres);
  SphereSet set = readSphereSet(file);
  if (set.meshHash != meshHash(loaded))
    scene.warnings.push_back(
        fmt::format("{} was made for another mesh than {}", file.string(), description.mesh));
  moveSpheres(set.spheres, matrix);
  return set;
}

SceneObject loadObject(const ObjectDescription& description, double ground, Scene& scene,
                       const Progress& progress) {
  const LoadedMesh loaded = loadMeshOrBuiltin(description.mesh);
  for (const std::string& warning : loaded.warnings)
    scene.warnings.push_back(description.mesh + ": " + warning);
  const glm::mat4 matrix(objectToWorld(description.transform, loaded.mesh.positions, ground));
  SceneObject object{description.name,   transformed(loaded.mesh, matrix), {}, {},
                     description.albedo, description.castsShadow};
  if (description.castsShadow) {
    SphereSet set = worldSpheres(description, loaded.mesh, object.mesh, matrix, scene, progress);
    object.spheres = std::move(set.spheres);
    object.measures = set.measures;
  }
  return object;
}

void loadSceneLight(const LightDescription& description, Scene& scene) {
  const std::string layout = description.layout == "auto" ? "" : description.layout;
  LoadedLight loaded = loadLight(description.source, layout);
  scene.warnings.insert(scene.warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
  const glm::mat3 rotation = yawRotation(description.rotateDegrees);
  const float scale = float(description.scale);
  const LightProjection projection = projectToCube(*loaded.environment, rotation, scale);
  scene.light = {std::move(loaded.environment), rotation, scale, projection};
}

}  // namespace

glm::vec3 SceneLight::radiance(const glm::vec3& direction) const {
  return scale * environment->radiance(glm::transpose(rotation) * direction);
}

std::vector<Sphere> Scene::blockerSpheres() const {
  std::vector<Sphere> all;
  for (const SceneObject& object : objects)
    all.insert(all.end(), object.spheres.begin(), object.spheres.end());
  return all;
}

Scene loadScene(const SceneDescription& description, const Progress& progress) {
  Scene scene;
  scene.receiver = description.receiver;
  const double ground = groundHeight(description);
  for (const ObjectDescription& object : description.objects)
    scene.objects.push_back(loadObject(object, ground, scene, progress));
  loadSceneLight(description.light, scene);
  return scene;
}

}  // namespace haarlight
