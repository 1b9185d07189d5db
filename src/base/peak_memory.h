#pragma once

namespace haarlight {

/// The most memory that this process has held so far, MiB of resident pages.
double peakMemoryMebibytes();

}  // namespace haarlight
