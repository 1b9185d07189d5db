#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cube/bit_cube.h"
#include "engine/exponentiation_tables.h"
#include "engine/receivers.h"
#include "engine/shading_tables.h"
#include "engine/stage_times.h"
#include "engine/transfer_tables.h"
#include "haar/occlusion_transform.h"
#include "visibility/sphere.h"
#include "visibility/sphere_binding.h"
#include "visibility/sphere_table.h"

namespace haarlight {

/// What an engine takes of its device.
struct DeviceUse {
  /// Bytes of device memory that are allocated now; 0 for engines on the host.
  std::uint64_t memoryBytes = 0;
  /// Work-items (CUDA: threads) of a work-group; 0 for engines without.
  int itemsPerGroup = 0;
  struct Kernel {
    std::string name;
    /// Bytes of local (CUDA: shared) memory of a work-group.
    std::uint64_t localBytes;
  };
  /// Kernels whose local memory the device tells.
  std::vector<Kernel> kernels;
};

/// One implementation of the steps of a frame (method.md §2, steps 4–7), on one device.
///
/// moving:         vertex positions → spheres (scenes that deform)
/// merge:          spheres and sample positions → bit cubes
/// transform:      bit cubes → occlusion in the Haar basis
/// triple product: occlusion, light, lobes → radiance
///
/// shade() runs all three without anything leaving the device in between, as three kernels or fused
/// into one. shadeByExponentiation() shades the same samples by spherical harmonics instead, and
/// shadeByTransfer() vertices whose light was precomputed. The other calls run single steps and
/// bring their results back, so that engines can be compared stage by stage (verify/). All engines
/// give the same bits (docs/numerics.md).
class Engine {
 public:
  virtual ~Engine() = default;

  /// "reference", "opencl", …
  virtual std::string name() const = 0;
  /// The device it runs on, in words.
  virtual std::string deviceName() const = 0;

  /// Why its results may differ from the reference's in the last bits, in words; empty when nothing
  /// is known that would (docs/numerics.md).
  virtual std::string numericLimitation() const { return {}; }

  /// Seconds spent on compiling kernels when the engine was made, 0 when nothing is compiled.
  virtual double preparationSeconds() const { return 0; }

  virtual DeviceUse deviceUse() const { return {}; }

  /// Sets light, lobes and terms for the following tripleProduct() and shade() calls.
  virtual void setShading(const ShadingTables& tables) = 0;

  /// Sets what the spheres of the following moveSpheres() calls follow.
  virtual void setSphereBinding(const SphereBinding& binding) = 0;
  /// The bound spheres when the vertices are at `positions` (x, y, z, any): step 4 of a frame.
  virtual std::vector<Sphere> moveSpheres(std::span<const glm::vec4> positions) = 0;

  /// Entry of the sphere table that each sphere falls into (visibility/sphere_bin.h), seen from
  /// each receiver: receiver · spheres + sphere. The table itself is not needed.
  virtual std::vector<std::uint32_t> sphereTableEntries(std::span<const Sphere> spheres,
                                                        ReceiverSpan receivers) = 0;
  virtual std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                             ReceiverSpan receivers) = 0;
  virtual std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) = 0;

  /// Radiance (RGB, 0) of white receivers with these occlusions and lobes.
  virtual std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                               std::span<const LobeBlend> lobes) = 0;

  /// How the following shade() calls compute; an engine with one path ignores it.
  virtual void setFramePath(FramePath) {}

  /// Radiance (RGB, 0) of white receivers: multiply by the albedo.
  virtual std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                                       StageTimes* times = nullptr) = 0;

  /// Sets order, light and lobes for the following shadeByExponentiation() calls.
  virtual void setExponentiation(const ExponentiationTables& tables) = 0;

  /// Radiance (RGB, 0) of white receivers whose visibility past all spheres is a function of low
  /// order, by spherical-harmonic exponentiation.
  virtual std::vector<glm::vec4> shadeByExponentiation(std::span<const Sphere> spheres,
                                                       ReceiverSpan receivers,
                                                       StageTimes* times = nullptr) = 0;

  /// Sets the rows of transfer of the following shadeByTransfer() calls, and the lights, which may
  /// change while the rows stay.
  virtual void setTransferRows(const TransferRows& rows) = 0;
  virtual void setTransferLights(const TransferLights& lights) = 0;

  /// Radiance (RGB, 0) by precomputed diffuse transfer; what the rows hold, such as the albedo, is
  /// in it. Throws std::invalid_argument as requireTransfer() does.
  virtual std::vector<glm::vec4> shadeByTransfer(const TransferReceivers& receivers,
                                                 StageTimes* times = nullptr) = 0;
};

/// The scalar engine: one thread, written to be read beside the paper. Without a table its
/// visibility is exact.
std::unique_ptr<Engine> makeReferenceEngine(std::shared_ptr<const SphereTable> table);

}  // namespace haarlight
