#include "verify/cases/line_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/text_format.h"

namespace haarlight::verify {

namespace {

constexpr std::size_t longestLine = 4096;
constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A word as a message shows it.
std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  text += visible(word.substr(0, longest));
  text += word.size() > longest ? "…'" : "'";
  return text;
}

template <typename Number, typename Format>
bool parse(std::string_view digits, Number& number, Format format) {
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number, format);
  return error == std::errc() && stop == end;
}

/// from_chars knows neither + nor 0x.
bool parseFloat(std::string_view word, float& number) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) word.remove_prefix(1);
  const bool hexadecimal = word.starts_with("0x");
  if (hexadecimal) word.remove_prefix(2);
  if (word.starts_with('-')) return false;
  const auto format = hexadecimal ? std::chars_format::hex : std::chars_format::general;
  if (!parse(word, number, format) || !std::isfinite(number)) return false;
  if (negative) number = -number;
  return true;
}

}  // namespace

bool LineReader::next() {
  while (!rest_.empty()) {
    ++number_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    if (line_.size() > longestLine)
      fail("the line is longer than " + std::to_string(longestLine) +
           " characters; is this the right file?");
    line_ = trimmed(line_);
    if (line_.empty() || line_.starts_with('#')) continue;
    keyword_ = takeWord();
    return true;
  }
  return false;
}

void LineReader::expectHeader(const std::string& format) {
  if (!next() || keyword() != format) fail("the text must begin with the line '" + format + " 1'");
  wholeNumber("the format's version", 1, 1);
  endLine();
}

std::string_view LineReader::takeWord() {
  const std::string_view first = line_.substr(0, line_.find_first_of(blanks));
  line_ = trimmed(line_.substr(first.size()));
  return first;
}

std::string_view LineReader::word(const std::string& what) {
  if (!hasWord()) fail(what + " is missing; add it to the line");
  return takeWord();
}

std::string_view LineReader::restOfLine(const std::string& what) {
  if (!hasWord()) fail(what + " is missing; add it to the line");
  return std::exchange(line_, {});
}

float LineReader::number(const std::string& what) {
  const std::string_view text = word(what);
  float value = 0;
  if (!parseFloat(text, value))
    fail(what + " must be a finite number that float32 holds, not " + quoted(text));
  return value;
}

std::uint64_t LineReader::wholeNumber(const std::string& what, std::uint64_t low,
                                      std::uint64_t high) {
  const std::string_view text = word(what);
  std::uint64_t value = 0;
  if (!parse(text, value, 10) || value < low || value > high)
    fail(what + " must be a whole number from " + std::to_string(low) + " to " +
         std::to_string(high) + ", not " + quoted(text));
  return value;
}

std::uint64_t LineReader::hexadecimal(const std::string& what, std::size_t digits) {
  const std::string_view text = word(what);
  std::uint64_t value = 0;
  if (text.size() != digits || !parse(text, value, 16))
    fail(what + " must be " + std::to_string(digits) + " hexadecimal digits, not " + quoted(text));
  return value;
}

void LineReader::endLine() {
  if (hasWord()) fail("remove " + quoted(line_) + " at the end of the line");
}

void LineReader::fail(const std::string& problem) const {
  throw InputError(source_ + ":" + std::to_string(number_) + ": " + problem);
}

}  // namespace haarlight::verify
