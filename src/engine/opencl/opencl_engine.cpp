#include "engine/opencl/opencl_engine.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "engine/opencl/opencl_devices.h"
#include "engine/opencl/opencl_program.h"

namespace haarlight {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double seconds(const cl::Event& event) {
  return 1e-9 * double(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                       event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
}

/// Device memory that grows to what is asked of it and is kept.
class GrowingBuffer {
 public:
  cl::Buffer& atLeast(const cl::Context& context, std::size_t bytes) {
    bytes = std::max<std::size_t>(bytes, 16);
    if (bytes > size_) {
      buffer_ = cl::Buffer(context, CL_MEM_READ_WRITE, bytes);
      size_ = bytes;
    }
    return buffer_;
  }
  const cl::Buffer& get() const { return buffer_; }

 private:
  cl::Buffer buffer_;
  std::size_t size_ = 0;
};

/// Tables of one light on the device, in the order of the kernel's arguments.
struct DeviceTables {
  int levels = 2;
  cl_uint4 lightListEnds{};
  GrowingBuffer lobeSlots, lightPlaces, lightCoefficients, lightWeights;
  GrowingBuffer lobeListStarts, lobePlaces, lobeValues, lightMeans, unshadowed;
};

/// What one batch of receivers passes from kernel to kernel.
struct BatchBuffers {
  GrowingBuffer positions, normals, lobes, bitCubes, coefficients, means, blocks, radiance;
};

class OpenClEngine final : public Engine {
 public:
  OpenClEngine(const OpenClDevice& device, int lanesPerItem, const SphereTable* table);

  std::string name() const override { return "opencl"; }
  std::string deviceName() const override { return device_.name + " (" + device_.platform + ")"; }
  double preparationSeconds() const override { return preparationSeconds_; }

  void setShading(const ShadingTables& tables) override;
  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override;
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override;
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override;

 private:
  template <typename Element>
  cl::Event upload(GrowingBuffer& buffer, std::span<const Element> data);
  template <typename Element>
  cl::Event download(const GrowingBuffer& buffer, std::span<Element> data);

  cl::Event launch(cl::Kernel& kernel, std::size_t samples);
  cl::Event launchMerge(std::span<const Sphere> spheres, std::size_t samples);
  cl::Event launchTransform(std::size_t samples);
  cl::Event launchTripleProduct(std::span<const LobeBlend> lobes);
  void shadeBatch(std::span<const Sphere> spheres, ReceiverSpan receivers,
                  std::span<glm::vec4> radiance, StageTimes& times);
  void warmUp();

  OpenClDevice device_;
  int lanesPerItem_;
  bool usesTable_;
  cl::Context context_;
  cl::CommandQueue queue_;
  cl::Kernel merge_, transform_, tripleProduct_;
  GrowingBuffer sphereTable_, occupiedFaces_, blockTable_, spheres_;
  BatchBuffers batch_;
  DeviceTables tables_;
  double preparationSeconds_ = 0;
};

/// Receivers worked on at a time: their intermediate results (3.6 KB each) stay in the caches of a
/// CPU, and a GPU still has enough to do.
constexpr std::size_t cpuBatch = 2048, gpuBatch = 32768;

OpenClEngine::OpenClEngine(const OpenClDevice& device, int lanesPerItem, const SphereTable* table)
    : device_(device),
      lanesPerItem_(lanesPerItem),
      usesTable_(table != nullptr),
      context_(device.device),
      queue_(context_, device.device, CL_QUEUE_PROFILING_ENABLE) {
  if (table) {
    upload(sphereTable_, table->words());
    upload(occupiedFaces_, table->occupiedFaces());
  }
  upload(blockTable_, std::span(blockTable()));
  const auto start = Clock::now();
  const cl::Program program = buildOpenClProgram(context_, device.device, lanesPerItem);
  merge_ = cl::Kernel(program, table ? "mergeBitCubes" : "mergeBitCubesExactly");
  transform_ = cl::Kernel(program, "transformOcclusion");
  tripleProduct_ = cl::Kernel(program, "tripleProduct");
  warmUp();
  preparationSeconds_ = secondsSince(start);
}

/// Some drivers (PoCL) compile a kernel when it is first launched.
void OpenClEngine::warmUp() {
  Receivers receivers;
  receivers.add({0, 0, 0}, {0, 1, 0});
  setShading(buildShadingTables(RadianceCube{}, {0, 2}, countLobes(receivers.lobes)));
  const Sphere sphere{{0, 2, 0}, 1};
  shade(std::span(&sphere, 1), receivers, nullptr);
}

template <typename Element>
cl::Event OpenClEngine::upload(GrowingBuffer& buffer, std::span<const Element> data) {
  cl::Event event;
  buffer.atLeast(context_, data.size_bytes());
  if (!data.empty())
    queue_.enqueueWriteBuffer(buffer.get(), CL_TRUE, 0, data.size_bytes(), data.data(), nullptr,
                              &event);
  return event;
}

template <typename Element>
cl::Event OpenClEngine::download(const GrowingBuffer& buffer, std::span<Element> data) {
  cl::Event event;
  queue_.enqueueReadBuffer(buffer.get(), CL_TRUE, 0, data.size_bytes(), data.data(), nullptr,
                           &event);
  return event;
}

cl::Event OpenClEngine::launch(cl::Kernel& kernel, std::size_t samples) {
  const std::size_t itemsPerGroup = partialSums / lanesPerItem_;
  cl::Event event;
  queue_.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(samples * itemsPerGroup),
                              cl::NDRange(itemsPerGroup), nullptr, &event);
  return event;
}

cl::Event OpenClEngine::launchMerge(std::span<const Sphere> spheres, std::size_t samples) {
  batch_.bitCubes.atLeast(context_, samples * sizeof(BitCube));
  cl_uint argument = 0;
  merge_.setArg(argument++, batch_.positions.get());
  merge_.setArg(argument++, batch_.normals.get());
  merge_.setArg(argument++, spheres_.get());
  merge_.setArg(argument++, cl_uint(spheres.size()));
  if (usesTable_) {
    merge_.setArg(argument++, sphereTable_.get());
    merge_.setArg(argument++, occupiedFaces_.get());
  }
  merge_.setArg(argument++, batch_.bitCubes.get());
  return launch(merge_, samples);
}

cl::Event OpenClEngine::launchTransform(std::size_t samples) {
  cl_uint argument = 0;
  transform_.setArg(argument++, batch_.bitCubes.get());
  transform_.setArg(argument++, blockTable_.get());
  transform_.setArg(argument++, batch_.coefficients.atLeast(
                                    context_, samples * sizeof(OcclusionHaar::coefficients)));
  transform_.setArg(argument++,
                    batch_.means.atLeast(context_, samples * sizeof(OcclusionHaar::means)));
  transform_.setArg(argument++,
                    batch_.blocks.atLeast(context_, samples * sizeof(OcclusionHaar::blocks)));
  return launch(transform_, samples);
}

cl::Event OpenClEngine::launchTripleProduct(std::span<const LobeBlend> lobes) {
  const bool single =
      std::ranges::all_of(lobes, [](const LobeBlend& b) { return b.weights[1] == 0; });
  cl_uint argument = 0;
  tripleProduct_.setArg(argument++, batch_.coefficients.get());
  tripleProduct_.setArg(argument++, batch_.means.get());
  tripleProduct_.setArg(argument++, batch_.blocks.get());
  tripleProduct_.setArg(argument++, blockTable_.get());
  tripleProduct_.setArg(argument++, batch_.lobes.get());
  tripleProduct_.setArg(argument++, cl_uint(single ? 1 : 3));
  tripleProduct_.setArg(argument++, cl_uint(tables_.levels));
  tripleProduct_.setArg(argument++, tables_.lobeSlots.get());
  tripleProduct_.setArg(argument++, tables_.lightListEnds);
  for (const GrowingBuffer* table :
       {&tables_.lightPlaces, &tables_.lightCoefficients, &tables_.lightWeights,
        &tables_.lobeListStarts, &tables_.lobePlaces, &tables_.lobeValues, &tables_.lightMeans,
        &tables_.unshadowed})
    tripleProduct_.setArg(argument++, table->get());
  tripleProduct_.setArg(argument++,
                        batch_.radiance.atLeast(context_, lobes.size() * sizeof(glm::vec4)));
  return launch(tripleProduct_, lobes.size());
}

void OpenClEngine::setShading(const ShadingTables& tables) {
  tables_.levels = tables.settings.levels;
  const auto& ends = tables.lightListEnds;
  tables_.lightListEnds = {{ends[coarseTerm], ends[blockTerm], ends[quarterTerm], 0}};
  upload(tables_.lobeSlots, std::span(tables.lobeSlots));
  upload(tables_.lightPlaces, std::span(tables.lightPlaces));
  upload(tables_.lightCoefficients, std::span(tables.lightCoefficients));
  upload(tables_.lightWeights, std::span(tables.lightWeights));
  upload(tables_.lobeListStarts, std::span(tables.lobeListStarts));
  upload(tables_.lobePlaces, std::span(tables.lobePlaces));
  upload(tables_.lobeValues, std::span(tables.lobeValues));
  upload(tables_.lightMeans, std::span(tables.lightMeans));
  upload(tables_.unshadowed, std::span(tables.unshadowed));
}

std::vector<BitCube> OpenClEngine::mergeBitCubes(std::span<const Sphere> spheres,
                                                 ReceiverSpan receivers) {
  std::vector<BitCube> cubes(receivers.size());
  if (cubes.empty()) return cubes;
  upload(spheres_, spheres);
  upload(batch_.positions, receivers.positions);
  upload(batch_.normals, receivers.normals);
  launchMerge(spheres, receivers.size());
  download(batch_.bitCubes, std::span(cubes));
  return cubes;
}

std::vector<OcclusionHaar> OpenClEngine::transformOcclusion(std::span<const BitCube> cubes) {
  std::vector<OcclusionHaar> occlusion(cubes.size());
  if (cubes.empty()) return occlusion;
  upload(batch_.bitCubes, cubes);
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

void OpenClEngine::shadeBatch(std::span<const Sphere> spheres, ReceiverSpan receivers,
                              std::span<glm::vec4> radiance, StageTimes& times) {
  times.upload += seconds(upload(batch_.positions, receivers.positions));
  times.upload += seconds(upload(batch_.normals, receivers.normals));
  times.upload += seconds(upload(batch_.lobes, receivers.lobes));
  const cl::Event merge = launchMerge(spheres, receivers.size());
  const cl::Event transform = launchTransform(receivers.size());
  const cl::Event product = launchTripleProduct(receivers.lobes);
  times.readBack += seconds(download(batch_.radiance, radiance));
  times.merge += seconds(merge);
  times.transform += seconds(transform);
  times.tripleProduct += seconds(product);
}

std::vector<glm::vec4> OpenClEngine::shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                                           StageTimes* times) {
  StageTimes ignored;
  StageTimes& stages = times ? *times : ignored;
  const auto start = Clock::now();
  upload(spheres_, spheres);
  std::vector<glm::vec4> radiance(receivers.size());
  const std::size_t batch = device_.isCpu ? cpuBatch : gpuBatch;
  for (std::size_t first = 0; first < receivers.size(); first += batch) {
    const std::size_t count = std::min(batch, receivers.size() - first);
    shadeBatch(spheres, receivers.part(first, count), std::span(radiance).subspan(first, count),
               stages);
  }
  stages.total += secondsSince(start);
  return radiance;
}

/// OpenCL errors in words: the call's name and the code.
template <typename Action>
auto inWords(const Action& action) {
  try {
    return action();
  } catch (const cl::Error& error) {
    throw std::runtime_error(std::string("OpenCL call ") + error.what() + " failed with error " +
                             std::to_string(error.err()));
  }
}

}  // namespace

std::unique_ptr<Engine> makeOpenClEngine(const EngineOptions& options,
                                         std::shared_ptr<const SphereTable> table) {
  return inWords([&]() -> std::unique_ptr<Engine> {
    const OpenClDevice device = chooseOpenClDevice(options.device);
    const int lanes = options.lanesPerItem ? options.lanesPerItem : device.isCpu ? partialSums : 1;
    return std::make_unique<OpenClEngine>(device, lanes, table.get());
  });
}

}  // namespace haarlight
