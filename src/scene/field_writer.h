#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/json_value.h"

namespace haarlight {

/// Writes variables as the fields of one JSON object, in the order of the calls: the counterpart of
/// FieldReader, whose functions have the same names and parameters.
class FieldWriter {
 public:
  void flag(const char* name, bool value) { json_[name] = value; }
  void integer(const char* name, int value, const Range&) { json_[name] = value; }
  void integer(const char* name, const std::optional<int>& value, const Range& range) {
    if (value) integer(name, *value, range);
  }
  void number(const char* name, double value, const Range&) { json_[name] = value; }
  void number(const char* name, const std::optional<double>& value, const Range& range) {
    if (value) number(name, *value, range);
  }
  void text(const char* name, const std::string& value) { json_[name] = value; }
  void text(const char* name, const std::optional<std::string>& value) {
    if (value) text(name, *value);
  }
  void path(const char* name, const std::optional<std::filesystem::path>& value) {
    if (value) text(name, value->string());
  }
  /// An empty text is no resource.
  void resource(const char* name, const std::string& value, const std::vector<std::string>&) {
    if (!value.empty()) json_[name] = value;
  }
  void resource(const char* name, const std::optional<std::string>& value,
                const std::vector<std::string>&) {
    text(name, value);
  }
  void word(const char* name, const std::string& value, std::span<const std::string_view>) {
    json_[name] = value;
  }
  void numberOrVector(const char* name, const glm::dvec3& value, const Range& range) {
    value == glm::dvec3(value.x) ? number(name, value.x, range) : vector(name, value, range);
  }
  void countOrFile(const char* name, const std::variant<int, std::filesystem::path>& value,
                   const Range&) {
    if (const int* count = std::get_if<int>(&value))
      json_[name] = *count;
    else
      json_[name] = std::get<std::filesystem::path>(value).string();
  }
  void numberOrWord(const char* name, std::optional<double> value, const char* word,
                    const Range& range) {
    value ? number(name, *value, range) : text(name, std::string(word));
  }
  void vectorOrWord(const char* name, const std::optional<glm::dvec3>& value, const char* word,
                    const Range& range) {
    value ? vector(name, *value, range) : text(name, std::string(word));
  }

  template <typename Vector>
  void vector(const char* name, const Vector& value, const Range&) {
    for (int i = 0; i < Vector::length(); ++i) json_[name].push_back(value[i]);
  }

  template <typename Vector>
  void vector(const char* name, const std::optional<Vector>& value, const Range& range) {
    if (value) vector(name, *value, range);
  }

  template <typename Choice, std::size_t count>
  void choice(const char* name, Choice value, const std::array<Named<Choice>, count>& names) {
    for (const auto& named : names)
      if (named.choice == value) json_[name] = named.name;
  }

  template <typename Choice, std::size_t count>
  void choice(const char* name, const std::optional<Choice>& value,
              const std::array<Named<Choice>, count>& names) {
    if (value) choice(name, *value, names);
  }

  template <typename Description>
  void object(const char* name, Description& value) {
    json_[name] = write(value);
  }

  template <typename Description>
  void object(const char* name, std::optional<Description>& value) {
    if (value) json_[name] = write(*value);
  }

  template <typename... Alternatives>
  void oneOf(std::variant<Alternatives...>& value,
             const char* (*nameOf)(const std::variant<Alternatives...>&)) {
    json_[nameOf(value)] = std::visit([](auto& alternative) { return write(alternative); }, value);
  }

  template <typename Description>
  void list(const char* name, std::vector<Description>& values, std::size_t) {
    json_[name] = nlohmann::ordered_json::array();
    for (Description& value : values) json_[name].push_back(write(value));
  }

  template <typename Key>
  void keys(const char* name, std::vector<Key>& values) {
    list(name, values, values.size());
  }

  void require(const char*) const {}
  void ignoredText(const char*) const {}

  /// A whole object by the list of fields visitFields(writer, value).
  template <typename Description>
  static nlohmann::ordered_json write(Description& value) {
    FieldWriter writer;
    visitFields(writer, value);
    return writer.json_;
  }

 private:
  nlohmann::ordered_json json_ = nlohmann::ordered_json::object();
};

}  // namespace haarlight
