#pragma once

/// What engines read to shade by precomputed diffuse transfer (docs/transfer.md), in the basis of
/// sh/basis.h: rows of transfer, lights, and receivers that blend both.
///
/// With the rows' weights w, the lights' weights v, and in every channel
///
///     T_k = w_0 T_0k,  then fma(w_1, T_1k, ·), fma(w_2, T_2k, ·)
///     L_k = v_0 L_0k,  then fma(v_i, L_ik, ·) for the other lights in turn
///
/// radiance is Σ T_k L_k: term k goes into partial sum k mod 32 by fma, from 0 on, the partial sums
/// are combined as a tree (base/canonical_order.h), and what is not above zero becomes zero.

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace haarlight {

/// Rows of transfer, one for each vertex of a scene.
struct TransferRows {
  int order = 1;
  int channels = 1;           ///< 1, where red, green and blue have the same row, or 3
  std::vector<float> values;  ///< row by row, channel by channel, coefficient by coefficient

  std::size_t coefficients() const { return std::size_t(order) * std::size_t(order); }
  std::size_t rowLength() const { return std::size_t(channels) * coefficients(); }
  std::size_t rowCount() const { return values.size() / rowLength(); }
  /// Order² coefficients; channel 0 to 2.
  std::span<const float> row(std::size_t row, int channel) const {
    const std::size_t first = channels == 1 ? 0 : std::size_t(channel) * coefficients();
    return std::span(values).subspan(row * rowLength() + first, coefficients());
  }
};

/// Lights as spherical harmonics. One stands for distant light; several, for light that was
/// measured at several places.
struct TransferLights {
  int order = 1;
  std::vector<float> values;  ///< light by light, channel by channel, coefficient by coefficient

  std::size_t coefficients() const { return std::size_t(order) * std::size_t(order); }
  std::size_t count() const { return values.size() / (3 * coefficients()); }
  /// Order² coefficients; channel 0 to 2.
  std::span<const float> light(std::size_t light, int channel) const {
    return std::span(values).subspan((3 * light + std::size_t(channel)) * coefficients(),
                                     coefficients());
  }
};

/// A receiver's row as a blend of three, in kernel layout: rows and weights of x, y and z; w is
/// unused. A vertex has the weights (1, 0, 0).
struct RowBlend {
  glm::uvec4 rows{0};
  glm::vec4 weights{1, 0, 0, 0};
};

/// Where radiance is wanted.
struct TransferReceivers {
  std::vector<RowBlend> blends;
  std::vector<float> lightWeights;  ///< receiver by receiver, one for each light

  std::size_t size() const { return blends.size(); }
};

/// Rows that the receivers need: one each where all are vertices, else three.
std::uint32_t rowsPerReceiver(std::span<const RowBlend> blends);

/// Throws std::invalid_argument unless the lights have the rows' order, there is a light, each
/// receiver has a weight for each light, and the rows that it names are below `rowCount`.
void requireTransfer(int order, std::size_t rowCount, const TransferLights& lights,
                     const TransferReceivers& receivers);

}  // namespace haarlight
