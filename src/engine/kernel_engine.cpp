#include "engine/kernel_engine.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "engine/growing_buffer.h"
#include "engine/lobe_window.h"

namespace haarlight {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Receivers that the fused path works on at a time; they leave nothing but their radiance.
constexpr std::size_t fusedBatch = 1 << 16;

/// Lobes to have room for at least, so that small frames need not grow theirs.
constexpr std::size_t smallestWindow = 16;

/// Weights of all texels for one lobe.
constexpr std::size_t texelWeightBytes = texelCount * sizeof(glm::uvec3);

std::size_t roundedUp(std::size_t count, std::size_t multiple) {
  return (count + multiple - 1) / multiple * multiple;
}

/// Receivers whose normals are all tabulated ones need one lobe each.
std::uint32_t lobesPerReceiver(std::span<const LobeBlend> lobes) {
  const bool single =
      std::ranges::all_of(lobes, [](const LobeBlend& b) { return b.weights[1] == 0; });
  return single ? 1 : 3;
}

/// Tables of one light on the device.
struct DeviceTables {
  glm::uvec4 squareListEnds{0};
  GrowingBuffer lobeSlots, squarePlaces, blockSquares, weights, unshadowed, scales;
};

/// The lobes whose weights are spread over texels, on the device, by their places.
struct DeviceWindow {
  LobeWindow places;
  GrowingBuffer newSlots, newPlaces, lobePlaces, unshadowed, scales, texelWeights;
};

/// What spheres follow, on the device.
struct DeviceBinding {
  std::size_t spheres = 0;
  GrowingBuffer listStarts, vertices, weights, radiusFactors, positions, moved;
};

/// Tables of exponentiation on the device.
struct DeviceExponentiation {
  std::optional<ShexpTables> visibility;
  GrowingBuffer logarithms, linear, constants, squareStarts, squareTerms, lobeSlots, lightLobes;
};

/// What one batch of receivers passes from kernel to kernel.
struct BatchBuffers {
  GrowingBuffer positions, normals, lobes, bitCubes, coefficients, means, blocks, radiance;
};

class KernelEngine final : public Engine {
 public:
  KernelEngine(std::unique_ptr<KernelDevice> device, const SphereTable* table, FramePath path);

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
  void setFramePath(FramePath path) override { path_ = path; }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override;
  void setExponentiation(const ExponentiationTables& tables) override;
  std::vector<glm::vec4> shadeByExponentiation(std::span<const Sphere> spheres,
                                               ReceiverSpan receivers, StageTimes* times) override;

 private:
  DeviceBuffer& room(GrowingBuffer& buffer, std::size_t bytes) {
    return buffer.atLeast(*device_, bytes, allocatedBytes_);
  }
  template <typename Element>
  CommandSeconds upload(GrowingBuffer& buffer, std::span<const Element> data);
  void uploadSpheres(std::span<const Sphere> spheres);
  template <typename Element>
  CommandSeconds uploadSamples(GrowingBuffer& buffer, std::span<const Element> data);
  template <typename Element>
  CommandSeconds download(const GrowingBuffer& buffer, std::span<Element> data);
  KernelArgument roomFor(GrowingBuffer& buffer, std::size_t samples, std::size_t bytesEach);
  template <std::size_t count>
  CommandSeconds launch(std::string_view kernel, std::size_t samples,
                        const std::array<KernelArgument, count>& arguments);

  template <std::size_t count>
  CommandSeconds launchTiles(std::string_view kernel, std::size_t samples,
                             const std::array<KernelArgument, count>& arguments) {
    return launch(kernel, roundedUp(samples, tileSamples_) / tileSamples_, arguments);
  }

  CommandSeconds launchMerge(std::size_t spheres, std::size_t samples);
  CommandSeconds launchTransform(std::size_t samples);
  CommandSeconds launchTripleProduct(std::span<const LobeBlend> lobes);
  void shadeStaged(std::size_t spheres, ReceiverSpan receivers, std::span<glm::vec4> radiance,
                   StageTimes& times);
  CommandSeconds openWindow(const std::vector<std::uint32_t>& slots);
  CommandSeconds launchFused(std::size_t spheres, std::span<const LobeBlend> lobes);
  void shadeFused(std::size_t spheres, ReceiverSpan receivers, std::span<glm::vec4> radiance,
                  StageTimes& times);
  void shadeLowOrder(std::size_t spheres, ReceiverSpan receivers, std::span<glm::vec4> radiance,
                     StageTimes& times);
  using ShadeBatch = void (KernelEngine::*)(std::size_t spheres, ReceiverSpan receivers,
                                            std::span<glm::vec4> radiance, StageTimes& times);
  std::vector<glm::vec4> shadeInBatches(ShadeBatch shadeBatch, std::size_t batch,
                                        std::span<const Sphere> spheres, ReceiverSpan receivers,
                                        StageTimes* times);
  void warmUp();

  std::unique_ptr<KernelDevice> device_;
  std::size_t samplesPerGroup_;
  /// Samples of an item where kernels merge.
  std::size_t tileSamples_;
  bool usesTable_;
  FramePath path_;
  std::uint64_t allocatedBytes_ = 0;
  GrowingBuffer tableEntries_, tableGroups_, spheres_, foundEntries_;
  BatchBuffers batch_;
  ShadingTables shading_;
  DeviceTables tables_;
  DeviceWindow window_;
  DeviceBinding binding_;
  DeviceExponentiation exponentiation_;
  double preparationSeconds_ = 0;
};

KernelEngine::KernelEngine(std::unique_ptr<KernelDevice> device, const SphereTable* table,
                           FramePath path)
    : device_(std::move(device)),
      samplesPerGroup_(std::size_t(device_->shape().samplesPerGroup)),
      tileSamples_(device_->shape().lanesPerItem > 1 ? std::size_t(tileSamples) : 1),
      usesTable_(table != nullptr),
      path_(path) {
  if (table) {
    upload(tableEntries_, table->entries());
    upload(tableGroups_, table->groups());
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

/// Uploads the spheres as kernels read them: x, y, z, radius of all, one after the other, padded to
/// a multiple of 32 with the last sphere.
void KernelEngine::uploadSpheres(std::span<const Sphere> spheres) {
  const std::size_t stride = roundedUp(spheres.size(), partialSums);
  std::vector<float> numbers(4 * stride);
  for (std::size_t i = 0; i < stride; ++i) {
    const Sphere& sphere = spheres[std::min(i, spheres.size() - 1)];
    for (int axis = 0; axis < 3; ++axis) numbers[axis * stride + i] = sphere.center[axis];
    numbers[3 * stride + i] = sphere.radius;
  }
  upload(spheres_, std::span<const float>(numbers));
}

/// Uploads one element per sample. Work-groups are full, so the last group's missing samples are
/// zeros, and nobody reads their results.
template <typename Element>
CommandSeconds KernelEngine::uploadSamples(GrowingBuffer& buffer, std::span<const Element> data) {
  const std::size_t count = roundedUp(data.size(), samplesPerGroup_ * tileSamples_);
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
  return &room(buffer, roundedUp(samples, samplesPerGroup_ * tileSamples_) * bytesEach);
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
    return launchTiles("mergeBitCubes", samples,
                       std::array<KernelArgument, 7>{batch_.positions, batch_.normals, spheres_,
                                                     count, tableEntries_, tableGroups_, cubes});
  return launchTiles(
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
  return launch("tripleProduct", lobes.size(),
                std::array<KernelArgument, 12>{
                    batch_.coefficients, batch_.means, batch_.blocks, batch_.lobes,
                    lobesPerReceiver(lobes), tables_.lobeSlots, tables_.squareListEnds,
                    tables_.squarePlaces, tables_.weights, tables_.unshadowed, tables_.scales,
                    roomFor(batch_.radiance, lobes.size(), sizeof(glm::vec4))});
}

void KernelEngine::setShading(const ShadingTables& tables) {
  // The weights, by far the largest part, are needed on the device only.
  shading_.lobeSlots = tables.lobeSlots;
  shading_.squarePlaces = tables.squarePlaces;
  shading_.unshadowed = tables.unshadowed;
  shading_.scales = tables.scales;
  window_.places = LobeWindow(std::min(device_->lobeWindow(), tables.slotCount()));
  const auto& ends = tables.squareListEnds;
  tables_.squareListEnds = {ends[coarseSquares], ends[blockSquares], ends[quarterSquares], 0};
  upload(tables_.lobeSlots, std::span(tables.lobeSlots));
  upload(tables_.squarePlaces, std::span(tables.squarePlaces));
  upload(tables_.blockSquares, std::span(tables.blockSquares));
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
  uploadSpheres(spheres);
  uploadSamples(batch_.positions, receivers.positions);
  uploadSamples(batch_.normals, receivers.normals);
  launchTiles("sphereTableEntries", receivers.size(),
              std::array<KernelArgument, 5>{
                  batch_.positions, batch_.normals, spheres_, std::uint32_t(spheres.size()),
                  roomFor(foundEntries_, receivers.size(), spheres.size() * sizeof entries[0])});
  download(foundEntries_, std::span(entries));
  return entries;
}

std::vector<BitCube> KernelEngine::mergeBitCubes(std::span<const Sphere> spheres,
                                                 ReceiverSpan receivers) {
  std::vector<BitCube> cubes(receivers.size());
  if (cubes.empty()) return cubes;
  uploadSpheres(spheres);
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

/// Gives the lobes of a batch their places; spreads the weights of those that had none.
CommandSeconds KernelEngine::openWindow(const std::vector<std::uint32_t>& slots) {
  LobeWindow::Change change = window_.places.open(slots);
  if (change.slots.empty()) return [] { return 0.0; };
  std::vector<std::uint32_t> lobePlaces;
  for (const std::uint32_t slot : shading_.lobeSlots)
    lobePlaces.push_back(window_.places.placeOf(slot));
  upload(window_.lobePlaces, std::span<const std::uint32_t>(lobePlaces));
  std::vector<glm::uvec4> unshadowed;
  std::vector<glm::vec4> scales;
  for (const std::uint32_t slot : window_.places.slots()) {
    unshadowed.push_back(shading_.unshadowed[slot]);
    scales.push_back(shading_.scales[slot]);
  }
  upload(window_.unshadowed, std::span<const glm::uvec4>(unshadowed));
  upload(window_.scales, std::span<const glm::vec4>(scales));
  // Work-groups are full; the last lobe fills them up.
  const std::size_t count = change.slots.size(), full = roundedUp(count, samplesPerGroup_);
  change.slots.resize(full, change.slots.back());
  change.places.resize(full, change.places.back());
  upload(window_.newSlots, std::span<const std::uint32_t>(change.slots));
  upload(window_.newPlaces, std::span<const std::uint32_t>(change.places));
  return launch("spreadWeights", count,
                std::array<KernelArgument, 6>{
                    window_.newSlots, window_.newPlaces, std::uint32_t(shading_.squareCount()),
                    tables_.weights, tables_.blockSquares,
                    &room(window_.texelWeights,
                          std::max(window_.places.capacity(), smallestWindow) * texelWeightBytes)});
}

CommandSeconds KernelEngine::launchFused(std::size_t spheres, std::span<const LobeBlend> lobes) {
  const auto count = std::uint32_t(spheres);
  const KernelArgument radiance = roomFor(batch_.radiance, lobes.size(), sizeof(glm::vec4));
  if (usesTable_)
    return launchTiles("shadeByTable", lobes.size(),
                       std::array<KernelArgument, 13>{
                           batch_.positions, batch_.normals, batch_.lobes, spheres_, count,
                           tableEntries_, tableGroups_, lobesPerReceiver(lobes), window_.lobePlaces,
                           window_.texelWeights, window_.unshadowed, window_.scales, radiance});
  return launchTiles("shadeExactly", lobes.size(),
                     std::array<KernelArgument, 11>{batch_.positions, batch_.normals, batch_.lobes,
                                                    spheres_, count, lobesPerReceiver(lobes),
                                                    window_.lobePlaces, window_.texelWeights,
                                                    window_.unshadowed, window_.scales, radiance});
}

/// Halves batches whose lobes do not fit into a window.
void KernelEngine::shadeFused(std::size_t spheres, ReceiverSpan receivers,
                              std::span<glm::vec4> radiance, StageTimes& times) {
  const auto slots = slotsOf(receivers.lobes, shading_);
  if (slots.size() > window_.places.capacity()) {
    const std::size_t half = receivers.size() / 2;
    shadeFused(spheres, receivers.part(0, half), radiance.first(half), times);
    shadeFused(spheres, receivers.part(half, receivers.size() - half), radiance.subspan(half),
               times);
    return;
  }
  const CommandSeconds spread = openWindow(slots);
  const std::array uploads{uploadSamples(batch_.positions, receivers.positions),
                           uploadSamples(batch_.normals, receivers.normals),
                           uploadSamples(batch_.lobes, receivers.lobes)};
  const CommandSeconds fused = launchFused(spheres, receivers.lobes);
  times.readBack += download(batch_.radiance, radiance)();
  for (const CommandSeconds& seconds : uploads) times.upload += seconds();
  times.fused += spread() + fused();
}

void KernelEngine::shadeStaged(std::size_t spheres, ReceiverSpan receivers,
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

std::vector<glm::vec4> KernelEngine::shadeInBatches(ShadeBatch shadeBatch, std::size_t batch,
                                                    std::span<const Sphere> spheres,
                                                    ReceiverSpan receivers, StageTimes* times) {
  StageTimes ignored;
  StageTimes& stages = times ? *times : ignored;
  const auto start = Clock::now();
  uploadSpheres(spheres);
  std::vector<glm::vec4> radiance(receivers.size());
  for (std::size_t first = 0; first < receivers.size(); first += batch) {
    const std::size_t count = std::min(batch, receivers.size() - first);
    (this->*shadeBatch)(spheres.size(), receivers.part(first, count),
                        std::span(radiance).subspan(first, count), stages);
  }
  stages.total += secondsSince(start);
  return radiance;
}

std::vector<glm::vec4> KernelEngine::shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                                           StageTimes* times) {
  if (path_ == FramePath::fused)
    return shadeInBatches(&KernelEngine::shadeFused, fusedBatch, spheres, receivers, times);
  return shadeInBatches(&KernelEngine::shadeStaged, device_->batchSize(), spheres, receivers,
                        times);
}

/// The kernel, which some drivers compile when it is first launched, runs once at the first call.
void KernelEngine::setExponentiation(const ExponentiationTables& tables) {
  const bool isFirst = !exponentiation_.visibility;
  const ShexpTables& visibility = exponentiation_.visibility.emplace(tables.visibility);
  upload(exponentiation_.logarithms, std::span(visibility.logarithms));
  upload(exponentiation_.linear, std::span(visibility.linear));
  upload(exponentiation_.constants, std::span(&visibility.constants, 1));
  upload(exponentiation_.squareStarts, std::span(visibility.squareStarts));
  upload(exponentiation_.squareTerms, std::span(visibility.squareTerms));
  upload(exponentiation_.lobeSlots, std::span(tables.lobeSlots));
  upload(exponentiation_.lightLobes, std::span(tables.lightLobes));
  if (!isFirst) return;
  Receivers receivers;
  receivers.add({0, 0, 0}, {0, 1, 0});
  shadeByExponentiation({}, receivers, nullptr);
}

void KernelEngine::shadeLowOrder(std::size_t spheres, ReceiverSpan receivers,
                                 std::span<glm::vec4> radiance, StageTimes& times) {
  const std::array uploads{uploadSamples(batch_.positions, receivers.positions),
                           uploadSamples(batch_.normals, receivers.normals),
                           uploadSamples(batch_.lobes, receivers.lobes)};
  const ShexpTables& visibility = exponentiation_.visibility.value();
  const CommandSeconds shading = launchTiles(
      "shadeByExponentiation", receivers.size(),
      std::array<KernelArgument, 16>{
          batch_.positions, batch_.normals, batch_.lobes, spheres_, std::uint32_t(spheres),
          std::uint32_t(visibility.order), std::uint32_t(visibility.mostHalvings(spheres)),
          exponentiation_.logarithms, exponentiation_.linear, exponentiation_.constants,
          exponentiation_.squareStarts, exponentiation_.squareTerms,
          lobesPerReceiver(receivers.lobes), exponentiation_.lobeSlots, exponentiation_.lightLobes,
          roomFor(batch_.radiance, receivers.size(), sizeof(glm::vec4))});
  times.readBack += download(batch_.radiance, radiance)();
  for (const CommandSeconds& seconds : uploads) times.upload += seconds();
  times.fused += shading();
}

std::vector<glm::vec4> KernelEngine::shadeByExponentiation(std::span<const Sphere> spheres,
                                                           ReceiverSpan receivers,
                                                           StageTimes* times) {
  return shadeInBatches(&KernelEngine::shadeLowOrder, fusedBatch, spheres, receivers, times);
}

}  // namespace

std::unique_ptr<Engine> makeKernelEngine(std::unique_ptr<KernelDevice> device,
                                         std::shared_ptr<const SphereTable> table, FramePath path) {
  return std::make_unique<KernelEngine>(std::move(device), table.get(), path);
}

}  // namespace haarlight
