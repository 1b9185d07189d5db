#pragma once

#include <functional>

#include "engine/cuda/kernel_call.h"

namespace haarlight {

/// A CUDA kernel compiled for the host (engine/cuda/host_emulation.h).
struct CudaHostKernel {
  KernelSignature signature;
  /// Runs one thread, with the values of KernelCall.
  std::function<void(void* const* values)> runThread;
};

/// All kernels of cuda/.
const std::vector<CudaHostKernel>& cudaHostKernels();

}  // namespace haarlight
