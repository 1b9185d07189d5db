#include "render/scene_transfer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "mesh/mesh_measures.h"
#include "mesh/mesh_transform.h"
#include "render/receiver_grid.h"
#include "sh/rotation.h"
#include "transfer/transfer_file.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;

constexpr int raysPerVertex = 1024;

struct StoredTransfer {
  fs::path path;
  DiffuseTransfer transfer;
};

void append(TriangleMesh& mesh, const TriangleMesh& part, bool blocks) {
  const auto first = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
  if (!blocks) return;
  for (const glm::uvec3& triangle : part.triangles) mesh.triangles.push_back(triangle + first);
}

/// The rotation of a matrix that moves, turns and scales evenly. Throws InputError for another one.
glm::dmat3 rotationOf(const glm::dmat3& matrix, const std::string& complaint) {
  const double scale = std::cbrt(glm::determinant(matrix));
  const glm::dmat3 rotation = matrix / scale, rest = glm::transpose(rotation) * rotation;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (!(std::abs(rest[column][row] - (row == column)) < 1e-4)) throw InputError(complaint);
  return rotation;
}

void requireMeshes(const Scene& scene) {
  for (const SceneObject& object : scene.objects)
    if (object.solid)
      throw InputError("object '" + object.name +
                       "' is a solid, and transfer is for the vertices of meshes: use --method "
                       "haar or shexp, or a mesh");
}

/// Fills the rows of a scene.
class Assembly {
 public:
  Assembly(const SceneDescription& description, const MovingScene& moving)
      : description_(description), moving_(moving), scene_(moving.scene()) {
    ofObjects_.resize(scene_.objects.size() + 1);
  }

  void readFiles(std::span<const fs::path> files);
  SceneTransfer assemble(std::optional<int> order, const Progress& progress);

 private:
  using Stored = std::shared_ptr<const StoredTransfer>;

  static Stored read(const fs::path& path) {
    return std::make_shared<const StoredTransfer>(path, readTransfer(path));
  }
  void placeWhereItFits(const Stored& stored);
  int orderOf(std::optional<int> wanted) const;
  std::size_t vertexCount(std::size_t object) const;
  void layOut(int order);
  ShRotation rotationToWorld(std::size_t object) const;
  void copyStored(std::size_t object);
  void compute(const Progress& progress);
  void write(std::uint32_t row, const ShVector<glm::vec3>& transfer);

  const SceneDescription& description_;
  const MovingScene& moving_;
  const Scene& scene_;
  std::vector<Stored> ofObjects_;  ///< by object, and the receiver's; null: computed
  bool ofWholeScene_ = false;      ///< one file serves all
  SceneTransfer result_;
};

void Assembly::placeWhereItFits(const Stored& stored) {
  bool fits = false;
  for (std::size_t i = 0; i < scene_.objects.size(); ++i)
    if (stored->transfer.meshHash == meshHash(moving_.objects()[i].loadedMesh())) {
      ofObjects_[i] = stored;
      fits = true;
    }
  if (!fits && stored->transfer.meshHash == meshHash(wholeSceneMesh(scene_))) {
    ofObjects_.assign(ofObjects_.size(), stored);
    fits = ofWholeScene_ = true;
  }
  if (!fits)
    throw InputError("transfer " + stored->path.string() +
                     " was computed for no mesh of this scene; compute it with haarlight prt");
}

void Assembly::readFiles(std::span<const fs::path> files) {
  for (const fs::path& path : files) placeWhereItFits(read(path));
  for (std::size_t i = 0; i < scene_.objects.size() && !ofWholeScene_; ++i) {
    const ObjectDescription& object = description_.objects[i];
    if (!object.transfer) continue;
    ofObjects_[i] = read(*object.transfer);
    requireTransferOf(ofObjects_[i]->transfer, *object.transfer, moving_.objects()[i].loadedMesh(),
                      object.mesh);
  }
}

int Assembly::orderOf(std::optional<int> wanted) const {
  if (wanted) return *wanted;
  int largest = 0;
  for (const Stored& stored : ofObjects_)
    if (stored) largest = std::max(largest, stored->transfer.order);
  return largest > 0 ? largest : defaultTransferOrder;
}

std::size_t Assembly::vertexCount(std::size_t object) const {
  if (object < scene_.objects.size()) return scene_.objects[object].mesh.positions.size();
  return scene_.receiver ? ReceiverGrid(*scene_.receiver).vertexCount() : 0;
}

void Assembly::layOut(int order) {
  result_.rows.order = order;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < ofObjects_.size(); ++i) {
    result_.firstRows.push_back(std::uint32_t(rows));
    rows += vertexCount(i);
    const DiffuseTransfer* stored = ofObjects_[i] ? &ofObjects_[i]->transfer : nullptr;
    const bool holds = stored && stored->kind == TransferKind::interreflected;
    result_.holdsAlbedo.push_back(holds);
    if (holds) result_.rows.channels = std::max(result_.rows.channels, stored->channels);
  }
  result_.rows.values.resize(rows * result_.rows.rowLength());
}

void Assembly::write(std::uint32_t row, const ShVector<glm::vec3>& transfer) {
  TransferRows& rows = result_.rows;
  const ShVector<glm::vec3> whole = transfer.withOrder(rows.order);
  float* value = &rows.values[row * rows.rowLength()];
  for (int channel = 0; channel < rows.channels; ++channel)
    for (int k = 0; k < whole.size(); ++k) *value++ = whole[k][channel];
}

/// From the object's own coordinates to the world's.
ShRotation Assembly::rotationToWorld(std::size_t object) const {
  const int order = ofObjects_[object]->transfer.order;
  if (ofWholeScene_) return ShRotation(glm::dmat3(1), order);
  const MovingObject& moving = moving_.objects()[object];
  const glm::mat4 toWorld = moving.toWorld(0);
  const auto complaint = [&](const char* how) {
    return fmt::format("object '{}' is {}, so that transfer {} does not hold for it",
                       scene_.objects[object].name, how, ofObjects_[object]->path.string());
  };
  if (transformed(moving.loadedMesh(), toWorld).positions != scene_.objects[object].mesh.positions)
    throw InputError(complaint("deformed"));
  return ShRotation(rotationOf(glm::dmat3(toWorld), complaint("stretched unevenly")), order);
}

/// Rows without reflections are taken as those of a white object.
void Assembly::copyStored(std::size_t object) {
  const DiffuseTransfer& stored = ofObjects_[object]->transfer;
  const ShRotation toWorld = rotationToWorld(object);
  const bool white = !result_.holdsAlbedo[object];
  const glm::vec3& a = stored.albedo;
  const int brightest = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  const float factor = white && a[brightest] > 0 ? 1 / a[brightest] : 1;
  const auto channelOf = [&](int channel) {
    return stored.channels == 1 ? 0 : white ? brightest : channel;
  };
  const std::size_t first =
      ofWholeScene_ ? result_.firstRows[object] : 0;  // in the file, as in the whole scene
  parallelFor(vertexCount(object), 256, [&](std::size_t begin, std::size_t end) {
    ShVector<glm::vec3> own(stored.order);
    for (std::size_t v = begin; v < end; ++v) {
      const auto row = stored.row(first + v);
      for (int k = 0; k < own.size(); ++k)
        for (int c = 0; c < 3; ++c)
          own[k][c] = factor * row[std::size_t(k * stored.channels + channelOf(c))];
      write(result_.firstRows[object] + std::uint32_t(v), toWorld(own));
    }
  });
  if (!white && object < scene_.objects.size() && scene_.objects[object].albedo != a)
    result_.warnings.push_back(
        fmt::format("object '{}' has the albedo of its transfer {}, for "
                    "light is reflected in it",
                    scene_.objects[object].name, ofObjects_[object]->path.string()));
}

void Assembly::compute(const Progress& progress) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> rows;  // by vertex
  const auto add = [&](std::size_t object, const TriangleMesh& part, bool blocks) {
    append(mesh, part, blocks);
    for (std::uint32_t v = 0; v < part.positions.size(); ++v)
      rows.push_back(result_.firstRows[object] + v);
  };
  const std::size_t objects = scene_.objects.size();
  for (std::size_t i = 0; i < objects; ++i)
    if (!ofObjects_[i]) add(i, scene_.objects[i].mesh, scene_.objects[i].castsShadow);
  if (!ofObjects_[objects] && scene_.receiver)
    add(objects, ReceiverGrid(*scene_.receiver).vertices(), false);
  if (rows.empty()) return;
  for (std::size_t i = 0; i < objects; ++i)
    if (ofObjects_[i] && scene_.objects[i].castsShadow) append(mesh, scene_.objects[i].mesh, true);
  const int order = result_.rows.order;
  const LightTransport transport(mesh, order, raysPerVertex, 1, false, {progress, {}}, rows.size());
  const std::vector<float>& direct = transport.direct();
  ShVector<glm::vec3> own(order);
  for (std::size_t v = 0; v < rows.size(); ++v) {
    for (int k = 0; k < own.size(); ++k)
      own[k] = glm::vec3(direct[v * std::size_t(own.size()) + std::size_t(k)]);
    write(rows[v], own);
  }
}

SceneTransfer Assembly::assemble(std::optional<int> order, const Progress& progress) {
  layOut(orderOf(order));
  for (std::size_t i = 0; i < ofObjects_.size(); ++i)
    if (ofObjects_[i] && vertexCount(i) > 0) copyStored(i);
  compute(progress);
  return std::move(result_);
}

}  // namespace

TriangleMesh wholeSceneMesh(const Scene& scene) {
  requireMeshes(scene);
  TriangleMesh mesh;
  for (const SceneObject& object : scene.objects) append(mesh, object.mesh, object.castsShadow);
  if (scene.receiver) append(mesh, ReceiverGrid(*scene.receiver).vertices(), false);
  return mesh;
}

SceneTransfer makeSceneTransfer(const SceneDescription& description, const MovingScene& scene,
                                std::span<const fs::path> files, std::optional<int> order,
                                const Progress& progress) {
  requireMeshes(scene.scene());
  Assembly assembly(description, scene);
  assembly.readFiles(files);
  return assembly.assemble(order, progress);
}

}  // namespace haarlight
