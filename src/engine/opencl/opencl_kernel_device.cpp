#include <algorithm>
#include <map>
#include <stdexcept>

#include "engine/opencl/opencl_devices.h"
#include "engine/opencl/opencl_engine.h"
#include "engine/opencl/opencl_program.h"
#include "engine/shading_tables.h"
#include "engine/shape_choice.h"

namespace haarlight {

namespace {

/// Receivers worked on at a time, in the shape for CPUs and in that for GPUs: their intermediate
/// results (3.6 KB each) stay in the caches of a CPU, and a GPU still has enough to do.
constexpr std::size_t cpuBatch = 2048, gpuBatch = 32768;
/// 18 MiB, which a CPU's caches hold; on GPUs all lobes, 125 MiB.
constexpr std::size_t cpuLobeWindow = 256, gpuLobeWindow = lobeCount;

struct OpenClBuffer final : DeviceBuffer {
  cl::Buffer memory;
};

const cl::Buffer& memoryOf(const DeviceBuffer& buffer) {
  return static_cast<const OpenClBuffer&>(buffer).memory;
}

CommandSeconds secondsOf(const cl::Event& event) {
  return [event] {
    return 1e-9 * double(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                         event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
  };
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

class OpenClKernelDevice final : public KernelDevice {
 public:
  OpenClKernelDevice(const OpenClDevice& device, const KernelShape& shape)
      : device_(device),
        shape_(shape),
        context_(device.device),
        queue_(context_, device.device, CL_QUEUE_PROFILING_ENABLE),
        program_(context_, device.device, shape) {}

  std::string engineName() const override { return "opencl"; }
  std::string name() const override { return device_.name + " (" + device_.platform + ")"; }
  std::string numericLimitation() const override { return device_.numericLimitation; }
  double buildSeconds() const override { return program_.buildSeconds(); }
  std::size_t batchSize() const override { return shape_.lanesPerItem > 1 ? cpuBatch : gpuBatch; }
  std::size_t lobeWindow() const override {
    return shape_.lanesPerItem > 1 ? cpuLobeWindow : gpuLobeWindow;
  }
  KernelShape shape() const override { return shape_; }
  std::optional<std::size_t> localBytes(std::string_view kernelName) const override {
    return inWords([&]() -> std::optional<std::size_t> {
      const cl::Kernel kernel(program_.program(), std::string(kernelName).c_str());
      return std::size_t(kernel.getWorkGroupInfo<CL_KERNEL_LOCAL_MEM_SIZE>(device_.device));
    });
  }

  std::unique_ptr<DeviceBuffer> allocate(std::size_t bytes) override {
    return inWords([&] {
      auto buffer = std::make_unique<OpenClBuffer>();
      buffer->memory = cl::Buffer(context_, CL_MEM_READ_WRITE, bytes);
      return buffer;
    });
  }

  CommandSeconds write(DeviceBuffer& buffer, std::span<const std::byte> data) override {
    if (data.empty()) return [] { return 0.0; };
    return inWords([&] {
      cl::Event event;
      queue_.enqueueWriteBuffer(memoryOf(buffer), CL_TRUE, 0, data.size(), data.data(), nullptr,
                                &event);
      return secondsOf(event);
    });
  }

  CommandSeconds read(const DeviceBuffer& buffer, std::span<std::byte> data) override {
    return inWords([&] {
      cl::Event event;
      queue_.enqueueReadBuffer(memoryOf(buffer), CL_TRUE, 0, data.size(), data.data(), nullptr,
                               &event);
      return secondsOf(event);
    });
  }

  CommandSeconds launch(std::string_view kernelName, std::size_t groups,
                        std::span<const KernelArgument> arguments) override {
    return inWords([&] {
      cl::Kernel& kernel = program_.kernel(kernelName);
      for (cl_uint i = 0; i < arguments.size(); ++i) setArgument(kernel, i, arguments[i]);
      const cl::NDRange group(std::size_t(partialSums / shape_.lanesPerItem),
                              std::size_t(shape_.samplesPerGroup));
      cl::Event event;
      queue_.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(group[0], group[1] * groups),
                                  group, nullptr, &event);
      return secondsOf(event);
    });
  }

 private:
  static void setArgument(cl::Kernel& kernel, cl_uint index, const KernelArgument& argument) {
    if (const auto* buffer = std::get_if<const DeviceBuffer*>(&argument))
      kernel.setArg(index, memoryOf(**buffer));
    else if (const auto* number = std::get_if<std::uint32_t>(&argument))
      kernel.setArg(index, cl_uint(*number));
    else
      kernel.setArg(index, sizeof(glm::uvec4), &std::get<glm::uvec4>(argument));
  }

  OpenClDevice device_;
  KernelShape shape_;
  cl::Context context_;
  cl::CommandQueue queue_;
  OpenClProgram program_;
};

}  // namespace

std::unique_ptr<KernelDevice> openOpenClDevice(const EngineOptions& options) {
  return inWords([&]() -> std::unique_ptr<KernelDevice> {
    const OpenClDevice device = chooseOpenClDevice(options.device);
    return std::make_unique<OpenClKernelDevice>(device,
                                                chooseShape(options, describe(device)).shape);
  });
}

}  // namespace haarlight
