#pragma once

#include <filesystem>

namespace haarlight {

/// Whether a file is a whole picture of this size that was written to the end. By the name's end:
/// ".png": all chunks up to IEND have their length and checksum, and nothing follows; ".exr": it
/// has this data window and all scan lines of all channels can be decoded. Every other file, and
/// one that is missing, unreadable or damaged, is none.
bool isCompleteFrame(const std::filesystem::path& path, int width, int height);

}  // namespace haarlight
