#pragma once

#include <string>
#include <vector>

#include "report/track_report.h"

namespace haarlight {

/// The figures of a track as texts; every row has as many as the header.
struct TrackTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< by frame, then by object
};

/// Columns that no frame has anything for are left out; what a frame does not have is "-".
TrackTable trackTable(const TrackReport& report);

}  // namespace haarlight
