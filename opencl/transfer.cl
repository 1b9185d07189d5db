// Shading by precomputed diffuse transfer: rows of spherical harmonics, lights, and receivers that
// blend both (src/engine/transfer_tables.h, with the formulas). The scalar twin is
// src/engine/reference/transfer_shader.h.

// A receiver's row as a blend of up to three (src/engine/transfer_tables.h).
typedef struct {
  uint4 rows;
  float4 weights;
} RowBlend;

// What receivers read.
typedef struct {
  uint rowsPerReceiver, rowLength, lightCount, lightLength;
} TransferLayout;

// One number of a receiver's row; `place` is that in a row.
inline float blendedTransfer(__global const float* rows, const RowBlend* blend,
                             TransferLayout layout, uint place) {
  float transfer = blend->weights.x * rows[blend->rows.x * layout.rowLength + place];
  if (layout.rowsPerReceiver > 1) {
    transfer = fma(blend->weights.y, rows[blend->rows.y * layout.rowLength + place], transfer);
    transfer = fma(blend->weights.z, rows[blend->rows.z * layout.rowLength + place], transfer);
  }
  return transfer;
}

// One number of a receiver's light.
inline float blendedLight(__global const float* lights, __global const float* weights,
                          TransferLayout layout, uint place) {
  float light = weights[0] * lights[place];
  for (uint i = 1; i < layout.lightCount; ++i)
    light = fma(weights[i], lights[i * layout.lightLength + place], light);
  return light;
}

// The trees of three sums at once, 32 partial sums each, one sum after the other.
inline void addThreePartials(__local float* partials) {
  for (uint width = LANES / 2; width > 0; width /= 2) {
    FOR_EACH_LANE(lane) if (lane < width) for (uint sum = 0; sum < 3; ++sum)
      partials[sum * LANES + lane] += partials[sum * LANES + lane + width];
    LANE_BARRIER();
  }
}

HAARLIGHT_KERNEL void shadeByTransfer(__global const RowBlend* restrict blends,
                                      const uint receiverCount,
                                      const uint rowsPerReceiver,
                                      __global const float* restrict rows,
                                      const uint channels,
                                      const uint coefficients,
                                      __global const float* restrict lights,
                                      const uint lightCount,
                                      __global const float* restrict lightWeights,
                                      __global float4* restrict radiance) {
  SAMPLE_LOCAL(float, partials, 3 * LANES);
  // Work-groups are full: items beyond the last receiver do its work again.
  const uint receiver = min((uint)SAMPLE, receiverCount - 1);
  const RowBlend blend = blends[receiver];
  __global const float* weights = lightWeights + receiver * lightCount;
  const TransferLayout layout = {rowsPerReceiver, channels * coefficients, lightCount,
                                 3 * coefficients};
  for (uint channel = 0; channel < 3; ++channel) {
    const uint ofLight = channel * coefficients, ofRow = channels == 1 ? 0 : ofLight;
    FOR_EACH_LANE(lane) {
      float partial = 0.0f;
      for (uint k = lane; k < coefficients; k += LANES)
        partial = fma(blendedTransfer(rows, &blend, layout, ofRow + k),
                      blendedLight(lights, weights, layout, ofLight + k), partial);
      partials[channel * LANES + lane] = partial;
    }
  }
  LANE_BARRIER();
  addThreePartials(partials);
  if (FIRST_LANE == 0)
    radiance[SAMPLE] = (float4)(positivePart(partials[0]), positivePart(partials[LANES]),
                                positivePart(partials[2 * LANES]), 0.0f);
}

// Order 2: a row of a channel is one float4, and a lane takes a receiver.

inline float4 timesFour(float weight, float4 values) { return weight * values; }

inline float4 addFour(float weight, float4 values, float4 sum) {
  return fma((float4)(weight), values, sum);
}

inline float4 blendedFourOfRows(__global const float4* rows, const RowBlend* blend,
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

inline float4 blendedFourOfLights(__global const float4* lights, __global const float* weights,
                                  TransferLayout layout, uint place) {
  float4 light = timesFour(weights[0], lights[place]);
  for (uint i = 1; i < layout.lightCount; ++i)
    light = addFour(weights[i], lights[i * layout.lightLength + place], light);
  return light;
}

// The tree over 32 partial sums, of which four are not zero.
inline float radianceOfFour(float4 transfer, float4 light) {
  const float4 products = transfer * light;
  return positivePart((products.x + products.z) + (products.y + products.w));
}

HAARLIGHT_KERNEL void shadeByFourCoefficients(__global const RowBlend* restrict blends,
                                              const uint receiverCount,
                                              const uint rowsPerReceiver,
                                              __global const float4* restrict rows,
                                              const uint channels,
                                              __global const float4* restrict lights,
                                              const uint lightCount,
                                              __global const float* restrict lightWeights,
                                              __global float4* restrict radiance) {
  const TransferLayout layout = {rowsPerReceiver, channels, lightCount, 3};
  FOR_EACH_LANE(lane) {
    const uint receiver = SAMPLE * LANES + lane;
    if (receiver >= receiverCount) continue;
    const RowBlend blend = blends[receiver];
    __global const float* weights = lightWeights + receiver * lightCount;
    float sums[3];
    for (uint channel = 0; channel < 3; ++channel)
      sums[channel] =
          radianceOfFour(blendedFourOfRows(rows, &blend, layout, channels == 1 ? 0 : channel),
                         blendedFourOfLights(lights, weights, layout, channel));
    radiance[receiver] = (float4)(sums[0], sums[1], sums[2], 0.0f);
  }
}
