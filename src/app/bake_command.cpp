#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "app/commands.h"
#include "app/frame_rate.h"
#include "app/shading_setup.h"
#include "base/error.h"
#include "base/file.h"
#include "base/parallel.h"
#include "engine/tile_order.h"
#include "scene/names.h"

namespace haarlight {

namespace {

struct BakeOptions {
  GeneralOptions general;
  SceneOptions scene;
  std::string output;
  std::string object;
  std::string size;
  std::vector<std::string> compareTo;
  bool frameRate = false;
};

/// Radiance per texel of the plane, or of a mesh's vertices as one row.
struct Target {
  glm::ivec2 size;
  std::vector<std::uint32_t> texels;   ///< where the samples' radiance goes
  std::vector<SurfaceSample> samples;  ///< in that order
  const SceneObject* object = nullptr;
};

std::size_t findObject(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].name == name) return i;
  std::string names;
  for (const SceneObject& object : scene.objects)
    names += (names.empty() ? "" : ", ") + object.name;
  throw InputError("the scene has no object '" + name + "'; it has " +
                   (names.empty() ? "none" : names));
}

Target bakeTarget(const BakeOptions& options, const Scene& scene) {
  if (!options.object.empty()) {
    const std::size_t object = findObject(scene, options.object);
    auto samples = vertexSamples(scene, object);
    const int count = int(samples.size());
    std::vector<std::uint32_t> texels(samples.size());
    std::iota(texels.begin(), texels.end(), 0u);
    return {{count, 1}, std::move(texels), std::move(samples), &scene.objects[object]};
  }
  if (!scene.receiver)
    throw InputError("the scene has no receiver plane to bake; name an object with --object");
  const glm::ivec2 size = scene.receiver->samples;
  return {size, tileOrder(size.x, size.y), planeSamplesInTiles(*scene.receiver), nullptr};
}

Image bake(RadianceMethod& method, const Target& target, const Progress& progress) {
  constexpr std::size_t block = 1 << 16;
  Image image(target.size.x, target.size.y);
  for (std::size_t first = 0; first < target.samples.size(); first += block) {
    const std::size_t count = std::min(block, target.samples.size() - first);
    const auto part = method.radiance(std::span(target.samples).subspan(first, count));
    for (std::size_t i = 0; i < count; ++i) image.pixels[target.texels[first + i]] = part[i];
    if (progress) progress("baking", double(first + count) / double(target.samples.size()));
  }
  return image;
}

/// Binary PLY: position and radiance per vertex, and the triangles.
std::string plyText(const TriangleMesh& mesh, const Image& radiance) {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment radiance, linear RGB, by haarlight\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float red\nproperty float green\nproperty float blue\n"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.triangles.size());
  const auto append = [&](const auto& value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append(mesh.positions[i]);
    append(radiance.pixels[i]);
  }
  for (const glm::uvec3& triangle : mesh.triangles) {
    append(std::uint8_t(3));
    append(triangle);
  }
  return text;
}

SceneDescription describe(const BakeOptions& options) {
  SceneDescription scene = describeScene(options.scene);
  requireOrder(options.compareTo, scene.shading);
  if (!options.size.empty()) {
    if (!scene.receiver) throw InputError("--size needs a receiver plane in the scene");
    scene.receiver->samples = parseReceiverSize(options.size);
  }
  return scene;
}

void run(const BakeOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  if (!options.output.empty())
    checkTarget(options.output, {options.object.empty() ? ".exr" : ".ply"});
  ShadingSetup setup(options.scene, describe(options), console);
  const ShadingMethod which = setup.description().shading.method;
  const Target target = bakeTarget(options, setup.scene());

  const auto method = setup.method(which, target.samples, false);
  const Image radiance = bake(*method, target, console.progress());
  if (target.object && !options.output.empty())
    writeFileAtomically(options.output, plyText(target.object->mesh, radiance));
  else if (!options.output.empty())
    writeExr(options.output, {{"", radiance}}, setup.attributes(*method));

  nlohmann::ordered_json results;
  if (!options.output.empty()) results["file"] = options.output;
  results["samples"] = target.samples.size();
  results.update(setup.summary(*method));
  results["shading_seconds"] = describeStages(method->times());
  if (options.frameRate) results["frame"] = measureFrameRate(*method, target.samples);
  for (const std::string& name : options.compareTo) {
    const auto other = setup.method(choiceOf(shadingMethodNames, name), target.samples, false);
    const Image reference = bake(*other, target, console.progress());
    results["comparison"].push_back(describeError(compareImages(radiance, reference), name));
  }
  console.results(results);
}

}  // namespace

void addBakeCommand(CLI::App& app) {
  const auto options = std::make_shared<BakeOptions>();
  CLI::App* command =
      app.add_subcommand("bake", "Compute radiance at the receiver's texels or a mesh's vertices");
  command->footer(
      "Examples:\n"
      "  haarlight bake scene.json -o plane.exr\n"
      "  haarlight bake --mesh bunny.obj --light grace.hdr --method haar --compare-to pixel\n"
      "  haarlight bake scene.json --object bunny -o bunny.ply");
  addSceneOptions(*command, options->scene);
  command
      ->add_option("-o,--output", options->output,
                   "File to write: .exr (one float32 pixel per texel), .ply with --object")
      ->group("Output");
  command->add_option("--object", options->object, "The vertices of this object, not the plane")
      ->group("Scene");
  command->add_option("--size", options->size, "Columns x rows of the plane's texels [128x128]")
      ->group("Output");
  command->add_flag("--frame-rate", options->frameRate, "Also measure frames per second")
      ->group("Computation");
  addCompareOption(*command, options->compareTo);
  addGeneralOptions(*command, options->general);
  command->callback([options] { run(*options); });
}

}  // namespace haarlight
