#pragma once

#include <string>

#include "verify/report/report.h"

namespace haarlight::verify {

/// Words for where a value stands. Indices are those of the arrays that engines return.

/// "face +X, row 3, column 17" of a bit cube; `word` is face · 32 + row.
Place bitPlace(int word, int column);

/// "face +X, level 2, row 1, column 0, diagonal coefficient" of OcclusionHaar::coefficients.
Place coefficientPlace(int index);

/// "face +X, level 2, row 1, column 0, mean" of OcclusionHaar::means.
Place meanPlace(int index);

/// "face +X, block row 3, block column 4" of OcclusionHaar::blocks.
Place blockPlace(int index);

/// "sphere 12: centre y" or "sphere 12: radius" of a moved sphere; `number` is 0 … 3.
Place movedSpherePlace(std::size_t sphere, int number);

/// "sphere 12: face +X, row 3, column 17, radius bin 5" of an entry of the sphere table.
Place entryPlace(std::size_t sphere, std::uint32_t entry);

/// "red", "green", "blue" or "alpha".
Place channelPlace(int channel);

}  // namespace haarlight::verify
