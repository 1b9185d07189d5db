#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace haarlight::test {

/// Bytes that are taken from their beginning; throws std::runtime_error past their end.
struct ByteReader {
  std::span<const std::uint8_t> rest;

  std::span<const std::uint8_t> take(std::size_t count) {
    if (count > rest.size()) throw std::runtime_error("too short");
    const auto taken = rest.first(count);
    rest = rest.subspan(count);
    return taken;
  }
  std::uint32_t bigEndian() {
    std::uint32_t value = 0;
    for (const std::uint8_t byte : take(4)) value = value << 8 | byte;
    return value;
  }
  void need(std::initializer_list<int> bytes) {
    for (const int byte : bytes)
      if (take(1)[0] != byte) throw std::runtime_error("wrong byte");
  }
};

/// CRC-32 (PNG specification, annex D) bit by bit.
inline std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes)
    for (int bit = 0; bit < 8; ++bit) {
      const bool low = (crc ^ byte >> bit) & 1;
      crc = crc >> 1 ^ (low ? 0xEDB88320 : 0);
    }
  return ~crc;
}

/// RFC 1950 in 64-bit sums, without reductions on the way.
inline std::uint32_t adler32(std::span<const std::uint8_t> bytes) {
  std::uint64_t a = 1, b = 0;
  for (const std::uint8_t byte : bytes) b += a += byte;
  return std::uint32_t(b % 65521 << 16 | a % 65521);
}

struct Png {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

inline std::span<const std::uint8_t> readChunk(ByteReader& png, const std::string& type) {
  const std::size_t length = png.bigEndian();
  const auto checked = png.take(4 + length);
  if (std::string(checked.begin(), checked.begin() + 4) != type) throw std::runtime_error("type");
  if (png.bigEndian() != crc32(checked)) throw std::runtime_error("CRC");
  return checked.subspan(4);
}

inline std::vector<std::uint8_t> readStoredStream(ByteReader stream) {
  stream.need({0x78, 0x01});
  std::vector<std::uint8_t> content;
  for (bool last = false; !last;) {
    const std::uint8_t head = stream.take(1)[0];
    if (head > 1) throw std::runtime_error("not a stored block");
    last = head == 1;
    const auto size = stream.take(4);
    const unsigned length = size[0] | size[1] << 8, inverse = size[2] | size[3] << 8;
    if ((length ^ inverse) != 0xFFFF) throw std::runtime_error("length");
    const auto block = stream.take(length);
    content.insert(content.end(), block.begin(), block.end());
  }
  if (stream.bigEndian() != adler32(content)) throw std::runtime_error("Adler-32");
  if (!stream.rest.empty()) throw std::runtime_error("bytes after the stream");
  return content;
}

/// Reads an 8-bit RGB PNG of stored blocks without filters, checking every length and checksum.
inline Png readPng(std::span<const std::uint8_t> bytes) {
  ByteReader reader{bytes};
  reader.need({0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
  ByteReader header{readChunk(reader, "IHDR")};
  Png png;
  png.width = header.bigEndian();
  png.height = header.bigEndian();
  header.need({8, 2, 0, 0, 0});
  const std::vector<std::uint8_t> rows = readStoredStream({readChunk(reader, "IDAT")});
  readChunk(reader, "IEND");
  ByteReader row{rows};
  for (std::uint32_t i = 0; i < png.height; ++i) {
    row.need({0});
    const auto pixels = row.take(3 * std::size_t(png.width));
    png.pixels.insert(png.pixels.end(), pixels.begin(), pixels.end());
  }
  if (!row.rest.empty() || !reader.rest.empty()) throw std::runtime_error("bytes after the end");
  return png;
}

}  // namespace haarlight::test
