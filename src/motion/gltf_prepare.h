#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace haarlight {

/// Brings the JSON of a glTF file into a form that tinygltf reads without loss.
///
/// tinygltf takes a number of the wrong kind for one that is not there, cuts integers to 32 bits,
/// follows nested extras until the stack ends, and stops at images it cannot find. This refuses
/// wrong integers (all of them lie between 0 and 2^31 − 1; a whole number written "3.0" becomes 3),
/// wrong lists, versions other than 2, and required extensions that change shapes; it leaves out
/// what says nothing about shapes: materials, images, cameras, extras and extensions. Throws
/// InputError.
void prepareGltf(nlohmann::json& document, const std::filesystem::path& path);

}  // namespace haarlight
