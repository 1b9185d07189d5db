#include "transfer/diffuse_transfer.h"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/stopwatch.h"
#include "mesh/mesh_measures.h"
#include "sh/basis.h"

namespace haarlight {

namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(what);
}

void checkOptions(const TransferOptions& options) {
  require(options.order >= 1 && options.order <= maximumTransferOrder,
          "the order of a transfer is out of range");
  require(options.kind == TransferKind::unshadowed ||
              (options.raysPerVertex >= 1 && options.raysPerVertex <= maximumTransferRays),
          "the number of rays of a transfer is out of range");
  require(options.kind != TransferKind::interreflected ||
              (options.bounces >= 1 && options.bounces <= maximumTransferBounces),
          "the number of bounces of a transfer is out of range");
  for (int c = 0; c < 3; ++c)
    require(options.albedo[c] >= 0 && options.albedo[c] <= 1, "an albedo lies between 0 and 1");
}

/// By vertex, a third of the area of its triangles.
std::vector<double> vertexAreas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.positions.size());
  for (const glm::uvec3& t : mesh.triangles) {
    const double area = triangleArea(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    for (int corner = 0; corner < 3; ++corner) areas[t[corner]] += area / 3;
  }
  return areas;
}

/// Adds bounce after bounce to a transfer.
class Summation {
 public:
  Summation(const TriangleMesh& mesh, const TransferOptions& options, TransferResult& result)
      : areas_(vertexAreas(mesh)), albedo_(options.albedo), factor_(albedo_), result_(result) {
    DiffuseTransfer& transfer = result.transfer;
    const bool interreflected = options.kind == TransferKind::interreflected;
    const bool grey = albedo_.x == albedo_.y && albedo_.y == albedo_.z;
    transfer = {
        .kind = options.kind,
        .order = options.order,
        .bounces = interreflected ? options.bounces : 0,
        .raysPerVertex = options.kind == TransferKind::unshadowed ? 0 : options.raysPerVertex,
        .seed = options.seed,
        .albedo = options.albedo,
        .meshHash = meshHash(mesh),
        .vertices = mesh.positions.size(),
        .channels = grey ? 1 : 3,
        .values = {}};
    transfer.values.resize(transfer.vertices * transfer.rowLength());
  }

  /// `bounce`: G_b for the next b.
  void add(std::span<const float> bounce) {
    const auto channels = static_cast<std::size_t>(result_.transfer.channels);
    for (std::size_t i = 0; i < bounce.size(); ++i)
      for (std::size_t c = 0; c < channels; ++c)
        result_.transfer.values[i * channels + c] +=
            static_cast<float>(factor_[static_cast<int>(c)] * bounce[i]);
    result_.energyByBounce.push_back(glm::vec3(factor_ * meanUnderUniformLight(bounce)));
    factor_ *= albedo_;
  }

 private:
  /// Light of radiance 1 has the single coefficient √4π.
  double meanUnderUniformLight(std::span<const float> bounce) const {
    const auto row = static_cast<std::size_t>(result_.transfer.coefficients());
    double sum = 0;
    for (std::size_t v = 0; v < areas_.size(); ++v) sum += areas_[v] * bounce[v * row];
    const double area = std::accumulate(areas_.begin(), areas_.end(), 0.0);
    return area > 0 ? std::sqrt(4 * std::numbers::pi) * sum / area : 0;
  }

  std::vector<double> areas_;
  glm::dvec3 albedo_, factor_;
  TransferResult& result_;
};

}  // namespace

std::string transferKindName(TransferKind kind) {
  constexpr std::array names{"unshadowed", "shadowed", "interreflected"};
  return names[static_cast<std::size_t>(kind)];
}

TransferResult computeTransfer(const TriangleMesh& mesh, const TransferOptions& options,
                               const TransferMonitor& monitor) {
  checkOptions(options);
  require(mesh.normals.size() == mesh.positions.size(), "transfer needs a normal for every vertex");
  TransferResult result;
  Summation sum(mesh, options, result);
  Stopwatch watch;
  if (options.kind == TransferKind::unshadowed) {
    sum.add(unshadowedTransfer(mesh.normals, options.order));
    return result;
  }
  const int bounces = result.transfer.bounces;
  const LightTransport transport(mesh, options.order, options.raysPerVertex, options.seed,
                                 bounces > 0, monitor);
  sum.add(transport.direct());
  result.blockedPart = transport.blockedPart();
  result.raySeconds = watch.lap();
  std::vector<float> bounced = transport.direct();
  for (int bounce = 1; bounce <= bounces; ++bounce) {
    bounced = transport.reflected(bounced, static_cast<std::size_t>(result.transfer.coefficients()),
                                  "bounce " + std::to_string(bounce));
    sum.add(bounced);
  }
  result.bounceSeconds = watch.lap();
  return result;
}

}  // namespace haarlight
