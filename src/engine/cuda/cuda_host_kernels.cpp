#include "engine/cuda/cuda_host_kernels.h"

#include <cstring>
#include <utility>

#include "engine/cuda/host_emulation.h"
#include "engine/kernel_constants.h"

namespace haarlight {

namespace cuda_host_kernels {

using namespace host_emulation;

#include "engine/cuda/all_kernels.inc"

}  // namespace cuda_host_kernels

namespace {

template <typename Value>
Value valueAt(const void* address) {
  Value value;
  std::memcpy(&value, address, sizeof value);
  return value;
}

template <typename... Parameters, std::size_t... index>
void call(void (*kernel)(Parameters...), void* const* values, std::index_sequence<index...>) {
  kernel(valueAt<Parameters>(values[index])...);
}

template <typename... Parameters>
CudaHostKernel describe(const char* name, void (*kernel)(Parameters...)) {
  return {kernelSignature(name, kernel), [kernel](void* const* values) {
            call(kernel, values, std::index_sequence_for<Parameters...>());
          }};
}

}  // namespace

const std::vector<CudaHostKernel>& cudaHostKernels() {
#define HAARLIGHT_DESCRIBE(kernel) describe(#kernel, cuda_host_kernels::kernel),
  static const std::vector<CudaHostKernel> kernels{HAARLIGHT_CUDA_KERNELS(HAARLIGHT_DESCRIBE)};
#undef HAARLIGHT_DESCRIBE
  return kernels;
}

}  // namespace haarlight
