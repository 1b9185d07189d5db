#include "engine/cuda/cuda_kernels.h"

#include "engine/kernel_constants.h"

namespace haarlight {

namespace cuda_kernels {

#include "engine/cuda/all_kernels.inc"

}  // namespace cuda_kernels

namespace {

template <typename... Parameters>
CudaKernel describe(const char* name, void (*kernel)(Parameters...)) {
  return {kernelSignature(name, kernel), reinterpret_cast<const void*>(kernel)};
}

}  // namespace

const std::vector<CudaKernel>& cudaKernels() {
#define HAARLIGHT_DESCRIBE(kernel) describe(#kernel, cuda_kernels::kernel),
  static const std::vector<CudaKernel> kernels{HAARLIGHT_CUDA_KERNELS(HAARLIGHT_DESCRIBE)};
#undef HAARLIGHT_DESCRIBE
  return kernels;
}

}  // namespace haarlight
