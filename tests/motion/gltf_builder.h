#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace haarlight::test {

/// Writes small glTF files. What a test wants otherwise it changes in `document` and `bytes`.
class GltfBuilder {
 public:
  GltfBuilder();

  nlohmann::json document;
  std::string bytes;  ///< the only buffer

  /// An accessor of its own, of numbers without gaps. `type` as in the file: "SCALAR", "VEC3", …
  template <typename Number>
  int add(const std::string& type, const std::vector<Number>& numbers, bool normalized = false) {
    const auto* first = reinterpret_cast<const char*>(numbers.data());
    const int view = addView(std::string(first, numbers.size() * sizeof(Number)));
    return addAccessor(view, type, componentType<Number>(), numbers.size(), normalized);
  }

  int addView(const std::string& content);
  int addAccessor(int view, const std::string& type, int componentType, std::size_t numbers,
                  bool normalized);

  /// A mesh of one primitive, and a node of the scene for it.
  int addMeshNode(const nlohmann::json& primitive, const nlohmann::json& nodeFields = {});
  /// A node; the scene only has those that are added to it.
  int addNode(const nlohmann::json& fields);
  void addToScene(int node);

  /// A channel of animation `name`; keys and values are accessors.
  void addChannel(const std::string& name, int node, const std::string& path, int keys, int values,
                  const std::string& interpolation = "LINEAR");

  std::string gltf() const;  ///< with the buffer embedded
  std::string glb() const;

  /// The document with the buffer at `uri`, or in the binary chunk where it is empty.
  std::string json(const std::string& uri) const;

 private:
  template <typename Number>
  static constexpr int componentType() {
    if constexpr (std::is_same_v<Number, float>) return 5126;
    const int size = sizeof(Number) == 1 ? 5120 : sizeof(Number) == 2 ? 5122 : 5124;
    return std::is_signed_v<Number> ? size : size + 1;
  }
  int append(const std::string& list, const nlohmann::json& element);
};

/// A GLB of these chunks.
std::string glbOf(const std::string& json, const std::string& binary);

/// The triangle (0 0 0) (1 0 0) (0 1 0) in a node of the scene.
GltfBuilder triangleGltf();

/// A bar along y, from 0 to 2, of four sides and without ends, with a joint at its foot and one at
/// its middle. Vertex i is at height i / 4, for i < 12; those at the bottom follow the first joint,
/// those at the top the second one, and those in the middle both alike. Animation "bend" turns the
/// second joint by 90° about z in a second.
GltfBuilder skinnedBar();

/// The skinned bar with a morph target, a sparse accessor and all three interpolations.
GltfBuilder everyFeature();

}  // namespace haarlight::test
