#include "scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/file.h"
#include "embedded/scenes.h"
#include "scene/field_reader.h"
#include "scene/field_writer.h"
#include "scene/json_text.h"
#include "scene/scene_checks.h"
#include "scene/scene_fields.h"
#include "solids/solid_checks.h"

namespace haarlight {

SceneDescription parseScene(std::string_view text, const std::filesystem::path& fileName) {
  const JsonSource source{fileName.string(), fileName.parent_path()};
  const nlohmann::json json = parseJson(text, source.name);
  const JsonValue document(json, "", source);
  SceneDescription scene;
  FieldReader::read(document, scene);
  checkTogether(scene, document);
  for (ObjectDescription& object : scene.objects)
    if (object.name.empty()) object.name = defaultObjectName(object);
  return scene;
}

SceneDescription readScene(const std::filesystem::path& path) {
  if (path.string().starts_with(builtinPrefix))
    return parseScene(builtinSceneText(path.string()), path);
  constexpr std::uint64_t largestFile = 4 << 20;
  const std::vector<std::uint8_t> bytes = readWholeFile(path, "scene", largestFile);
  return parseScene({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

std::string sceneToJson(const SceneDescription& scene) {
  SceneDescription copy = scene;
  return FieldWriter::write(copy).dump(2) + "\n";
}

std::string defaultObjectName(const std::string& mesh) {
  if (mesh.starts_with(builtinPrefix)) return mesh.substr(builtinPrefix.size());
  return std::filesystem::path(mesh).stem().string();
}

std::string defaultObjectName(const ObjectDescription& object) {
  return object.solid ? shapeName(*object.solid) : defaultObjectName(object.mesh);
}

bool isGltfFile(const std::string& mesh) {
  std::string extension = std::filesystem::path(mesh).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char letter) { return std::tolower(letter); });
  return extension == ".gltf" || extension == ".glb";
}

std::string_view builtinSceneText(const std::string& name) {
  if (std::find(builtinScenes.begin(), builtinScenes.end(), name) == builtinScenes.end())
    throw InputError(
        fmt::format("unknown scene '{}'; built in are {}", name, joinNames(builtinScenes)));
  return embedded::scenes(name.substr(builtinPrefix.size()) + ".json");
}

std::string_view sceneSchema() {
  return embedded::scenes("scene.schema.json");
}

}  // namespace haarlight
