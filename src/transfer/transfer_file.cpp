#include "transfer/transfer_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

#include "base/crc32.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text_format.h"
#include "mesh/mesh_measures.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "HAARLPRT";
constexpr std::uint32_t formatVersion = 1;
constexpr std::size_t headerBytes = 64;
constexpr std::size_t checksumBytes = 4;

class LittleEndianWriter {
 public:
  std::vector<std::uint8_t> bytes;

  template <typename Unsigned>
  void number(Unsigned value) {
    for (std::size_t k = 0; k < sizeof value; ++k)
      bytes.push_back(static_cast<std::uint8_t>(value >> 8 * k));
  }
  void real(float value) { number(std::bit_cast<std::uint32_t>(value)); }
};

class LittleEndianReader {
 public:
  explicit LittleEndianReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <typename Unsigned>
  Unsigned number() {
    Unsigned value = 0;
    for (std::size_t k = 0; k < sizeof value; ++k)
      value |= static_cast<Unsigned>(Unsigned(rest_[k]) << 8 * k);
    rest_ = rest_.subspan(sizeof value);
    return value;
  }
  float real() { return std::bit_cast<float>(number<std::uint32_t>()); }

 private:
  std::span<const std::uint8_t> rest_;
};

/// A file's content while it is being checked.
struct TransferFile {
  fs::path path;
  std::vector<std::uint8_t> bytes;

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError("cannot read transfer " + path.string() + ": " + problem);
  }

  void require(bool condition, const std::string& problem) const {
    if (!condition) fail(problem);
  }
};

constexpr const char* again = "; compute it again with haarlight prt";

void checkKind(const TransferFile& file) {
  file.require(!file.bytes.empty(), "it is empty");
  const bool known =
      file.bytes.size() >= magic.size() + 4 &&
      std::equal(magic.begin(), magic.end(), file.bytes.begin(),
                 [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  file.require(known, "it is no transfer file: it does not begin with " + std::string(magic));
  const auto version =
      LittleEndianReader(std::span(file.bytes).subspan(magic.size())).number<std::uint32_t>();
  file.require(version == formatVersion,
               "it is of version " + std::to_string(version) + ", and this program knows version " +
                   std::to_string(formatVersion) + " only; compute it again with this haarlight");
}

/// The header but for magic and version; values are still missing.
DiffuseTransfer readHeader(const TransferFile& file) {
  LittleEndianReader reader(std::span(file.bytes).subspan(magic.size() + 4));
  const auto inRange = [&](const char* name, std::uint32_t least, std::uint32_t most) {
    const auto value = reader.number<std::uint32_t>();
    file.require(value >= least && value <= most,
                 std::string(name) + " is " + std::to_string(value) + ", not from " +
                     std::to_string(least) + " to " + std::to_string(most) + again);
    return value;
  };
  DiffuseTransfer transfer;
  transfer.kind = static_cast<TransferKind>(inRange("its kind", 0, 2));
  transfer.order = static_cast<int>(inRange("its order", 1, maximumTransferOrder));
  transfer.channels = static_cast<int>(inRange("its number of channels", 1, 3));
  file.require(transfer.channels != 2, std::string("its number of channels is 2") + again);
  transfer.bounces = static_cast<int>(inRange("its number of bounces", 0, maximumTransferBounces));
  transfer.raysPerVertex = static_cast<int>(inRange("its number of rays", 0, maximumTransferRays));
  transfer.vertices = inRange("its number of vertices", 0, ~0u);
  transfer.meshHash = reader.number<std::uint64_t>();
  transfer.seed = reader.number<std::uint64_t>();
  for (int c = 0; c < 3; ++c) {
    transfer.albedo[c] = reader.real();
    file.require(transfer.albedo[c] >= 0 && transfer.albedo[c] <= 1,
                 std::string("its albedo does not lie between 0 and 1") + again);
  }
  const bool shadowed = transfer.kind != TransferKind::unshadowed;
  const bool interreflected = transfer.kind == TransferKind::interreflected;
  file.require(shadowed == (transfer.raysPerVertex > 0) && interreflected == (transfer.bounces > 0),
               std::string("its kind does not go with its rays and bounces") + again);
  return transfer;
}

void checkSize(const TransferFile& file, const DiffuseTransfer& transfer) {
  const std::uint64_t needed =
      headerBytes + checksumBytes + std::uint64_t(transfer.vertices) * transfer.rowLength() * 4;
  if (file.bytes.size() == needed) return;
  const std::string problem = file.bytes.size() < needed ? "it is cut off" : "it is too long";
  file.fail(problem + ": it holds " + countText(file.bytes.size(), "byte") + ", and order " +
            std::to_string(transfer.order) + " for " + countText(transfer.vertices) +
            " vertices takes " + countText(needed) + again);
}

void checkSum(const TransferFile& file) {
  const auto content = std::span(file.bytes).first(file.bytes.size() - checksumBytes);
  const auto stored =
      LittleEndianReader(std::span(file.bytes).last(checksumBytes)).number<std::uint32_t>();
  file.require(crc32(content) == stored,
               std::string("it has been changed: its checksum does not fit") + again);
}

}  // namespace

void writeTransfer(const fs::path& path, const DiffuseTransfer& transfer) {
  LittleEndianWriter out;
  out.bytes.reserve(headerBytes + checksumBytes + 4 * transfer.values.size());
  out.bytes.assign(magic.begin(), magic.end());
  out.number(formatVersion);
  for (const int value : {static_cast<int>(transfer.kind), transfer.order, transfer.channels,
                          transfer.bounces, transfer.raysPerVertex})
    out.number(static_cast<std::uint32_t>(value));
  out.number(static_cast<std::uint32_t>(transfer.vertices));
  out.number(transfer.meshHash);
  out.number(transfer.seed);
  for (int c = 0; c < 3; ++c) out.real(transfer.albedo[c]);
  for (const float value : transfer.values) out.real(value);
  out.number(crc32(out.bytes));
  writeFileAtomically(path, std::span<const std::uint8_t>(out.bytes));
}

DiffuseTransfer readTransfer(const fs::path& path) {
  const TransferFile file{path, readWholeFile(path, "transfer")};
  checkKind(file);
  file.require(file.bytes.size() >= headerBytes + checksumBytes,
               std::string("it is cut off in its header") + again);
  DiffuseTransfer transfer = readHeader(file);
  checkSize(file, transfer);
  checkSum(file);
  transfer.values.resize(transfer.vertices * transfer.rowLength());
  LittleEndianReader reader(std::span(file.bytes).subspan(headerBytes));
  for (float& value : transfer.values) value = reader.real();
  file.require(std::ranges::all_of(transfer.values, [](float v) { return std::isfinite(v); }),
               std::string("it holds a value that is no number") + again);
  return transfer;
}

void requireTransferOf(const DiffuseTransfer& transfer, const fs::path& path,
                       const TriangleMesh& mesh, const std::string& meshName) {
  if (transfer.vertices == mesh.positions.size() && transfer.meshHash == meshHash(mesh)) return;
  throw InputError("transfer " + path.string() + " was computed for another mesh than " + meshName +
                   "; compute it with haarlight prt " + meshName);
}

}  // namespace haarlight
