#include "engine/square_weights.h"

#include <algorithm>
#include <cmath>

#include "base/canonical_order.h"

namespace haarlight {

namespace {

constexpr int levelsOf(SquareDetail detail) {
  return detail == coarseSquares ? coarseLevels : 1;
}
constexpr int firstLevelOf(SquareDetail detail) {
  return detail == coarseSquares ? 0 : coarseLevels - 1 + detail;
}

Square squareOf(const LightTerm& term) {
  if (term.coefficient == 0) return {term.face, 0, 0};
  const Wavelet w = waveletAt(term.coefficient);
  return {term.face, w.level, w.square};
}

/// The square whose occlusion a term reads: at level I blocks are uniform.
Square squareWithOcclusion(const Square& square, const ShadingSettings& settings) {
  if (settings.levels == 2 || square.level <= coarseLevels) return square;
  const int side = squaresPerSide(square.level);
  const int row = square.square / side, column = square.square % side;
  return {square.face, coarseLevels, row / 2 * (side / 2) + column / 2};
}

int pyramidIndex(const Square& square) {
  return square.face * meansPerFace + meanIndex(square.level, square.square);
}

/// Signs of w_h, w_v, w_d on a quarter.
template <typename Vec4>
auto weightOnQuarter(const Vec4& weight, int child) {
  auto sum = weight.w;
  for (int type = 0; type < 3; ++type)
    if (waveletSign(type, child) > 0)
      sum += weight[type];
    else
      sum -= weight[type];
  return sum;
}

/// Factors of the occlusion's three coefficients and mean on the term's square.
glm::dvec4 factorsOf(const HaarFace<float>& lobe, int coefficient) {
  if (coefficient == 0) return {0, 0, 0, lobe.coefficients[0]};
  const Wavelet w = waveletAt(coefficient);
  const int a = (w.type + 1) % 3, b = (w.type + 2) % 3;
  const double height = squaresPerSide(w.level);
  glm::dvec4 factors;
  factors[w.type] = lobe.mean(w.level, w.square);
  factors[a] = height * lobe.coefficient({w.level, w.square, b});
  factors[b] = height * lobe.coefficient({w.level, w.square, a});
  factors.w = lobe.coefficients[coefficient];
  return factors;
}

/// What a coefficient and a mean are per blocked texel: 2^{l − 10} and 2^{2l − 10}.
glm::dvec4 unitsOf(int level) {
  const double coefficient = std::ldexp(1.0, level - 2 * haarLevels);
  return {glm::dvec3(coefficient), std::ldexp(1.0, 2 * (level - haarLevels))};
}

void addLightTerms(ExactSquareWeights& weights, const SquareList& squares,
                   const ShadingSettings& settings, const LightHaar& light,
                   std::span<const LightTerm> terms, const HaarCube<float>& lobe) {
  for (const LightTerm& term : terms) {
    const Square square = squareOf(term), read = squareWithOcclusion(square, settings);
    glm::dvec4 factors = factorsOf(lobe[term.face], term.coefficient);
    if (settings.levels == 1 && square.level >= coarseLevels) factors = {0, 0, 0, factors.w};
    factors *= unitsOf(read.level);
    const glm::dvec3& coefficient = light[term.face].coefficients[term.coefficient];
    for (int channel = 0; channel < 3; ++channel)
      weights[squares.indexOf(read)][channel] += coefficient[channel] * factors;
  }
}

void addLobeTerms(ExactSquareWeights& weights, const SquareList& squares,
                  const ShadingSettings& settings, const LightHaar& light,
                  const HaarCube<float>& lobe) {
  const int levels = settings.isComplete() && settings.levels == 2 ? haarLevels : coarseLevels;
  for (int face = 0; face < faceCount; ++face)
    for (int i = 1; i < firstCoefficient(levels); ++i) {
      const Wavelet w = waveletAt(i);
      const double factor = lobe[face].coefficients[i] * unitsOf(w.level)[w.type];
      const glm::dvec3& mean = light[face].mean(w.level, w.square);
      for (int channel = 0; channel < 3; ++channel)
        weights[squares.indexOf({face, w.level, w.square})][channel][w.type] +=
            factor * mean[channel];
    }
}

/// Bounds of a sum of weights of texels.
struct Range {
  glm::dvec3 low{0}, high{0};
};

Range rangeOfSums(const SquareList& squares, const ExactSquareWeights& weights) {
  Range range;
  for (const glm::dvec3& weight :
       spreadOverTexels<glm::dvec3>(squares, std::span<const ChannelWeights<glm::dvec4>>(weights)))
    for (int channel = 0; channel < 3; ++channel)
      (weight[channel] < 0 ? range.low : range.high)[channel] += weight[channel];
  return range;
}

/// The largest exponent with which `largest` stays well within 31 bits: rounding adds less than 10
/// units to the weight of a texel, and what is left over is 2^20.
int exponentFor(double largest) {
  constexpr double room = 0x1p31 - 0x1p20;
  constexpr int bound = 100;
  if (!(largest > 0)) return 0;
  return std::clamp(int(std::floor(std::log2(room / largest))), -bound, bound);
}

std::uint32_t wrapped(double integer) {
  return std::uint32_t(std::int64_t(std::fmod(integer, 0x1p32)));
}

/// Rounds the weights of one channel.
void roundChannel(const SquareList& squares, const ExactSquareWeights& weights, int channel,
                  int exponent, SquareWeights& rounded) {
  std::vector<double> carried(squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const Square& square = squares[i];
    if (SquareList::isFiller(square)) continue;
    glm::dvec4 left;
    for (int k = 0; k < 4; ++k) {
      const double exact =
          std::ldexp(weights[i][channel][k], exponent) + (k == 3 ? carried[i] : 0.0);
      const double nearest = std::nearbyint(exact);
      rounded[i][channel][k] = wrapped(nearest);
      left[k] = exact - nearest;
    }
    if (square.level == haarLevels - 1) continue;
    const auto quarters = children(square.level, square.square);
    for (int child = 0; child < 4; ++child) {
      const int index = squares.indexOf({square.face, square.level + 1, quarters[child]});
      if (index != SquareList::absent) carried[index] += weightOnQuarter(left, child);
    }
  }
}

}  // namespace

SquareList::SquareList(std::span<const LightTerm> terms, const ShadingSettings& settings) {
  for (const LightTerm& term : terms)
    wanted_[pyramidIndex(squareWithOcclusion(squareOf(term), settings))] = true;
  for (const SquareDetail detail : {coarseSquares, blockSquares, quarterSquares}) append(detail);
}

void SquareList::append(SquareDetail detail) {
  const int first = firstLevelOf(detail);
  for (int face = 0; face < faceCount; ++face)
    for (int level = first; level < first + levelsOf(detail); ++level)
      for (int square = 0; square < squaresPerSide(level) * squaresPerSide(level); ++square) {
        const Square candidate{face, level, square};
        if (detail != coarseSquares && !wanted_[pyramidIndex(candidate)]) continue;
        indices_[pyramidIndex(candidate)] = int(squares_.size());
        squares_.push_back(candidate);
      }
  constexpr std::size_t multiple = partialSums;
  squares_.resize((squares_.size() + multiple - 1) / multiple * multiple, {0, -1, 0});
  ends_[detail] = std::uint32_t(squares_.size());
}

ExactSquareWeights gatherBySquares(const SquareList& squares, const ShadingSettings& settings,
                                   const LightHaar& light, std::span<const LightTerm> terms,
                                   const HaarCube<float>& lobe) {
  ExactSquareWeights weights(squares.size(), {glm::dvec4(0), glm::dvec4(0), glm::dvec4(0)});
  addLightTerms(weights, squares, settings, light, terms, lobe);
  addLobeTerms(weights, squares, settings, light, lobe);
  return weights;
}

template <typename Vec3, typename Vec4>
std::vector<Vec3> spreadOverTexels(const SquareList& squares,
                                   std::span<const ChannelWeights<Vec4>> weights) {
  std::vector<Vec3> texels;
  for (int face = 0; face < faceCount; ++face) {
    std::vector<Vec3> coarse{Vec3(0)};
    for (int level = 0; level < haarLevels; ++level) {
      std::vector<Vec3> fine(4 * coarse.size());
      for (int square = 0; square < int(coarse.size()); ++square) {
        const int index = squares.indexOf({face, level, square});
        const auto quarters = children(level, square);
        for (int child = 0; child < 4; ++child) {
          Vec3& value = fine[quarters[child]] = coarse[square];
          if (index == SquareList::absent) continue;
          for (int channel = 0; channel < 3; ++channel)
            value[channel] += weightOnQuarter(weights[index][channel], child);
        }
      }
      coarse = std::move(fine);
    }
    texels.insert(texels.end(), coarse.begin(), coarse.end());
  }
  return texels;
}

template std::vector<glm::dvec3> spreadOverTexels(const SquareList&,
                                                  std::span<const ChannelWeights<glm::dvec4>>);
template std::vector<glm::uvec3> spreadOverTexels(const SquareList&,
                                                  std::span<const ChannelWeights<glm::uvec4>>);

RoundedLobe roundWeights(const SquareList& squares, const ExactSquareWeights& weights,
                         const glm::dvec3& unshadowed) {
  RoundedLobe lobe;
  lobe.weights.resize(squares.size(), {glm::uvec4(0), glm::uvec4(0), glm::uvec4(0)});
  const Range range = rangeOfSums(squares, weights);
  for (int channel = 0; channel < 3; ++channel) {
    const double open = unshadowed[channel];
    const int exponent = exponentFor(
        std::max(std::abs(open - range.high[channel]), std::abs(open - range.low[channel])));
    roundChannel(squares, weights, channel, exponent, lobe.weights);
    lobe.unshadowed[channel] = wrapped(std::nearbyint(std::ldexp(open, exponent)));
    lobe.scale[channel] = float(std::ldexp(1.0, -exponent));
  }
  return lobe;
}

}  // namespace haarlight
