#include "motion/gltf_vertices.h"

#include <algorithm>
#include <glm/ext/vector_uint4.hpp>
#include <glm/vec4.hpp>
#include <map>

#include "motion/gltf_accessor.h"

namespace haarlight {

namespace {

int attribute(const std::map<std::string, int>& attributes, const std::string& name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? -1 : found->second;
}

/// The accessors of <prefix>0, <prefix>1, … up to the first that is missing.
std::vector<int> attributeSets(const std::map<std::string, int>& attributes,
                               const std::string& prefix) {
  std::vector<int> sets;
  while (true) {
    const int accessor = attribute(attributes, prefix + std::to_string(sets.size()));
    if (accessor < 0) return sets;
    sets.push_back(accessor);
  }
}

class VertexReader {
 public:
  VertexReader(const GltfFile& file, const VertexSources& sources, const std::string& place)
      : file_(file), sources_(sources), place_(place) {}

  VertexBlock read(std::size_t& total) {
    if (sources_.positions < 0) file_.fail(place_, "it has no POSITION; export it again");
    block_.positions =
        readGltfElements<glm::vec3>(file_, sources_.positions, place_ + ", POSITION");
    addToGltfCount(
        file_, total,
        block_.positions.size() * (1 + 2 * sources_.morphs.size() + 8 * sources_.joints.size()));
    block_.normals = readVectors(sources_.normals, "NORMAL");
    for (const auto& [positions, normals] : sources_.morphs)
      block_.morphTargets.push_back({readVectors(positions, "POSITION of a morph target"),
                                     readVectors(normals, "NORMAL of a morph target")});
    if (!sources_.joints.empty()) readInfluences();
    return std::move(block_);
  }

 private:
  std::vector<glm::vec3> readVectors(int accessor, const std::string& name) const {
    if (accessor < 0) return {};
    return readGltfElements<glm::vec3>(file_, accessor, place_ + ", " + name,
                                       block_.positions.size());
  }

  void readInfluences() {
    if (sources_.joints.size() != sources_.weights.size())
      file_.fail(place_, "it has other sets of JOINTS than of WEIGHTS; export it again");
    const std::size_t count = block_.positions.size();
    std::vector<std::vector<glm::uvec4>> joints;
    std::vector<std::vector<glm::vec4>> weights;
    for (std::size_t set = 0; set < sources_.joints.size(); ++set) {
      joints.push_back(
          readGltfElements<glm::uvec4>(file_, sources_.joints[set], place_ + ", JOINTS", count));
      weights.push_back(
          readGltfElements<glm::vec4>(file_, sources_.weights[set], place_ + ", WEIGHTS", count));
    }
    block_.influenceStart.push_back(0);
    for (std::size_t vertex = 0; vertex < count; ++vertex) {
      for (std::size_t set = 0; set < joints.size(); ++set)
        addInfluences(vertex, joints[set][vertex], weights[set][vertex]);
      finishVertex(vertex);
    }
  }

  void addInfluences(std::size_t vertex, const glm::uvec4& joints, const glm::vec4& weights) {
    for (int i = 0; i < 4; ++i) {
      if (weights[i] < 0) failAt(vertex, "has a negative skin weight");
      if (weights[i] == 0) continue;
      block_.influences.push_back({joints[i], weights[i]});
      block_.largestJoint = std::max<std::uint32_t>(block_.largestJoint, joints[i]);
    }
  }

  /// Makes the sum of the vertex's weights 1.
  void finishVertex(std::size_t vertex) {
    const auto first = block_.influences.begin() + std::ptrdiff_t(block_.influenceStart.back());
    double sum = 0;
    for (auto i = first; i != block_.influences.end(); ++i) sum += double(i->weight);
    if (sum == 0) failAt(vertex, "has skin weights of the sum 0");
    for (auto i = first; i != block_.influences.end(); ++i) i->weight = float(i->weight / sum);
    block_.influenceStart.push_back(block_.influences.size());
  }

  [[noreturn]] void failAt(std::size_t vertex, const std::string& problem) const {
    file_.fail(place_, "vertex " + std::to_string(vertex) + " " + problem + "; export it again");
  }

  const GltfFile& file_;
  const VertexSources& sources_;
  std::string place_;
  VertexBlock block_;
};

std::vector<std::uint32_t> readIndices(const GltfFile& file, const tinygltf::Primitive& primitive,
                                       std::size_t vertexCount, const std::string& place) {
  std::vector<std::uint32_t> indices;
  if (primitive.indices < 0) {
    for (std::size_t i = 0; i < vertexCount; ++i) indices.push_back(std::uint32_t(i));
    return indices;
  }
  indices = readGltfElements<std::uint32_t>(file, primitive.indices, place + ", indices");
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= vertexCount)
      file.fail(place, "index " + std::to_string(i) + " is vertex " + std::to_string(indices[i]) +
                           " of " + std::to_string(vertexCount) + "; export it again");
  return indices;
}

}  // namespace

VertexSources::VertexSources(const tinygltf::Primitive& primitive)
    : positions(attribute(primitive.attributes, "POSITION")),
      normals(attribute(primitive.attributes, "NORMAL")),
      joints(attributeSets(primitive.attributes, "JOINTS_")),
      weights(attributeSets(primitive.attributes, "WEIGHTS_")) {
  for (const auto& target : primitive.targets)
    morphs.emplace_back(attribute(target, "POSITION"), attribute(target, "NORMAL"));
}

VertexBlock readVertexBlock(const GltfFile& file, const VertexSources& sources,
                            const std::string& place, std::size_t& count) {
  return VertexReader(file, sources, place).read(count);
}

std::vector<std::uint32_t> readTriangleCorners(const GltfFile& file,
                                               const tinygltf::Primitive& primitive,
                                               std::size_t vertexCount, const std::string& place) {
  const int mode = primitive.mode;
  if (mode < TINYGLTF_MODE_TRIANGLES) return {};
  if (mode > TINYGLTF_MODE_TRIANGLE_FAN)
    file.fail(place, "its mode " + std::to_string(mode) + " does not exist; export it again");
  const std::vector<std::uint32_t> indices = readIndices(file, primitive, vertexCount, place);
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    if (indices.size() % 3 != 0)
      file.fail(place, "its triangles have " + countText(indices.size(), "corner") +
                           ", not a multiple of 3; export it again");
    return indices;
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
    const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
    const std::size_t odd = i % 2;
    if (fan)
      corners.insert(corners.end(), {indices[i + 1], indices[i + 2], indices[0]});
    else
      corners.insert(corners.end(), {indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
  }
  return corners;
}

}  // namespace haarlight
