#include "verify/shrink.h"

#include <algorithm>
#include <map>
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

/// The entries of the binding with these numbers; spheres without any are left out, and so are
/// vertices that nothing follows.
Case withEntries(const Case& value, const Indices& indices) {
  Case part = value;
  part.binding = {};
  part.vertices.clear();
  std::map<std::uint32_t, std::uint32_t> numbers;
  const SphereBinding& whole = value.binding;
  for (std::size_t i = 0, next = 0; i < whole.sphereCount(); ++i) {
    std::vector<std::uint32_t> list;
    std::vector<glm::vec4> weights;
    for (; next < indices.size() && indices[next] < whole.listStarts[i + 1]; ++next) {
      const std::uint32_t vertex = whole.vertices[indices[next]];
      const auto [place, isNew] = numbers.try_emplace(vertex, std::uint32_t(numbers.size()));
      if (isNew) part.vertices.push_back(value.vertices[vertex]);
      list.push_back(place->second);
      weights.push_back(whole.weights[indices[next]]);
    }
    if (!list.empty()) part.binding.add(list, weights, whole.radiusFactors[i]);
  }
  return part;
}

Indices entriesOf(const SphereBinding& binding, const Indices& spheres) {
  Indices entries;
  for (const std::size_t i : spheres)
    for (std::size_t entry = binding.listStarts[i]; entry < binding.listStarts[i + 1]; ++entry)
      entries.push_back(entry);
  return entries;
}

Case withSmallestBinding(const Case& failing, const std::function<bool(const Case&)>& fails) {
  if (Case without = withEntries(failing, {}); fails(without)) return without;
  const auto entriesFail = [&](const Indices& entries) {
    return fails(withEntries(failing, entries));
  };
  const Indices spheres = smallest(all(failing.binding.sphereCount()), [&](const Indices& indices) {
    return entriesFail(entriesOf(failing.binding, indices));
  });
  return withEntries(failing, smallest(entriesOf(failing.binding, spheres), entriesFail));
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
  return withSmallestBinding(withSpheres(result, spheres), fails);
}

}  // namespace haarlight::verify
