#include <memory>

#include "engine/cuda/cuda_check.h"
#include "engine/cuda/cuda_devices.h"
#include "engine/cuda/cuda_engine.h"
#include "engine/cuda/cuda_kernels.h"
#include "engine/shading_tables.h"
#include "engine/shape_choice.h"

namespace haarlight {

namespace {

class Event {
 public:
  Event() { HAARLIGHT_CUDA_CALL(cudaEventCreate, &event_); }
  ~Event() { cudaEventDestroy(event_); }
  Event(const Event&) = delete;
  Event& operator=(const Event&) = delete;

  void record(cudaStream_t stream) { HAARLIGHT_CUDA_CALL(cudaEventRecord, event_, stream); }
  double secondsTo(const Event& later) const {
    float milliseconds = 0;
    HAARLIGHT_CUDA_CALL(cudaEventSynchronize, later.event_);
    HAARLIGHT_CUDA_CALL(cudaEventElapsedTime, &milliseconds, event_, later.event_);
    return 1e-3 * double(milliseconds);
  }

 private:
  cudaEvent_t event_ = nullptr;
};

struct CommandEvents {
  Event begin, end;
};

struct GpuBuffer final : CudaBuffer {
  explicit GpuBuffer(std::size_t count) {
    HAARLIGHT_CUDA_CALL(cudaMalloc, &memory, count);
    bytes = count;
  }
  ~GpuBuffer() override { cudaFree(memory); }
};

class CudaDevice final : public KernelDevice {
 public:
  CudaDevice(const DeviceDescription& device, const KernelShape& shape)
      : device_(device), shape_(shape) {
    makeCurrent();
    HAARLIGHT_CUDA_CALL(cudaStreamCreate, &stream_);
  }
  ~CudaDevice() override { cudaStreamDestroy(stream_); }

  std::string engineName() const override { return "cuda"; }
  std::string name() const override { return device_.name; }
  std::size_t batchSize() const override { return 32768; }
  std::size_t lobeWindow() const override { return lobeCount; }
  KernelShape shape() const override { return shape_; }
  std::optional<std::size_t> localBytes(std::string_view kernelName) const override {
    makeCurrent();
    cudaFuncAttributes attributes{};
    HAARLIGHT_CUDA_CALL(cudaFuncGetAttributes, &attributes,
                        findKernel(cudaKernels(), kernelName).function);
    return attributes.sharedSizeBytes;
  }

  std::unique_ptr<DeviceBuffer> allocate(std::size_t bytes) override {
    makeCurrent();
    return std::make_unique<GpuBuffer>(bytes);
  }

  CommandSeconds write(DeviceBuffer& buffer, std::span<const std::byte> data) override {
    return timed([&] { copy(memoryOf(buffer, data.size()), data.data(), data.size()); });
  }

  CommandSeconds read(const DeviceBuffer& buffer, std::span<std::byte> data) override {
    return timed([&] { copy(data.data(), memoryOf(buffer, data.size()), data.size()); });
  }

  CommandSeconds launch(std::string_view kernelName, std::size_t groups,
                        std::span<const KernelArgument> arguments) override {
    const CudaKernel& kernel = findKernel(cudaKernels(), kernelName);
    KernelCall call(kernel.signature, arguments);
    return timed([&] {
      HAARLIGHT_CUDA_CALL(cudaLaunchKernel, kernel.function, dim3(unsigned(groups)),
                          dim3(partialSums, unsigned(shape_.samplesPerGroup)), call.values(), 0,
                          stream_);
    });
  }

 private:
  /// The current device belongs to the host thread, and the engine may be used from several.
  void makeCurrent() const { HAARLIGHT_CUDA_CALL(cudaSetDevice, device_.index); }

  /// Waits for the copy: only then may the host's memory be changed or read.
  void copy(void* target, const void* source, std::size_t bytes) {
    HAARLIGHT_CUDA_CALL(cudaMemcpyAsync, target, source, bytes, cudaMemcpyDefault, stream_);
    HAARLIGHT_CUDA_CALL(cudaStreamSynchronize, stream_);
  }

  template <typename Command>
  CommandSeconds timed(const Command& command) {
    makeCurrent();
    const auto events = std::make_shared<CommandEvents>();
    events->begin.record(stream_);
    command();
    events->end.record(stream_);
    return [events] { return events->begin.secondsTo(events->end); };
  }

  DeviceDescription device_;
  KernelShape shape_;
  cudaStream_t stream_ = nullptr;
};

}  // namespace

std::unique_ptr<KernelDevice> openCudaDevice(const EngineOptions& options) {
  const DeviceDescription device = chooseCudaDevice(options.device);
  return std::make_unique<CudaDevice>(device, chooseShape(options, device).shape);
}

}  // namespace haarlight
