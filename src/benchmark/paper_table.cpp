#include "benchmark/paper_table.h"

#include <array>

namespace haarlight::benchmark {

namespace {

struct PaperRow {
  int spheres, terms;
  double cpu, gpuI, gpuII;
};

constexpr std::array<PaperRow, 8> paperRows{{
    {32, 50, 2.91, 34.45, 31.53},
    {64, 50, 1.91, 24.83, 23.62},
    {96, 50, 1.42, 18.72, 18.15},
    {128, 50, 1.13, 15.50, 15.07},
    {32, 200, 1.52, 27.16, 22.64},
    {64, 200, 1.20, 21.01, 17.87},
    {96, 200, 0.98, 16.75, 14.78},
    {128, 200, 0.83, 14.10, 12.80},
}};

}  // namespace

std::optional<PaperFigures> paperFigures(int spheres, int terms, int levels) {
  for (const PaperRow& row : paperRows)
    if (row.spheres == spheres && row.terms == terms)
      return PaperFigures{row.cpu, levels == 1 ? row.gpuI : row.gpuII};
  return std::nullopt;
}

}  // namespace haarlight::benchmark
