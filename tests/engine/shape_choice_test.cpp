#include "engine/shape_choice.h"

#include <cstdlib>

#include "base/error.h"
#include "engine/cuda/cuda_engine.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

DeviceDescription device(const std::string& engine, bool isCpu) {
  DeviceDescription device;
  device.engine = engine;
  device.name = "a device";
  device.isCpu = isCpu;
  return device;
}

EngineOptions inShape(int lanesPerItem, int samplesPerGroup) {
  EngineOptions options;
  options.lanesPerItem = lanesPerItem;
  options.samplesPerGroup = samplesPerGroup;
  return options;
}

const DeviceDescription openClCpu = device("opencl", true), openClGpu = device("opencl", false);
const DeviceDescription cuda = device("cuda", false), cudaHost = device("cuda-host", true);

void checkChoice(const ShapeChoice& choice, const KernelShape& shape, ShapeSource source) {
  CHECK(nameOf(choice.shape) == nameOf(shape));
  CHECK(choice.source == source);
}

/// Sets an environment variable while it lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* now = std::getenv(name)) before_ = now;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("engines come in shapes of 1, 2, 4 and 8 samples, OpenCL in full items too") {
  CHECK(
      shapesOf("opencl") ==
      std::vector<KernelShape>{{1, 1}, {1, 2}, {1, 4}, {1, 8}, {32, 1}, {32, 2}, {32, 4}, {32, 8}});
  for (const char* engine : {"cuda", "cuda-host"})
    CHECK(shapesOf(engine) == std::vector<KernelShape>{{1, 1}, {1, 2}, {1, 4}, {1, 8}});
}

TEST_CASE("the standard shape suits the kind of device") {
  checkChoice(chooseShape({}, openClCpu, nullptr, {}), {32, 1}, ShapeSource::standard);
  for (const DeviceDescription& other : {openClGpu, cuda, cudaHost})
    checkChoice(chooseShape({}, other, nullptr, {}), {1, 4}, ShapeSource::standard);
}

TEST_CASE("options go before the environment, that before the tuned shape") {
  TunedShapes tuned;
  tuned.keep(openClCpu, KernelShape{32, 2});
  checkChoice(chooseShape({}, openClCpu, nullptr, tuned), {32, 2}, ShapeSource::tuned);
  checkChoice(chooseShape({}, openClCpu, "", tuned), {32, 2}, ShapeSource::tuned);
  checkChoice(chooseShape({}, openClGpu, "1x8", tuned), {1, 8}, ShapeSource::environment);
  checkChoice(chooseShape({}, openClCpu, "default", tuned), {32, 1}, ShapeSource::standard);
  checkChoice(chooseShape(inShape(1, 1), openClCpu, "1x8", tuned), {1, 1}, ShapeSource::options);
}

TEST_CASE("options that say a part of a shape leave the rest to what is standard") {
  TunedShapes tuned;
  tuned.keep(openClCpu, KernelShape{1, 8});
  checkChoice(chooseShape(inShape(1, 0), openClCpu, "32x4", tuned), {1, 4}, ShapeSource::options);
  checkChoice(chooseShape(inShape(0, 2), openClCpu, "32x4", tuned), {32, 2}, ShapeSource::options);
  checkChoice(chooseShape(inShape(32, 0), openClGpu, nullptr, {}), {32, 1}, ShapeSource::options);
}

TEST_CASE("shapes that kernels do not come in are refused, whoever wants them") {
  for (const auto& [lanes, samples] : {std::pair{7, 1}, {-1, 1}, {32, 9}, {1, -1}})
    CHECK_THROWS_AS(chooseShape(inShape(lanes, samples), openClCpu, nullptr, {}), InputError);
  CHECK_THROWS_AS(chooseShape(inShape(32, 0), cuda, nullptr, {}), InputError);
  for (const char* wanted : {"32", "32x", "x1", "32x1x1", "32 x 1", "7x1", "32x0", "0x0", "fast"}) {
    CAPTURE(wanted);
    CHECK_THROWS_WITH_AS(chooseShape({}, openClCpu, wanted, {}),
                         doctest::Contains("HAARLIGHT_WORK_SHAPE"), InputError);
  }
}

TEST_CASE("the environment's shape is for the devices whose kernels come in it") {
  TunedShapes tuned;
  tuned.keep(cuda, KernelShape{1, 8});
  checkChoice(chooseShape({}, openClGpu, "32x1", tuned), {32, 1}, ShapeSource::environment);
  checkChoice(chooseShape({}, cuda, "32x1", tuned), {1, 8}, ShapeSource::tuned);
  checkChoice(chooseShape({}, cudaHost, "32x1", tuned), {1, 4}, ShapeSource::standard);
}

TEST_CASE("a device is opened in the shape that was kept for it") {
  const TemporaryFolder folder;
  const Variable cache("HAARLIGHT_CACHE_DIR", folder.path());
  TunedShapes tuned;
  tuned.keep(listCudaHostDevices().front(), KernelShape{1, 2});
  tuned.write(folder.path());
  CHECK(openCudaHostDevice({})->shape() == KernelShape{1, 2});
  CHECK(makeEngine({.engine = "cuda-host"}, nullptr)->deviceUse().itemsPerGroup == 2 * 32);
  CHECK(openCudaHostDevice(inShape(0, 8))->shape() == KernelShape{1, 8});
  {
    const Variable shape(shapeVariable, "1x1");
    CHECK(openCudaHostDevice({})->shape() == KernelShape{1, 1});
  }
  const Variable shape(shapeVariable, "default");
  CHECK(openCudaHostDevice({})->shape() == KernelShape{1, 4});
}

TEST_CASE("opening a device tells of a file of tuned shapes that is ignored") {
  const TemporaryFolder folder;
  const Variable cache("HAARLIGHT_CACHE_DIR", folder.path());
  writeFile(tunedShapesFile(folder.path()), "foreign");
  std::vector<std::string> warnings;
  EngineOptions options;
  options.onWarning = [&](const std::string& warning) { warnings.push_back(warning); };
  CHECK(openCudaHostDevice(options)->shape() == KernelShape{1, 4});
  CHECK(warnings.size() == 1);
  CHECK(openCudaHostDevice({})->shape() == KernelShape{1, 4});
}
