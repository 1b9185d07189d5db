#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/cases/case.h"
#include "verify/cases/line_reader.h"

namespace haarlight::verify {

/// Collects a Case from the lines that describe it (verify/cases/case_file.h), which case files and
/// the known answers share.
class CaseLines {
 public:
  /// Reads the line if it belongs to a case; false if its keyword is another.
  bool read(LineReader& line);

  /// What the lines so far say.
  const Case& value() const { return value_; }

  /// The case after its last line, the current one of `line`.
  Case finish(const LineReader& line);

 private:
  void readName(LineReader& line);
  void readSphere(LineReader& line);
  void readReceiver(LineReader& line);
  void readPlane(LineReader& line);
  void readLight(LineReader& line);
  void readTexel(LineReader& line);
  void readVertex(LineReader& line);
  void readBound(LineReader& line);
  void readFollows(LineReader& line);
  void finishBound(const LineReader& line);
  void checkMovedSpheres(const LineReader& line) const;

  /// The sphere of the last line 'bound', with the lines 'follows' since.
  struct BoundSphere {
    glm::vec2 radiusFactors;
    std::vector<std::uint32_t> vertices;
    std::vector<glm::vec4> weights;
  };

  Case value_;
  std::optional<BoundSphere> bound_;
  bool hasLight_ = false;
  /// Texels that had their line; empty when none had.
  std::vector<bool> texelsRead_;
};

}  // namespace haarlight::verify
