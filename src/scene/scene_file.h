#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene_description.h"

namespace haarlight {

/// Largest product of width and height of an image.
inline constexpr long long maximumPixelCount = 1ll << 28;

/// Reads a scene file (docs/scene.md, docs/scene.schema.json), or a scene of builtinScenes by its
/// name. Relative paths in the scene are resolved against the file's folder; whether their files
/// exist is not looked at. Throws InputError with file and field, or line and column, for whatever
/// the schema or this page does not allow; files of more than 4 MiB are refused.
SceneDescription readScene(const std::filesystem::path& path);

/// The same for text in memory; `fileName` serves for messages and for relative paths.
SceneDescription parseScene(std::string_view text, const std::filesystem::path& fileName);

/// The scene as a file with every field; parseScene gives the same scene back. Paths are written as
/// they are.
std::string sceneToJson(const SceneDescription& scene);

/// The name of an object that is given none: "torusknot" for "builtin:torusknot" and for
/// "meshes/torusknot.obj".
std::string defaultObjectName(const std::string& mesh);
/// The same, or the name of a solid's shape ("cone").
std::string defaultObjectName(const ObjectDescription& object);

/// Whether the extension of a mesh's path is .gltf or .glb, in capitals or not.
bool isGltfFile(const std::string& mesh);

/// The text of a scene of builtinScenes. Throws InputError for another name.
std::string_view builtinSceneText(const std::string& name);

/// The JSON Schema (draft 2020-12) of scene files.
std::string_view sceneSchema();

}  // namespace haarlight
