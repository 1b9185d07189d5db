#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "app/commands.h"
#include "app/options.h"
#include "app/transfer_json.h"
#include "base/error.h"
#include "base/file.h"
#include "base/parallel.h"
#include "image/read_image.h"
#include "light/builtin_lights.h"
#include "light/light_projection.h"
#include "light/load_light.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_measures.h"
#include "mesh/solid_repair.h"
#include "report/measures_json.h"
#include "scene/names.h"
#include "scene/scene_file.h"
#include "solids/solid_checks.h"
#include "spheres/sphere_measures.h"
#include "spheres/sphere_set.h"
#include "transfer/transfer_file.h"

namespace haarlight {

namespace {

using Json = nlohmann::ordered_json;

template <typename Vector>
Json list(const Vector& v) {
  return {v[0], v[1], v[2]};
}

Json describeMesh(const std::string& name, Console& console) {
  const LoadedMesh loaded = loadMeshOrBuiltin(name);
  for (const std::string& warning : loaded.warnings) console.warning(name + ": " + warning);
  const BoundingBox box = boundingBox(loaded.mesh);
  const MeshTopology& topology = loaded.topology;
  return {{"kind", "mesh"},
          {"vertices", topology.vertices},
          {"triangles", loaded.mesh.triangles.size()},
          {"closed", topology.closed},
          {"parts", topology.components},
          {"boundary_edges", topology.boundaryEdges},
          {"non_manifold_edges", topology.nonManifoldEdges},
          {"lower_corner", list(box.lower)},
          {"upper_corner", list(box.upper)},
          {"surface_area", surfaceArea(loaded.mesh)},
          {"volume", signedVolume(loaded.mesh)},
          {"hash", fmt::format("{:016x}", meshHash(loaded.mesh))}};
}

/// The measures anew, against a mesh, and those of the set grown until it covers 2 million points
/// of the surface and 1 million inside: sets that leave out unequal parts only compare after that.
Json measureSet(const SphereSet& set, const std::string& meshName, Console& console) {
  constexpr std::size_t samples = 1000000;
  const LoadedMesh loaded = loadMeshOrBuiltin(meshName);
  const SolidRepair repair = prepareSolid(loaded.mesh);
  for (const auto* warnings : {&loaded.warnings, &repair.warnings})
    for (const std::string& warning : *warnings) console.warning(meshName + ": " + warning);
  std::vector<glm::vec3> points = sampleSurface(repair.mesh, 2 * samples, 1);
  const std::vector<glm::vec3> interior = sampleInterior(repair.mesh, samples, 2);
  points.insert(points.end(), interior.begin(), interior.end());
  const std::vector<Sphere> grown = grownToCover(set.spheres, points);
  return {
      {"mesh", meshName},
      {"measures", measuresJson(measureSpheres(repair.mesh, set.spheres, samples, 3))},
      {"measures_at_full_coverage", measuresJson(measureSpheres(repair.mesh, grown, samples, 3))}};
}

Json describeSet(const std::string& name, const std::string& mesh, Console& console) {
  const SphereSet set = readSphereSet(name);
  const auto [smallest, largest] = std::ranges::minmax(set.spheres, {}, &Sphere::radius);
  Json info{{"kind", "sphere set"},
            {"spheres", set.spheres.size()},
            {"mesh", set.meshName},
            {"mesh_hash", fmt::format("{:016x}", set.meshHash)},
            {"objective", nameOf(set.objective)},
            {"method", set.method},
            {"seed", set.seed}};
  info.update(measuresJson(set.measures));
  info["smallest_radius"] = smallest.radius;
  info["largest_radius"] = largest.radius;
  if (!mesh.empty()) info["measured_against"] = measureSet(set, mesh, console);
  return info;
}

/// Throws InputError when a mesh is given that the transfer was not computed for.
Json describeTransfer(const std::string& name, const std::string& mesh) {
  const DiffuseTransfer transfer = readTransfer(name);
  if (!mesh.empty()) requireTransferOf(transfer, name, loadMeshOrBuiltin(mesh).mesh, mesh);
  Json info{{"kind", "transfer"}};
  info.update(transferJson(transfer));
  return info;
}

Json describeObject(const ObjectDescription& object) {
  Json info{{"name", object.name}};
  if (object.solid)
    info["solid"] = shapeName(*object.solid);
  else
    info["mesh"] = object.mesh;
  if (object.family) info["family"] = *object.family;
  return info;
}

void addPunctualLights(const SceneDescription& scene, Json& info) {
  for (const PointLightDescription& light : scene.pointLights)
    info["point_light"].push_back(
        {{"position", list(light.position)}, {"intensity", list(light.intensity)}});
  for (const DirectionalLightDescription& light : scene.directionalLights)
    info["directional_light"].push_back(
        {{"towards", list(light.towards)}, {"irradiance", list(light.irradiance)}});
}

Json describeSceneFile(const std::string& name) {
  const SceneDescription scene = readScene(name);
  Json objects = Json::array();
  for (const ObjectDescription& object : scene.objects) objects.push_back(describeObject(object));
  Json info{{"kind", "scene"}, {"objects", scene.objects.size()}};
  if (!objects.empty()) info["object"] = objects;
  if (scene.receiver)
    info["receiver_samples"] =
        fmt::format("{}x{}", scene.receiver->samples.x, scene.receiver->samples.y);
  info["light"] = scene.light.source;
  addPunctualLights(scene, info);
  info["image"] = fmt::format("{}x{}", scene.image.width, scene.image.height);
  info["method"] = nameOf(shadingMethodNames, scene.shading.method);
  info["terms"] = scene.shading.terms;
  info["levels"] = scene.shading.levels;
  if (scene.shading.order) info["order"] = *scene.shading.order;
  return info;
}

/// Power as a light; an image of no light layout has none.
void addLightFigures(const std::string& name, Json& info) {
  try {
    const LoadedLight light = loadLight(name);
    const LightProjection projection = projectToCube(*light.environment);
    info["as_light"] = light.environment->description();
    info["power"] = list(projection.sourcePower);
    info["power_on_the_cube"] = list(projection.cubePower);
    info["power_kept"] = projection.powerRatio;
  } catch (const InputError& error) {
    info["as_light"] = std::string("no: ") + error.what();
  }
}

Json describeImage(const std::string& name, Console& console) {
  const ImageFile file = readImage(name);
  for (const std::string& warning : file.warnings) console.warning(name + ": " + warning);
  glm::vec3 largest(0);
  for (const glm::vec3& pixel : file.image.pixels) largest = glm::max(largest, pixel);
  Json info{{"kind", "image"},
            {"format", file.format},
            {"size", fmt::format("{}x{}", file.image.width, file.image.height)},
            {"channels", file.channels},
            {"largest_values", list(largest)}};
  for (const auto& [key, value] : file.attributes) info["attributes"][key] = value;
  addLightFigures(name, info);
  return info;
}

Json describeBuiltin(const std::string& name, Console& console) {
  const std::vector<std::string> meshes = builtinMeshNames(), lights = builtinLightNames();
  if (std::ranges::find(builtinScenes, name) != builtinScenes.end()) return describeSceneFile(name);
  if (std::ranges::find(meshes, name) != meshes.end()) return describeMesh(name, console);
  if (std::ranges::find(lights, name) == lights.end())
    throw InputError(fmt::format("there is no {}; built in are {}, {}, {}", name,
                                 fmt::join(builtinScenes, ", "), fmt::join(meshes, ", "),
                                 fmt::join(lights, ", ")));
  Json info{{"kind", "light"}};
  addLightFigures(name, info);
  return info;
}

bool isSphereSet(const std::string& name) {
  const auto bytes = readWholeFile(name, "file", std::uint64_t(64) << 20);
  const auto json = nlohmann::json::parse(bytes, nullptr, false);
  return json.is_object() && json.contains("spheres") && json.contains("format");
}

std::string lowerExtension(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return std::tolower(c); });
  return extension;
}

Json describeFile(const std::string& name, const std::string& mesh, Console& console) {
  if (name.starts_with(builtinPrefix)) return describeBuiltin(name, console);
  const std::string extension = lowerExtension(name);
  if (extension == ".json")
    return isSphereSet(name) ? describeSet(name, mesh, console) : describeSceneFile(name);
  if (extension == ".hdr" || extension == ".exr" || extension == ".pic" || extension == ".rgbe")
    return describeImage(name, console);
  if (extension == ".prt") return describeTransfer(name, mesh);
  return describeMesh(name, console);
}

}  // namespace

void addInfoCommand(CLI::App& app) {
  struct InfoOptions {
    GeneralOptions general;
    std::string file, mesh;
  };
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand(
      "info", "Say what a mesh, light, image, sphere set, transfer or scene file holds");
  command->footer("Example: haarlight info grace.hdr");
  command->add_option("FILE", options->file, "File, or builtin:…")->required();
  command->add_option(
      "--mesh", options->mesh,
      "Measure a sphere set against this mesh, with three million points; check that a "
      "transfer is this mesh's");
  addGeneralOptions(*command, options->general);
  command->callback([options] {
    Console console(options->general.json, options->general.quiet);
    setThreadCount(options->general.threads);
    Json results{{"file", options->file}};
    results.update(describeFile(options->file, options->mesh, console));
    console.results(results);
  });
}

}  // namespace haarlight
