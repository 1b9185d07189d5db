#pragma once

#include <concepts>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace haarlight::verify {

/// Writes one JSON value (RFC 8259) member by member, indented by two blanks:
///
///   JsonWriter json;
///   json.beginObject().key("rows").beginArray().value(1).value(2.5f).end().end();
///   json.text();
///
/// Every call that would not give valid JSON (a value without its key, a second value at the top, a
/// key given twice in an object, an end too many) throws std::logic_error.
class JsonWriter {
 public:
  JsonWriter& beginObject();
  JsonWriter& beginArray();
  /// Ends the object or array begun last.
  JsonWriter& end();
  JsonWriter& key(std::string_view name);

  JsonWriter& null();
  /// Bytes that are no UTF-8 become U+FFFD.
  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(const std::string& text) { return value(std::string_view(text)); }
  /// Reads back as the same number; NaN and infinities become null.
  JsonWriter& value(float number);
  JsonWriter& value(double number);
  template <std::integral Integer>
  JsonWriter& value(Integer number) {
    if constexpr (std::same_as<Integer, bool>)
      return literal(number ? "true" : "false");
    else
      return literal(std::to_string(number));
  }

  /// A key and its value.
  template <typename Value>
  JsonWriter& member(std::string_view name, const Value& content) {
    return key(name).value(content);
  }
  /// The same, an empty text as null.
  JsonWriter& textOrNull(std::string_view name, std::string_view text);

  /// The whole text, with a newline at its end.
  std::string text() const;

 private:
  /// An object or array that is begun and not ended.
  struct Open {
    bool object;
    bool empty = true;
    bool expectsValue = false;
    std::set<std::string, std::less<>> keys = {};
  };

  JsonWriter& begin(char bracket);
  JsonWriter& literal(std::string_view text);
  template <typename Number>
  JsonWriter& finiteNumber(Number number);
  void beforeValue();
  void separate(Open& open);
  void newLine();
  void quote(std::string_view text);

  std::string text_;
  std::vector<Open> open_;
};

}  // namespace haarlight::verify
