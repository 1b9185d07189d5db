#include "mesh/text_lines.h"

#include <algorithm>

namespace haarlight {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

/// Through double, as std::from_chars does not read what is below the smallest float.
bool parseCoordinate(std::string_view word, float& value) {
  double precise = 0;
  if (!parseNumber(word, precise)) return false;
  value = static_cast<float>(precise);
  return std::isfinite(value);
}

}  // namespace

bool TextLines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line = rest_.substr(0, end);
  if (line.ends_with('\r')) line.remove_suffix(1);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return true;
}

std::string_view takeWord(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
  const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

bool takeVector(std::string_view& line, glm::vec3& vector) {
  return parseCoordinate(takeWord(line), vector.x) && parseCoordinate(takeWord(line), vector.y) &&
         parseCoordinate(takeWord(line), vector.z);
}

}  // namespace haarlight
