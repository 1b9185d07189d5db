#include "verify/report/json_writer.h"

#include <cmath>
#include <stdexcept>

#include "base/text_format.h"
#include "base/utf8.h"

namespace haarlight::verify {

namespace {

void require(bool condition, const char* rule) {
  if (!condition) throw std::logic_error(std::string("JSON: ") + rule);
}

std::string escaped(char32_t point) {
  constexpr std::string_view characters = "\"\\\b\f\n\r\t", letters = "\"\\bfnrt";
  if (point < 0x80)
    if (const auto i = characters.find(char(point)); i != std::string_view::npos)
      return {'\\', letters[i]};
  constexpr char hexadecimal[] = "0123456789abcdef";
  if (point < 0x20) return {'\\', 'u', '0', '0', hexadecimal[point >> 4], hexadecimal[point & 15]};
  std::string text;
  appendUtf8(text, point);
  return text;
}

}  // namespace

JsonWriter& JsonWriter::beginObject() {
  return begin('{');
}
JsonWriter& JsonWriter::beginArray() {
  return begin('[');
}

JsonWriter& JsonWriter::begin(char bracket) {
  beforeValue();
  text_ += bracket;
  open_.push_back({.object = bracket == '{'});
  return *this;
}

JsonWriter& JsonWriter::end() {
  require(!open_.empty(), "nothing is begun");
  require(!open_.back().expectsValue, "a key has no value");
  const Open ended = open_.back();
  open_.pop_back();
  if (!ended.empty) newLine();
  text_ += ended.object ? '}' : ']';
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  require(!open_.empty() && open_.back().object, "a key stands outside of objects");
  Open& open = open_.back();
  require(!open.expectsValue, "a key has no value");
  require(open.keys.emplace(name).second, "a key is given twice");
  separate(open);
  quote(name);
  text_ += ": ";
  open.expectsValue = true;
  return *this;
}

JsonWriter& JsonWriter::null() {
  return literal("null");
}

JsonWriter& JsonWriter::value(std::string_view text) {
  beforeValue();
  quote(text);
  return *this;
}

JsonWriter& JsonWriter::value(float number) {
  return finiteNumber(number);
}
JsonWriter& JsonWriter::value(double number) {
  return finiteNumber(number);
}

template <typename Number>
JsonWriter& JsonWriter::finiteNumber(Number number) {
  return std::isfinite(number) ? literal(numberText(number)) : null();
}

JsonWriter& JsonWriter::textOrNull(std::string_view name, std::string_view text) {
  key(name);
  return text.empty() ? null() : value(text);
}

std::string JsonWriter::text() const {
  require(open_.empty() && !text_.empty(), "the text is not complete");
  return text_ + '\n';
}

JsonWriter& JsonWriter::literal(std::string_view text) {
  beforeValue();
  text_ += text;
  return *this;
}

void JsonWriter::beforeValue() {
  if (open_.empty()) {
    require(text_.empty(), "a second value stands at the top");
    return;
  }
  Open& open = open_.back();
  require(open.expectsValue || !open.object, "a value has no key");
  if (!open.object) separate(open);
  open.expectsValue = false;
}

void JsonWriter::separate(Open& open) {
  if (!open.empty) text_ += ',';
  open.empty = false;
  newLine();
}

void JsonWriter::newLine() {
  text_.append("\n").append(2 * open_.size(), ' ');
}

void JsonWriter::quote(std::string_view text) {
  text_ += '"';
  while (!text.empty()) text_ += escaped(takeCodePoint(text));
  text_ += '"';
}

}  // namespace haarlight::verify
