#include "gltf_builder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "base/html.h"

namespace haarlight::test {

namespace {

using Json = nlohmann::json;

std::string fourBytes(std::size_t number) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += char(number >> 8 * i & 0xFF);
  return bytes;
}

std::string padded(std::string content, char filler) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  return content;
}

std::string chunk(const std::string& type, const std::string& content) {
  return fourBytes(content.size()) + type + content;
}

/// Four corners of each of the heights 0, 1 and 2.
std::vector<float> barPositions() {
  std::vector<float> positions;
  for (const float y : {0.0f, 1.0f, 2.0f})
    for (const auto& [x, z] : {std::pair(0.1f, 0.1f), {0.1f, -0.1f}, {-0.1f, -0.1f}, {-0.1f, 0.1f}})
      positions.insert(positions.end(), {x, y, z});
  return positions;
}

std::vector<std::uint16_t> barIndices() {
  std::vector<std::uint16_t> indices;
  for (int ring = 0; ring < 2; ++ring)
    for (int side = 0; side < 4; ++side) {
      const int next = (side + 1) % 4, low = 4 * ring;
      for (const int vertex :
           {low + side, low + next, low + 4 + next, low + side, low + 4 + next, low + 4 + side})
        indices.push_back(std::uint16_t(vertex));
    }
  return indices;
}

}  // namespace

GltfBuilder::GltfBuilder()
    : document{{"asset", {{"version", "2.0"}}},
               {"scenes", Json::array({Json{{"nodes", Json::array()}}})}} {}

int GltfBuilder::append(const std::string& list, const Json& element) {
  document[list].push_back(element);
  return int(document[list].size()) - 1;
}

int GltfBuilder::addView(const std::string& content) {
  bytes = padded(bytes, 0);
  const std::size_t start = bytes.size();
  bytes += content;
  return append("bufferViews",
                {{"buffer", 0}, {"byteOffset", start}, {"byteLength", content.size()}});
}

int GltfBuilder::addAccessor(int view, const std::string& type, int componentType,
                             std::size_t numbers, bool normalized) {
  const std::map<std::string, std::size_t> components{
      {"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  return append("accessors", {{"bufferView", view},
                              {"type", type},
                              {"componentType", componentType},
                              {"count", numbers / components.at(type)},
                              {"normalized", normalized}});
}

int GltfBuilder::addNode(const Json& fields) {
  return append("nodes", fields.is_null() ? Json::object() : fields);
}

void GltfBuilder::addToScene(int node) {
  document["scenes"][0]["nodes"].push_back(node);
}

int GltfBuilder::addMeshNode(const Json& primitive, const Json& nodeFields) {
  Json node = nodeFields.is_null() ? Json::object() : nodeFields;
  node["mesh"] = append("meshes", {{"primitives", Json::array({primitive})}});
  const int index = addNode(node);
  addToScene(index);
  return index;
}

void GltfBuilder::addChannel(const std::string& name, int node, const std::string& path, int keys,
                             int values, const std::string& interpolation) {
  Json& animations = document["animations"];
  auto animation = std::find_if(animations.begin(), animations.end(),
                                [&](const Json& candidate) { return candidate["name"] == name; });
  if (animation == animations.end()) {
    animations.push_back(
        {{"name", name}, {"samplers", Json::array()}, {"channels", Json::array()}});
    animation = animations.end() - 1;
  }
  (*animation)["channels"].push_back(
      {{"sampler", (*animation)["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  (*animation)["samplers"].push_back(
      {{"input", keys}, {"output", values}, {"interpolation", interpolation}});
}

std::string GltfBuilder::json(const std::string& uri) const {
  Json complete = document;
  Json buffer{{"byteLength", bytes.size()}};
  if (!uri.empty()) buffer["uri"] = uri;
  if (!complete.contains("buffers")) complete["buffers"] = Json::array({buffer});
  return complete.dump();
}

std::string GltfBuilder::gltf() const {
  const std::span content(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return json("data:application/octet-stream;base64," + base64(content));
}

std::string GltfBuilder::glb() const {
  return glbOf(json(""), bytes);
}

std::string glbOf(const std::string& json, const std::string& binary) {
  const std::string chunks =
      chunk("JSON", padded(json, ' ')) + chunk(std::string("BIN\0", 4), padded(binary, '\0'));
  return "glTF" + fourBytes(2) + fourBytes(12 + chunks.size()) + chunks;
}

GltfBuilder triangleGltf() {
  GltfBuilder builder;
  const int positions = builder.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  builder.addMeshNode({{"attributes", {{"POSITION", positions}}}});
  return builder;
}

GltfBuilder skinnedBar() {
  GltfBuilder builder;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (int vertex = 0; vertex < 12; ++vertex) {
    const float second = float(vertex / 4) / 2;
    joints.insert(joints.end(), {0, 1, 0, 0});
    weights.insert(weights.end(), {1 - second, second, 0, 0});
  }
  const int foot = builder.addNode({{"children", Json::array({1})}});
  const int middle = builder.addNode({{"translation", {0, 1, 0}}});
  // Columns: the identity, and the way back from the middle to the foot.
  std::vector<float> matrices(32, 0.0f);
  for (const std::size_t i : {0, 5, 10, 15, 16, 21, 26, 31}) matrices[i] = 1;
  matrices[29] = -1;
  builder.document["skins"] = Json::array(
      {Json{{"joints", {foot, middle}}, {"inverseBindMatrices", builder.add("MAT4", matrices)}}});
  builder.addToScene(foot);
  builder.addMeshNode({{"attributes",
                        {{"POSITION", builder.add("VEC3", barPositions())},
                         {"JOINTS_0", builder.add("VEC4", joints)},
                         {"WEIGHTS_0", builder.add("VEC4", weights)}}},
                       {"indices", builder.add("SCALAR", barIndices())}},
                      {{"skin", 0}});
  const float half = std::sqrt(0.5f);
  builder.addChannel("bend", middle, "rotation", builder.add<float>("SCALAR", {0, 1}),
                     builder.add<float>("VEC4", {0, 0, 0, 1, 0, 0, half, half}));
  return builder;
}

GltfBuilder everyFeature() {
  GltfBuilder builder = skinnedBar();
  const int offsets = builder.add("VEC3", std::vector<float>(36, 0.0f));
  const int places = builder.addView(std::string("\1\0\7\0", 4));
  const std::vector<float> pushed{0.5f, 0, 0, 0, 0, 0.5f};
  const int values = builder.addView(std::string(reinterpret_cast<const char*>(pushed.data()), 24));
  builder.document["accessors"][offsets]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", places}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
  builder.document["meshes"][0]["primitives"][0]["targets"] =
      Json::array({Json{{"POSITION", offsets}}});
  const int keys = builder.add<float>("SCALAR", {0, 0.5f, 2});
  builder.addChannel("bend", 2, "weights", keys, builder.add<float>("SCALAR", {0, 1, 0.5f}),
                     "STEP");
  builder.addChannel("bend", 0, "translation", builder.add<float>("SCALAR", {0, 1}),
                     builder.add("VEC3", std::vector<float>{0, 0, 0, 0, 0, 0, 1, 0, 0,  //
                                                            1, 0, 0, 2, 0, 0, 0, 0, 0}),
                     "CUBICSPLINE");
  return builder;
}

}  // namespace haarlight::test
