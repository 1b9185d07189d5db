#include "engine/kernel_engine.h"

#include <algorithm>
#include <chrono>

#include "engine/growing_buffer.h"

namespace haarlight {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::size_t roundedUp(std::size_t count, std::size_t multiple) {
  return (count + multiple - 1) / multiple * multiple;
}

/// Tables of one light on the device.
struct DeviceTables {
  glm::uvec4 squareListEnds{0};
  GrowingBuffer lobeSlots, squarePlaces, weights, unshadowed, scales;
};

/// What spheres follow, on the device.
struct DeviceBinding {
  std::size_t spheres = 0;
  GrowingBuffer listStarts, vertices, weights, radiusFactors, positions, moved;
};

/// What one batch of receivers passes from kernel to kernel.
struct BatchBuffers {
  GrowingBuffer positions, normals, lobes, bitCubes, coefficients, means, blocks, radiance;
};

class KernelEngine final : public Engine {
 public:
  KernelEngine(std::unique_ptr<KernelDevice> device, const SphereTable* table);

  std::string name() const override { return device_->engineName(); }
  std::string deviceName() const override { return device_->name(); }
  std::string numericLimitation() const override { return device_->numericLimitation(); }
  double preparationSeconds() const override { return preparationSeconds_; }
  DeviceUse deviceUse() const override;

  void setShading(const ShadingTables& tables) override;
  void setSphereBinding(const SphereBinding& binding) override;
  std::vector<Sphere> moveSpheres(std::span<const glm::vec4> positions) override;
  std::vector<std::uint32_t> sphereTableEntries(std::span<const Sphere> spheres,
                                                ReceiverSpan receivers) override;
  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override;
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override;
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override;
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override;

 private:
  DeviceBuffer& room(GrowingBuffer& buffer, std::size_t bytes) {
    return buffer.atLeast(*device_, bytes, allocatedBytes_);
  }
  template <typename Element>
  CommandSeconds upload(GrowingBuffer& buffer, std::span<const Element> data);
  template <typename Element>
  CommandSeconds uploadSamples(GrowingBuffer& buffer, std::span<const Element> data);
  template <typename Element>
  CommandSeconds download(const GrowingBuffer& buffer, std::span<Element> data);
  KernelArgument roomFor(GrowingBuffer& buffer, std::size_t samples, std::size_t bytesEach);
  template <std::size_t count>
  CommandSeconds launch(std::string_view kernel, std::size_t samples,
                        const std::array<KernelArgument, count>& arguments);

  CommandSeconds launchMerge(std::size_t spheres, std::size_t samples);
  CommandSeconds launchTransform(std::size_t samples);
  CommandSeconds launchTripleProduct(std::span<const LobeBlend> lobes);
  void shadeBatch(std::size_t spheres, ReceiverSpan receivers, std::span<glm::vec4> radiance,
                  StageTimes& times);
  void warmUp();

  std::unique_ptr<KernelDevice> device_;
  std::size_t samplesPerGroup_;
  bool usesTable_;
  std::uint64_t allocatedBytes_ = 0;
  GrowingBuffer sphereTable_, occupiedFaces_, spheres_, tableEntries_;
  BatchBuffers batch_;
  DeviceTables tables_;
  DeviceBinding binding_;
  double preparationSeconds_ = 0;
};

KernelEngine::KernelEngine(std::unique_ptr<KernelDevice> device, const SphereTable* table)
    : device_(std::move(device)),
      samplesPerGroup_(std::size_t(device_->shape().samplesPerGroup)),
      usesTable_(table != nullptr) {
  if (table) {
    upload(sphereTable_, table->words());
    upload(occupiedFaces_, table->occupiedFaces());
  }
  const auto start = Clock::now();
  warmUp();
  preparationSeconds_ = device_->buildSeconds() + secondsSince(start);
}

/// Some drivers (PoCL) compile a kernel when it is first launched.
void KernelEngine::warmUp() {
  Receivers receivers;
  receivers.add({0, 0, 0}, {0, 1, 0});
  setShading(buildShadingTables(RadianceCube{}, {0, 2}, countLobes(receivers.lobes)));
  const Sphere sphere{{0, 2, 0}, 1};
  SphereBinding binding;
  binding.add(std::array{0u}, std::array{glm::vec4(1, 1, 0, 0)}, {1, 0});
  setSphereBinding(binding);
  moveSpheres(receivers.positions);
  setSphereBinding({});
  shade(std::span(&sphere, 1), receivers, nullptr);
}

DeviceUse KernelEngine::deviceUse() const {
  DeviceUse use;
  use.memoryBytes = allocatedBytes_;
  const KernelShape shape = device_->shape();
  use.itemsPerGroup = partialSums / shape.lanesPerItem * shape.samplesPerGroup;
  for (const std::string_view kernel : kernelNames)
    if (const auto bytes = device_->localBytes(kernel))
      use.kernels.push_back({std::string(kernel), *bytes});
  return use;
}

template <typename Element>
CommandSeconds KernelEngine::upload(GrowingBuffer& buffer, std::span<const Element> data) {
  return device_->write(room(buffer, data.size_bytes()), std::as_bytes(data));
}

/// Uploads one element per sample. Work-groups are full, so the last group's missing samples are
/// zeros, and nobody reads their results.
template <typename Element>
CommandSeconds KernelEngine::uploadSamples(GrowingBuffer& buffer, std::span<const Element> data) {
  const std::size_t count = roundedUp(data.size(), samplesPerGroup_);
  if (count == data.size()) return upload(buffer, data);
  std::vector<Element> padded(count);
  std::ranges::copy(data, padded.begin());
  return upload(buffer, std::span<const Element>(padded));
}

template <typename Element>
CommandSeconds KernelEngine::download(const GrowingBuffer& buffer, std::span<Element> data) {
  return device_->read(buffer.get(), std::as_writable_bytes(data));
}

KernelArgument KernelEngine::roomFor(GrowingBuffer& buffer, std::size_t samples,
                                     std::size_t bytesEach) {
  return &room(buffer, roundedUp(samples, samplesPerGroup_) * bytesEach);
}

template <std::size_t count>
CommandSeconds KernelEngine::launch(std::string_view kernel, std::size_t samples,
                                    const std::array<KernelArgument, count>& arguments) {
  return device_->launch(kernel, roundedUp(samples, samplesPerGroup_) / samplesPerGroup_,
                         arguments);
}

CommandSeconds KernelEngine::launchMerge(std::size_t spheres, std::size_t samples) {
  const auto count = std::uint32_t(spheres);
  const KernelArgument cubes = roomFor(batch_.bitCubes, samples, sizeof(BitCube));
  if (usesTable_)
    return launch("mergeBitCubes", samples,
                  std::array<KernelArgument, 7>{batch_.positions, batch_.normals, spheres_, count,
                                                sphereTable_, occupiedFaces_, cubes});
  return launch(
      "mergeBitCubesExactly", samples,
      std::array<KernelArgument, 5>{batch_.positions, batch_.normals, spheres_, count, cubes});
}

CommandSeconds KernelEngine::launchTransform(std::size_t samples) {
  return launch("transformOcclusion", samples,
                std::array<KernelArgument, 4>{
                    batch_.bitCubes,
                    roomFor(batch_.coefficients, samples, sizeof(OcclusionHaar::coefficients)),
                    roomFor(batch_.means, samples, sizeof(OcclusionHaar::means)),
                    roomFor(batch_.blocks, samples, sizeof(OcclusionHaar::blocks))});
}

CommandSeconds KernelEngine::launchTripleProduct(std::span<const LobeBlend> lobes) {
  const bool single =
      std::ranges::all_of(lobes, [](const LobeBlend& b) { return b.weights[1] == 0; });
  const std::uint32_t lobesPerReceiver = single ? 1 : 3;
  return launch(
      "tripleProduct", lobes.size(),
      std::array<KernelArgument, 12>{
          batch_.coefficients, batch_.means, batch_.blocks, batch_.lobes, lobesPerReceiver,
          tables_.lobeSlots, tables_.squareListEnds, tables_.squarePlaces, tables_.weights,
          tables_.unshadowed, tables_.scales,
          roomFor(batch_.radiance, lobes.size(), sizeof(glm::vec4))});
}

void KernelEngine::setShading(const ShadingTables& tables) {
  const auto& ends = tables.squareListEnds;
  tables_.squareListEnds = {ends[coarseSquares], ends[blockSquares], ends[quarterSquares], 0};
  upload(tables_.lobeSlots, std::span(tables.lobeSlots));
  upload(tables_.squarePlaces, std::span(tables.squarePlaces));
  upload(tables_.weights, std::span(tables.weights));
  upload(tables_.unshadowed, std::span(tables.unshadowed));
  upload(tables_.scales, std::span(tables.scales));
}

void KernelEngine::setSphereBinding(const SphereBinding& binding) {
  binding_.spheres = binding.sphereCount();
  if (binding_.spheres == 0) return;
  upload(binding_.listStarts, std::span(binding.listStarts));
  upload(binding_.vertices, std::span(binding.vertices));
  upload(binding_.weights, std::span(binding.weights));
  upload(binding_.radiusFactors, std::span(binding.radiusFactors));
}

std::vector<Sphere> KernelEngine::moveSpheres(std::span<const glm::vec4> positions) {
  std::vector<Sphere> spheres(binding_.spheres);
  if (spheres.empty()) return spheres;
  upload(binding_.positions, positions);
  launch("moveSpheres", spheres.size(),
         std::array<KernelArgument, 7>{binding_.positions, std::uint32_t(spheres.size()),
                                       binding_.listStarts, binding_.vertices, binding_.weights,
                                       binding_.radiusFactors,
                                       roomFor(binding_.moved, spheres.size(), sizeof(Sphere))});
  download(binding_.moved, std::span(spheres));
  return spheres;
}

std::vector<std::uint32_t> KernelEngine::sphereTableEntries(std::span<const Sphere> spheres,
                                                            ReceiverSpan receivers) {
  std::vector<std::uint32_t> entries(receivers.size() * spheres.size());
  if (entries.empty()) return entries;
  upload(spheres_, spheres);
  uploadSamples(batch_.positions, receivers.positions);
  uploadSamples(batch_.normals, receivers.normals);
  launch("sphereTableEntries", receivers.size(),
         std::array<KernelArgument, 5>{
             batch_.positions, batch_.normals, spheres_, std::uint32_t(spheres.size()),
             roomFor(tableEntries_, receivers.size(), spheres.size() * sizeof entries[0])});
  download(tableEntries_, std::span(entries));
  return entries;
}

std::vector<BitCube> KernelEngine::mergeBitCubes(std::span<const Sphere> spheres,
                                                 ReceiverSpan receivers) {
  std::vector<BitCube> cubes(receivers.size());
  if (cubes.empty()) return cubes;
  upload(spheres_, spheres);
  uploadSamples(batch_.positions, receivers.positions);
  uploadSamples(batch_.normals, receivers.normals);
  launchMerge(spheres.size(), receivers.size());
  download(batch_.bitCubes, std::span(cubes));
  return cubes;
}

std::vector<OcclusionHaar> KernelEngine::transformOcclusion(std::span<const BitCube> cubes) {
  std::vector<OcclusionHaar> occlusion(cubes.size());
  if (cubes.empty()) return occlusion;
  uploadSamples(batch_.bitCubes, cubes);
  launchTransform(cubes.size());
  std::vector<decltype(OcclusionHaar::coefficients)> coefficients(cubes.size());
  std::vector<decltype(OcclusionHaar::means)> means(cubes.size());
  std::vector<decltype(OcclusionHaar::blocks)> blocks(cubes.size());
  download(batch_.coefficients, std::span(coefficients));
  download(batch_.means, std::span(means));
  download(batch_.blocks, std::span(blocks));
  for (std::size_t i = 0; i < cubes.size(); ++i)
    occlusion[i] = {coefficients[i], means[i], blocks[i]};
  return occlusion;
}

std::vector<glm::vec4> KernelEngine::tripleProduct(std::span<const OcclusionHaar> occlusion,
                                                   std::span<const LobeBlend> lobes) {
  std::vector<glm::vec4> radiance(occlusion.size());
  if (radiance.empty()) return radiance;
  std::vector<decltype(OcclusionHaar::coefficients)> coefficients;
  std::vector<decltype(OcclusionHaar::means)> means;
  std::vector<decltype(OcclusionHaar::blocks)> blocks;
  for (const OcclusionHaar& one : occlusion) {
    coefficients.push_back(one.coefficients);
    means.push_back(one.means);
    blocks.push_back(one.blocks);
  }
  uploadSamples(batch_.coefficients,
                std::span<const decltype(OcclusionHaar::coefficients)>(coefficients));
  uploadSamples(batch_.means, std::span<const decltype(OcclusionHaar::means)>(means));
  uploadSamples(batch_.blocks, std::span<const decltype(OcclusionHaar::blocks)>(blocks));
  uploadSamples(batch_.lobes, lobes);
  launchTripleProduct(lobes);
  download(batch_.radiance, std::span(radiance));
  return radiance;
}

void KernelEngine::shadeBatch(std::size_t spheres, ReceiverSpan receivers,
                              std::span<glm::vec4> radiance, StageTimes& times) {
  const std::array uploads{uploadSamples(batch_.positions, receivers.positions),
                           uploadSamples(batch_.normals, receivers.normals),
                           uploadSamples(batch_.lobes, receivers.lobes)};
  const CommandSeconds merge = launchMerge(spheres, receivers.size());
  const CommandSeconds transform = launchTransform(receivers.size());
  const CommandSeconds product = launchTripleProduct(receivers.lobes);
  times.readBack += download(batch_.radiance, radiance)();
  for (const CommandSeconds& seconds : uploads) times.upload += seconds();
  times.merge += merge();
  times.transform += transform();
  times.tripleProduct += product();
}

std::vector<glm::vec4> KernelEngine::shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                                           StageTimes* times) {
  StageTimes ignored;
  StageTimes& stages = times ? *times : ignored;
  const auto start = Clock::now();
  upload(spheres_, spheres);
  std::vector<glm::vec4> radiance(receivers.size());
  const std::size_t batch = device_->batchSize();
  for (std::size_t first = 0; first < receivers.size(); first += batch) {
    const std::size_t count = std::min(batch, receivers.size() - first);
    shadeBatch(spheres.size(), receivers.part(first, count),
               std::span(radiance).subspan(first, count), stages);
  }
  stages.total += secondsSince(start);
  return radiance;
}

}  // namespace

std::unique_ptr<Engine> makeKernelEngine(std::unique_ptr<KernelDevice> device,
                                         std::shared_ptr<const SphereTable> table) {
  return std::make_unique<KernelEngine>(std::move(device), table.get());
}

}  // namespace haarlight
