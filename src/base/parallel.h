#pragma once

#include <cstddef>
#include <functional>

namespace haarlight {

/// Number of threads parallelFor uses; 0 (the default) means one per processor.
void setThreadCount(unsigned count);
unsigned threadCount();

/// Calls body(begin, end) for consecutive ranges of at most `grain` items that together cover
/// [0, count), on threadCount() threads. The ranges do not depend on the number of threads. The
/// first exception thrown by a body is thrown again here, after all threads have ended.
void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace haarlight
