#include "shexp/exponentiation.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/canonical_order.h"
#include "sh/basis.h"
#include "shexp/float_functions.h"

namespace haarlight {

namespace {

/// Where a number lies in a table of equal steps: between row and row + 1.
struct TablePlace {
  int row;
  float fraction;
};

/// `scaled` is the number in steps, ≥ 0; beyond the last row the last step is continued.
TablePlace placeInTable(float scaled, int rows) {
  const int row = int(std::min(float(rows - 1), scaled));
  return {row, scaled - float(row)};
}

float interpolate(float fraction, float a, float b) {
  return std::fma(fraction, b - a, a);
}

/// √x within 2e-7 relative for x ≥ 0 that are not denormal.
float rootOf(float x) {
  return x * inverseSquareRoot(x);
}

/// A sphere as a sample sees it: unit direction, and the cosine of its angular radius.
struct SphereView {
  glm::vec3 direction;
  float cosine;
};

/// Far spheres are seen at a smaller scale, so that no square overflows.
SphereView viewSphere(const Sphere& sphere, const glm::vec3& position, const glm::vec3& normal) {
  const auto squareOf = [](const glm::vec3& v) {
    return std::fma(v.z, v.z, std::fma(v.y, v.y, v.x * v.x));
  };
  const glm::vec3 d = sphere.center - position;
  const float scale = squareOf(d) > 0x1p120f ? 0x1p-64f : 1.0f;
  const glm::vec3 scaled = d * scale;
  const float inverse = inverseSquareRoot(squareOf(scaled));
  const float ratio = sphere.radius * scale * inverse;
  const float height = ((d.x * normal.x + d.y * normal.y) + d.z * normal.z) * scale * inverse;
  const float below = 4.0f * std::min(height, 0.0f);
  const float squared = std::min(std::max(std::fma(-ratio, ratio, 1.0f), below * below), 1.0f);
  return {scaled * inverse, rootOf(squared)};
}

using ZonalFactors = std::array<float, largestShexpOrder>;

ZonalFactors logarithmFactors(const ShexpTables& tables, float cosine) {
  const TablePlace place =
      placeInTable(cosine * ShexpTables::logarithmRows, ShexpTables::logarithmRows);
  const float* row = &tables.logarithms[place.row * ShexpTables::logarithmRowSize];
  const float* steps = row + ShexpTables::logarithmRowSize / 2;
  ZonalFactors factors{};
  for (int l = 0; l < tables.order; ++l) factors[l] = std::fma(place.fraction, steps[l], row[l]);
  return factors;
}

/// Adds factors[l] · y_lm(direction) for one m ≥ 0 and for −m; (cosine, sine) = s^m (cos, sin) mφ.
void addColumn(const ShexpTables& tables, const ZonalFactors& factors, int m, float z, float cosine,
               float sine, ShexpVector& sum) {
  float previous = 0, current = tables.constants.diagonal[m];
  for (int l = m; l < tables.order; ++l) {
    if (l > m) {
      const int entry = l * (l + 1) / 2 + m;
      const float next = std::fma(tables.constants.first[entry] * z, current,
                                  -(tables.constants.second[entry] * previous));
      previous = current;
      current = next;
    }
    const float value = factors[l] * current;
    sum[shIndex(l, m)] = std::fma(value, cosine, sum[shIndex(l, m)]);
    if (m > 0) sum[shIndex(l, -m)] = std::fma(value, sine, sum[shIndex(l, -m)]);
  }
}

}  // namespace

void addSphereLogarithm(const ShexpTables& tables, const Sphere& sphere,
                        const glm::vec3& samplePosition, const glm::vec3& sampleNormal,
                        ShexpVector& sum) {
  const SphereView view = viewSphere(sphere, samplePosition, sampleNormal);
  const ZonalFactors factors = logarithmFactors(tables, view.cosine);
  float cosine = 1, sine = 0;
  for (int m = 0; m < tables.order; ++m) {
    addColumn(tables, factors, m, view.direction.z, cosine, sine, sum);
    const float before = cosine;
    cosine = std::fma(view.direction.x, cosine, -(view.direction.y * sine));
    sine = std::fma(view.direction.x, sine, view.direction.y * before);
  }
}

ShexpVector sphereLogarithms(const ShexpTables& tables, std::span<const Sphere> spheres,
                             const glm::vec3& samplePosition, const glm::vec3& sampleNormal) {
  std::array<ShexpVector, partialSums> partials{};
  for (std::size_t k = 0; k < spheres.size(); ++k)
    addSphereLogarithm(tables, spheres[k], samplePosition, sampleNormal, partials[k % partialSums]);
  return combineAsTree(partials, [](ShexpVector a, const ShexpVector& b) {
    for (int i = 0; i < largestShexpCount; ++i) a[i] += b[i];
    return a;
  });
}

ShexpVector shexpSquare(const ShexpTables& tables, const ShexpVector& g) {
  const auto addTerm = [&](const ShexpSquareTerm& term, float sum) {
    return std::fma(term.weight, g[term.first] * g[term.second], sum);
  };
  ShexpVector result{};
  for (int k = 0; k < shCoefficientCount(tables.order); ++k) {
    float even = 0, odd = 0;
    for (auto i = tables.squareStarts[k]; i < tables.squareStarts[k + 1]; i += 2) {
      even = addTerm(tables.squareTerms[i], even);
      odd = addTerm(tables.squareTerms[i + 1], odd);
    }
    result[k] = even + odd;
  }
  return result;
}

ShexpVector shexpVisibility(const ShexpTables& tables, std::span<const Sphere> spheres,
                            const glm::vec3& samplePosition, const glm::vec3& sampleNormal) {
  return shexpExponential(tables, sphereLogarithms(tables, spheres, samplePosition, sampleNormal),
                          tables.mostHalvings(spheres.size()));
}

ShexpVector shexpExponential(const ShexpTables& tables, const ShexpVector& f, int mostHalvings) {
  constexpr float constant = 0.28209479f;  // y_00
  const int count = shCoefficientCount(tables.order);
  float squares = 0;
  for (int i = 1; i < count; ++i) squares = std::fma(f[i], f[i], squares);
  float scale = 1;
  int halvings = 0;
  for (; halvings < mostHalvings && squares > tables.constants.limitSquared; ++halvings) {
    squares *= 0.25f;
    scale *= 0.5f;
  }
  const TablePlace place =
      placeInTable(rootOf(squares) * tables.constants.linearScale, ShexpTables::linearRows);
  const glm::vec2 low = tables.linear[place.row], high = tables.linear[place.row + 1];
  const float mean = exponential(f[0] * constant * scale);
  const float factor = interpolate(place.fraction, low.y, high.y) * scale * mean;
  ShexpVector g{};
  g[0] = interpolate(place.fraction, low.x, high.x) * mean;
  for (int i = 1; i < count; ++i) g[i] = factor * f[i];
  for (int i = 0; i < halvings; ++i) g = shexpSquare(tables, g);
  return g;
}

}  // namespace haarlight
