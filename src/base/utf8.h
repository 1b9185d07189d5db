#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace haarlight {

/// Stands for bytes that are no UTF-8.
inline constexpr char32_t replacementCharacter = 0xFFFD;

/// Takes the first code point off a text that is not empty. Bytes that are no UTF-8 (also overlong
/// forms, surrogates and numbers above 10FFFF) are taken one by one as replacementCharacter.
inline char32_t takeCodePoint(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return std::uint8_t(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  constexpr char32_t smallest[]{0, 0, 0x80, 0x800, 0x10000};
  char32_t point = length == 1 ? first : first & (0x7F >> length);
  bool valid = length == 1 || (first >= 0xC2 && first <= 0xF4 && length <= text.size());
  for (std::size_t i = 1; valid && i < length; ++i) {
    valid = (byte(i) & 0xC0) == 0x80;
    point = point << 6 | (byte(i) & 0x3F);
  }
  const bool surrogate = point >= 0xD800 && point <= 0xDFFF;
  valid = valid && point >= smallest[length] && point <= 0x10FFFF && !surrogate;
  text.remove_prefix(valid ? length : 1);
  return valid ? point : replacementCharacter;
}

/// Appends a code point as UTF-8.
inline void appendUtf8(std::string& text, char32_t point) {
  if (point < 0x80) {
    text += char(point);
    return;
  }
  const int following = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
  text += char((0xFF00 >> (following + 1) & 0xFF) | point >> 6 * following);
  for (int i = following - 1; i >= 0; --i) text += char(0x80 | (point >> 6 * i & 0x3F));
}

}  // namespace haarlight
