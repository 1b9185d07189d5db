#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/json_value.h"

namespace haarlight {

/// Reads the fields of one JSON object into variables; a field that is absent leaves its variable
/// as it was. It remembers what it was asked for, so that refuseUnknown() can complain of the rest.
/// FieldWriter has the same functions, so that one list of fields (scene/scene_fields.h) serves
/// both.
class FieldReader {
 public:
  explicit FieldReader(const JsonValue& object) : object_(object) { object.requireObject(); }

  void flag(const char* name, bool& value);
  void integer(const char* name, int& value, const Range& range);
  void integer(const char* name, std::optional<int>& value, const Range& range);
  void number(const char* name, double& value, const Range& range);
  void number(const char* name, std::optional<double>& value, const Range& range);
  void text(const char* name, std::string& value);
  void text(const char* name, std::optional<std::string>& value);
  void path(const char* name, std::optional<std::filesystem::path>& value);
  void resource(const char* name, std::string& value, const std::vector<std::string>& builtins);
  void resource(const char* name, std::optional<std::string>& value,
                const std::vector<std::string>& builtins);
  void word(const char* name, std::string& value, std::span<const std::string_view> words);
  /// A number stands for three equal ones.
  void numberOrVector(const char* name, glm::dvec3& value, const Range& range);
  void countOrFile(const char* name, std::variant<int, std::filesystem::path>& value,
                   const Range& range);
  /// `word` stands for no value.
  void numberOrWord(const char* name, std::optional<double>& value, const char* word,
                    const Range& range);
  void vectorOrWord(const char* name, std::optional<glm::dvec3>& value, const char* word,
                    const Range& range);

  template <typename Vector>
  void vector(const char* name, Vector& value, const Range& range) {
    if (const auto field = find(name)) value = field->vector<Vector>(range);
  }

  template <typename Vector>
  void vector(const char* name, std::optional<Vector>& value, const Range& range) {
    if (const auto field = find(name)) value = field->vector<Vector>(range);
  }

  /// `value` is a Choice or a std::optional of one.
  template <typename Value, typename Choice, std::size_t count>
  void choice(const char* name, Value& value, const std::array<Named<Choice>, count>& names) {
    if (const auto field = find(name)) value = field->choice(names);
  }

  template <typename Description>
  void object(const char* name, Description& value) {
    if (const auto field = find(name)) read(*field, value);
  }

  template <typename Description>
  void object(const char* name, std::optional<Description>& value) {
    if (const auto field = find(name)) read(*field, value.emplace());
  }

  /// The object has one field, which is named as `nameOf` names an alternative, and holds it.
  template <typename... Alternatives>
  void oneOf(std::variant<Alternatives...>& value,
             const char* (*nameOf)(const std::variant<Alternatives...>&)) {
    (alternative<Alternatives>(nameOf(Alternatives{}), value), ...);
    requireOneKnown();
  }

  template <typename Description>
  void list(const char* name, std::vector<Description>& values, std::size_t maximumSize) {
    const auto field = find(name);
    if (!field) return;
    field->requireArray(maximumSize);
    for (std::size_t i = 0; i < field->json().size(); ++i)
      read(field->element(i), values.emplace_back());
  }

  /// A list that must be there, of 1 to 65536 objects whose `seconds` increase.
  template <typename Key>
  void keys(const char* name, std::vector<Key>& values) {
    require(name);
    list(name, values, 65536);
    requireIncreasingSeconds(object_.member(name));
  }

  /// Throws InputError when the field is absent.
  void require(const char* name) const;
  /// A text that is allowed and says nothing.
  void ignoredText(const char* name);
  /// Throws InputError when the object has a field that was not asked for.
  void refuseUnknown() const;

  /// Reads a whole object by the list of fields visitFields(reader, value).
  template <typename Description>
  static void read(const JsonValue& object, Description& value) {
    FieldReader reader(object);
    visitFields(reader, value);
    reader.refuseUnknown();
  }

 private:
  std::optional<JsonValue> find(const char* name);

  template <typename Alternative, typename Variant>
  void alternative(const char* name, Variant& value) {
    if (const auto field = find(name)) read(*field, value.template emplace<Alternative>());
  }

  void requireOneKnown() const;
  static void requireIncreasingSeconds(const JsonValue& keys);

  JsonValue object_;
  std::vector<std::string_view> knownNames_;
};

}  // namespace haarlight
