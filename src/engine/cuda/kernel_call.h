#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/kernel_device.h"

namespace haarlight {

/// Memory that CUDA kernels see, of a GPU or of the host that stands in for it.
struct CudaBuffer : DeviceBuffer {
  void* memory = nullptr;
  std::size_t bytes = 0;
};

/// Memory for `count` bytes. Throws std::logic_error when the buffer is smaller.
std::byte* memoryOf(const DeviceBuffer& buffer, std::size_t count);

/// What a parameter of a kernel takes, as the alternatives of KernelArgument.
enum class ParameterKind { buffer, number, fourNumbers };

struct KernelSignature {
  std::string_view name;
  std::vector<ParameterKind> parameters;
};

template <typename Parameter>
constexpr ParameterKind parameterKind() {
  if constexpr (std::is_pointer_v<Parameter>) {
    return ParameterKind::buffer;
  } else if constexpr (std::is_same_v<Parameter, std::uint32_t>) {
    return ParameterKind::number;
  } else {
    static_assert(std::is_class_v<Parameter> && sizeof(Parameter) == sizeof(glm::uvec4),
                  "kernels take pointers, uint and uint4");
    return ParameterKind::fourNumbers;
  }
}

template <typename... Parameters>
KernelSignature kernelSignature(std::string_view name, void (*)(Parameters...)) {
  return {name, {parameterKind<Parameters>()...}};
}

/// Arguments of one launch as cudaLaunchKernel takes them: the addresses of their values.
class KernelCall {
 public:
  /// Throws std::logic_error when number or kinds of the arguments are not the kernel's.
  KernelCall(const KernelSignature& signature, std::span<const KernelArgument> arguments);
  KernelCall(const KernelCall&) = delete;
  KernelCall& operator=(const KernelCall&) = delete;

  void** values() { return addresses_.data(); }

 private:
  struct alignas(16) Value {
    std::array<std::byte, sizeof(glm::uvec4)> bytes;
  };
  std::vector<Value> values_;
  std::vector<void*> addresses_;
};

[[noreturn]] void throwUnknownKernel(std::string_view name);

/// The kernel called `name` in a list of structs with a `signature`. Throws std::logic_error when
/// there is none.
template <typename Kernel>
const Kernel& findKernel(const std::vector<Kernel>& kernels, std::string_view name) {
  for (const Kernel& kernel : kernels)
    if (kernel.signature.name == name) return kernel;
  throwUnknownKernel(name);
}

}  // namespace haarlight
