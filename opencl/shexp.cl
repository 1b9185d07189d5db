// Shading by spherical-harmonic exponentiation: twin of src/shexp/exponentiation.cpp and of
// src/engine/reference/exponentiation_shader.h, with the formulas in src/shexp/exponentiation.h and
// src/engine/exponentiation_tables.h. Where lanes are items, each takes every 32nd coefficient.

// Coefficients of a + b f, which is squared as often as f was halved: the first one, and the factor
// of the others. `first` is that of f, `squares` the sum of the others' squares, halved.
typedef struct {
  LaneFloat first, factor;
} LinearExponential;

inline LinearExponential linearExponential(const ShexpTables* tables, LaneFloat first,
                                           LaneFloat squares, LaneFloat scale) {
  const TablePlace place =
      placeInTable(rootOf(squares) * tables->constants->linearScale, LINEAR_ROWS);
  const LaneInt index = 2 * place.row;
  const LaneFloat a = interpolate(place.fraction, OF_TABLE(tables->linear, index),
                                  OF_TABLE(tables->linear + 2, index));
  const LaneFloat b = interpolate(place.fraction, OF_TABLE(tables->linear + 1, index),
                                  OF_TABLE(tables->linear + 3, index));
  const LaneFloat mean = exponential(first * 0x1.20dd74p-2f * scale);
  const LinearExponential result = {a * mean, b * scale * mean};
  return result;
}

#if LANES_PER_ITEM == 1
// A sample's room after its sum: that, two functions in turn, then the partial sums of radiance.
#define RADIANCE_ROWS (3 * LIGHT_LOBE_ROW)
#define RADIANCE_QUARTERS (RADIANCE_ROWS + 3 * TREE_STRIDE)

inline float addSquareTerm(ShexpSquareTerm term, __local const float* g, float sum) {
  return fma(term.weight, g[term.first] * g[term.second], sum);
}

inline float squareCoefficient(const ShexpTables* tables, __local const float* g, uint k) {
  float even = 0.0f, odd = 0.0f;
  for (uint i = tables->squareStarts[k]; i < tables->squareStarts[k + 1]; i += 2) {
    even = addSquareTerm(tables->squareTerms[i], g, even);
    odd = addSquareTerm(tables->squareTerms[i + 1], g, odd);
  }
  return even + odd;
}

// exp of the function in `room`; returns where it is. All samples of a group go through as many
// steps, and those that need fewer squarings wait with copies.
inline uint exponentiate(const ShexpTables* tables, uint mostHalvings, __local float* room) {
  const uint count = (uint)(tables->order * tables->order);
  float squares = 0.0f, scale = 1.0f;
  for (uint i = 1; i < count; ++i) squares = fma(room[i], room[i], squares);
  uint halvings = 0;
  for (; halvings < mostHalvings && squares > tables->constants->limitSquared; ++halvings) {
    squares *= 0.25f;
    scale *= 0.5f;
  }
  const LinearExponential start = linearExponential(tables, room[0], squares, scale);
  uint from = LIGHT_LOBE_ROW, to = 2 * LIGHT_LOBE_ROW;
  for (uint k = FIRST_LANE; k < LIGHT_LOBE_ROW; k += LANES)
    room[from + k] = k == 0 ? start.first : k < count ? start.factor * room[k] : 0.0f;
  LANE_BARRIER();
  for (uint i = 0; i < mostHalvings; ++i) {
    for (uint k = FIRST_LANE; k < LIGHT_LOBE_ROW; k += LANES)
      room[to + k] = i < halvings && k < count ? squareCoefficient(tables, room + from, k)
                                               : room[from + k];
    LANE_BARRIER();
    const uint other = from;
    from = to;
    to = other;
  }
  return from;
}

inline float channelPartial(const Blend* blend, __global const float* lightLobes,
                            __local const float* visibility, uint channel) {
  float partial = 0.0f;
  for (uint k = FIRST_LANE; k < LIGHT_LOBE_ROW; k += LANES) {
    __global const float* own = lightLobes + channel * LIGHT_LOBE_ROW + k;
    float lightLobe = blend->weights[0] * own[3 * LIGHT_LOBE_ROW * blend->slots[0]];
    for (uint i = 1; i < blend->count; ++i)
      lightLobe = fma(blend->weights[i], own[3 * LIGHT_LOBE_ROW * blend->slots[i]], lightLobe);
    partial = fma(visibility[k], lightLobe, partial);
  }
  return partial;
}

// Radiance of the sample whose visibility is at `visibility` in `room`.
inline void shadeLowOrder(const Blend* blend, __global const float* lightLobes, uint visibility,
                          __local float* room, __global float4* radiance) {
  for (uint channel = 0; channel < 3; ++channel)
    room[RADIANCE_ROWS + channel * TREE_STRIDE + FIRST_LANE] =
        channelPartial(blend, lightLobes, room + visibility, channel);
  LANE_BARRIER();
  __local float* quarters = room + RADIANCE_QUARTERS;
  if (FIRST_LANE < 3 * 4)
    quarters[FIRST_LANE] =
        quarterOfTree(room + RADIANCE_ROWS + FIRST_LANE / 4 * TREE_STRIDE + FIRST_LANE % 4);
  LANE_BARRIER();
  if (FIRST_LANE == 0)
    radiance[FIRST_OF_TILE] = (float4)(positivePart(treeOfQuarters(quarters)),
                                       positivePart(treeOfQuarters(quarters + 4)),
                                       positivePart(treeOfQuarters(quarters + 8)), 0.0f);
}

inline void shadeTileByExponentiation(const ShexpTables* tables, const Tile* tile,
                                      __global const float* spheres, uint sphereCount,
                                      uint mostHalvings, __global const LobeBlend* receivers,
                                      uint lobesPerReceiver, __global const uint* lobeSlots,
                                      __global const float* lightLobes, __local float* room,
                                      __global float4* radiance) {
  sumLogarithms(tables, tile, spheres, sphereCount, room);
  const uint visibility = exponentiate(tables, mostHalvings, room);
  const Blend blend = blendOf(receivers[FIRST_OF_TILE], lobesPerReceiver, lobeSlots);
  shadeLowOrder(&blend, lightLobes, visibility, room, radiance);
}
#else
// Visibility of a tile, a coefficient of all samples after the other.
#define SHEXP_ROOM (LIGHT_LOBE_ROW * TILE)

inline LaneFloat addSquareTerm(ShexpSquareTerm term, const LaneFloat* g, LaneFloat sum) {
  return fma((LaneFloat)(term.weight), g[term.first] * g[term.second], sum);
}

inline void squareWhere(const ShexpTables* tables, LaneInt wanted, LaneFloat* g) {
  const uint count = (uint)(tables->order * tables->order);
  LaneFloat squared[SHEXP_COUNT];
  for (uint k = 0; k < count; ++k) {
    LaneFloat even = (LaneFloat)(0.0f), odd = (LaneFloat)(0.0f);
    for (uint i = tables->squareStarts[k]; i < tables->squareStarts[k + 1]; i += 2) {
      even = addSquareTerm(tables->squareTerms[i], g, even);
      odd = addSquareTerm(tables->squareTerms[i + 1], g, odd);
    }
    squared[k] = even + odd;
  }
  for (uint k = 0; k < count; ++k) g[k] = select(g[k], squared[k], wanted);
}

// exp of a function, in its place.
inline void exponentiate(const ShexpTables* tables, uint mostHalvings, LaneFloat* f) {
  const uint count = (uint)(tables->order * tables->order);
  LaneFloat squares = (LaneFloat)(0.0f), scale = (LaneFloat)(1.0f);
  for (uint i = 1; i < count; ++i) squares = fma(f[i], f[i], squares);
  LaneInt halvings = (LaneInt)(0);
  uint most = 0;
  for (; most < mostHalvings; ++most) {
    const LaneInt large = squares > tables->constants->limitSquared;
    if (!ANY_LANE(large)) break;
    squares = select(squares, squares * 0.25f, large);
    scale = select(scale, scale * 0.5f, large);
    halvings -= large;
  }
  const LinearExponential start = linearExponential(tables, f[0], squares, scale);
  f[0] = start.first;
  for (uint k = 1; k < count; ++k) f[k] = start.factor * f[k];
  for (uint i = 0; i < most; ++i) squareWhere(tables, halvings > (int)i, f);
}

// Coefficients 16 k to 16 k + 15 of a sample.
inline LaneFloat loadSixteen(__local const float* visibility, uint sample, uint k) {
  const int16 places = LANE_NUMBERS(0) * TILE + (int)(16 * k * TILE + sample);
  return OF_TABLE(visibility, places);
}

inline LaneFloat blendSixteen(const Blend* blend, __global const float* lightLobes) {
  LaneFloat sum =
      blend->weights[0] * vload16(0, lightLobes + 3 * LIGHT_LOBE_ROW * blend->slots[0]);
  for (uint i = 1; i < blend->count; ++i)
    sum = fma((LaneFloat)(blend->weights[i]),
              vload16(0, lightLobes + 3 * LIGHT_LOBE_ROW * blend->slots[i]), sum);
  return sum;
}

// The tree over 32 partial sums.
inline float addPartialSums(LaneFloat low, LaneFloat high) {
  const LaneFloat p = low + high;
  return (((p.s0 + p.s8) + (p.s4 + p.sc)) + ((p.s2 + p.sa) + (p.s6 + p.se))) +
         (((p.s1 + p.s9) + (p.s5 + p.sd)) + ((p.s3 + p.sb) + (p.s7 + p.sf)));
}

inline float shadeChannel(const Blend* blend, __global const float* lightLobes,
                          const LaneFloat* visibility) {
  LaneFloat partials[2] = {(LaneFloat)(0.0f), (LaneFloat)(0.0f)};
  for (uint k = 0; k < LIGHT_LOBE_ROW / 16; ++k)
    partials[k % 2] =
        fma(visibility[k], blendSixteen(blend, lightLobes + 16 * k), partials[k % 2]);
  const float sum = addPartialSums(partials[0], partials[1]);
  return positivePart(sum);
}

inline float4 shadeLowOrder(const Blend* blend, __global const float* lightLobes,
                            __local const float* room, uint sample) {
  LaneFloat visibility[LIGHT_LOBE_ROW / 16];
  for (uint k = 0; k < LIGHT_LOBE_ROW / 16; ++k)
    visibility[k] = loadSixteen(room, sample, k);
  return (float4)(shadeChannel(blend, lightLobes, visibility),
                  shadeChannel(blend, lightLobes + LIGHT_LOBE_ROW, visibility),
                  shadeChannel(blend, lightLobes + 2 * LIGHT_LOBE_ROW, visibility), 0.0f);
}

inline void shadeTileByExponentiation(const ShexpTables* tables, const Tile* tile,
                                      __global const float* spheres, uint sphereCount,
                                      uint mostHalvings, __global const LobeBlend* receivers,
                                      uint lobesPerReceiver, __global const uint* lobeSlots,
                                      __global const float* lightLobes, __local float* room,
                                      __global float4* radiance) {
  LaneFloat f[LIGHT_LOBE_ROW];
  sumLogarithms(tables, tile, spheres, sphereCount, f);
  exponentiate(tables, mostHalvings, f);
  for (uint k = (uint)(tables->order * tables->order); k < LIGHT_LOBE_ROW; ++k)
    f[k] = (LaneFloat)(0.0f);
  for (uint k = 0; k < LIGHT_LOBE_ROW; ++k) ((__local LaneFloat*)room)[k] = f[k];
  for (uint i = 0; i < TILE; ++i) {
    const Blend blend = blendOf(receivers[FIRST_OF_TILE + i], lobesPerReceiver, lobeSlots);
    radiance[FIRST_OF_TILE + i] = shadeLowOrder(&blend, lightLobes, room, i);
  }
}
#endif

HAARLIGHT_KERNEL void shadeByExponentiation(__global const float4* restrict positions,
                                            __global const float4* restrict normals,
                                            __global const LobeBlend* restrict receivers,
                                            __global const float* restrict spheres,
                                            const uint sphereCount,
                                            const uint order,
                                            const uint mostHalvings,
                                            __global const float* restrict logarithms,
                                            __global const float* restrict linear,
                                            __global const ShexpConstants* restrict constants,
                                            __global const uint* restrict squareStarts,
                                            __global const ShexpSquareTerm* restrict squareTerms,
                                            const uint lobesPerReceiver,
                                            __global const uint* restrict lobeSlots,
                                            __global const float* restrict lightLobes,
                                            __global float4* restrict radiance) {
  SAMPLE_LOCAL(float, room, SHEXP_ROOM);
  const Tile tile = loadTile(positions, normals);
  const ShexpTables tables = {(int)order, logarithms, linear, constants, squareStarts, squareTerms};
  shadeTileByExponentiation(&tables, &tile, spheres, sphereCount, mostHalvings, receivers,
                            lobesPerReceiver, lobeSlots, lightLobes, room, radiance);
}
