#include "base/error.h"
#include "engine/opencl/opencl_engine.h"

namespace haarlight {

std::vector<DeviceDescription> listOpenClDevices() {
  return {};
}

std::string openClAdvice() {
  return "this haarlight was built without OpenCL: install opencl-headers and ocl-icd-opencl-dev "
         "and build it again";
}

std::unique_ptr<KernelDevice> openOpenClDevice(const EngineOptions&) {
  throw InputError(openClAdvice());
}

}  // namespace haarlight
