#include "motion/gltf_file.h"

#include <limits>

#include "base/file.h"
#include "mesh/mesh_file_formats.h"
#include "motion/gltf_buffers.h"
#include "motion/gltf_container.h"
#include "motion/gltf_prepare.h"
#include "scene/json_text.h"

namespace haarlight {

namespace {

/// tinygltf goes on after some faults, but never without a word.
void parseModel(const std::filesystem::path& path, const std::string& json,
                tinygltf::Model& model) {
  if (json.size() > std::numeric_limits<unsigned>::max())
    meshFileError(path, "its JSON is larger than 4 GiB; export it with binary buffers");
  std::string error, warning;
  const bool read = tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, json.data(),
                                                             unsigned(json.size()), "");
  if (!read || !error.empty())
    meshFileError(path, visible(error.substr(0, error.find('\n'))) + "; export it again");
}

}  // namespace

void GltfFile::fail(const std::string& place, const std::string& problem) const {
  meshFileError(path, place + ": " + problem);
}

void addToGltfCount(const GltfFile& file, std::size_t& count, std::size_t more) {
  count += more;
  if (count > largestGltfCount)
    file.fail("scene", "more than " + countText(largestGltfCount) +
                           " vertices, corners, morph offsets or keys; leave some of them out");
}

GltfFile readGltf(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = readWholeFile(path, "mesh");
  const GltfContainer container = splitGltf(path, bytes);
  nlohmann::json document = parseJson(container.json, path.string());
  prepareGltf(document, path);
  GltfFile file{path, {}};
  std::vector<tinygltf::Buffer> buffers = readGltfBuffers(document, container.binary, path);
  document.erase("buffers");
  parseModel(path, document.dump(), file.model);
  file.model.buffers = std::move(buffers);
  return file;
}

}  // namespace haarlight
