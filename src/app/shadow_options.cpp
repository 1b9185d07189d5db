#include "app/shadow_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "mesh/text_lines.h"
#include "scene/field_ranges.h"

namespace haarlight {

namespace {

glm::dvec3 parseVector(const std::string& text, const std::string& option) {
  glm::dvec3 vector(0);
  std::string_view rest = text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? rest.find(',') : rest.size();
    if (end == std::string_view::npos || !parseNumber(rest.substr(0, end), vector[axis]) ||
        !(std::abs(vector[axis]) <= coordinateRange.maximum))
      throw InputError(fmt::format("{} takes X,Y,Z such as 2.5,5,2, not '{}'", option, text));
    rest.remove_prefix(std::min(rest.size(), end + 1));
  }
  return vector;
}

constexpr double irradianceAtTarget = 3;

}  // namespace

LevelOfDetail parseDetail(const std::string& text) {
  LevelOfDetail detail;
  const std::string_view prefix = "depth=";
  const std::string_view view = text;
  int depth = 0;
  double edge = 0;
  if (view.starts_with(prefix)) {
    const std::string_view digits = view.substr(prefix.size());
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), depth);
    if (error != std::errc() || end != digits.end() || depth < 0 || depth > deepestCell)
      throw InputError(
          fmt::format("--detail takes depth=0 to depth={}, not '{}'", deepestCell, text));
    detail.boundary = depth;
  } else {
    if (!parseNumber(view, edge) || !(edge > 0))
      throw InputError(
          fmt::format("--detail takes the largest edge of the smallest cells, such as 0.02, or "
                      "depth=N, not '{}'",
                      text));
    detail.boundary = edge;
  }
  checkDetail(detail);
  return detail;
}

LevelOfDetail detailOf(const std::string& option, const ShadingDescription& shading,
                       const AxisBox& scene) {
  if (!option.empty()) return parseDetail(option);
  constexpr int cellsAlongScene = 512;
  const glm::dvec3 size = scene.isEmpty() ? glm::dvec3(1) : scene.upper - scene.lower;
  const double longest = std::max({size.x, size.y, size.z});
  LevelOfDetail detail;
  detail.boundary = shading.shadowDetail.value_or(longest > 0 ? longest / cellsAlongScene : 1);
  return detail;
}

std::string textOf(const LevelOfDetail& detail) {
  if (const auto* depth = std::get_if<int>(&detail.boundary))
    return fmt::format("depth={}", *depth);
  return fmt::format("{:.4g}", std::get<double>(detail.boundary));
}

void addPunctualLightOptions(CLI::App& command, PunctualLightOptions& options) {
  const auto add = [&](const char* name, std::vector<std::string>& list, const char* help) {
    command.add_option(name, list, help)->allow_extra_args(false)->group("Scene");
  };
  add("--point-light", options.pointLights,
      "X,Y,Z of a point light, instead of the scene's lights; may be repeated");
  add("--directional-light", options.directionalLights,
      "X,Y,Z towards a light far away, instead of the scene's lights; may be repeated");
}

void applyPunctualLights(const PunctualLightOptions& options, SceneDescription& scene) {
  if (options.pointLights.empty() && options.directionalLights.empty()) return;
  scene.pointLights.clear();
  scene.directionalLights.clear();
  for (const std::string& text : options.pointLights) {
    PointLightDescription& light = scene.pointLights.emplace_back();
    light.position = parseVector(text, "--point-light");
    const glm::dvec3 away = light.position - scene.camera.target;
    light.intensity = glm::dvec3(irradianceAtTarget * std::max(glm::dot(away, away), 1e-6));
  }
  for (const std::string& text : options.directionalLights) {
    DirectionalLightDescription& light = scene.directionalLights.emplace_back();
    light.towards = parseVector(text, "--directional-light");
    if (light.towards == glm::dvec3(0))
      throw InputError("--directional-light 0,0,0 points nowhere");
    light.irradiance = glm::dvec3(irradianceAtTarget);
  }
}

}  // namespace haarlight
