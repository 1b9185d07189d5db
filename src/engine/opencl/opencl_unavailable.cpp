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

std::unique_ptr<Engine> makeOpenClEngine(const EngineOptions&, std::shared_ptr<const SphereTable>) {
  throw InputError(openClAdvice());
}

}  // namespace haarlight
