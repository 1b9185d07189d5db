#include "app/shading_setup.h"

#include <fmt/format.h>

#include "app/shadow_options.h"
#include "app/version.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "render/punctual_method.h"
#include "render/scene_participants.h"
#include "scene/names.h"

namespace haarlight {

namespace {

std::size_t sphereCount(const Scene& scene) {
  std::size_t count = 0;
  for (const SceneObject& object : scene.objects) count += object.spheres.size();
  return count;
}

/// Whether the spheres' visibility is found as the scene's `visibility` says.
bool usesVisibilityKind(const RadianceMethod& method) {
  return method.name() == "haar" || method.name() == "pixel";
}

}  // namespace

ShadingSetup::ShadingSetup(const SceneOptions& options, SceneDescription description,
                           Console& console)
    : options_(options),
      description_(std::move(description)),
      console_(console),
      moving_(description_, console.progress()) {
  for (const std::string& warning : scene().warnings) console.warning(warning);
  if (!description_.light.samples.empty() && description_.shading.method != ShadingMethod::Sh)
    console.warning("only the method sh knows light.samples; others take the light alone");
  const LightProjection& projection = scene().light.projection;
  console.message(fmt::format("light: {}; {:.3f} % of its power is on the cube",
                              scene().light.environment->description(),
                              100 * projection.powerRatio));
}

void ShadingSetup::requireStillObjects() const {
  if (description_.shading.method != ShadingMethod::Sh) return;
  for (std::size_t i = 0; i < scene().objects.size(); ++i)
    if (moving_.objects()[i].moves())
      throw InputError("object '" + scene().objects[i].name +
                       "' moves, and transfer is for one pose: use --method haar or shexp");
}

std::shared_ptr<const SceneTransfer> ShadingSetup::transfer() {
  if (transfer_) return transfer_;
  const std::vector<std::filesystem::path> files(options_.transfer.begin(),
                                                 options_.transfer.end());
  const Stopwatch watch;
  transfer_ = std::make_shared<const SceneTransfer>(makeSceneTransfer(
      description_, moving_, files, description_.shading.order, console_.progress()));
  transferSeconds_ = watch.total();
  for (const std::string& warning : transfer_->warnings) console_.warning(warning);
  console_.message(fmt::format("transfer of {} vertices, order {}, ready in {:.2f} s",
                               transfer_->rows.rowCount(), transfer_->rows.order,
                               transferSeconds_));
  return transfer_;
}

std::unique_ptr<RadianceMethod> ShadingSetup::method(ShadingMethod which,
                                                     std::span<const SurfaceSample> typicalSamples,
                                                     bool anyNormal) {
  auto method = environmentMethod(which, typicalSamples, anyNormal);
  if (scene().punctualLights.empty()) return method;
  if (which == ShadingMethod::PixelMesh)  // the reference
    return withExactPunctualLights(std::move(method), scene());
  if (!shadowDetail_)
    shadowDetail_ =
        detailOf(options_.shadowDetail, description_.shading, SceneParticipants(scene()).bounds());
  return withPunctualLights(std::move(method), scene(), *shadowDetail_);
}

std::unique_ptr<RadianceMethod> ShadingSetup::environmentMethod(
    ShadingMethod which, std::span<const SurfaceSample> typicalSamples, bool anyNormal) {
  if (which == ShadingMethod::PixelMesh) return makePixelMeshMethod(scene());
  if (!table_) table_ = openSphereTable(description_, console_);
  if (which == ShadingMethod::Pixel) return makePixelMethod(scene(), table_);
  if (!engine_) {
    engine_ = openEngine(options_, description_, table_, console_);
    engine_->setSphereBinding(moving_.binding());
  }
  if (which == ShadingMethod::Shexp)
    return makeShexpMethod(scene(), engine_, shexpOrder(description_.shading), typicalSamples,
                           anyNormal);
  if (which == ShadingMethod::Sh)
    return makeTransferMethod(scene(), engine_, transfer(), description_.shading.per);
  ShadingSettings settings;
  settings.terms = description_.shading.terms;
  settings.levels = description_.shading.levels;
  return makeHaarMethod(scene(), engine_, settings, typicalSamples, anyNormal);
}

ShowTimes ShadingSetup::show(double seconds, RadianceMethod& method) {
  ShowTimes times;
  Stopwatch watch;
  moving_.showMeshes(seconds);
  times.meshes = watch.lap();
  moving_.showSpheres(engine_ ? engine_->moveSpheres(moving_.boundVertices())
                              : moveSpheres(moving_.binding(), moving_.boundVertices()));
  times.spheres = watch.lap();
  method.sceneChanged(moving_.showLight(seconds, method.readsLightCube()));
  times.light = watch.lap();
  return times;
}

nlohmann::ordered_json ShadingSetup::summary(const RadianceMethod& method) const {
  nlohmann::ordered_json summary{{"method", method.name()}, {"device", method.deviceName()}};
  if (method.name() == "haar") {
    summary["terms"] = description_.shading.terms;
    summary["levels"] = description_.shading.levels;
  }
  if (method.name() == "shexp") summary["order"] = shexpOrder(description_.shading);
  if (method.name() == "sh") {
    summary["order"] = transfer_->rows.order;
    summary["per"] = nameOf(shadedPerNames, description_.shading.per);
    summary["transfer_channels"] = transfer_->rows.channels;
    summary["vertices"] = transfer_->rows.rowCount();
    summary["transfer_seconds"] = transferSeconds_;  // before any shading
  }
  if (usesVisibilityKind(method))
    summary["visibility"] = nameOf(visibilityKindNames, description_.shading.visibility);
  if (!scene().punctualLights.empty()) {
    summary["punctual_lights"] = scene().punctualLights.size();
    if (method.name() != "pixel-mesh") {
      summary["shadow_detail"] = textOf(*shadowDetail_);
      summary["shadow_octrees_built"] = method.builtShadowOctrees();
    }
    summary["punctual_seconds"] = method.punctualSeconds();
  }
  summary["spheres"] = sphereCount(scene());
  summary["light"] = description_.light.source;
  summary["light_power_kept"] = scene().light.projection.powerRatio;
  return summary;
}

ImageAttributes ShadingSetup::attributes(const RadianceMethod& method) const {
  ImageAttributes attributes{{"software", std::string("haarlight " HAARLIGHT_VERSION)},
                             {"method", method.name()},
                             {"device", method.deviceName()},
                             {"spheres", int(sphereCount(scene()))},
                             {"light", description_.light.source}};
  if (usesVisibilityKind(method))
    attributes["visibility"] = nameOf(visibilityKindNames, description_.shading.visibility);
  if (method.name() == "haar") {
    attributes["terms"] = description_.shading.terms;
    attributes["levels"] = description_.shading.levels;
  }
  if (method.name() == "shexp") attributes["order"] = shexpOrder(description_.shading);
  if (method.name() == "sh") {
    attributes["order"] = transfer_->rows.order;
    attributes["per"] = nameOf(shadedPerNames, description_.shading.per);
  }
  return attributes;
}

nlohmann::ordered_json describeStages(const StageTimes& times) {
  nlohmann::ordered_json stages{{"total", times.total}};
  for (const NamedStage& stage : namedStages)
    if (times.*stage.seconds > 0) stages[stage.name] = times.*stage.seconds;
  return stages;
}

nlohmann::ordered_json describeError(const ImageError& error, const std::string& referenceName) {
  return {{"reference", referenceName},
          {"rmse", error.rootMeanSquare},
          {"mean", error.referenceMean},
          {"rmse_relative_to_mean_percent", 100 * error.relativeRootMeanSquare},
          {"largest_difference", error.maximum},
          {"at_column", error.maximumPixel.x},
          {"at_row", error.maximumPixel.y}};
}

void addCompareOption(CLI::App& command, std::vector<std::string>& methods) {
  command
      .add_option("--compare-to", methods,
                  "Compute it again by this method and print the root mean square error; may be "
                  "repeated")
      ->allow_extra_args(false)
      ->group("Computation")
      ->check(CLI::IsMember(namesOf(shadingMethodNames)));
}

}  // namespace haarlight
