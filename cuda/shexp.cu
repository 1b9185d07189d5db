// Shading by spherical-harmonic exponentiation: twin of src/shexp/exponentiation.cpp and of
// src/engine/reference/exponentiation_shader.h, with the formulas in src/shexp/exponentiation.h and
// src/engine/exponentiation_tables.h. A lane takes every 32nd coefficient.

// Coefficients of a + b f, which is squared as often as f was halved: the first one, and the factor
// of the others. `first` is that of f, `squares` the sum of the others' squares, halved.
struct LinearExponential {
  float first, factor;
};

__device__ inline LinearExponential linearExponential(const ShexpTables* tables, float first,
                                                      float squares, float scale) {
  const TablePlace place =
      placeInTable(rootOf(squares) * tables->constants->linearScale, LINEAR_ROWS);
  const int index = 2 * place.row;
  const float a = interpolate(place.fraction, tables->linear[index],
                              tables->linear[index + 2]);
  const float b = interpolate(place.fraction, tables->linear[index + 1],
                              tables->linear[index + 3]);
  const float mean = exponential(first * 0x1.20dd74p-2f * scale);
  const LinearExponential result = {a * mean, b * scale * mean};
  return result;
}

// A sample's room after its sum: that, two functions in turn, then the partial sums of radiance.
#define RADIANCE_ROWS (3 * LIGHT_LOBE_ROW)
#define RADIANCE_QUARTERS (RADIANCE_ROWS + 3 * TREE_STRIDE)

__device__ inline float addSquareTerm(ShexpSquareTerm term, const float* g, float sum) {
  return __fmaf_rn(term.weight, g[term.first] * g[term.second], sum);
}

__device__ inline float squareCoefficient(const ShexpTables* tables, const float* g, uint k) {
  float even = 0.0f, odd = 0.0f;
  for (uint i = tables->squareStarts[k]; i < tables->squareStarts[k + 1]; i += 2) {
    even = addSquareTerm(tables->squareTerms[i], g, even);
    odd = addSquareTerm(tables->squareTerms[i + 1], g, odd);
  }
  return even + odd;
}

// exp of the function in `room`; returns where it is. All samples of a group go through as many
// steps, and those that need fewer squarings wait with copies.
__device__ inline uint exponentiate(const ShexpTables* tables, uint mostHalvings, float* room) {
  const uint count = uint(tables->order * tables->order);
  float squares = 0.0f, scale = 1.0f;
  for (uint i = 1; i < count; ++i) squares = __fmaf_rn(room[i], room[i], squares);
  uint halvings = 0;
  for (; halvings < mostHalvings && squares > tables->constants->limitSquared; ++halvings) {
    squares *= 0.25f;
    scale *= 0.5f;
  }
  const LinearExponential start = linearExponential(tables, room[0], squares, scale);
  uint from = LIGHT_LOBE_ROW, to = 2 * LIGHT_LOBE_ROW;
  for (uint k = LANE; k < LIGHT_LOBE_ROW; k += LANES)
    room[from + k] = k == 0 ? start.first : k < count ? start.factor * room[k] : 0.0f;
  LANE_BARRIER();
  for (uint i = 0; i < mostHalvings; ++i) {
    for (uint k = LANE; k < LIGHT_LOBE_ROW; k += LANES)
      room[to + k] = i < halvings && k < count ? squareCoefficient(tables, room + from, k)
                                               : room[from + k];
    LANE_BARRIER();
    const uint other = from;
    from = to;
    to = other;
  }
  return from;
}

__device__ inline float channelPartial(const Blend* blend, const float* lightLobes,
                                       const float* visibility, uint channel) {
  float partial = 0.0f;
  for (uint k = LANE; k < LIGHT_LOBE_ROW; k += LANES) {
    const float* own = lightLobes + channel * LIGHT_LOBE_ROW + k;
    float lightLobe = blend->weights[0] * own[3 * LIGHT_LOBE_ROW * blend->slots[0]];
    for (uint i = 1; i < blend->count; ++i)
      lightLobe = __fmaf_rn(blend->weights[i], own[3 * LIGHT_LOBE_ROW * blend->slots[i]],
                            lightLobe);
    partial = __fmaf_rn(visibility[k], lightLobe, partial);
  }
  return partial;
}

// Radiance of the sample whose visibility is at `visibility` in `room`.
__device__ inline void shadeLowOrder(const Blend* blend, const float* lightLobes, uint visibility,
                                     float* room, float4* radiance) {
  for (uint channel = 0; channel < 3; ++channel)
    room[RADIANCE_ROWS + channel * TREE_STRIDE + LANE] =
        channelPartial(blend, lightLobes, room + visibility, channel);
  LANE_BARRIER();
  float* quarters = room + RADIANCE_QUARTERS;
  if (LANE < 3 * 4)
    quarters[LANE] =
        quarterOfTree(room + RADIANCE_ROWS + LANE / 4 * TREE_STRIDE + LANE % 4);
  LANE_BARRIER();
  if (LANE == 0)
    radiance[FIRST_OF_TILE] = make_float4(positivePart(treeOfQuarters(quarters)),
                                          positivePart(treeOfQuarters(quarters + 4)),
                                          positivePart(treeOfQuarters(quarters + 8)), 0.0f);
}

__device__ inline void shadeTileByExponentiation(const ShexpTables* tables, const Tile* tile,
                                                 const float* spheres, uint sphereCount,
                                                 uint mostHalvings, const LobeBlend* receivers,
                                                 uint lobesPerReceiver, const uint* lobeSlots,
                                                 const float* lightLobes, float* room,
                                                 float4* radiance) {
  sumLogarithms(tables, tile, spheres, sphereCount, room);
  const uint visibility = exponentiate(tables, mostHalvings, room);
  const Blend blend = blendOf(receivers[FIRST_OF_TILE], lobesPerReceiver, lobeSlots);
  shadeLowOrder(&blend, lightLobes, visibility, room, radiance);
}

HAARLIGHT_KERNEL void shadeByExponentiation(const float4* __restrict__ positions,
                                            const float4* __restrict__ normals,
                                            const LobeBlend* __restrict__ receivers,
                                            const float* __restrict__ spheres,
                                            const uint sphereCount,
                                            const uint order,
                                            const uint mostHalvings,
                                            const float* __restrict__ logarithms,
                                            const float* __restrict__ linear,
                                            const ShexpConstants* __restrict__ constants,
                                            const uint* __restrict__ squareStarts,
                                            const ShexpSquareTerm* __restrict__ squareTerms,
                                            const uint lobesPerReceiver,
                                            const uint* __restrict__ lobeSlots,
                                            const float* __restrict__ lightLobes,
                                            float4* __restrict__ radiance) {
  SAMPLE_LOCAL(float, room, SHEXP_ROOM);
  const Tile tile = loadTile(positions, normals);
  const ShexpTables tables = {int(order), logarithms, linear, constants, squareStarts, squareTerms};
  shadeTileByExponentiation(&tables, &tile, spheres, sphereCount, mostHalvings, receivers,
                            lobesPerReceiver, lobeSlots, lightLobes, room, radiance);
}
