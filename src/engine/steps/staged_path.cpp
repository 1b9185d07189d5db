#include "engine/steps/staged_path.h"

namespace haarlight {

namespace {

using Coefficients = decltype(OcclusionHaar::coefficients);
using Means = decltype(OcclusionHaar::means);
using Blocks = decltype(OcclusionHaar::blocks);

/// The parts of occlusion, each in an array of its own, as kernels have them.
struct OcclusionParts {
  explicit OcclusionParts(std::size_t count) : coefficients(count), means(count), blocks(count) {}

  std::vector<Coefficients> coefficients;
  std::vector<Means> means;
  std::vector<Blocks> blocks;
};

}  // namespace

CommandSeconds StagedPath::launchMerge(std::size_t samples) {
  const KernelArgument cubes = queue_.roomForSamples(bitCubes_, samples, sizeof(BitCube));
  if (frame_.usesTable)
    return queue_.launchTiles(
        "mergeBitCubes", samples,
        {frame_.positions, frame_.normals, frame_.spheres, frame_.sphereCount(),
         frame_.tableEntries, frame_.tableGroups, cubes});
  return queue_.launchTiles(
      "mergeBitCubesExactly", samples,
      {frame_.positions, frame_.normals, frame_.spheres, frame_.sphereCount(), cubes});
}

CommandSeconds StagedPath::launchTransform(std::size_t samples) {
  return queue_.launch(
      "transformOcclusion", samples,
      {bitCubes_, queue_.roomForSamples(coefficients_, samples, sizeof(Coefficients)),
       queue_.roomForSamples(means_, samples, sizeof(Means)),
       queue_.roomForSamples(blocks_, samples, sizeof(Blocks))});
}

CommandSeconds StagedPath::launchTripleProduct(std::span<const LobeBlend> lobes) {
  const ShadingBuffers::OfLobes& ofLobes = shading_.ofLobes();
  return queue_.launch(
      "tripleProduct", lobes.size(),
      {coefficients_, means_, blocks_, frame_.lobes, lobesPerReceiver(lobes), ofLobes.slots,
       ofLobes.squareListEnds, ofLobes.squarePlaces, shading_.weights, ofLobes.unshadowed,
       ofLobes.scales, frame_.roomForRadiance(lobes.size())});
}

void StagedPath::shade(ReceiverSpan receivers, std::span<glm::vec4> radiance, StageTimes& times) {
  const auto places = frame_.uploadPlaces(receivers);
  const CommandSeconds lobes = frame_.uploadLobes(receivers.lobes);
  const CommandSeconds merge = launchMerge(receivers.size());
  const CommandSeconds transform = launchTransform(receivers.size());
  const CommandSeconds product = launchTripleProduct(receivers.lobes);
  times.readBack += queue_.download(frame_.radiance, radiance)();
  times.upload += places[0]() + places[1]() + lobes();
  times.merge += merge();
  times.transform += transform();
  times.tripleProduct += product();
}

std::vector<std::uint32_t> StagedPath::sphereTableEntries(ReceiverSpan receivers) {
  std::vector<std::uint32_t> entries(receivers.size() * frame_.sphereCount());
  if (entries.empty()) return entries;
  frame_.uploadPlaces(receivers);
  queue_.launchTiles("sphereTableEntries", receivers.size(),
                     {frame_.positions, frame_.normals, frame_.spheres, frame_.sphereCount(),
                      queue_.roomForSamples(tableEntries_, receivers.size(),
                                            frame_.sphereCount() * sizeof entries[0])});
  queue_.download(tableEntries_, entries);
  return entries;
}

std::vector<BitCube> StagedPath::mergeBitCubes(ReceiverSpan receivers) {
  std::vector<BitCube> cubes(receivers.size());
  if (cubes.empty()) return cubes;
  frame_.uploadPlaces(receivers);
  launchMerge(receivers.size());
  queue_.download(bitCubes_, cubes);
  return cubes;
}

std::vector<OcclusionHaar> StagedPath::transformOcclusion(std::span<const BitCube> cubes) {
  std::vector<OcclusionHaar> occlusion(cubes.size());
  if (cubes.empty()) return occlusion;
  queue_.uploadSamples(bitCubes_, cubes);
  launchTransform(cubes.size());
  OcclusionParts parts(cubes.size());
  queue_.download(coefficients_, parts.coefficients);
  queue_.download(means_, parts.means);
  queue_.download(blocks_, parts.blocks);
  for (std::size_t i = 0; i < cubes.size(); ++i)
    occlusion[i] = {parts.coefficients[i], parts.means[i], parts.blocks[i]};
  return occlusion;
}

std::vector<glm::vec4> StagedPath::tripleProduct(std::span<const OcclusionHaar> occlusion,
                                                 std::span<const LobeBlend> lobes) {
  std::vector<glm::vec4> radiance(occlusion.size());
  if (radiance.empty()) return radiance;
  OcclusionParts parts(occlusion.size());
  for (std::size_t i = 0; i < occlusion.size(); ++i) {
    parts.coefficients[i] = occlusion[i].coefficients;
    parts.means[i] = occlusion[i].means;
    parts.blocks[i] = occlusion[i].blocks;
  }
  queue_.uploadSamples(coefficients_, parts.coefficients);
  queue_.uploadSamples(means_, parts.means);
  queue_.uploadSamples(blocks_, parts.blocks);
  frame_.uploadLobes(lobes);
  launchTripleProduct(lobes);
  queue_.download(frame_.radiance, radiance);
  return radiance;
}

}  // namespace haarlight
