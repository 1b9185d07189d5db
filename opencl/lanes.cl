// Lanes: how kernels share one sample among work-items.
//
// A sample is worked on by LANES = 32 lanes. The host chooses how many lanes a work-item carries:
// on a GPU one (the 32 items of a sample are one warp), on a CPU all of them (a sample is one item,
// and the compiler turns lane loops into vector instructions). It also chooses how many samples a
// work-group holds: get_local_id(0) counts the items of a sample, get_local_id(1) the samples of a
// group. Results depend on neither.
//
//   SAMPLE                            number of the sample
//   FOR_EACH_LANE(lane) { … }         runs the lanes of this work-item
//   OF_LANE(array, lane)              element of a private array declared with [LANES_PER_ITEM]
//   SAMPLE_LOCAL(type, array, size);  local memory of a sample, at the head of a kernel
//   LANE_BARRIER()                    what lanes wrote to local memory is seen by all lanes
//
// Constants come from the host (src/engine/kernel_constants.h, src/engine/opencl/opencl_program.cpp).

#pragma OPENCL FP_CONTRACT OFF

#define ITEMS_PER_SAMPLE (LANES / LANES_PER_ITEM)
#define FOR_EACH_LANE(lane) \
  for (uint lane = FIRST_LANE; lane < FIRST_LANE + LANES_PER_ITEM; ++lane)
#define OF_LANE(array, lane) (array)[(lane) % LANES_PER_ITEM]

#if SAMPLES_PER_GROUP > 1
#define SAMPLE_IN_GROUP get_local_id(1)
#else
#define SAMPLE_IN_GROUP 0
#endif
#define SAMPLE (get_group_id(1) * SAMPLES_PER_GROUP + SAMPLE_IN_GROUP)
#define SAMPLE_LOCAL(type, array, size)                     \
  __local type array##OfGroup[SAMPLES_PER_GROUP * (size)] __attribute__((aligned(64))); \
  __local type* const array = array##OfGroup + SAMPLE_IN_GROUP * (size)

#if ITEMS_PER_SAMPLE > 1
#define FIRST_LANE ((uint)get_local_id(0) * LANES_PER_ITEM)
#define LANE_BARRIER() barrier(CLK_LOCAL_MEM_FENCE)
#else
#define FIRST_LANE 0u
#define LANE_BARRIER()
#endif

// The lanes of a work-item as vectors, for code that has to be vector code on a CPU: LANE_VECTORS
// values of type LaneFloat and so on hold LANES_PER_ITEM lanes. Comparisons give LaneInt masks that
// `&` and select() take.
#if LANES_PER_ITEM == 1
typedef float LaneFloat;
typedef int LaneInt;
typedef uint LaneUint;
#define LANE_VECTORS 1
#define LANE_NUMBERS(vector) ((int)get_local_id(0))
#define TO_LANE_FLOAT(value) ((float)(value))
#define TO_LANE_UINT(value) ((uint)(value))
#define TO_LANE_INT(value) ((int)(value))
#define LANE_FLOAT_OF_BITS(value) as_float(value)
#define BITS_OF_LANE_FLOAT(value) as_uint(value)
#define ANY_LANE(mask) (mask)
#define LOAD_LANES(address) ((address)[get_local_id(0)])
#define STORE_LANES(value, address) ((address)[get_local_id(0)] = (value))
#else
typedef float16 LaneFloat;
typedef int16 LaneInt;
typedef uint16 LaneUint;
#define LANE_VECTORS (LANES_PER_ITEM / 16)
#define LANE_NUMBERS(vector) \
  ((int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15) + 16 * (int)(vector))
#define TO_LANE_FLOAT(value) convert_float16(value)
#define TO_LANE_UINT(value) convert_uint16(value)
#define TO_LANE_INT(value) convert_int16(value)
#define LANE_FLOAT_OF_BITS(value) as_float16(value)
#define BITS_OF_LANE_FLOAT(value) as_uint16(value)
#define ANY_LANE(mask) any(mask)
#define LOAD_LANES(address) vload16(0, address)
#define STORE_LANES(value, address) vstore16(value, 0, address)
#endif

// Merging takes a tile of samples at a time: one where lanes are items, else a sample per element of
// a LaneFloat, against blocks of spheres.
#if LANES_PER_ITEM == 1
#define TILE 1
#else
#define TILE TILE_SAMPLES
#define SPHERES_AT_ONCE 16
#endif
#define FIRST_OF_TILE (SAMPLE * TILE)

#define HAARLIGHT_KERNEL \
  __kernel __attribute__((reqd_work_group_size(ITEMS_PER_SAMPLE, SAMPLES_PER_GROUP, 1)))

// A receiver's normal (src/material/cosine_lobe.h).
typedef struct {
  uint4 lobes;
  float4 weights;
} LobeBlend;

// Runs over the set bits of a word, from the lowest.
#define FOR_EACH_BIT(number, bits)                                     \
  for (uint left = (bits), number = 31 - clz(left & -left); left; \
       left &= left - 1, number = 31 - clz(left & -left))
