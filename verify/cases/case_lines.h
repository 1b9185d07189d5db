#pragma once

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
  void checkReceiverCount(const LineReader& line, std::size_t more) const;

  Case value_;
  bool hasLight_ = false;
  /// Texels that had their line; empty when none had.
  std::vector<bool> texelsRead_;
};

}  // namespace haarlight::verify
