// The sum of the logarithms of all spheres' visibilities in spherical harmonics: twin of
// src/shexp/exponentiation.cpp, with the formulas in its header. A lane takes every 32nd sphere.

#define SHEXP_COUNT (SHEXP_BANDS * SHEXP_BANDS)
#define SHEXP_PAIRS (SHEXP_BANDS * (SHEXP_BANDS + 1) / 2)

// Twins of the host's (src/shexp/tables.h).
struct ShexpConstants {
  float diagonal[SHEXP_BANDS], first[SHEXP_PAIRS], second[SHEXP_PAIRS];
  float limitSquared, linearScale;
};

struct ShexpSquareTerm {
  ushort first, second;
  float weight;
};

struct ShexpTables {
  int order;
  const float* logarithms;
  const float* linear;
  const ShexpConstants* constants;
  const uint* squareStarts;
  const ShexpSquareTerm* squareTerms;
};

// A sphere's direction and the cosine of its angular radius.
struct SphereView {
  float x, y, z, cosine;
};

__device__ inline float squaredLength(float x, float y, float z) {
  return __fmaf_rn(z, z, __fmaf_rn(y, y, x * x));
}

__device__ inline SphereView viewSphere(const SeenSpheres* seen) {
  const float scale =
      squaredLength(seen->x, seen->y, seen->z) > 0x1p120f ? 0x1p-64f : 1.0f;
  const float x = seen->x * scale, y = seen->y * scale, z = seen->z * scale;
  const float inverse = inverseSquareRoot(squaredLength(x, y, z));
  const float ratio = seen->radius * scale * inverse;
  const float height = seen->height * scale * inverse;
  const float below = 4.0f * smaller(height, 0.0f);
  const float squared = smaller(larger(__fmaf_rn(-ratio, ratio, 1.0f), below * below), 1.0f);
  const SphereView view = {x * inverse, y * inverse, z * inverse, rootOf(squared)};
  return view;
}

// Adds factors[l] y_lm for one m >= 0 and for -m; (cosine, sine) = s^m (cos, sin) m phi.
__device__ inline void addColumn(const ShexpTables* tables, int m, const float* factors, float z,
                                 float cosine, float sine, float* sum) {
  float previous = 0.0f;
  float current = tables->constants->diagonal[m];
  UNROLL for (int l = 0; l < SHEXP_BANDS; ++l) {
    if (l < m) continue;
    if (l >= tables->order) break;
    if (l > m) {
      const int entry = l * (l + 1) / 2 + m;
      const float next = __fmaf_rn(tables->constants->first[entry] * z, current,
                                   -(tables->constants->second[entry] * previous));
      previous = current;
      current = next;
    }
    const float value = factors[l] * current;
    sum[l * (l + 1) + m] = __fmaf_rn(value, cosine, sum[l * (l + 1) + m]);
    if (m > 0) sum[l * (l + 1) - m] = __fmaf_rn(value, sine, sum[l * (l + 1) - m]);
  }
}

__device__ inline void logarithmFactors(const ShexpTables* tables, float cosine, float* factors) {
  const TablePlace place = placeInTable(cosine * float(LOGARITHM_ROWS), LOGARITHM_ROWS);
  const float* row = tables->logarithms + LOGARITHM_ROW * place.row;
  UNROLL for (int l = 0; l < SHEXP_BANDS; ++l)
    factors[l] = __fmaf_rn(place.fraction, row[LOGARITHM_ROW / 2 + l], row[l]);
}

// Adds the logarithm of a sphere's visibility.
__device__ inline void addLogarithm(const ShexpTables* tables, const SphereView* view,
                                    const float* factors, float* sum) {
  float cosine = 1.0f, sine = 0.0f;
  UNROLL for (int m = 0; m < SHEXP_BANDS; ++m) {
    if (m >= tables->order) break;
    addColumn(tables, m, factors, view->z, cosine, sine, sum);
    const float before = cosine;
    cosine = __fmaf_rn(view->x, cosine, -(view->y * sine));
    sine = __fmaf_rn(view->x, sine, view->y * before);
  }
}

// Room of a sample: rows of partial sums, and quarters of their trees. Rows lie 4 further apart than
// lanes, so that the quarters of different rows are read from different banks.
#define TREE_ROWS 8
#define TREE_STRIDE (LANES + 4)
#define QUARTERS (TREE_ROWS * TREE_STRIDE)
#define SHEXP_ROOM (QUARTERS + 4 * (SHEXP_COUNT + TREE_ROWS / 2))

// The tree over 32 partial sums: four quarters by one lane each, then those.
__device__ inline float quarterOfTree(const float* partials) {
  return ((partials[0] + partials[16]) + (partials[8] + partials[24])) +
         ((partials[4] + partials[20]) + (partials[12] + partials[28]));
}

__device__ inline float treeOfQuarters(const float* quarters) {
  return (quarters[0] + quarters[2]) + (quarters[1] + quarters[3]);
}

// The logarithms of all spheres; coefficients are in `room` then, and zeros to the end of their row.
__device__ inline void sumLogarithms(const ShexpTables* tables, const Tile* tile,
                                     const float* spheres, uint sphereCount, float* room) {
  const uint stride = sphereStride(sphereCount);
  const uint count = uint(tables->order * tables->order);
  float own[SHEXP_COUNT];
  UNROLL for (uint k = 0; k < SHEXP_COUNT; ++k) own[k] = 0.0f;
  for (uint first = 0; first + LANE < sphereCount; first += LANES) {
    const SeenSpheres seen = seeSpheres(tile, spheres, stride, first);
    const SphereView view = viewSphere(&seen);
    float factors[SHEXP_BANDS];
    logarithmFactors(tables, view.cosine, factors);
    addLogarithm(tables, &view, factors, own);
  }
  UNROLL for (uint first = 0; first < SHEXP_COUNT; first += TREE_ROWS) {
    UNROLL for (uint i = 0; i < TREE_ROWS; ++i)
      room[i * TREE_STRIDE + LANE] = first + i < SHEXP_COUNT ? own[first + i] : 0.0f;
    LANE_BARRIER();
    room[QUARTERS + 4 * first + LANE] =
        quarterOfTree(room + LANE / 4 * TREE_STRIDE + LANE % 4);
    LANE_BARRIER();
  }
  for (uint k = LANE; k < LIGHT_LOBE_ROW; k += LANES)
    room[k] = k < count ? treeOfQuarters(room + QUARTERS + 4 * k) : 0.0f;
  LANE_BARRIER();
}
