#include "image/frame_files.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/crc32.h"
#include "base/file.h"
#include "image/open_exr_stream.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;
using Bytes = std::span<const std::uint8_t>;

/// Takes `count` bytes off the front; nothing when there are fewer.
std::optional<Bytes> take(Bytes& rest, std::size_t count) {
  if (count > rest.size()) return std::nullopt;
  const Bytes taken = rest.first(count);
  rest = rest.subspan(count);
  return taken;
}

std::uint32_t bigEndian(Bytes bytes) {
  return std::uint32_t(bytes[0]) << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
}

/// A chunk of a PNG (PNG specification, section 5.3).
struct PngChunk {
  std::string_view type;
  Bytes content;
};

/// Takes the next chunk off; nothing when it is cut or its checksum is wrong.
std::optional<PngChunk> takeChunk(Bytes& rest) {
  const auto length = take(rest, 4);
  if (!length) return std::nullopt;
  const auto checked = take(rest, std::size_t(4) + bigEndian(*length));
  const auto checksum = take(rest, 4);
  if (!checked || !checksum || crc32(*checked) != bigEndian(*checksum)) return std::nullopt;
  return PngChunk{{reinterpret_cast<const char*>(checked->data()), 4}, checked->subspan(4)};
}

bool isPngHeader(const PngChunk& chunk, std::uint32_t width, std::uint32_t height) {
  return chunk.type == "IHDR" && chunk.content.size() == 13 && bigEndian(chunk.content) == width &&
         bigEndian(chunk.content.subspan(4)) == height;
}

bool isCompletePng(Bytes file, int width, int height) {
  constexpr std::uint8_t signature[]{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  const auto start = take(file, std::size(signature));
  if (!start || !std::ranges::equal(*start, signature)) return false;
  const auto header = takeChunk(file);
  if (!header || !isPngHeader(*header, std::uint32_t(width), std::uint32_t(height))) return false;
  bool hasPixels = false;
  while (const auto chunk = takeChunk(file)) {
    if (chunk->type == "IEND") return hasPixels && file.empty();
    hasPixels = hasPixels || chunk->type == "IDAT";
  }
  return false;
}

/// Decodes every scan line of a picture that starts at (0, 0); throws when one is missing or
/// damaged.
void decodeLines(Imf::InputFile& file) {
  const Imath::Box2i window = file.header().dataWindow();
  const Imf::ChannelList& channels = file.header().channels();
  Imf::FrameBuffer frame;
  std::vector<float> line(std::size_t(window.max.x) + 1);  // all lines of all channels go here
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
    frame.insert(channel.name(),
                 Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(line.data()), sizeof(float), 0,
                            channel.channel().xSampling, channel.channel().ySampling));
  file.setFrameBuffer(frame);
  for (int y = window.min.y; y <= window.max.y; ++y) file.readPixels(y);
}

bool isCompleteExr(Bytes bytes, int width, int height) {
  OpenExrInput stream(bytes);
  Imf::InputFile file(stream, 0);
  if (file.header().dataWindow() != Imath::Box2i({0, 0}, {width - 1, height - 1})) return false;
  decodeLines(file);
  return true;
}

}  // namespace

bool isCompleteFrame(const fs::path& path, int width, int height) {
  try {
    const std::vector<std::uint8_t> bytes = readWholeFile(path, "frame");
    if (path.extension() == ".png") return isCompletePng(bytes, width, height);
    return path.extension() == ".exr" && isCompleteExr(bytes, width, height);
  } catch (const std::exception&) {  // what cannot be read is not complete
    return false;
  }
}

}  // namespace haarlight
