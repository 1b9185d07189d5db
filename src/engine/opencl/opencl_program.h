#pragma once

#include <string>

#include "engine/opencl/opencl_api.h"

namespace haarlight {

/// The source every kernel is built from: constants of the host as #defines, then the files of
/// opencl/. `lanesPerItem` is 1 or 32 (opencl/lanes.cl).
std::string openClSource(int lanesPerItem);

/// Builds the program for one device as OpenCL C 1.1, without options that change results. When
/// HAARLIGHT_DUMP_KERNELS names a file, the source is written there first. A failed build throws
/// with the compiler's log.
cl::Program buildOpenClProgram(const cl::Context& context, const cl::Device& device,
                               int lanesPerItem);

}  // namespace haarlight
