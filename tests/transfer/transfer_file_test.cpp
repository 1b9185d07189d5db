#include "transfer/transfer_file.h"

#include <doctest/doctest.h>

#include <bit>
#include <cstring>
#include <limits>

#include "base/crc32.h"
#include "error_text.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

template <typename Value>
std::string bytesOf(Value value) {
  static_assert(std::endian::native == std::endian::little);
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// With the checksum of what comes before it.
std::string sealed(std::string bytes) {
  return bytes +
         bytesOf(crc32({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
}

/// The fields of the documented header, by hand.
struct Header {
  std::string magic = "HAARLPRT";
  std::uint32_t version = 1, kind = 2, order = 2, channels = 3, bounces = 2, rays = 64,
                vertices = 2;
  std::uint64_t hash = 0x0123456789abcdef, seed = 77;
  float albedo[3]{0.25f, 0.5f, 1};

  std::string bytes() const {
    std::string text = magic;
    for (const std::uint32_t value : {version, kind, order, channels, bounces, rays, vertices})
      text += bytesOf(value);
    text += bytesOf(hash) + bytesOf(seed);
    for (const float value : albedo) text += bytesOf(value);
    return text;
  }
};

std::string exampleValues() {
  std::string text;
  for (int i = 0; i < 24; ++i) text += bytesOf(0.1f * float(i) - 1);
  return text;
}

DiffuseTransfer example() {
  DiffuseTransfer transfer{.kind = TransferKind::interreflected,
                           .order = 2,
                           .bounces = 2,
                           .raysPerVertex = 64,
                           .seed = 77,
                           .albedo = {0.25f, 0.5f, 1},
                           .meshHash = 0x0123456789abcdef,
                           .vertices = 2,
                           .channels = 3,
                           .values = {}};
  for (int i = 0; i < 24; ++i) transfer.values.push_back(0.1f * float(i) - 1);
  return transfer;
}

/// Checks that a file with these bytes is refused in one line with its name and `problem`.
void checkBytesRefused(const std::string& bytes, const std::string& problem) {
  const TemporaryFolder folder;
  writeFile(folder / "bad.prt", bytes);
  const std::string error = inputErrorOf([&] { readTransfer(folder / "bad.prt"); });
  CAPTURE(error);
  CAPTURE(problem);
  CHECK(error.starts_with("cannot read transfer " + (folder / "bad.prt").string() + ": "));
  CHECK(contains(error, problem));
  CHECK_FALSE(contains(error, "\n"));
}

}  // namespace

TEST_CASE("a transfer file has the documented bytes and comes back bit by bit") {
  const TemporaryFolder folder;
  const auto path = folder / "example.prt";
  writeTransfer(path, example());
  CHECK(Header().bytes().size() == 64);
  CHECK(readFile(path) == sealed(Header().bytes() + exampleValues()));
  const DiffuseTransfer read = readTransfer(path), written = example();
  CHECK(read.kind == written.kind);
  CHECK(read.order == written.order);
  CHECK(read.bounces == written.bounces);
  CHECK(read.raysPerVertex == written.raysPerVertex);
  CHECK(read.seed == written.seed);
  CHECK(read.albedo == written.albedo);
  CHECK(read.meshHash == written.meshHash);
  CHECK(read.vertices == written.vertices);
  CHECK(read.channels == written.channels);
  REQUIRE(read.values.size() == written.values.size());
  CHECK(std::memcmp(read.values.data(), written.values.data(), 4 * read.values.size()) == 0);
  CHECK(read.row(1)[0] == 0.1f * 12 - 1);
}

TEST_CASE("what is no transfer file, or of a newer version, is refused") {
  checkBytesRefused("", "it is empty");
  checkBytesRefused("HAARL", "does not begin with HAARLPRT");
  checkBytesRefused(std::string(200, 'x'), "does not begin with HAARLPRT");
  Header header;
  header.magic = "HAARLPRS";
  checkBytesRefused(sealed(header.bytes() + exampleValues()), "does not begin with HAARLPRT");
  for (const std::uint32_t version : {0u, 2u, 0xffffffffu}) {
    header = Header();
    header.version = version;
    checkBytesRefused(sealed(header.bytes() + exampleValues()),
                      "it is of version " + std::to_string(version));
  }
}

TEST_CASE("every cut, every changed byte and every added one is noticed") {
  const std::string whole = sealed(Header().bytes() + exampleValues());
  for (std::size_t size = 12; size < whole.size(); ++size)
    checkBytesRefused(whole.substr(0, size), "it is cut off");
  checkBytesRefused(whole + '\0', "it is too long");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    checkBytesRefused(changed, at < 64 ? "" : "its checksum does not fit");
  }
}

TEST_CASE("a header that no transfer has is refused though its checksum fits") {
  const auto refused = [](const auto& change, const std::string& problem) {
    Header header;
    change(header);
    checkBytesRefused(sealed(header.bytes() + exampleValues()), problem);
  };
  refused([](Header& h) { h.kind = 3; }, "its kind is 3, not from 0 to 2");
  refused([](Header& h) { h.order = 0; }, "its order is 0");
  refused([](Header& h) { h.order = 21; }, "its order is 21");
  refused([](Header& h) { h.order = 3; }, "cut off");
  refused([](Header& h) { h.channels = 2; }, "channels is 2");
  refused([](Header& h) { h.channels = 1; }, "too long");
  refused([](Header& h) { h.bounces = 65; }, "bounces is 65");
  refused([](Header& h) { h.bounces = 0; }, "does not go with");
  refused([](Header& h) { h.kind = 1; }, "does not go with");
  refused([](Header& h) { h.rays = 0; }, "does not go with");
  refused([](Header& h) { h.rays = 65537; }, "rays is 65537");
  refused([](Header& h) { h.vertices = 0xffffffff; }, "cut off");
  refused([](Header& h) { h.albedo[1] = std::numeric_limits<float>::quiet_NaN(); }, "albedo");
  refused([](Header& h) { h.albedo[2] = 1.5f; }, "albedo");
  std::string values = exampleValues();
  values.replace(40, 4, bytesOf(std::numeric_limits<float>::infinity()));
  checkBytesRefused(sealed(Header().bytes() + values), "no number");
}

TEST_CASE("missing files and folders are refused, and nothing is left where none can be written") {
  const TemporaryFolder folder;
  CHECK(contains(inputErrorOf([&] { readTransfer(folder / "none.prt"); }), "none.prt"));
  CHECK(contains(inputErrorOf([&] { readTransfer(folder.path()); }), "it is a folder"));
  CHECK(contains(inputErrorOf([&] { writeTransfer(folder / "no/x.prt", example()); }), "x.prt"));
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a transfer belongs to the mesh that it was computed for") {
  const TriangleMesh sphere = icosphere(1);
  const DiffuseTransfer transfer =
      computeTransfer(sphere, {.kind = TransferKind::unshadowed, .order = 2}).transfer;
  requireTransferOf(transfer, "a.prt", sphere, "sphere.obj");
  TriangleMesh moved = sphere, larger = icosphere(2);
  moved.positions[3].x += 1e-3f;
  for (const TriangleMesh* other : {&moved, &larger})
    CHECK(inputErrorOf([&] { requireTransferOf(transfer, "a.prt", *other, "other.obj"); }) ==
          "transfer a.prt was computed for another mesh than other.obj; compute it with "
          "haarlight prt other.obj");
}
