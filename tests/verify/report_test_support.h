#pragma once

/// Readers of what the reports write: small, strict, and independent of the writers. All throw
/// std::runtime_error where the text or picture is not valid.

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace haarlight::test {

inline void expect(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

/// A text that is taken from its beginning.
struct TextReader {
  std::string_view rest;

  bool take(std::string_view wanted) {
    if (!rest.starts_with(wanted)) return false;
    rest.remove_prefix(wanted.size());
    return true;
  }
  void need(std::string_view wanted) {
    expect(take(wanted), "no '" + std::string(wanted) + "' at: " + std::string(rest.substr(0, 40)));
  }
  std::string takeUntil(std::string_view ends) {
    const std::size_t length = std::min(rest.find_first_of(ends), rest.size());
    const std::string taken(rest.substr(0, length));
    rest.remove_prefix(length);
    return taken;
  }
  std::string takeDigits() {
    const std::size_t length = std::min(rest.find_first_not_of("0123456789"), rest.size());
    expect(length > 0, "no digit at: " + std::string(rest.substr(0, 40)));
    const std::string taken(rest.substr(0, length));
    rest.remove_prefix(length);
    return taken;
  }
  void skipBlanks() { rest.remove_prefix(std::min(rest.find_first_not_of(" \n"), rest.size())); }
};

/// The scalars of a JSON text as they are written, by place: "/rows/0/stage" → "\"bit_cubes\"".
using Json = std::map<std::string, std::string>;

inline void readJsonNumber(TextReader& reader) {
  reader.take("-");
  const std::string whole = reader.takeDigits();
  expect(whole.size() == 1 || whole[0] != '0', "leading zero");
  if (reader.take(".")) reader.takeDigits();
  if (!reader.take("e")) return;
  if (!reader.take("-")) reader.take("+");
  reader.takeDigits();
}

/// A string with its quotes and escapes.
inline std::string readJsonString(TextReader& reader) {
  const std::string_view begin = reader.rest;
  reader.need("\"");
  for (;;) {
    for (const char c : reader.takeUntil("\"\\"))
      expect(std::uint8_t(c) >= 0x20, "control character");
    if (reader.take("\"")) return std::string(begin.substr(0, begin.size() - reader.rest.size()));
    reader.need("\\");
    expect(!reader.rest.empty() && std::string_view("\"\\/bfnrtu").find(reader.rest[0]) < 9,
           "escape");
    if (reader.take("u"))
      expect(reader.rest.find_first_not_of("0123456789abcdef") >= 4, "escape of four digits");
    else
      reader.rest.remove_prefix(1);
  }
}

inline void readJsonValue(TextReader& reader, const std::string& place, Json& values) {
  const bool object = reader.rest.starts_with('{');
  if (object || reader.rest.starts_with('[')) {
    const std::string end = object ? "}" : "]";
    reader.rest.remove_prefix(1);
    reader.skipBlanks();
    if (reader.take(end)) return;
    for (int index = 0;; ++index) {
      std::string name = std::to_string(index);
      if (object) {
        name = readJsonString(reader);
        name = name.substr(1, name.size() - 2);
        reader.need(": ");
      }
      readJsonValue(reader, place + "/" + name, values);
      reader.skipBlanks();
      if (reader.take(end)) return;
      reader.need(",");
      reader.skipBlanks();
    }
  }
  const std::string_view begin = reader.rest;
  if (begin.starts_with('"'))
    readJsonString(reader);
  else if (!reader.take("true") && !reader.take("false") && !reader.take("null"))
    readJsonNumber(reader);
  const std::string scalar(begin.substr(0, begin.size() - reader.rest.size()));
  expect(values.emplace(place, scalar).second, "twice: " + place);
}

inline Json readJson(std::string_view text) {
  Json values;
  TextReader reader{text};
  readJsonValue(reader, "", values);
  reader.skipBlanks();
  expect(reader.rest.empty(), "text after the end");
  return values;
}

/// The names directly below a place.
inline std::set<std::string> namesBelow(const Json& json, const std::string& place) {
  std::set<std::string> names;
  for (const auto& [key, ignored] : json)
    if (key.starts_with(place + "/"))
      names.insert(
          key.substr(place.size() + 1, key.find('/', place.size() + 1) - place.size() - 1));
  return names;
}

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  /// The text directly in it.
  std::string text;
};

/// A text with its references resolved.
inline std::string readXmlText(const std::string& written) {
  static const std::map<std::string, char> references{
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"#39", '\''}};
  std::string text;
  TextReader reader{written};
  while (!reader.rest.empty()) {
    for (const char c : reader.takeUntil("&")) {
      expect(std::uint8_t(c) >= 0x20 || c == '\n', "character that XML 1.0 forbids");
      text += c;
    }
    if (!reader.take("&")) continue;
    text += references.at(reader.takeUntil(";"));
    reader.need(";");
  }
  return text;
}

inline Element readXmlTag(TextReader& reader) {
  Element element;
  element.name = reader.takeUntil(" />");
  while (reader.take(" ")) {
    const std::string name = reader.takeUntil("=");
    reader.need("=\"");
    const std::string value = reader.takeUntil("\"<");
    reader.need("\"");
    expect(element.attributes.emplace(name, readXmlText(value)).second, "attribute twice");
  }
  return element;
}

/// The elements of an XML text, in order of their beginnings. Knows no comments, CDATA and
/// processing instructions but the declaration (or HTML's document type) at the head.
inline std::vector<Element> readXml(std::string_view text) {
  TextReader reader{text};
  if (!reader.take("<!DOCTYPE html>\n"))
    reader.need("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  std::vector<Element> elements;
  std::vector<std::size_t> open;
  do {
    reader.need("<");
    if (reader.take("/")) {
      expect(!open.empty() && reader.takeUntil(">") == elements[open.back()].name, "wrong end tag");
      open.pop_back();
    } else {
      open.push_back(elements.size());
      elements.push_back(readXmlTag(reader));
      if (reader.take("/")) open.pop_back();
    }
    reader.need(">");
    const std::string between = readXmlText(reader.takeUntil("<"));
    if (!open.empty()) elements[open.back()].text += between;
  } while (!open.empty());
  expect(reader.rest.empty(), "text after the root");
  return elements;
}

inline std::vector<Element> named(const std::vector<Element>& elements, const std::string& name) {
  std::vector<Element> found;
  for (const Element& element : elements)
    if (element.name == name) found.push_back(element);
  return found;
}

}  // namespace haarlight::test
