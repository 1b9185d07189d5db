#include <doctest/doctest.h>

#include <array>
#include <stdexcept>

#include "base/error.h"
#include "engine/cuda/cuda_engine.h"

using namespace haarlight;

namespace {

using Arguments = std::vector<KernelArgument>;

struct HostDevice {
  std::unique_ptr<KernelDevice> device = openCudaHostDevice({});
  std::unique_ptr<DeviceBuffer> buffer = device->allocate(64);

  void launch(const char* kernel, const Arguments& arguments) {
    device->launch(kernel, 0, arguments);
  }
  Arguments transformArguments() const { return Arguments(4, buffer.get()); }
};

EngineOptions onDevice(const std::string& device) {
  EngineOptions options;
  options.device = device;
  return options;
}

EngineOptions inShape(int lanesPerItem, int samplesPerGroup) {
  EngineOptions options;
  options.lanesPerItem = lanesPerItem;
  options.samplesPerGroup = samplesPerGroup;
  return options;
}

}  // namespace

TEST_CASE("cuda-host: memory keeps what is written to it, and starts as NaN") {
  HostDevice host;
  const std::array<std::uint32_t, 2> written{7, 8};
  host.device->write(*host.buffer, std::as_bytes(std::span(written)));
  std::array<std::uint32_t, 4> found{};
  CHECK(host.device->read(*host.buffer, std::as_writable_bytes(std::span(found)))() >= 0);
  CHECK(found == std::array<std::uint32_t, 4>{7, 8, 0xffffffff, 0xffffffff});
}

TEST_CASE("cuda-host: copies beyond a buffer are faults of the program") {
  HostDevice host;
  std::array<std::byte, 65> bytes{};
  CHECK_THROWS_AS(host.device->write(*host.buffer, bytes), std::logic_error);
  CHECK_THROWS_AS(host.device->read(*host.buffer, bytes), std::logic_error);
}

TEST_CASE("cuda-host: launches with other arguments than the kernel's are faults of the program") {
  HostDevice host;
  CHECK_NOTHROW(host.launch("transformOcclusion", host.transformArguments()));
  CHECK_THROWS_WITH_AS(host.launch("noSuchKernel", {}), "no kernel is called noSuchKernel",
                       std::logic_error);

  Arguments arguments = host.transformArguments();
  arguments.pop_back();
  CHECK_THROWS_WITH_AS(host.launch("transformOcclusion", arguments),
                       "kernel transformOcclusion takes 4 arguments, not 3", std::logic_error);
  for (const KernelArgument& wrong : Arguments{std::uint32_t(1), glm::uvec4(1)}) {
    arguments = host.transformArguments();
    arguments[3] = wrong;
    CHECK_THROWS_WITH_AS(host.launch("transformOcclusion", arguments),
                         "kernel transformOcclusion: argument 3 is of the wrong kind",
                         std::logic_error);
  }
}

TEST_CASE("cuda-host is one emulated device with one lane a thread") {
  const auto devices = listCudaHostDevices();
  REQUIRE(devices.size() == 1);
  CHECK(devices[0].engine == "cuda-host");
  CHECK(devices[0].emulation);
  CHECK(devices[0].problem.empty());
  CHECK(openCudaHostDevice({})->name() == devices[0].name);

  const KernelShape shape = openCudaHostDevice(inShape(1, 8))->shape();
  CHECK(shape.lanesPerItem == 1);
  CHECK(shape.samplesPerGroup == 8);
}

TEST_CASE("cuda-host: what it does not offer is refused in words") {
  CHECK_THROWS_AS(openCudaHostDevice(onDevice("GeForce")), InputError);
  CHECK_THROWS_AS(openCudaHostDevice(onDevice("1")), InputError);
  CHECK_THROWS_AS(openCudaHostDevice(inShape(32, 0)), InputError);
  CHECK_THROWS_AS(openCudaHostDevice(inShape(0, 9)), InputError);
  CHECK_THROWS_AS(openCudaHostDevice(inShape(0, -1)), InputError);
}

TEST_CASE("without a CUDA device there is a reason in words") {
  const auto devices = listCudaDevices();
  CHECK(devices.empty() == !cudaAdvice().empty());
  if (devices.empty()) CHECK_THROWS_WITH_AS(openCudaDevice({}), cudaAdvice().c_str(), InputError);
  CHECK_THROWS_AS(openCudaDevice(onDevice("no such device")), InputError);
}
