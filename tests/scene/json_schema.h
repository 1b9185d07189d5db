#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace haarlight::test {

/// The places of all values of a document, the document itself among them.
std::vector<nlohmann::json::json_pointer> placesOf(const nlohmann::json& document);

/// The part of JSON Schema (draft 2020-12) that the schemas in docs use.
class JsonSchema {
 public:
  explicit JsonSchema(const nlohmann::json& root) : root_(root) {}

  /// Whether the schema allows `value`. Throws std::logic_error at a keyword it does not know.
  bool allows(const nlohmann::json& value) const { return allows(root_, value); }

  /// The schema of a value at `place` in a document, with "$ref" followed.
  nlohmann::json at(const nlohmann::json::json_pointer& place) const;

 private:
  using Json = nlohmann::json;

  bool allows(const Json& schema, const Json& value) const;
  bool allowsBy(const std::string& keyword, const Json& schema, const Json& value) const;
  bool allowsMembers(const Json& schema, const Json& value) const;
  const Json& referred(const Json& reference) const;

  Json root_;
};

}  // namespace haarlight::test
