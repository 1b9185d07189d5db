#include "scene/json_value.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace haarlight {

namespace {

/// A short ASCII line for a message.
std::string describe(const nlohmann::json& value) {
  if (value.is_array()) return fmt::format("an array of {}", value.size());
  if (value.is_object()) return "an object";
  constexpr std::size_t longest = 60;
  const std::string text = value.dump(-1, ' ', true);
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

std::size_t characterCount(const std::string& utf8) {
  return std::count_if(utf8.begin(), utf8.end(), [](char byte) { return (byte & 0xC0) != 0x80; });
}

bool isControlCharacter(char byte) {
  return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F;
}

}  // namespace

void JsonValue::fail(const std::string& problem) const {
  throw InputError(source_.name + ": " + (place_.empty() ? "" : place_ + ": ") + problem);
}

void JsonValue::failWithValue(const std::string& problem) const {
  fail(problem + ", is " + describe(value_));
}

bool JsonValue::flag() const {
  if (!value_.is_boolean()) failWithValue("must be true or false");
  return value_.get<bool>();
}

double JsonValue::number(const Range& range) const {
  if (!isNumber()) failWithValue("must be a number");
  const double number = value_.get<double>();
  if (range.minimum == range.maximum && number != range.minimum)
    failWithValue(fmt::format("must be {}", range.minimum));
  if (!(number >= range.minimum)) failWithValue(fmt::format("must be >= {}", range.minimum));
  if (!(number <= range.maximum)) failWithValue(fmt::format("must be <= {}", range.maximum));
  return number;
}

int JsonValue::integer(const Range& range) const {
  const double value = number(range);
  if (value != std::floor(value)) failWithValue("must be a whole number");
  return static_cast<int>(value);
}

std::string JsonValue::text() const {
  constexpr std::size_t longest = 1024;
  if (!isText()) failWithValue("must be text in quotes");
  const auto text = value_.get<std::string>();
  if (text.empty()) fail("must not be empty");
  if (characterCount(text) > longest) fail(fmt::format("must be at most {} characters", longest));
  if (std::any_of(text.begin(), text.end(), isControlCharacter))
    failWithValue("must not hold control characters");
  return text;
}

std::filesystem::path JsonValue::path() const {
  const std::string name = text();
  if (name.starts_with(builtinPrefix)) failWithValue("must be the path of a file");
  return (source_.folder / name).lexically_normal();
}

std::string JsonValue::resource(const std::vector<std::string>& builtins) const {
  const std::string name = text();
  if (!name.starts_with(builtinPrefix)) return path().string();
  if (std::find(builtins.begin(), builtins.end(), name) == builtins.end())
    failWithValue("must be a path or one of " + joinNames(builtins));
  return name;
}

std::string JsonValue::word(std::span<const std::string_view> words) const {
  if (std::find(words.begin(), words.end(), value_) == words.end())
    failWithValue("must be one of " + joinNames(words));
  return value_.get<std::string>();
}

void JsonValue::requireObject() const {
  if (!value_.is_object()) failWithValue("must be an object {...}");
}

void JsonValue::requireArray(std::size_t maximumSize) const {
  if (!value_.is_array()) failWithValue("must be an array [...]");
  if (value_.size() > maximumSize)
    failWithValue(fmt::format("must be an array of at most {}", maximumSize));
}

void JsonValue::requireArrayOf(std::size_t size) const {
  if (!value_.is_array() || value_.size() != size)
    failWithValue(fmt::format("must be an array of {} numbers", size));
}

JsonValue JsonValue::element(std::size_t index) const {
  return {value_[index], fmt::format("{}[{}]", place_, index), source_};
}

JsonValue JsonValue::member(const std::string& name) const {
  return {value_[name], place_.empty() ? name : place_ + "." + name, source_};
}

}  // namespace haarlight
