#include "json_schema.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <stdexcept>

namespace haarlight::test {

namespace {

using Json = nlohmann::json;

bool hasType(const Json& value, const std::string& type) {
  if (type == "integer")
    return value.is_number() && value.get<double>() == std::floor(value.get<double>());
  if (type == "number") return value.is_number();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "array") return value.is_array();
  if (type == "object") return value.is_object();
  throw std::logic_error("unknown type " + type);
}

std::size_t characterCount(const Json& text) {
  const auto& bytes = text.get_ref<const std::string&>();
  return std::count_if(bytes.begin(), bytes.end(), [](char byte) { return (byte & 0xC0) != 0x80; });
}

/// Kept, as compiling takes longer than searching.
const std::regex& compiled(const std::string& pattern) {
  static std::map<std::string, std::regex> known;
  const auto found = known.find(pattern);
  return found != known.end() ? found->second : known.emplace(pattern, pattern).first->second;
}

}  // namespace

const Json& JsonSchema::referred(const Json& reference) const {
  return root_.at(Json::json_pointer(reference.get<std::string>().substr(1)));  // without '#'
}

Json JsonSchema::at(const Json::json_pointer& place) const {
  if (place.empty()) return root_;
  const Json parent = at(place.parent_pointer());
  Json schema = parent.contains("items") ? parent["items"] : parent["properties"][place.back()];
  if (schema.contains("$ref")) {
    Json target = referred(schema["$ref"]);
    target.update(schema);
    return target;
  }
  return schema;
}

bool JsonSchema::allows(const Json& schema, const Json& value) const {
  for (const auto& [keyword, ignored] : schema.items())
    if (!allowsBy(keyword, schema, value)) return false;
  return true;
}

bool JsonSchema::allowsBy(const std::string& keyword, const Json& schema, const Json& value) const {
  const Json& operand = schema[keyword];
  const auto byOperand = [&](const Json& alternative) { return allows(alternative, value); };
  const auto byItems = [&](const Json& item) { return allows(operand, item); };
  if (keyword == "$ref") return allows(referred(operand), value);
  if (keyword == "anyOf") return std::any_of(operand.begin(), operand.end(), byOperand);
  if (keyword == "not") return !byOperand(operand);
  if (keyword == "type") return hasType(value, operand);
  if (keyword == "const") return value == operand;
  if (keyword == "enum") return std::count(operand.begin(), operand.end(), value) > 0;
  if (keyword == "minimum") return !value.is_number() || value >= operand;
  if (keyword == "maximum") return !value.is_number() || value <= operand;
  if (keyword == "exclusiveMinimum") return !value.is_number() || value > operand;
  if (keyword == "minLength") return !value.is_string() || characterCount(value) >= operand;
  if (keyword == "maxLength") return !value.is_string() || characterCount(value) <= operand;
  if (keyword == "pattern")
    return !value.is_string() || std::regex_search(value.get<std::string>(), compiled(operand));
  if (keyword == "minItems") return !value.is_array() || value.size() >= operand;
  if (keyword == "maxItems") return !value.is_array() || value.size() <= operand;
  if (keyword == "minProperties") return !value.is_object() || value.size() >= operand;
  if (keyword == "maxProperties") return !value.is_object() || value.size() <= operand;
  if (keyword == "items")
    return !value.is_array() || std::all_of(value.begin(), value.end(), byItems);
  if (keyword == "required")
    return !value.is_object() || std::all_of(operand.begin(), operand.end(), [&](const Json& name) {
      return value.contains(name.get<std::string>());
    });
  if (keyword == "properties") return !value.is_object() || allowsMembers(schema, value);
  for (const char* known :
       {"additionalProperties", "title", "description", "default", "$schema", "$defs"})
    if (keyword == known) return true;
  throw std::logic_error("unknown keyword " + keyword);
}

bool JsonSchema::allowsMembers(const Json& schema, const Json& value) const {
  const bool open = schema.value("additionalProperties", true);
  const Json& properties = schema["properties"];
  for (const auto& [name, member] : value.items()) {
    if (!properties.contains(name) && !open) return false;
    if (properties.contains(name) && !allows(properties[name], member)) return false;
  }
  return true;
}

namespace {

void collectPlaces(const nlohmann::json& value, const nlohmann::json::json_pointer& place,
                   std::vector<nlohmann::json::json_pointer>& places) {
  places.push_back(place);
  if (value.is_object())
    for (const auto& [name, member] : value.items()) collectPlaces(member, place / name, places);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) collectPlaces(value[i], place / i, places);
}

}  // namespace

std::vector<nlohmann::json::json_pointer> placesOf(const nlohmann::json& document) {
  std::vector<nlohmann::json::json_pointer> places;
  collectPlaces(document, nlohmann::json::json_pointer(), places);
  return places;
}

}  // namespace haarlight::test
