#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "engine/kernel_shape.h"

namespace haarlight {

/// Memory of a KernelDevice.
class DeviceBuffer {
 public:
  virtual ~DeviceBuffer() = default;
};

/// What a kernel takes: a buffer, `uint` or `uint4`.
using KernelArgument = std::variant<const DeviceBuffer*, std::uint32_t, glm::uvec4>;

/// Seconds a command took on the device; to be called after a read() that followed the command.
using CommandSeconds = std::function<double()>;

/// Samples that an item with all lanes works on at a time where kernels merge.
inline constexpr int tileSamples = 16;

/// The kernels of every device.
inline constexpr std::array<std::string_view, 12> kernelNames{
    "moveSpheres",        "sphereTableEntries",    "mergeBitCubes",   "mergeBitCubesExactly",
    "transformOcclusion", "tripleProduct",         "spreadWeights",   "shadeByTable",
    "shadeExactly",       "shadeByExponentiation", "shadeByTransfer", "shadeByFourCoefficients"};

/// What the kernel engine (kernel_engine.h) needs of a compute API: memory, copies and launches, in
/// order. One implementation per API; the kernels of all of them have the same names, arguments and
/// results.
class KernelDevice {
 public:
  virtual ~KernelDevice() = default;

  /// Name of the engine: "opencl", "cuda" or "cuda-host".
  virtual std::string engineName() const = 0;
  /// The device, in words.
  virtual std::string name() const = 0;
  /// Why its results may differ from the reference's in the last bits, in words; empty when nothing
  /// is known that would (docs/numerics.md).
  virtual std::string numericLimitation() const { return {}; }
  /// Seconds spent on building the kernels.
  virtual double buildSeconds() const { return 0; }
  /// Receivers to work on at a time.
  virtual std::size_t batchSize() const = 0;
  /// Lobes to keep the weights of all texels of, 72 KiB each.
  virtual std::size_t lobeWindow() const = 0;
  virtual KernelShape shape() const = 0;
  /// Bytes of local (CUDA: shared) memory that a work-group of a kernel takes; nothing where the
  /// API does not say.
  virtual std::optional<std::size_t> localBytes(std::string_view /*kernel*/) const {
    return std::nullopt;
  }

  virtual std::unique_ptr<DeviceBuffer> allocate(std::size_t bytes) = 0;
  /// Copies to the start of the buffer. The data may be changed after the call.
  virtual CommandSeconds write(DeviceBuffer& buffer, std::span<const std::byte> data) = 0;
  /// Copies from the start of the buffer, after all earlier commands.
  virtual CommandSeconds read(const DeviceBuffer& buffer, std::span<std::byte> data) = 0;
  /// Runs a kernel on `groups` work-groups of the device's shape.
  virtual CommandSeconds launch(std::string_view kernel, std::size_t groups,
                                std::span<const KernelArgument> arguments) = 0;
};

}  // namespace haarlight
