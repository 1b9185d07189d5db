#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "material/cosine_lobe.h"

namespace haarlight {

/// The samples at which radiance is wanted: texels of a plane, vertices of a mesh or pixels of a
/// screen alike; engines do not know which. The arrays have equal length and kernel layout.
struct Receivers {
  /// World position; w is unused (0).
  std::vector<glm::vec4> positions;
  /// Unit normal; w is unused (0).
  std::vector<glm::vec4> normals;
  /// The normal's lobe, as a blend of tabulated ones.
  std::vector<LobeBlend> lobes;

  std::size_t size() const { return positions.size(); }
  void add(const glm::vec3& position, const glm::vec3& unitNormal) {
    resize(size() + 1);
    set(size() - 1, position, unitNormal);
  }
  /// To be followed by set(), which threads may call for different receivers.
  void resize(std::size_t count) {
    positions.resize(count);
    normals.resize(count);
    lobes.resize(count);
  }
  void set(std::size_t index, const glm::vec3& position, const glm::vec3& unitNormal) {
    positions[index] = {position, 0.0f};
    normals[index] = {unitNormal, 0.0f};
    lobes[index] = blendLobes(unitNormal);
  }
};

/// A contiguous part of the receivers, as engines work through them.
struct ReceiverSpan {
  std::span<const glm::vec4> positions;
  std::span<const glm::vec4> normals;
  std::span<const LobeBlend> lobes;

  ReceiverSpan(const Receivers& all)
      : positions(all.positions), normals(all.normals), lobes(all.lobes) {}

  std::size_t size() const { return positions.size(); }
  ReceiverSpan part(std::size_t first, std::size_t count) const {
    ReceiverSpan span = *this;
    span.positions = positions.subspan(first, count);
    span.normals = normals.subspan(first, count);
    span.lobes = lobes.subspan(first, count);
    return span;
  }
};

}  // namespace haarlight
