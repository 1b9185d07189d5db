#pragma once

#include <cuda_runtime_api.h>

#include <stdexcept>
#include <string>

namespace haarlight {

/// Turns CUDA's errors into exceptions in words.
inline void checkCuda(cudaError_t status, const char* call) {
  if (status == cudaSuccess) return;
  cudaGetLastError();  // or the next launch would report it again
  throw std::runtime_error(std::string("CUDA call ") + call +
                           " failed: " + cudaGetErrorString(status));
}

/// HAARLIGHT_CUDA_CALL(cudaMalloc, &memory, bytes) calls cudaMalloc(&memory, bytes).
#define HAARLIGHT_CUDA_CALL(call, ...) ::haarlight::checkCuda(call(__VA_ARGS__), #call)

}  // namespace haarlight
