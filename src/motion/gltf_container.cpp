#include "motion/gltf_container.h"

#include <string>

#include "mesh/mesh_file_formats.h"

namespace haarlight {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::string_view magic = "glTF";
constexpr std::size_t headerSize = 12, chunkHeaderSize = 8;
constexpr std::uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;

std::string_view textOf(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint32_t littleEndian(Bytes bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | bytes[at + i];
  return number;
}

struct Chunk {
  std::uint32_t type = 0;
  Bytes content;
};

/// Takes the first chunk off `rest`; `number` is for the message.
Chunk takeChunk(const std::filesystem::path& path, Bytes& rest, int number) {
  const std::string place = "GLB chunk " + std::to_string(number);
  if (rest.size() < chunkHeaderSize) meshFileError(path, place + " is cut off; copy it again");
  const std::uint32_t size = littleEndian(rest, 0), type = littleEndian(rest, 4);
  rest = rest.subspan(chunkHeaderSize);
  if (size > rest.size())
    meshFileError(path, place + " says it has " + std::to_string(size) + " bytes, only " +
                            std::to_string(rest.size()) + " are left; copy the file again");
  const Chunk chunk{type, rest.first(size)};
  rest = rest.subspan(size);
  return chunk;
}

GltfContainer splitGlb(const std::filesystem::path& path, Bytes bytes) {
  if (bytes.size() < headerSize) meshFileError(path, "the GLB header is cut off; copy it again");
  const std::uint32_t version = littleEndian(bytes, 4), size = littleEndian(bytes, 8);
  if (version != 2)
    meshFileError(path, "it is GLB version " + std::to_string(version) + "; export it as glTF 2.0");
  if (size < headerSize || size > bytes.size())
    meshFileError(path, "the GLB header says " + std::to_string(size) + " bytes, the file has " +
                            std::to_string(bytes.size()) + "; copy it again");
  Bytes rest = bytes.subspan(headerSize, size - headerSize);
  const Chunk first = takeChunk(path, rest, 0);
  if (first.type != jsonChunk) meshFileError(path, "GLB chunk 0 is not JSON; export it again");
  GltfContainer container{textOf(first.content), {}};
  if (rest.empty()) return container;
  const Chunk second = takeChunk(path, rest, 1);
  if (second.type == binaryChunk) container.binary = second.content;
  return container;
}

}  // namespace

GltfContainer splitGltf(const std::filesystem::path& path, Bytes bytes) {
  if (bytes.empty()) meshFileError(path, "it is empty");
  if (textOf(bytes).starts_with(magic)) return splitGlb(path, bytes);
  return {textOf(bytes), {}};
}

}  // namespace haarlight
