#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace haarlight {

/// Folder for what can be computed again: $HAARLIGHT_CACHE_DIR, else $XDG_CACHE_HOME/haarlight,
/// else ~/.cache/haarlight; empty when none of them is set.
std::filesystem::path cacheFolder();

/// Reads a whole file. Throws InputError when it is missing, a folder, unreadable, or larger than
/// `maximumBytes`. `what` names it in the message ("mesh", "light", …).
std::vector<std::uint8_t> readWholeFile(const std::filesystem::path& path, const std::string& what,
                                        std::uint64_t maximumBytes = std::uint64_t(8) << 30);

/// Lets `write` fill a file beside `target` and renames it to `target` when `write` has returned
/// and everything has reached the disk; when anything fails, nothing of it stays and an earlier
/// `target` is untouched. A target that exists and is no plain file (such as /dev/full or
/// /dev/stdout) is written in place. Throws InputError when the folder or file cannot be written.
void writeFileAtomically(const std::filesystem::path& target,
                         const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for bytes already in memory.
void writeFileAtomically(const std::filesystem::path& target, std::span<const std::uint8_t> bytes);
void writeFileAtomically(const std::filesystem::path& target, const std::string& text);

/// FNV-1a over 64-bit words (a shorter last word is padded with zeros): notices a file that was cut
/// or changed by accident; it is no protection against intent.
std::uint64_t checksum(std::span<const std::uint8_t> bytes);

}  // namespace haarlight
