#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace haarlight {

/// How deep arrays and objects may lie within one another.
inline constexpr int maximumJsonDepth = 16;

/// Parses JSON (RFC 8259, UTF-8, with or without a byte order mark). Throws InputError with
/// `fileName`, line and column for wrong syntax and comments, and also for a name that is given
/// twice in one object and for more than maximumJsonDepth levels.
nlohmann::json parseJson(std::string_view text, const std::string& fileName);

}  // namespace haarlight
