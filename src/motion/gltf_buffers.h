#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

namespace haarlight {

/// The buffers of a prepared glTF document (gltf_prepare.h), each cut to its byteLength: from
/// base64 in the document, from a file whose relative path the document gives, or, where it gives
/// nothing, from the binary chunk of a .glb. Throws InputError when one has fewer bytes than it
/// says, or lies elsewhere (an absolute path, the network) or in no plain file.
std::vector<tinygltf::Buffer> readGltfBuffers(const nlohmann::json& document,
                                              std::span<const std::uint8_t> binaryChunk,
                                              const std::filesystem::path& path);

}  // namespace haarlight
