#pragma once

/// The constants that kernels share with the host, by the names kernels know them by. OpenCL gets
/// them as #defines before its source, CUDA as constexpr values.

#include "engine/exponentiation_tables.h"
#include "engine/kernel_device.h"
#include "engine/shading_tables.h"
#include "haar/occlusion_transform.h"
#include "visibility/sphere_bin.h"

// clang-format off
#define HAARLIGHT_KERNEL_CONSTANTS(CONSTANT)                \
  CONSTANT(LANES, haarlight::partialSums)                              \
  CONSTANT(FACES, haarlight::faceCount)                                \
  CONSTANT(FACE_SIZE, haarlight::faceSize)                             \
  CONSTANT(BIT_CUBE_ROWS, haarlight::bitCubeRows)                      \
  CONSTANT(RADIUS_BINS, haarlight::radiusBins)                         \
  CONSTANT(HORIZON_FACTOR, int(haarlight::horizonFactor))              \
  CONSTANT(COARSE_COEFFICIENTS, haarlight::coarseCoefficientsPerFace)  \
  CONSTANT(COARSE_MEANS, haarlight::coarseMeansPerFace)                \
  CONSTANT(BLOCKS, haarlight::blockCount)                              \
  CONSTANT(BLOCKS_PER_FACE, haarlight::blocksPerFace)                  \
  CONSTANT(BLOCKS_PER_SIDE, haarlight::blocksPerSide)                  \
  CONSTANT(TILE_SAMPLES, haarlight::tileSamples)                       \
  CONSTANT(TEXEL_WEIGHTS, haarlight::texelWeightCount)                 \
  CONSTANT(ABSENT_SQUARE, haarlight::ShadingTables::absentSquare)      \
  CONSTANT(SHEXP_BANDS, haarlight::largestShexpOrder)                  \
  CONSTANT(LOGARITHM_ROWS, haarlight::ShexpTables::logarithmRows)      \
  CONSTANT(LOGARITHM_ROW, haarlight::ShexpTables::logarithmRowSize)    \
  CONSTANT(LINEAR_ROWS, haarlight::ShexpTables::linearRows)            \
  CONSTANT(LIGHT_LOBE_ROW, haarlight::ExponentiationTables::rowSize)
// clang-format on
