#include "base/error.h"
#include "engine/cuda/cuda_engine.h"

namespace haarlight {

std::vector<DeviceDescription> listCudaDevices() {
  return {};
}

std::string cudaAdvice() {
  return "this build has no CUDA engine: install the CUDA toolkit 12 or newer and build haarlight "
         "again";
}

std::unique_ptr<KernelDevice> openCudaDevice(const EngineOptions&) {
  throw InputError(cudaAdvice());
}

}  // namespace haarlight
