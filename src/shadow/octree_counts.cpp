#include "shadow/octree_counts.h"

namespace haarlight {

OctreeCounts& OctreeCounts::operator+=(const OctreeCounts& other) {
  const auto add = [](ByDepth& sum, const ByDepth& more) {
    for (std::size_t depth = 0; depth < sum.size(); ++depth) sum[depth] += more[depth];
  };
  add(cells, other.cells);
  add(unreached, other.unreached);
  add(inShadow, other.inShadow);
  add(inLight, other.inLight);
  byRay += other.byRay;
  rays += other.rays;
  proofSeconds += other.proofSeconds;
  raySeconds += other.raySeconds;
  sortSeconds += other.sortSeconds;
  return *this;
}

}  // namespace haarlight
