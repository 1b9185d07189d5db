// The sum of the logarithms of all spheres' visibilities in spherical harmonics: twin of
// src/shexp/exponentiation.cpp, with the formulas in its header. Where lanes are items, a lane takes
// every 32nd sphere; else an item takes a tile, a sample per element.

#define SHEXP_COUNT (SHEXP_BANDS * SHEXP_BANDS)
#define SHEXP_PAIRS (SHEXP_BANDS * (SHEXP_BANDS + 1) / 2)

// Twins of the host's (src/shexp/tables.h).
typedef struct {
  float diagonal[SHEXP_BANDS], first[SHEXP_PAIRS], second[SHEXP_PAIRS];
  float limitSquared, linearScale;
} ShexpConstants;

typedef struct {
  ushort first, second;
  float weight;
} ShexpSquareTerm;

typedef struct {
  int order;
  __global const float* logarithms;
  __global const float* linear;
  __global const ShexpConstants* constants;
  __global const uint* squareStarts;
  __global const ShexpSquareTerm* squareTerms;
} ShexpTables;

// A sphere's direction and the cosine of its angular radius.
typedef struct {
  LaneFloat x, y, z, cosine;
} SphereView;

inline LaneFloat squaredLength(LaneFloat x, LaneFloat y, LaneFloat z) {
  return fma(z, z, fma(y, y, x * x));
}

inline SphereView viewSphere(const SeenSpheres* seen) {
  const LaneFloat scale = select((LaneFloat)(1.0f), (LaneFloat)(0x1p-64f),
                                 squaredLength(seen->x, seen->y, seen->z) > 0x1p120f);
  const LaneFloat x = seen->x * scale, y = seen->y * scale, z = seen->z * scale;
  const LaneFloat inverse = inverseSquareRoot(squaredLength(x, y, z));
  const LaneFloat ratio = seen->radius * scale * inverse;
  const LaneFloat height = seen->height * scale * inverse;
  const LaneFloat below = 4.0f * smaller(height, (LaneFloat)(0.0f));
  const LaneFloat squared = smaller(
      larger(fma(-ratio, ratio, (LaneFloat)(1.0f)), below * below), (LaneFloat)(1.0f));
  const SphereView view = {x * inverse, y * inverse, z * inverse, rootOf(squared)};
  return view;
}

// Adds factors[l] y_lm for one m >= 0 and for -m; (cosine, sine) = s^m (cos, sin) m phi.
inline void addColumn(const ShexpTables* tables, int m, const LaneFloat* factors, LaneFloat z,
                      LaneFloat cosine, LaneFloat sine, LaneFloat* sum) {
  LaneFloat previous = (LaneFloat)(0.0f);
  LaneFloat current = (LaneFloat)(tables->constants->diagonal[m]);
#pragma unroll
  for (int l = 0; l < SHEXP_BANDS; ++l) {
    if (l < m) continue;
    if (l >= tables->order) break;
    if (l > m) {
      const int entry = l * (l + 1) / 2 + m;
      const LaneFloat next = fma(tables->constants->first[entry] * z, current,
                                 -(tables->constants->second[entry] * previous));
      previous = current;
      current = next;
    }
    const LaneFloat value = factors[l] * current;
    sum[l * (l + 1) + m] = fma(value, cosine, sum[l * (l + 1) + m]);
    if (m > 0) sum[l * (l + 1) - m] = fma(value, sine, sum[l * (l + 1) - m]);
  }
}

#if LANES_PER_ITEM == 1
inline void logarithmFactors(const ShexpTables* tables, float cosine, float* factors) {
  const TablePlace place = placeInTable(cosine * (float)LOGARITHM_ROWS, LOGARITHM_ROWS);
  __global const float* row = tables->logarithms + LOGARITHM_ROW * place.row;
#pragma unroll
  for (int l = 0; l < SHEXP_BANDS; ++l)
    factors[l] = fma(place.fraction, row[LOGARITHM_ROW / 2 + l], row[l]);
}
#else
inline float8 factorsOfSample(const ShexpTables* tables, int row, float fraction) {
  __global const float8* own = (__global const float8*)tables->logarithms + 2 * row;
  return fma((float8)(fraction), own[1], own[0]);
}

// A sample's factors lie beside each other in the table, and are found at once.
inline void logarithmFactors(const ShexpTables* tables, LaneFloat cosine, LaneFloat* factors) {
  const TablePlace place = placeInTable(cosine * (float)LOGARITHM_ROWS, LOGARITHM_ROWS);
  int rows[TILE] __attribute__((aligned(64)));
  float fractions[TILE] __attribute__((aligned(64)));
  *(LaneInt*)rows = place.row;
  *(LaneFloat*)fractions = place.fraction;
  float bySample[8 * TILE] __attribute__((aligned(64)));
#pragma unroll
  for (uint i = 0; i < TILE; ++i)
    ((float8*)bySample)[i] = factorsOfSample(tables, rows[i], fractions[i]);
  const LaneInt places = 8 * LANE_NUMBERS(0);
#pragma unroll
  for (int l = 0; l < SHEXP_BANDS; ++l) {
    if (l >= tables->order) break;
    factors[l] = OF_TABLE(bySample + l, places);
  }
}
#endif

// Adds the logarithm of a sphere's visibility.
inline void addLogarithm(const ShexpTables* tables, const SphereView* view,
                         const LaneFloat* factors, LaneFloat* sum) {
  LaneFloat cosine = (LaneFloat)(1.0f), sine = (LaneFloat)(0.0f);
#pragma unroll
  for (int m = 0; m < SHEXP_BANDS; ++m) {
    if (m >= tables->order) break;
    addColumn(tables, m, factors, view->z, cosine, sine, sum);
    const LaneFloat before = cosine;
    cosine = fma(view->x, cosine, -(view->y * sine));
    sine = fma(view->x, sine, view->y * before);
  }
}

#if LANES_PER_ITEM == 1
// Room of a sample: rows of partial sums, and quarters of their trees. Rows lie 4 further apart than
// lanes, so that the quarters of different rows are read from different banks.
#define TREE_ROWS 8
#define TREE_STRIDE (LANES + 4)
#define QUARTERS (TREE_ROWS * TREE_STRIDE)
#define SHEXP_ROOM (QUARTERS + 4 * (SHEXP_COUNT + TREE_ROWS / 2))

// The tree over 32 partial sums: four quarters by one lane each, then those.
inline float quarterOfTree(__local const float* partials) {
  return ((partials[0] + partials[16]) + (partials[8] + partials[24])) +
         ((partials[4] + partials[20]) + (partials[12] + partials[28]));
}

inline float treeOfQuarters(__local const float* quarters) {
  return (quarters[0] + quarters[2]) + (quarters[1] + quarters[3]);
}

// The logarithms of all spheres; coefficients are in `room` then, and zeros to the end of their row.
inline void sumLogarithms(const ShexpTables* tables, const Tile* tile,
                          __global const float* spheres, uint sphereCount, __local float* room) {
  const uint stride = sphereStride(sphereCount);
  const uint count = (uint)(tables->order * tables->order);
  float own[SHEXP_COUNT];
#pragma unroll
  for (uint k = 0; k < SHEXP_COUNT; ++k) own[k] = 0.0f;
  for (uint first = 0; first + FIRST_LANE < sphereCount; first += LANES) {
    const SeenSpheres seen = seeSpheres(tile, spheres, stride, first);
    const SphereView view = viewSphere(&seen);
    float factors[SHEXP_BANDS];
    logarithmFactors(tables, view.cosine, factors);
    addLogarithm(tables, &view, factors, own);
  }
#pragma unroll
  for (uint first = 0; first < SHEXP_COUNT; first += TREE_ROWS) {
#pragma unroll
    for (uint i = 0; i < TREE_ROWS; ++i)
      room[i * TREE_STRIDE + FIRST_LANE] = first + i < SHEXP_COUNT ? own[first + i] : 0.0f;
    LANE_BARRIER();
    room[QUARTERS + 4 * first + FIRST_LANE] =
        quarterOfTree(room + FIRST_LANE / 4 * TREE_STRIDE + FIRST_LANE % 4);
    LANE_BARRIER();
  }
  for (uint k = FIRST_LANE; k < LIGHT_LOBE_ROW; k += LANES)
    room[k] = k < count ? treeOfQuarters(room + QUARTERS + 4 * k) : 0.0f;
  LANE_BARRIER();
}
#else
#define FOR_EACH_COEFFICIENT(k) for (uint k = 0; k < count; ++k)

// Partial sums in the order in which the tree needs them, 0, 16, 8, 24, 4 … bits reversed.
inline uint partialSum(uint i) {
  return (i & 1) << 4 | (i & 2) << 2 | (i & 4) | (i & 8) >> 2 | (i & 16) >> 4;
}

#define FOR_EACH_OF_FOUR(own, i)       \
  for (uint own = 0; own < 4; ++own)    \
    if (first + partialSum((i) + own) < sphereCount)

// Four partial sums, from i on. A sphere's operations wait for each other, those of four do not.
inline void addToFourSums(const ShexpTables* tables, const Tile* tile,
                          __global const float* spheres, uint sphereCount, uint i,
                          LaneFloat sums[4][SHEXP_COUNT]) {
  const uint stride = sphereStride(sphereCount);
  for (uint first = 0; first < sphereCount; first += LANES) {
    SphereView views[4];
    LaneFloat factors[4][SHEXP_BANDS];
    FOR_EACH_OF_FOUR(own, i) {
      const SeenSpheres seen = seeSphere(tile, spheres, stride, first + partialSum(i + own));
      views[own] = viewSphere(&seen);
    }
    FOR_EACH_OF_FOUR(own, i) logarithmFactors(tables, views[own].cosine, factors[own]);
    FOR_EACH_OF_FOUR(own, i) addLogarithm(tables, &views[own], factors[own], sums[own]);
  }
}

// Of every level of the tree one sum waits in `waiting` for its partner.
inline void sumLogarithms(const ShexpTables* tables, const Tile* tile,
                          __global const float* spheres, uint sphereCount, LaneFloat* sum) {
  const uint count = (uint)(tables->order * tables->order);
  LaneFloat waiting[3][SHEXP_COUNT];
  for (uint i = 0; i < LANES / 4; ++i) {
    LaneFloat sums[4][SHEXP_COUNT];
    for (uint own = 0; own < 4; ++own)
      FOR_EACH_COEFFICIENT(k) sums[own][k] = (LaneFloat)(0.0f);
    addToFourSums(tables, tile, spheres, sphereCount, 4 * i, sums);
    FOR_EACH_COEFFICIENT(k) sum[k] = (sums[0][k] + sums[1][k]) + (sums[2][k] + sums[3][k]);
    uint level = 0;
    for (; i >> level & 1; ++level) FOR_EACH_COEFFICIENT(k) sum[k] = waiting[level][k] + sum[k];
    if (level < 3) FOR_EACH_COEFFICIENT(k) waiting[level][k] = sum[k];
  }
}
#endif
