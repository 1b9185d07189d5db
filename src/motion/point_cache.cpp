#include "motion/point_cache.h"

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/error.h"
#include "motion/file_stamp.h"
#include "motion/file_vertices.h"
#include "motion/sampled_motion.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;

/// So many samples and points of any mesh do not overflow 64 bits when they become bytes.
constexpr std::int64_t largestSampleCount = 1 << 24;
constexpr std::uint64_t bytesPerPoint = 3 * sizeof(float);

[[noreturn]] void pointCacheError(const fs::path& path, const std::string& problem) {
  throw InputError("cannot read point cache " + path.string() + ": " + problem);
}

/// Numbers of four bytes each.
struct Words {
  std::vector<std::uint8_t> bytes;
  std::endian order;

  std::uint32_t word(std::size_t i) const {
    std::uint32_t result = 0;
    for (std::size_t k = 0; k < 4; ++k)
      result |= std::uint32_t(bytes[4 * i + k]) << 8 * (order == std::endian::big ? 3 - k : k);
    return result;
  }
  std::int32_t integer(std::size_t i) const { return std::int32_t(word(i)); }
  float number(std::size_t i) const { return std::bit_cast<float>(word(i)); }
};

/// A file that must stay as it is while it is read piece by piece.
class PointCacheFile {
 public:
  PointCacheFile(const fs::path& path, std::endian order)
      : path_(path), order_(order), stamp_(fileStamp(path, "point cache")) {
    stream_.open(path, std::ios::binary);
    if (!stream_) pointCacheError(path, std::strerror(errno));
  }

  const fs::path& path() const { return path_; }
  std::uint64_t size() const { return stamp_.bytes; }

  Words read(std::uint64_t offset, std::uint64_t count) {
    if (offset + count > size())
      pointCacheError(path_, "it is cut off: it holds " + std::to_string(size()) +
                                 " bytes, and its header alone takes " +
                                 std::to_string(offset + count));
    Words words{std::vector<std::uint8_t>(count), order_};
    stream_.clear();
    stream_.seekg(std::streamoff(offset));
    stream_.read(reinterpret_cast<char*>(words.bytes.data()), std::streamsize(count));
    requireUnchanged(path_, "point cache", stamp_);
    if (!stream_) pointCacheError(path_, "reading it failed");
    return words;
  }

 private:
  fs::path path_;
  std::endian order_;
  FileStamp stamp_;
  std::ifstream stream_;
};

struct PointCacheLayout {
  std::uint64_t firstFrame;     ///< its offset in the file
  std::vector<double> seconds;  ///< of each frame, from 0
};

/// Throws unless the counts agree with the mesh and with the size of the file.
void checkCounts(const PointCacheFile& file, std::int64_t points, std::int64_t samples,
                 std::size_t vertices, std::uint64_t headerBytes,
                 std::uint64_t headerBytesPerSample) {
  const auto problem = [&](const std::string& text) { pointCacheError(file.path(), text); };
  if (points <= 0 || samples <= 0 || samples > largestSampleCount)
    problem("its header says " + std::to_string(samples) + " samples of " + std::to_string(points) +
            " points; there must be at least one of each, and at most " +
            std::to_string(largestSampleCount) + " samples");
  if (std::size_t(points) != vertices)
    problem("it holds " + std::to_string(points) + " points, but the mesh's file has " +
            std::to_string(vertices) + " vertices");
  const std::uint64_t needed =
      headerBytes +
      std::uint64_t(samples) * (headerBytesPerSample + std::uint64_t(points) * bytesPerPoint);
  if (file.size() != needed)
    problem("it holds " + std::to_string(file.size()) + " bytes, but " + std::to_string(samples) +
            " samples of " + std::to_string(points) + " points take " + std::to_string(needed));
}

PointCacheLayout readPc2Layout(PointCacheFile& file, std::size_t vertices, double framesPerSecond) {
  constexpr char magic[12] = "POINTCACHE2";
  constexpr std::uint64_t headerBytes = 32;
  const Words header = file.read(0, headerBytes);
  if (std::memcmp(header.bytes.data(), magic, sizeof magic) != 0)
    pointCacheError(file.path(), "it does not begin with POINTCACHE2");
  if (header.integer(3) != 1)
    pointCacheError(file.path(), "it is of version " + std::to_string(header.integer(3)) +
                                     "; only version 1 is known");
  const std::int32_t points = header.integer(4), samples = header.integer(7);
  const double start = header.number(5), rate = header.number(6);
  if (!std::isfinite(start)) pointCacheError(file.path(), "its start frame is not a number");
  if (!std::isfinite(rate) || rate <= 0)
    pointCacheError(file.path(), "its sample rate, in frames, must be a number above 0");
  checkCounts(file, points, samples, vertices, headerBytes, 0);
  return {headerBytes, evenSeconds(std::size_t(samples), rate, framesPerSecond)};
}

PointCacheLayout readMddLayout(PointCacheFile& file, std::size_t vertices) {
  constexpr std::uint64_t headerBytes = 8;
  const Words header = file.read(0, headerBytes);
  const std::int32_t samples = header.integer(0), points = header.integer(1);
  checkCounts(file, points, samples, vertices, headerBytes, sizeof(float));
  const std::uint64_t timeBytes = std::uint64_t(samples) * sizeof(float);
  const Words times = file.read(headerBytes, timeBytes);
  PointCacheLayout layout{headerBytes + timeBytes, std::vector<double>(std::size_t(samples))};
  for (std::size_t i = 0; i < layout.seconds.size(); ++i) {
    const bool increases = i == 0 || times.number(i) > times.number(i - 1);
    if (!std::isfinite(times.number(i)) || !increases)
      pointCacheError(file.path(), "the second of frame " + std::to_string(i) +
                                       " (from 0) is not a number above that of the frame before");
    layout.seconds[i] = double(times.number(i)) - double(times.number(0));
  }
  return layout;
}

class PointCache final : public SampledMotion {
 public:
  PointCache(PointCacheFile file, PointCacheLayout layout, const LoadedMesh& mesh)
      : SampledMotion(mesh.sourceVertices.size(), std::move(layout.seconds)),
        file_(std::move(file)),
        firstFrame_(layout.firstFrame),
        points_(fileVertexCount(mesh)),
        sourceVertices_(mesh.sourceVertices) {}

 protected:
  std::vector<glm::vec3> readFrame(std::size_t frame) override {
    const std::uint64_t frameBytes = points_ * bytesPerPoint;
    const Words words = file_.read(firstFrame_ + frame * frameBytes, frameBytes);
    std::vector<glm::vec3> points(points_);
    for (std::size_t i = 0; i < 3 * points_; ++i) {
      const float coordinate = words.number(i);
      if (!(std::abs(coordinate) <= largestCoordinate))
        pointCacheError(file_.path(), "vertex " + std::to_string(i / 3) + " of frame " +
                                          std::to_string(frame) +
                                          " (both from 0) is not a number or lies beyond 1e9");
      points[i / 3][int(i % 3)] = coordinate;
    }
    return inMeshOrder(points, sourceVertices_);
  }

 private:
  PointCacheFile file_;
  std::uint64_t firstFrame_;
  std::size_t points_;
  std::vector<std::uint32_t> sourceVertices_;
};

}  // namespace

std::unique_ptr<VertexMotion> openPointCache(const fs::path& path, const LoadedMesh& mesh,
                                             double framesPerSecond) {
  const std::string extension = path.extension().string();
  const bool isPc2 = extension == ".pc2" || extension == ".PC2";
  if (!isPc2 && extension != ".mdd" && extension != ".MDD")
    pointCacheError(path, "its extension is none of .mdd, .pc2");
  PointCacheFile file(path, isPc2 ? std::endian::little : std::endian::big);
  const std::size_t vertices = fileVertexCount(mesh);
  PointCacheLayout layout =
      isPc2 ? readPc2Layout(file, vertices, framesPerSecond) : readMddLayout(file, vertices);
  return std::make_unique<PointCache>(std::move(file), std::move(layout), mesh);
}

}  // namespace haarlight
