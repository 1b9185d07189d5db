#pragma once

/// What the readers of the image formats share; include image/read_image.h to read a file.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "image/read_image.h"

namespace haarlight {

/// Decoders for a file's bytes; `path` serves the messages.
ImageFile decodeRadianceHdr(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);
ImageFile decodeOpenExr(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

/// Throws InputError("cannot read image …: reason").
[[noreturn]] void cannotReadImage(const std::filesystem::path& path, const std::string& reason);

/// Throws InputError unless a header's image size is positive, within readImage's limits and no
/// more than any compression could hold in a file of `fileBytes` bytes.
void checkImageSize(std::int64_t width, std::int64_t height, std::size_t fileBytes,
                    const std::filesystem::path& path);

}  // namespace haarlight
