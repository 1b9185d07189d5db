#pragma once

#include <string>

namespace haarlight::verify {

/// Processor, its number of threads and the operating system: what a reader of a report needs to
/// know of the machine.
std::string hostDescription();

/// Now, as "2026-11-22T07:30:00Z".
std::string utcNow();

}  // namespace haarlight::verify
