#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace haarlight {

/// The two parts of a glTF file, as views of its bytes.
struct GltfContainer {
  std::string_view json;
  /// The binary chunk of a .glb; empty in a .gltf and where there is none.
  std::span<const std::uint8_t> binary;
};

/// Tells .glb from .gltf by the first bytes, and finds the chunks of a .glb (glTF 2.0,
/// section 4.4). Throws InputError when it is cut off, of another version, or a chunk is longer
/// than the file.
GltfContainer splitGltf(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace haarlight
