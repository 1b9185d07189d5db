#include "hard_shadow/scene_octrees.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "mesh_shadow/lit_mesh.h"
#include "mesh_shadow/mesh_object.h"
#include "shadow/solid_object.h"

namespace haarlight {

namespace {

std::unique_ptr<ShadowObject> prepared(const Occluder& shape, const ShadowLight& light) {
  if (const auto* solid = std::get_if<const Solid*>(&shape)) return makeShadowObject(**solid);
  return makeShadowObject(*std::get<const TriangleMesh*>(shape), light);
}

/// Whether a receiver's octree may differ: it, or one that casts a shadow on it, has moved.
bool isTouched(std::uint32_t receiver, const std::vector<std::uint32_t>& casters,
               const std::vector<bool>& moved) {
  return moved[receiver] ||
         std::ranges::any_of(casters, [&](std::uint32_t caster) { return moved[caster]; });
}

}  // namespace

SceneOctrees::SceneOctrees(const LevelOfDetail& detail) : detail_(detail) {
  checkDetail(detail);
}

void SceneOctrees::show(std::span<const ShadowParticipant> participants, const ShadowLight& light,
                        const std::vector<bool>& moved) {
  checkLight(light);
  const std::size_t count = participants.size();
  const bool isNew = light_ != light || moved.empty() || octrees_.size() != count;
  const std::vector<bool> changed = isNew ? std::vector<bool>(count, true) : moved;
  if (isNew) {
    light_ = light;
    rays_.emplace(std::vector<Occluder>(count), light);
    objects_.resize(count), boxes_.resize(count), octrees_.resize(count),
        casters_.assign(count, {});
  }
  work_ = {};
  Stopwatch watch;
  prepare(participants, changed);
  work_.prepareSeconds = watch.lap();
  work_.pairs = findPairs(participants, boxes_, light);
  const auto casters = castersByReceiver(work_.pairs.kept, count);
  work_.pairSeconds = watch.lap();

  std::vector<const ShadowObject*> objects;
  for (const auto& object : objects_) objects.push_back(object.get());
  const ShadowScene scene{objects, *light_, *rays_};
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!isTouched(i, casters[i], changed) && !isTouched(i, casters_[i], changed)) continue;
    octrees_[i] =
        buildShadowOctree(scene, i, casters[i], depthsFor(detail_, boxes_[i]), work_.counts);
    ++work_.builtOctrees;
  }
  casters_ = casters;
  work_.octreeSeconds = watch.lap();
}

void SceneOctrees::prepare(std::span<const ShadowParticipant> participants,
                           const std::vector<bool>& moved) {
  for (std::uint32_t i = 0; i < participants.size(); ++i) {
    if (!moved[i]) continue;
    rays_->replace(i, participants[i].shape);
    objects_[i] = prepared(participants[i].shape, *light_);
    boxes_[i] = objects_[i]->bounds();
    ++work_.preparedObjects;
  }
}

void SceneOctrees::answer(std::span<const ReceiverPoint> points,
                          std::span<std::uint8_t> inShadow) const {
  parallelFor(points.size(), 4096, [&](std::size_t begin, std::size_t end) {
    std::uint32_t object = ReceiverPoint::nothing;
    const ShadowLeaf* leaf = nullptr;  // of the point before, which often lies in the same
    double reach = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const ReceiverPoint& point = points[i];
      inShadow[i] = 0;
      if (point.object == ReceiverPoint::nothing) continue;
      if (std::exchange(object, point.object) != point.object) {
        leaf = nullptr;
        reach = singlePrecisionMargin(boxes_[object]);
      }
      leaf = octrees_[object].leafNear(point.position, reach, leaf);
      inShadow[i] = (leaf && leaf->inShadow) || !facesLight(point, *light_);
    }
  });
}

double SceneOctrees::cellEdge() const {
  double largest = 0;
  for (std::size_t i = 0; i < octrees_.size(); ++i)
    if (!boxes_[i].isEmpty())
      largest =
          std::max(largest, octrees_[i].cube().edgeAt(depthsFor(detail_, boxes_[i]).boundary));
  return largest;
}

std::size_t SceneOctrees::memory() const {
  std::size_t leaves = 0;
  for (const ShadowOctree& octree : octrees_) leaves += octree.leaves().size();
  return leaves * sizeof(ShadowLeaf);
}

}  // namespace haarlight
