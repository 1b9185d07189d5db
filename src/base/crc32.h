#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace haarlight {

/// CRC-32 as PNG and zlib use it (PNG specification, annex D).
inline std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  static constexpr std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> result{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      result[i] = i;
      for (int bit = 0; bit < 8; ++bit)
        result[i] = result[i] >> 1 ^ (result[i] & 1 ? 0xEDB88320u : 0u);
    }
    return result;
  }();
  std::uint32_t crc = ~0u;
  for (const std::uint8_t byte : bytes) crc = table[(crc ^ byte) & 0xFF] ^ crc >> 8;
  return ~crc;
}

}  // namespace haarlight
