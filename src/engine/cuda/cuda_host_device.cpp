#include <chrono>
#include <cstring>

#include "base/parallel.h"
#include "engine/cuda/cuda_engine.h"
#include "engine/cuda/cuda_host_kernels.h"
#include "engine/cuda/host_emulation.h"
#include "engine/device_selection.h"
#include "engine/shading_tables.h"
#include "engine/shape_choice.h"

namespace haarlight {

namespace {

const char* const deviceName = "CUDA kernels compiled for the host (emulation)";

using Clock = std::chrono::steady_clock;

CommandSeconds secondsSince(Clock::time_point start) {
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return [seconds] { return seconds; };
}

/// New memory holds NaN, so that reading it before it was written shows.
struct HostBuffer final : CudaBuffer {
  explicit HostBuffer(std::size_t count) : content(count, std::byte{0xff}) {
    memory = content.data();
    bytes = count;
  }
  std::vector<std::byte> content;
};

class CudaHostDevice final : public KernelDevice {
 public:
  explicit CudaHostDevice(const KernelShape& shape) : shape_(shape) {}

  std::string engineName() const override { return "cuda-host"; }
  std::string name() const override { return deviceName; }
  std::size_t batchSize() const override { return 2048; }
  std::size_t lobeWindow() const override { return 64; }
  KernelShape shape() const override { return shape_; }

  std::unique_ptr<DeviceBuffer> allocate(std::size_t bytes) override {
    return std::make_unique<HostBuffer>(bytes);
  }

  CommandSeconds write(DeviceBuffer& buffer, std::span<const std::byte> data) override {
    const auto start = Clock::now();
    std::ranges::copy(data, memoryOf(buffer, data.size()));
    return secondsSince(start);
  }

  CommandSeconds read(const DeviceBuffer& buffer, std::span<std::byte> data) override {
    const auto start = Clock::now();
    std::copy_n(memoryOf(buffer, data.size()), data.size(), data.data());
    return secondsSince(start);
  }

  CommandSeconds launch(std::string_view kernelName, std::size_t groups,
                        std::span<const KernelArgument> arguments) override {
    const auto start = Clock::now();
    const CudaHostKernel& kernel = findKernel(cudaHostKernels(), kernelName);
    KernelCall call(kernel.signature, arguments);
    host_emulation::runBlocks(std::string(kernelName), groups,
                              {partialSums, unsigned(shape_.samplesPerGroup), 1},
                              [&] { kernel.runThread(call.values()); });
    return secondsSince(start);
  }

 private:
  KernelShape shape_;
};

}  // namespace

std::vector<DeviceDescription> listCudaHostDevices() {
  DeviceDescription host;
  host.engine = "cuda-host";
  host.name = deviceName;
  host.platform = "host";
  host.computeUnits = int(threadCount());
  host.isCpu = true;
  host.emulation = true;
  return {host};
}

std::unique_ptr<KernelDevice> openCudaHostDevice(const EngineOptions& options) {
  chooseDevice("cuda-host", {{deviceName, false, {}}}, options.device);
  const ShapeChoice choice = chooseShape(options, listCudaHostDevices().front());
  return std::make_unique<CudaHostDevice>(choice.shape);
}

}  // namespace haarlight
