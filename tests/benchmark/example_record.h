#pragma once

#include "benchmark/record.h"

namespace haarlight::test {

/// Two subjects with made-up times: exact with 64 spheres, 200 terms, level 2 at 4 ms a frame, and
/// 7 spheres, which the paper does not have; table with the former at 8 ms.
benchmark::Record exampleRecord();

/// The same with peers and errors.
benchmark::Record recordWithPeers();

/// The first with ceilings, and a roofline of the row with the table.
benchmark::Record recordWithRoofline();

/// Sweeps instead of rows, with a linear law.
benchmark::Record recordWithScale();

}  // namespace haarlight::test
