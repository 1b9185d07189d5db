// Lanes: how kernels share one sample among threads. Twin of opencl/lanes.cl where a thread has one
// lane.
//
// A sample is worked on by LANES = 32 threads, one warp. The host chooses how many samples a block
// holds, at most MAXIMUM_SAMPLES_PER_GROUP: threadIdx.x counts the lanes of a sample, threadIdx.y
// the samples of a block. Results do not depend on it.
//
//   SAMPLE                            number of the sample
//   LANE                              number of the lane
//   SAMPLE_LOCAL(type, array, size);  shared memory of a sample, at the head of a kernel
//   LANE_BARRIER()                    what lanes wrote to shared memory is seen by all lanes; every
//                                     thread of a block has to come by
//
// Constants come from the file that includes this one (src/engine/cuda/all_kernels.inc).
//
// Products and sums are separate operations, as everywhere (docs/numerics.md): nvcc is given
// -fmad=false (cmake/CompilerSettings.cmake); a fused operation is written __fmaf_rn.

using uchar = unsigned char;
using ushort = unsigned short;
using uint = unsigned int;

// Told of all shared memory when a kernel starts, where a host emulates CUDA.
#ifndef NEW_SHARED_MEMORY
#define NEW_SHARED_MEMORY(array)
#endif

// Comes before a loop over a private array, which registers can hold if every index is known.
#ifndef UNROLL
#define UNROLL _Pragma("unroll")
#endif

#define SAMPLE_IN_GROUP threadIdx.y
#define SAMPLE (blockIdx.x * blockDim.y + SAMPLE_IN_GROUP)
#define SAMPLE_LOCAL(type, array, size)                                     \
  __shared__ type array##OfGroup[MAXIMUM_SAMPLES_PER_GROUP * (size)];       \
  NEW_SHARED_MEMORY(array##OfGroup);                                        \
  type* const array = array##OfGroup + SAMPLE_IN_GROUP * (size)

// Merging takes a tile of samples at a time: here one.
#define TILE 1
#define FIRST_OF_TILE SAMPLE

#define LANE threadIdx.x
#define LANE_BARRIER() __syncthreads()

#define HAARLIGHT_KERNEL __global__ __launch_bounds__(LANES * MAXIMUM_SAMPLES_PER_GROUP)

// A receiver's normal (src/material/cosine_lobe.h).
struct LobeBlend {
  uint4 lobes;
  float4 weights;
};
