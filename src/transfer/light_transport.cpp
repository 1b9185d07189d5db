#include "transfer/light_transport.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "sh/zonal.h"

namespace haarlight {

namespace {

constexpr std::size_t rangeLength = 64;  ///< vertices that a thread takes at a time

void writeUnshadowed(std::span<const double> zonal, const glm::vec3& normal, std::span<float> row) {
  const ShVector<double> lobe = rotateZonal(zonal, glm::dvec3(normal));
  for (std::size_t i = 0; i < row.size(); ++i)
    row[i] = static_cast<float>(lobe[static_cast<int>(i)] / std::numbers::pi);
}

}  // namespace

std::vector<float> unshadowedTransfer(std::span<const glm::vec3> normals, int order) {
  const std::vector<double> zonal = clampedCosineZonal(order);
  const auto row = static_cast<std::size_t>(shCoefficientCount(order));
  std::vector<float> result(normals.size() * row);
  parallelFor(normals.size(), rangeLength, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      writeUnshadowed(zonal, normals[v], std::span(result).subspan(v * row, row));
  });
  return result;
}

/// Ranges of vertices on all threads, watched.
class LightTransport::Stage {
 public:
  Stage(const TransferMonitor& monitor, std::string task, std::size_t vertices)
      : monitor_(monitor), task_(std::move(task)), vertices_(vertices) {}

  template <typename Body>
  void run(const Body& body) {
    parallelFor(vertices_, rangeLength, [&](std::size_t begin, std::size_t end) {
      if (monitor_.cancelled && monitor_.cancelled()) throw TransferCancelled();
      body(begin, end);
      const std::size_t finished = finished_ += end - begin;
      if (monitor_.progress)
        monitor_.progress(task_, static_cast<double>(finished) / static_cast<double>(vertices_));
    });
  }

 private:
  const TransferMonitor& monitor_;
  std::string task_;
  std::size_t vertices_;
  std::atomic<std::size_t> finished_ = 0;
};

LightTransport::LightTransport(const TriangleMesh& mesh, int order, int raysPerVertex,
                               std::uint64_t seed, bool keepReflectors,
                               const TransferMonitor& monitor, std::optional<std::size_t> vertices)
    : mesh_(mesh),
      order_(order),
      raysPerVertex_(raysPerVertex),
      keepReflectors_(keepReflectors),
      monitor_(monitor),
      vertices_(vertices.value_or(mesh.positions.size())),
      reflectors_((vertices_ + rangeLength - 1) / rangeLength),
      reflectorCounts_(vertices_),
      blockedCounts_(vertices_) {
  if (vertices_ > mesh.positions.size() || (keepReflectors && vertices_ < mesh.positions.size()))
    throw std::invalid_argument("the number of vertices of a transfer is out of range");
  const VertexRays rays(mesh, raysPerVertex, seed);
  direct_ = unshadowedTransfer(std::span(mesh.normals).first(vertices_), order);
  Stage(monitor_, "casting rays", vertices_).run([&](std::size_t begin, std::size_t end) {
    castRange(rays, begin, end);
  });
}

void LightTransport::castRange(const VertexRays& rays, std::size_t begin, std::size_t end) {
  const auto row = static_cast<std::size_t>(shCoefficientCount(order_));
  std::vector<SurfacePlace> reflectors;
  VertexView view;
  for (std::size_t v = begin; v < end; ++v) {
    rays.cast(static_cast<std::uint32_t>(v), view);
    sumDirect(view, std::span(direct_).subspan(v * row, row));
    blockedCounts_[v] = static_cast<std::uint32_t>(view.blockedCount);
    if (!keepReflectors_) continue;
    reflectorCounts_[v] = static_cast<std::uint32_t>(view.reflectors.size());
    reflectors.insert(reflectors.end(), view.reflectors.begin(), view.reflectors.end());
  }
  reflectors_[begin / rangeLength] = {reflectors.begin(), reflectors.end()};  // without spare room
}

void LightTransport::sumDirect(const VertexView& view, std::span<float> row) const {
  const std::size_t count = view.blocked.size();
  const bool takeBlocked = 2 * view.blockedCount <= count;
  std::vector<double> sum(row.size());
  std::vector<float> basis(row.size());
  for (std::size_t ray = 0; ray < count; ++ray) {
    if (static_cast<bool>(view.blocked[ray]) != takeBlocked) continue;
    evaluateShBasis<float>(order_, view.directions[ray], basis);
    for (std::size_t i = 0; i < row.size(); ++i) sum[i] += basis[i];
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double mean = sum[i] / static_cast<double>(count);
    row[i] = static_cast<float>(takeBlocked ? row[i] - mean : mean);
  }
}

std::vector<float> LightTransport::reflected(std::span<const float> radiance, std::size_t rowLength,
                                             const std::string& task) const {
  const std::size_t vertices = mesh_.positions.size();
  if (!keepReflectors_ || radiance.size() != vertices * rowLength)
    throw std::invalid_argument("reflection needs the reflectors and a row for every vertex");
  std::vector<float> result(radiance.size());
  Stage(monitor_, task, vertices).run([&](std::size_t begin, std::size_t end) {
    reflectRange(radiance, rowLength, begin, end, result);
  });
  return result;
}

void LightTransport::reflectRange(std::span<const float> radiance, std::size_t rowLength,
                                  std::size_t begin, std::size_t end,
                                  std::vector<float>& result) const {
  const SurfacePlace* place = reflectors_[begin / rangeLength].data();
  std::vector<double> sum(rowLength);
  for (std::size_t v = begin; v < end; ++v) {
    std::ranges::fill(sum, 0.0);
    for (std::uint32_t k = 0; k < reflectorCounts_[v]; ++k, ++place) {
      const glm::uvec3& t = mesh_.triangles[place->triangle];
      const glm::vec3 w = place->weights();
      const float *a = &radiance[t.x * rowLength], *b = &radiance[t.y * rowLength],
                  *c = &radiance[t.z * rowLength];
      for (std::size_t i = 0; i < rowLength; ++i) sum[i] += w.x * a[i] + w.y * b[i] + w.z * c[i];
    }
    for (std::size_t i = 0; i < rowLength; ++i)
      result[v * rowLength + i] = static_cast<float>(sum[i] / raysPerVertex_);
  }
}

double LightTransport::blockedPart() const {
  const auto blocked =
      std::accumulate(blockedCounts_.begin(), blockedCounts_.end(), std::uint64_t(0));
  return static_cast<double>(blocked) /
         (static_cast<double>(raysPerVertex_) * static_cast<double>(blockedCounts_.size()));
}

}  // namespace haarlight
