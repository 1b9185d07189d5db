#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace haarlight {

/// From a point to the light: is one object in the way?
struct OcclusionRay {
  glm::dvec3 from{0};
  std::uint32_t caster = 0;
  bool leavesCaster = false;  ///< it starts on the caster's own surface, which counts beyond only
};

/// Answers rays exactly, many at a time.
class OcclusionQuery {
 public:
  virtual ~OcclusionQuery() = default;

  /// Sets blocked[i] to 1 where the caster has a point on the way of rays[i], which is closed, and
  /// to 0 elsewhere. As many answers as rays. In the calling thread; any may ask.
  virtual void answerHere(std::span<const OcclusionRay> rays,
                          std::span<std::uint8_t> blocked) const = 0;

  /// The same with all threads.
  void answer(std::span<const OcclusionRay> rays, std::span<std::uint8_t> blocked) const;
};

}  // namespace haarlight
