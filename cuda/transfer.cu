// Shading by precomputed diffuse transfer: rows of spherical harmonics, lights, and receivers that
// blend both (src/engine/transfer_tables.h, with the formulas). The scalar twin is
// src/engine/reference/transfer_shader.h.

// A receiver's row as a blend of up to three (src/engine/transfer_tables.h).
struct RowBlend {
  uint4 rows;
  float4 weights;
};

// What receivers read.
struct TransferLayout {
  uint rowsPerReceiver, rowLength, lightCount, lightLength;
};

// One number of a receiver's row; `place` is that in a row.
__device__ inline float blendedTransfer(const float* rows, const RowBlend* blend,
                                        TransferLayout layout, uint place) {
  float transfer = blend->weights.x * rows[blend->rows.x * layout.rowLength + place];
  if (layout.rowsPerReceiver > 1) {
    transfer =
        __fmaf_rn(blend->weights.y, rows[blend->rows.y * layout.rowLength + place], transfer);
    transfer =
        __fmaf_rn(blend->weights.z, rows[blend->rows.z * layout.rowLength + place], transfer);
  }
  return transfer;
}

// One number of a receiver's light.
__device__ inline float blendedLight(const float* lights, const float* weights,
                                     TransferLayout layout, uint place) {
  float light = weights[0] * lights[place];
  for (uint i = 1; i < layout.lightCount; ++i)
    light = __fmaf_rn(weights[i], lights[i * layout.lightLength + place], light);
  return light;
}

// The trees of three sums at once, 32 partial sums each, one sum after the other.
__device__ inline void addThreePartials(float* partials) {
  for (uint width = LANES / 2; width > 0; width /= 2) {
    if (LANE < width)
      for (uint sum = 0; sum < 3; ++sum)
        partials[sum * LANES + LANE] += partials[sum * LANES + LANE + width];
    LANE_BARRIER();
  }
}

HAARLIGHT_KERNEL void shadeByTransfer(const RowBlend* __restrict__ blends,
                                      const uint receiverCount,
                                      const uint rowsPerReceiver,
                                      const float* __restrict__ rows,
                                      const uint channels,
                                      const uint coefficients,
                                      const float* __restrict__ lights,
                                      const uint lightCount,
                                      const float* __restrict__ lightWeights,
                                      float4* __restrict__ radiance) {
  SAMPLE_LOCAL(float, partials, 3 * LANES);
  // Blocks are full: threads beyond the last receiver do its work again.
  const uint receiver = min(uint(SAMPLE), receiverCount - 1);
  const RowBlend blend = blends[receiver];
  const float* weights = lightWeights + receiver * lightCount;
  const TransferLayout layout = {rowsPerReceiver, channels * coefficients, lightCount,
                                 3 * coefficients};
  for (uint channel = 0; channel < 3; ++channel) {
    const uint ofLight = channel * coefficients, ofRow = channels == 1 ? 0 : ofLight;
    float partial = 0.0f;
    for (uint k = LANE; k < coefficients; k += LANES)
      partial = __fmaf_rn(blendedTransfer(rows, &blend, layout, ofRow + k),
                          blendedLight(lights, weights, layout, ofLight + k), partial);
    partials[channel * LANES + LANE] = partial;
  }
  LANE_BARRIER();
  addThreePartials(partials);
  if (LANE == 0)
    radiance[SAMPLE] = make_float4(positivePart(partials[0]), positivePart(partials[LANES]),
                                   positivePart(partials[2 * LANES]), 0.0f);
}

// Order 2: a row of a channel is one float4, and a lane takes a receiver.

__device__ inline float4 timesFour(float weight, float4 values) {
  return make_float4(weight * values.x, weight * values.y, weight * values.z, weight * values.w);
}

__device__ inline float4 addFour(float weight, float4 values, float4 sum) {
  return make_float4(__fmaf_rn(weight, values.x, sum.x), __fmaf_rn(weight, values.y, sum.y),
                     __fmaf_rn(weight, values.z, sum.z), __fmaf_rn(weight, values.w, sum.w));
}

__device__ inline float4 blendedFourOfRows(const float4* rows, const RowBlend* blend,
                                           TransferLayout layout, uint place) {
  float4 transfer =
      timesFour(blend->weights.x, rows[blend->rows.x * layout.rowLength + place]);
  if (layout.rowsPerReceiver > 1) {
    transfer =
        addFour(blend->weights.y, rows[blend->rows.y * layout.rowLength + place], transfer);
    transfer =
        addFour(blend->weights.z, rows[blend->rows.z * layout.rowLength + place], transfer);
  }
  return transfer;
}

__device__ inline float4 blendedFourOfLights(const float4* lights, const float* weights,
                                             TransferLayout layout, uint place) {
  float4 light = timesFour(weights[0], lights[place]);
  for (uint i = 1; i < layout.lightCount; ++i)
    light = addFour(weights[i], lights[i * layout.lightLength + place], light);
  return light;
}

// The tree over 32 partial sums, of which four are not zero.
__device__ inline float radianceOfFour(float4 transfer, float4 light) {
  const float x = transfer.x * light.x, y = transfer.y * light.y, z = transfer.z * light.z,
              w = transfer.w * light.w;
  return positivePart((x + z) + (y + w));
}

HAARLIGHT_KERNEL void shadeByFourCoefficients(const RowBlend* __restrict__ blends,
                                              const uint receiverCount,
                                              const uint rowsPerReceiver,
                                              const float4* __restrict__ rows,
                                              const uint channels,
                                              const float4* __restrict__ lights,
                                              const uint lightCount,
                                              const float* __restrict__ lightWeights,
                                              float4* __restrict__ radiance) {
  const TransferLayout layout = {rowsPerReceiver, channels, lightCount, 3};
  const uint receiver = SAMPLE * LANES + LANE;
  if (receiver >= receiverCount) return;
  const RowBlend blend = blends[receiver];
  const float* weights = lightWeights + receiver * lightCount;
  float sums[3];
  for (uint channel = 0; channel < 3; ++channel)
    sums[channel] =
        radianceOfFour(blendedFourOfRows(rows, &blend, layout, channels == 1 ? 0 : channel),
                       blendedFourOfLights(lights, weights, layout, channel));
  radiance[receiver] = make_float4(sums[0], sums[1], sums[2], 0.0f);
}
