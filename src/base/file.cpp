#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "base/error.h"

namespace haarlight {

namespace fs = std::filesystem;

namespace {

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string systemMessage() {
  return std::strerror(errno);
}

[[noreturn]] void cannotWrite(const fs::path& target, const std::string& reason) {
  throw InputError("cannot write " + target.string() + ": " + reason);
}

/// A plain write through stdio leaves errors to fclose; this reports every one of them.
void writeBytes(const fs::path& path, const fs::path& target, std::span<const std::uint8_t> bytes) {
  FileHandle file(std::fopen(path.c_str(), "wb"), std::fclose);
  if (!file) cannotWrite(target, systemMessage());
  const bool written =
      bytes.empty() ||  // fwrite takes no null pointer, even to write nothing from it
      std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  if (!written || std::fflush(file.get()) != 0) cannotWrite(target, systemMessage());
}

/// Some file systems report a full disk only when the data is flushed.
void flushToDisk(const fs::path& path, const fs::path& target) {
  const int descriptor = open(path.c_str(), O_WRONLY);
  if (descriptor < 0) cannotWrite(target, systemMessage());
  const int status = fsync(descriptor);
  const std::string message = systemMessage();
  close(descriptor);
  if (status != 0) cannotWrite(target, message);
}

/// Hidden, with the target's extension (image writers look at it) and this process's number.
fs::path temporaryBeside(const fs::path& target) {
  std::string name = ".";
  name += target.stem().string();
  name += '.';
  name += std::to_string(getpid());
  name += target.extension().string();
  return target.parent_path() / name;
}

}  // namespace

fs::path cacheFolder() {
  if (const char* own = std::getenv("HAARLIGHT_CACHE_DIR"); own && *own) return own;
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg)
    return fs::path(xdg) / "haarlight";
  if (const char* home = std::getenv("HOME"); home && *home)
    return fs::path(home) / ".cache" / "haarlight";
  return {};
}

std::vector<std::uint8_t> readWholeFile(const fs::path& path, const std::string& what,
                                        std::uint64_t maximumBytes) {
  std::error_code error;
  if (fs::is_directory(path, error))
    throw InputError("cannot read " + what + " " + path.string() + ": it is a folder");
  if (fs::is_character_file(path, error) || fs::is_block_file(path, error))
    throw InputError("cannot read " + what + " " + path.string() + ": it is a device");
  FileHandle file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw InputError("cannot read " + what + " " + path.string() + ": " + systemMessage());
  std::vector<std::uint8_t> bytes;
  std::uint8_t block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
    if (bytes.size() + count > maximumBytes)
      throw InputError("cannot read " + what + " " + path.string() + ": it is larger than " +
                       std::to_string(maximumBytes) + " bytes");
    bytes.insert(bytes.end(), block, block + count);
  }
  if (std::ferror(file.get()))
    throw InputError("cannot read " + what + " " + path.string() + ": " + systemMessage());
  return bytes;
}

void writeFileAtomically(const fs::path& target,
                         const std::function<void(const fs::path&)>& write) {
  struct stat status {};
  if (stat(target.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) cannotWrite(target, "it is a folder");
    if (!S_ISREG(status.st_mode)) return write(target);
    if (access(target.c_str(), W_OK) != 0) cannotWrite(target, systemMessage());
  }
  const fs::path temporary = temporaryBeside(target);
  try {
    writeBytes(temporary, target, {});
    write(temporary);
    flushToDisk(temporary, target);
    std::error_code error;
    fs::rename(temporary, target, error);
    if (error) cannotWrite(target, error.message());
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

void writeFileAtomically(const fs::path& target, std::span<const std::uint8_t> bytes) {
  writeFileAtomically(target, [&](const fs::path& path) { writeBytes(path, target, bytes); });
}

void writeFileAtomically(const fs::path& target, const std::string& text) {
  writeFileAtomically(target,
                      std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::uint64_t checksum(std::span<const std::uint8_t> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
    hash = (hash ^ word) * 0x100000001b3;
  }
  return hash;
}

}  // namespace haarlight
