#include "verify/shrink.h"

#include <algorithm>
#include <numeric>

namespace haarlight::verify {

namespace {

using Indices = std::vector<std::size_t>;

/// Leaves out chunks of ever smaller size as long as `fails` holds for what remains.
Indices smallest(Indices kept, const std::function<bool(const Indices&)>& fails) {
  for (std::size_t chunk = std::max<std::size_t>(kept.size() / 2, 1);; chunk /= 2) {
    for (std::size_t first = 0; first < kept.size();) {
      Indices rest(kept.begin(), kept.begin() + std::ptrdiff_t(first));
      const std::size_t end = std::min(first + chunk, kept.size());
      rest.insert(rest.end(), kept.begin() + std::ptrdiff_t(end), kept.end());
      if (!rest.empty() && fails(rest))
        kept = std::move(rest);
      else
        first = end;
    }
    if (chunk <= 1) return kept;
  }
}

Indices all(std::size_t count) {
  Indices indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

Case withReceivers(const Case& value, const Indices& indices) {
  Case part = value;
  part.receivers = {};
  part.frameWidth = part.frameHeight = 0;
  part.pixels.clear();
  for (const std::size_t i : indices) {
    part.receivers.positions.push_back(value.receivers.positions[i]);
    part.receivers.normals.push_back(value.receivers.normals[i]);
    part.receivers.lobes.push_back(value.receivers.lobes[i]);
  }
  return part;
}

Case withSpheres(const Case& value, const Indices& indices) {
  Case part = value;
  part.spheres.clear();
  for (const std::size_t i : indices) part.spheres.push_back(value.spheres[i]);
  return part;
}

}  // namespace

Case shrunk(const Case& failing, const std::function<bool(const Case&)>& fails) {
  Case result = failing;
  const Indices receivers = smallest(all(result.receivers.size()), [&](const Indices& indices) {
    return fails(withReceivers(result, indices));
  });
  result = withReceivers(result, receivers);
  const Indices spheres = smallest(all(result.spheres.size()), [&](const Indices& indices) {
    return fails(withSpheres(result, indices));
  });
  return withSpheres(result, spheres);
}

}  // namespace haarlight::verify
