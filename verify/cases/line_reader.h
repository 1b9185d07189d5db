#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace haarlight::verify {

/// Walks over the lines of a text, and over the words of each. A line is a keyword and what belongs
/// to it; empty lines and lines that begin with # are passed over; a line ends with LF or CR LF and
/// has at most 4,096 characters. Whatever is wrong throws InputError, which names source and line.
class LineReader {
 public:
  /// The text must stay alive.
  LineReader(std::string_view text, std::string source) : rest_(text), source_(std::move(source)) {}

  /// Moves to the next line that holds something; false at the end of the text.
  bool next();

  /// Moves to the first line, which must say `format` and version 1.
  void expectHeader(const std::string& format);

  /// First word of the line.
  std::string_view keyword() const { return keyword_; }
  bool hasWord() const { return !line_.empty(); }

  /// What follows on the line. `what` names it in messages, as in "the radius of a sphere".
  std::string_view word(const std::string& what);
  std::string_view restOfLine(const std::string& what);
  /// A finite number, decimal or hexadecimal (0x1.8p+3).
  float number(const std::string& what);
  /// A whole number in low … high.
  std::uint64_t wholeNumber(const std::string& what, std::uint64_t low, std::uint64_t high);
  /// `digits` hexadecimal digits.
  std::uint64_t hexadecimal(const std::string& what, std::size_t digits);
  /// Fails when there is anything left on the line.
  void endLine();

  /// `problem` is a sentence that also says what to do.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::string_view takeWord();

  /// The text behind the current line, and what is not yet read of the line.
  std::string_view rest_, line_, keyword_;
  std::string source_;
  std::size_t number_ = 0;
};

}  // namespace haarlight::verify
