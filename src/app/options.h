#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "engine/devices.h"
#include "scene/json_value.h"
#include "scene/scene_description.h"

namespace haarlight {

/// Options that every command has.
struct GeneralOptions {
  bool json = false;
  bool quiet = false;
  unsigned threads = 0;
};

void addGeneralOptions(CLI::App& command, GeneralOptions& options);

/// --seed; CLI11 would take −1 for 2⁶⁴ − 1.
CLI::Option* addSeedOption(CLI::App& command, std::uint64_t& seed, const std::string& help);

/// A scene from a file or from a mesh, and what the command line changes about it.
struct SceneOptions {
  std::string scene;
  std::string mesh;
  std::string light;
  std::string layout;
  std::optional<double> lightRotation;
  std::optional<double> lightScale;
  std::string sun;
  std::optional<double> sunDisc;
  std::optional<int> spheres;
  std::string objective;
  std::string method;
  std::optional<int> terms;
  std::optional<int> levels;
  std::optional<int> order;
  std::string per;
  std::vector<std::string> transfer;
  std::string visibility;
  std::string shadowDetail;
  std::string engine;
  std::string device;
};

void addSceneOptions(CLI::App& command, SceneOptions& options);

/// Those of them that say what is in the scene, but for its spheres.
void addSceneContentOptions(CLI::App& command, SceneOptions& options);

/// Those that say how it is shaded, but for the method.
void addShadingOptions(CLI::App& command, SceneOptions& options);

/// Bands of visibility of the method shexp. Throws InputError when it does not have the order asked
/// for.
int shexpOrder(const ShadingDescription& shading);

/// Throws InputError when one of these methods does not have the order asked for.
void requireOrder(const std::vector<std::string>& methods, const ShadingDescription& shading);

/// The scene that the options ask for; without a scene and a mesh the built-in default. Throws
/// InputError.
SceneDescription describeScene(const SceneOptions& options);

/// The sphere table, or null when the scene asks for exact visibility.
std::shared_ptr<const SphereTable> openSphereTable(const SceneDescription& scene, Console& console);

/// The engine that the options and the scene ask for; says on the console how long compiling
/// kernels took.
std::shared_ptr<Engine> openEngine(const SceneOptions& options, const SceneDescription& scene,
                                   std::shared_ptr<const SphereTable> table, Console& console);

/// "960x540" as two positive numbers. Throws InputError naming the option.
glm::ivec2 parseSize(const std::string& text, const std::string& option);

/// --size of a receiver plane: the same, with at most 4096 samples a side.
glm::ivec2 parseReceiverSize(const std::string& text);

/// --sun: "120,45" as azimuth and elevation in degrees. Throws InputError.
void parseSun(const std::string& text, SkySettings& sky);

/// An option's number as it is. Throws InputError when it is out of range or not a number.
double withinRange(double value, const Range& range, const std::string& option);

/// Throws InputError unless a file of one of these extensions can be made at `target`, so that no
/// work is done in vain.
void checkTarget(const std::filesystem::path& target, const std::vector<std::string>& extensions);

/// The name of a choice, and the choice of a name (scene/names.h).
template <typename Names, typename Choice>
std::string nameOf(const Names& names, Choice choice) {
  for (const auto& entry : names)
    if (entry.choice == choice) return std::string(entry.name);
  return {};
}

template <typename Names>
auto choiceOf(const Names& names, const std::string& name) {
  for (const auto& entry : names)
    if (entry.name == name) return entry.choice;
  return names.front().choice;
}

template <typename Names>
std::vector<std::string> namesOf(const Names& names) {
  std::vector<std::string> list;
  for (const auto& entry : names) list.emplace_back(entry.name);
  return list;
}

}  // namespace haarlight
