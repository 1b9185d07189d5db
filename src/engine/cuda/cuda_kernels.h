#pragma once

#include "engine/cuda/kernel_call.h"

namespace haarlight {

/// A kernel as cudaLaunchKernel takes it.
struct CudaKernel {
  KernelSignature signature;
  const void* function;
};

/// All kernels of cuda/, compiled for GPUs.
const std::vector<CudaKernel>& cudaKernels();

}  // namespace haarlight
