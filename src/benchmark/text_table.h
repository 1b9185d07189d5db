#pragma once

#include <string>
#include <vector>

namespace haarlight::benchmark {

using Cells = std::vector<std::string>;

/// Lines of cells below one another, two blanks between them; the first `leftColumns` stand to the
/// left, the others to the right. All lines have as many cells.
std::string alignedText(const std::vector<Cells>& lines, std::size_t leftColumns,
                        const std::string& indent);

}  // namespace haarlight::benchmark
