#pragma once

/// Point caches as bytes, and messages of refusals.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "error_text.h"
#include "mesh/mesh_file.h"
#include "mesh/random.h"

namespace haarlight::test {

using Frames = std::vector<std::vector<glm::vec3>>;

template <typename Number>
void append(std::string& bytes, Number number, bool bigEndian) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  if (bigEndian) std::reverse(raw, raw + sizeof number);
  bytes.append(raw, sizeof number);
}

inline void appendFrames(std::string& bytes, const Frames& frames, bool bigEndian) {
  for (const auto& frame : frames)
    for (const glm::vec3& point : frame)
      for (int i = 0; i < 3; ++i) append(bytes, point[i], bigEndian);
}

inline std::string pc2Bytes(const Frames& frames, float start = 0, float rate = 1) {
  std::string bytes("POINTCACHE2\0", 12);
  append(bytes, std::int32_t(1), false);
  append(bytes, std::int32_t(frames.at(0).size()), false);
  append(bytes, start, false);
  append(bytes, rate, false);
  append(bytes, std::int32_t(frames.size()), false);
  appendFrames(bytes, frames, false);
  return bytes;
}

inline std::string mddBytes(const Frames& frames, const std::vector<float>& seconds) {
  std::string bytes;
  append(bytes, std::int32_t(frames.size()), true);
  append(bytes, std::int32_t(frames.at(0).size()), true);
  for (const float second : seconds) append(bytes, second, true);
  appendFrames(bytes, frames, true);
  return bytes;
}

/// Points anywhere between -10 and 10.
inline Frames randomFrames(std::size_t count, std::size_t points, std::uint64_t seed) {
  Random random(seed);
  Frames frames(count, std::vector<glm::vec3>(points));
  for (auto& frame : frames)
    for (glm::vec3& point : frame)
      for (int i = 0; i < 3; ++i) point[i] = float(20 * random.uniform() - 10);
  return frames;
}

/// A mesh whose file has these vertices; all triangles are the first one.
inline LoadedMesh meshWithVertices(std::size_t count) {
  LoadedMesh loaded;
  loaded.mesh.positions.resize(count);
  loaded.mesh.triangles = {{0, 1, 2}};
  loaded.sourceVertices.resize(count);
  std::iota(loaded.sourceVertices.begin(), loaded.sourceVertices.end(), 0u);
  return loaded;
}

/// Whether both hold the same bits, also where these are −0 and 0.
inline bool sameBits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

}  // namespace haarlight::test
