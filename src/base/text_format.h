#pragma once

/// How the reports write numbers and foreign text. No function depends on the locale.

#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "base/utf8.h"

namespace haarlight {

/// A number as std::to_chars writes it with these settings; the shortest text that reads back as
/// the same number without any.
template <typename Number, typename... Settings>
std::string numberText(Number number, Settings... settings) {
  // The longest double in fixed notation has 309 digits before the point.
  char buffer[400];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, number, settings...).ptr};
}

/// "%.9g": enough digits to tell any two float32 numbers apart.
inline std::string floatText(float value) {
  return numberText(value, std::chars_format::general, 9);
}

inline std::string fixedText(double value, int decimals) {
  return numberText(value, std::chars_format::fixed, decimals);
}

/// "12.5 %" for 0.125, with a blank that is not broken.
inline std::string percentText(double part, int decimals) {
  return fixedText(100 * part, decimals) + "\u00A0%";
}

/// "1,234,567".
inline std::string countText(std::uint64_t count) {
  std::string text = numberText(count);
  for (int i = int(text.size()) - 3; i > 0; i -= 3) text.insert(std::size_t(i), ",");
  return text;
}

/// "1 row", "2,048 rows".
inline std::string countText(std::uint64_t count, const std::string& noun) {
  return countText(count) + " " + noun + (count == 1 ? "" : "s");
}

/// "0x3f800000".
inline std::string bitsText(std::uint32_t bits) {
  const std::string digits = numberText(bits, 16);
  return "0x" + std::string(8 - digits.size(), '0') + digits;
}

/// The parts that are not empty, with `separator` between them.
inline std::string joined(std::initializer_list<std::string_view> parts,
                          std::string_view separator) {
  std::string text;
  for (const std::string_view part : parts)
    if (!part.empty()) text.append(text.empty() ? "" : separator).append(part);
  return text;
}

/// `text` as one line of valid UTF-8 that neither a terminal nor XML 1.0 stumbles over: control
/// characters and the like become "\x1b", bytes that are no UTF-8 become U+FFFD.
inline std::string visible(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const char32_t point = takeCodePoint(text);
    const bool control = point < 0x20 || (point >= 0x7F && point < 0xA0);
    const bool noCharacter = (point & 0xFFFE) == 0xFFFE;
    if (point == '\n')
      result += "\\n";
    else if (control || noCharacter)
      result += "\\x" + numberText(std::uint32_t(point), 16);
    else
      appendUtf8(result, point);
  }
  return result;
}

/// visible() for XML and HTML, in elements as well as in quoted attributes.
inline std::string markup(std::string_view text) {
  std::string result;
  for (const char c : visible(text)) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\'')
      result += "&#39;";
    else
      result += c;
  }
  return result;
}

}  // namespace haarlight
