#include "benchmark/text_table.h"

#include <algorithm>

namespace haarlight::benchmark {

namespace {

/// Characters of UTF-8.
std::size_t widthOf(const std::string& text) {
  return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string alignedText(const std::vector<Cells>& lines, std::size_t leftColumns,
                        const std::string& indent) {
  std::vector<std::size_t> widths;
  for (const Cells& cells : lines) {
    widths.resize(std::max(widths.size(), cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i)
      widths[i] = std::max(widths[i], widthOf(cells[i]));
  }
  std::string text;
  for (const Cells& cells : lines) {
    std::string line = indent;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string blanks(widths[i] - widthOf(cells[i]), ' ');
      line += (i > 0 ? "  " : "") + (i < leftColumns ? cells[i] + blanks : blanks + cells[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace haarlight::benchmark
