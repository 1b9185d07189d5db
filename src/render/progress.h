#pragma once

#include <functional>
#include <string>

namespace haarlight {

/// Called with what is being done and how much of it is finished, 0 … 1.
using Progress = std::function<void(const std::string& task, double finished)>;

}  // namespace haarlight
