#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/names.h"

namespace haarlight {

/// The file a value comes from: `name` for messages; paths in it are relative to `folder`.
struct JsonSource {
  std::string name;
  std::filesystem::path folder;
};

/// The values from minimum to maximum, both included.
struct Range {
  double minimum, maximum;
};

/// A value somewhere in a file. Every conversion throws InputError with file and place
/// ("scene.json: objects[2].transform.scale: must be …") when the value is not what is asked for.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string place, const JsonSource& source)
      : value_(value), place_(std::move(place)), source_(source) {}

  const nlohmann::json& json() const { return value_; }
  bool isNumber() const { return value_.is_number(); }
  bool isText() const { return value_.is_string(); }

  bool flag() const;
  double number(const Range& range) const;
  int integer(const Range& range) const;
  /// 1 to 1024 characters, none of them a control character.
  std::string text() const;
  /// A path, resolved against the file's folder.
  std::filesystem::path path() const;
  /// One of `builtins` as it is, or a path.
  std::string resource(const std::vector<std::string>& builtins) const;
  /// One of `words`.
  std::string word(std::span<const std::string_view> words) const;
  /// An array of as many numbers as Vector has components, each within `range`.
  template <typename Vector>
  Vector vector(const Range& range) const;
  template <typename Choice, std::size_t count>
  Choice choice(const std::array<Named<Choice>, count>& names) const;

  void requireObject() const;
  /// Requires an array of at most `maximumSize` values.
  void requireArray(std::size_t maximumSize) const;
  JsonValue element(std::size_t index) const;
  JsonValue member(const std::string& name) const;

  /// Throws InputError "<file>: <place>: <problem>".
  [[noreturn]] void fail(const std::string& problem) const;
  /// The same with ", is <value>" at the end.
  [[noreturn]] void failWithValue(const std::string& problem) const;

 private:
  void requireArrayOf(std::size_t size) const;

  const nlohmann::json& value_;
  std::string place_;
  const JsonSource& source_;
};

/// "a, b, c"
template <typename Names>
std::string joinNames(const Names& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

template <typename Vector>
Vector JsonValue::vector(const Range& range) const {
  requireArrayOf(Vector::length());
  Vector result{};
  for (int i = 0; i < Vector::length(); ++i) {
    if constexpr (std::is_integral_v<typename Vector::value_type>)
      result[i] = element(i).integer(range);
    else
      result[i] = element(i).number(range);
  }
  return result;
}

template <typename Choice, std::size_t count>
Choice JsonValue::choice(const std::array<Named<Choice>, count>& names) const {
  std::array<std::string_view, count> words;
  std::transform(names.begin(), names.end(), words.begin(),
                 [](const Named<Choice>& named) { return named.name; });
  const std::string chosen = word(words);
  return names[std::find(words.begin(), words.end(), chosen) - words.begin()].choice;
}

}  // namespace haarlight
