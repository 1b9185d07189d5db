#include "motion/gltf_buffers.h"

#include <charconv>
#include <limits>
#include <string>
#include <string_view>

#include "base/file.h"
#include "base/text_format.h"
#include "mesh/mesh_file_formats.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

/// RFC 3986: "%20" becomes a blank.
std::string percentDecoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char* digits = text.data() + i + 1;
    std::uint8_t code = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      result += char(code);
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

class BufferReader {
 public:
  BufferReader(const fs::path& path, std::span<const std::uint8_t> binaryChunk)
      : path_(path), binaryChunk_(binaryChunk) {}

  tinygltf::Buffer read(const json& buffer, std::size_t number) {
    place_ = "buffer " + std::to_string(number);
    if (!buffer.is_object() || !buffer.contains("byteLength"))
      fail("has no byteLength; export it again");
    const auto size = buffer["byteLength"].get<std::size_t>();
    tinygltf::Buffer result;
    result.data = bytesOf(buffer, number);
    if (result.data.size() < size)
      fail("says it has " + std::to_string(size) + " bytes, there are " +
           std::to_string(result.data.size()) + "; export it again");
    result.data.resize(size);
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    meshFileError(path_, place_ + " " + problem);
  }

  Bytes bytesOf(const json& buffer, std::size_t number) const {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) {
      if (number > 0) fail("has no uri, which only buffer 0 of a .glb may do; export it again");
      return {binaryChunk_.begin(), binaryChunk_.end()};
    }
    if (!uri->is_string()) fail("has a uri that is no text; export it again");
    const auto& text = uri->get_ref<const std::string&>();
    return text.starts_with("data:") ? embedded(text) : external(percentDecoded(text));
  }

  Bytes embedded(const std::string& uri) const {
    constexpr std::string_view marker = ";base64,";
    const std::size_t start = uri.find(marker);
    // tinygltf counts the characters in an int, and knows few media types.
    if (start == std::string::npos || uri.size() > std::numeric_limits<int>::max())
      fail("is embedded, but not as base64 of at most 2 GiB; export it again");
    Bytes bytes;
    std::string mediaType;
    tinygltf::DecodeDataURI(&bytes, mediaType, "data:application/octet-stream" + uri.substr(start),
                            0, false);
    return bytes;
  }

  Bytes external(const std::string& name) const {
    const bool relative = !name.empty() && fs::path(name).is_relative() &&
                          name.find(':') == std::string::npos &&
                          name.find('\0') == std::string::npos;
    if (!relative)
      fail("lies at '" + visible(name.substr(0, 80)) + "', which is no relative path of a file");
    const fs::path file = path_.parent_path() / name;
    std::error_code error;
    if (fs::exists(file, error) && !fs::is_regular_file(file, error))
      fail("lies in " + file.string() + ", which is no plain file");
    return readWholeFile(file, place_ + " of " + path_.string() + ",");
  }

  const fs::path& path_;
  std::span<const std::uint8_t> binaryChunk_;
  std::string place_;
};

}  // namespace

std::vector<tinygltf::Buffer> readGltfBuffers(const json& document,
                                              std::span<const std::uint8_t> binaryChunk,
                                              const fs::path& path) {
  std::vector<tinygltf::Buffer> result;
  const auto buffers = document.find("buffers");
  if (buffers == document.end()) return result;
  BufferReader reader(path, binaryChunk);
  for (const json& buffer : *buffers) result.push_back(reader.read(buffer, result.size()));
  return result;
}

}  // namespace haarlight
