#pragma once

/// The part of CUDA that the kernels of cuda/ use, for an ordinary C++ compiler, so that they run,
/// and are tested, without a GPU. Every thread of a block has a stack of its own and runs until it
/// meets a barrier or ends, then the next one does; so a block goes from barrier to barrier as on a
/// GPU, one thread at a time. Shared memory is there once for each host thread, and blocks are
/// spread over the host's threads.
///
/// A kernel's file is included inside a namespace with `using namespace host_emulation`.

#include <bit>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

#define __global__
#define __device__
#define __launch_bounds__(threads)
#define __shared__ static thread_local
/// cuda/lanes.cu tells of its shared memory by this, so that reading it before it was written
/// shows.
#define NEW_SHARED_MEMORY(array) newSharedMemory(array, sizeof(array))
#define UNROLL

namespace haarlight::host_emulation {

struct alignas(16) float4 {
  float x, y, z, w;
};
struct alignas(8) float2 {
  float x, y;
};
struct alignas(16) uint4 {
  unsigned x, y, z, w;
};
struct Index3 {
  unsigned x = 0, y = 0, z = 0;
};

inline float4 make_float4(float x, float y, float z, float w) {
  return {x, y, z, w};
}

inline uint4 make_uint4(unsigned x, unsigned y, unsigned z, unsigned w) {
  return {x, y, z, w};
}

inline int min(int a, int b) {
  return a < b ? a : b;
}
inline int max(int a, int b) {
  return a > b ? a : b;
}
inline unsigned min(unsigned a, unsigned b) {
  return a < b ? a : b;
}
inline unsigned max(unsigned a, unsigned b) {
  return a > b ? a : b;
}

inline float __uint_as_float(unsigned bits) {
  return std::bit_cast<float>(bits);
}
inline unsigned __float_as_uint(float value) {
  return std::bit_cast<unsigned>(value);
}
inline float fmaxf(float a, float b) {
  return std::fmax(a, b);
}

/// a·b + c, rounded once.
inline float __fmaf_rn(float a, float b, float c) {
  return std::fma(a, b, c);
}

extern constinit thread_local Index3 threadIdx, blockIdx, blockDim;

/// Waits until all threads of the block have come here.
void __syncthreads();

/// Fills memory that a block finds with NaN, before any of its threads writes to it.
void newSharedMemory(void* memory, std::size_t bytes);

/// Runs `thread` once for every thread of every block, with threadIdx and blockIdx set. In blocks
/// of even number threads run in ascending order between barriers, in the others in descending
/// order: where a barrier is missing, one of the two reads what has not been written yet. Throws
/// std::logic_error, with the kernel's name, when some threads of a block end while others wait at
/// a barrier; a GPU would hang or go on with wrong values.
void runBlocks(const std::string& kernel, std::size_t blocks, Index3 threadsPerBlock,
               const std::function<void()>& thread);

}  // namespace haarlight::host_emulation
