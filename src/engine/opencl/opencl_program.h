#pragma once

#include <map>
#include <string>

#include "engine/kernel_device.h"
#include "engine/opencl/opencl_api.h"

namespace haarlight {

/// The source every kernel is built from: constants of the host as #defines, then the files of
/// opencl/. When HAARLIGHT_KERNELS names a folder, files there take the place of the embedded ones
/// of the same name: a kernel can be tried without building the program.
std::string openClSource(const KernelShape& shape);

/// The kernels, built for one device as OpenCL C 1.1, without options that change results.
class OpenClProgram {
 public:
  /// When HAARLIGHT_DUMP_KERNELS names a file, the source is written there first. A failed build
  /// throws with the compiler's log.
  OpenClProgram(const cl::Context& context, const cl::Device& device, const KernelShape& shape);

  cl::Kernel& kernel(std::string_view name);
  const cl::Program& program() const { return program_; }
  double buildSeconds() const { return buildSeconds_; }

 private:
  cl::Program program_;
  std::map<std::string, cl::Kernel, std::less<>> kernels_;
  double buildSeconds_ = 0;
};

}  // namespace haarlight
