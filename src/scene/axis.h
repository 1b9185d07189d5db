#pragma once

namespace haarlight {

/// A coordinate axis; its number is the component's in a vector.
enum class Axis { x, y, z };

}  // namespace haarlight
