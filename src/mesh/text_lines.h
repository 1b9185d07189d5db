#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <string_view>

namespace haarlight {

/// Walks over the lines of a text; a line ends with LF or CR LF.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}

  /// Moves to the next line; false at the end of the text.
  bool next(std::string_view& line);
  /// Number of the current line, from 1.
  std::size_t number() const { return number_; }
  /// What follows the current line.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// Takes the next word, set off by blanks, from the front of `line`; empty when there is none.
std::string_view takeWord(std::string_view& line);

/// Reads a number that takes up the whole of `word`; false when it is none, too large or not
/// finite.
template <typename Number>
bool parseNumber(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end && std::isfinite(static_cast<double>(value));
}

/// Takes three finite numbers from the front of `line`; false when they are not there.
bool takeVector(std::string_view& line, glm::vec3& vector);

}  // namespace haarlight
