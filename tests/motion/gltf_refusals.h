#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "gltf_support.h"

namespace haarlight::test {

/// The message with which a file is refused, without what comes before the path.
inline std::string refusal(const std::string& content, const std::string& animation = "") {
  try {
    loadGltfText(content, animation);
  } catch (const InputError& error) {
    const std::string message = error.what();
    CHECK(message.find('\n') == std::string::npos);
    const std::string name = "model.gltf: ";
    REQUIRE(message.find(name) != std::string::npos);
    return message.substr(message.find(name) + name.size());
  }
  return "not refused";
}

struct Fault {
  const char* problem;  ///< a part of the message
  std::function<void(GltfBuilder&, nlohmann::json& document)> make;
};

/// Makes each fault in a fresh file, and expects its message.
inline void checkFaults(GltfBuilder (*fresh)(), const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    GltfBuilder builder = fresh();
    fault.make(builder, builder.document);
    CAPTURE(fault.problem);
    const std::string message = refusal(builder.gltf());
    INFO(message);
    CHECK(message.find(fault.problem) != std::string::npos);
  }
}

inline nlohmann::json& primitive(nlohmann::json& document) {
  return document["meshes"][0]["primitives"][0];
}

inline nlohmann::json& accessor(nlohmann::json& document, const char* attribute) {
  return document["accessors"][primitive(document)["attributes"][attribute].get<int>()];
}

inline nlohmann::json& sampler(nlohmann::json& document) {
  return document["animations"][0]["samplers"][0];
}

}  // namespace haarlight::test
