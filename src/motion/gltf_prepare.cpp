#include "motion/gltf_prepare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "base/text_format.h"
#include "mesh/mesh_file_formats.h"

namespace haarlight {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 8> lists{"accessors", "animations", "bufferViews", "buffers",
                                                "meshes",    "nodes",      "scenes",      "skins"};

/// Names of members that hold an integer or an array of them, and of those that hold objects with
/// nothing else ("attributes", "targets").
constexpr std::array<std::string_view, 25> integerMembers{"attributes",
                                                          "buffer",
                                                          "bufferView",
                                                          "byteLength",
                                                          "byteOffset",
                                                          "byteStride",
                                                          "camera",
                                                          "children",
                                                          "count",
                                                          "componentType",
                                                          "indices",
                                                          "input",
                                                          "inverseBindMatrices",
                                                          "joints",
                                                          "material",
                                                          "mesh",
                                                          "mode",
                                                          "node",
                                                          "nodes",
                                                          "output",
                                                          "sampler",
                                                          "scene",
                                                          "skeleton",
                                                          "skin",
                                                          "targets"};

/// Beginnings of the names of extensions that a mesh can do without, or that need nothing more
/// (quantized positions).
constexpr std::array<std::string_view, 8> harmlessExtensions{
    "EXT_lights_",  "EXT_texture_",          "KHR_lights_",   "KHR_materials_",
    "KHR_texture_", "KHR_mesh_quantization", "MSFT_texture_", "KHR_xmp"};

bool isOneOf(const auto& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

class Preparation {
 public:
  explicit Preparation(const std::filesystem::path& path) : path_(path) {}

  void run(json& document) const {
    if (!document.is_object()) fail("its JSON is no object; export it again");
    requireVersion(document);
    refuseExtensions(document);
    keepShapes(document);
    clean(document, "");
    addOptionalMembers(document);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const { meshFileError(path_, problem); }

  void requireVersion(const json& document) const {
    const auto asset = document.find("asset");
    if (asset == document.end() || !asset->is_object() || !asset->contains("version") ||
        !asset->at("version").is_string())
      fail("asset.version is missing; export it as glTF 2.0");
    const std::string version = asset->at("version").get<std::string>();
    if (!version.starts_with("2."))
      fail("it is glTF version " + visible(version) + "; export it as glTF 2.0");
  }

  void refuseExtensions(const json& document) const {
    const auto required = document.find("extensionsRequired");
    if (required == document.end()) return;
    for (const json& entry : *required) {
      const std::string name = entry.is_string() ? entry.get<std::string>() : entry.dump();
      if (std::ranges::none_of(harmlessExtensions, [&](std::string_view harmless) {
            return name.starts_with(harmless);
          }))
        fail("it requires the extension " + visible(name) +
             ", which is not supported; export it without");
    }
  }

  void keepShapes(json& document) const {
    for (auto member = document.begin(); member != document.end();) {
      const bool list = isOneOf(lists, member.key());
      if (list && !member->is_array()) fail(member.key() + " is no array; export it again");
      const bool kept = list || member.key() == "asset" || member.key() == "scene";
      member = kept ? std::next(member) : document.erase(member);
    }
  }

  /// `name` is the member that holds `value`, or the array it is in.
  void clean(json& value, const std::string& name) const {
    if (value.is_array()) {
      for (json& element : value) clean(element, name);
    } else if (value.is_object()) {
      value.erase("extras");
      value.erase("extensions");
      const bool integers = name == "attributes" || name == "targets";
      for (auto& [key, member] : value.items()) clean(member, integers ? name : key);
    } else if (isOneOf(integerMembers, name)) {
      makeInteger(value, name);
    }
  }

  void makeInteger(json& value, const std::string& name) const {
    constexpr double largest = std::numeric_limits<std::int32_t>::max();
    const double number = value.is_number() ? value.get<double>() : -1;
    if (!(number >= 0 && number <= largest && number == std::floor(number)))
      fail(name + " is " + visible(value.dump().substr(0, 40)) +
           ", not a whole number from 0 to 2147483647; export it again");
    value = std::int32_t(number);
  }

  /// tinygltf calls their absence, which the standard allows, an error.
  void addOptionalMembers(json& document) const {
    for (json& skin : document["skins"])
      if (skin.is_object() && !skin.contains("inverseBindMatrices"))
        skin["inverseBindMatrices"] = -1;
    for (json& animation : document["animations"]) {
      if (!animation.is_object()) continue;
      for (json& channel : animation["channels"])
        if (channel.is_object() && channel["target"].is_object() &&
            !channel["target"].contains("node"))
          channel["target"]["node"] = -1;
    }
  }

  const std::filesystem::path& path_;
};

}  // namespace

void prepareGltf(json& document, const std::filesystem::path& path) {
  Preparation(path).run(document);
}

}  // namespace haarlight
