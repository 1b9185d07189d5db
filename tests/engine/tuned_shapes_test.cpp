#include "engine/tuned_shapes.h"

#include "base/error.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

DeviceDescription deviceCalled(const std::string& engine, const std::string& name,
                               const std::string& driver) {
  DeviceDescription device;
  device.engine = engine;
  device.name = name;
  device.driver = driver;
  return device;
}

const DeviceDescription cpu = deviceCalled("opencl", "Some CPU", "3.1");
const DeviceDescription gpu = deviceCalled("cuda", "Fast GPU\twith\na strange näme", "CUDA 13.0");
const DeviceDescription host = deviceCalled("cuda-host", "the host", "");

TunedShapes shapesOfThree() {
  TunedShapes shapes;
  shapes.keep(cpu, KernelShape{32, 2});
  shapes.keep(gpu, KernelShape{1, 8});
  shapes.keep(host, KernelShape{1, 1});
  return shapes;
}

/// What read() finds and says.
struct Reading {
  explicit Reading(const std::filesystem::path& folder)
      : shapes(TunedShapes::read(folder, [this](const std::string& w) { warnings.push_back(w); })) {
  }
  std::vector<std::string> warnings;
  TunedShapes shapes;

  bool isEmpty() const { return !shapes.find(cpu) && !shapes.find(gpu) && !shapes.find(host); }
};

const std::string goodFile = "haarlight work shapes 1\nopencl\tSome CPU\t3.1\t32\t2\nend\n";

void checkIgnored(const std::string& content, const std::string& reason) {
  CAPTURE(content);
  const TemporaryFolder folder;
  writeFile(tunedShapesFile(folder.path()), content);
  const Reading reading(folder.path());
  CHECK(reading.isEmpty());
  REQUIRE(reading.warnings.size() == 1);
  CHECK(reading.warnings[0].starts_with(tunedShapesFile(folder.path()).string()));
  CHECK(reading.warnings[0].find(reason) != std::string::npos);
}

std::string withLine(const std::string& line) {
  return "haarlight work shapes 1\n" + line + "\nend\n";
}

}  // namespace

TEST_CASE("tuned shapes come back from their file") {
  const TemporaryFolder folder;
  shapesOfThree().write(folder / "made");
  const Reading reading(folder / "made");
  CHECK(reading.warnings.empty());
  CHECK(reading.shapes.find(cpu) == KernelShape{32, 2});
  CHECK(reading.shapes.find(gpu) == KernelShape{1, 8});
  CHECK(reading.shapes.find(host) == KernelShape{1, 1});
}

TEST_CASE("tuned shapes are of one engine, device and driver version") {
  const TunedShapes shapes = shapesOfThree();
  CHECK_FALSE(shapes.find(deviceCalled("cuda", "Some CPU", "3.1")));
  CHECK_FALSE(shapes.find(deviceCalled("opencl", "Some CPU 2", "3.1")));
  CHECK_FALSE(shapes.find(deviceCalled("opencl", "Some CPU", "3.2")));
  CHECK_FALSE(shapes.find(deviceCalled("cuda", "Fast GPU with a strange näme", "CUDA 13.0")));
}

TEST_CASE("a tuned shape replaces the one before; none forgets it") {
  TunedShapes shapes = shapesOfThree();
  shapes.keep(cpu, KernelShape{1, 4});
  CHECK(shapes.find(cpu) == KernelShape{1, 4});
  shapes.keep(cpu, std::nullopt);
  CHECK_FALSE(shapes.find(cpu));
  CHECK(shapes.find(host) == KernelShape{1, 1});
}

TEST_CASE("the file of tuned shapes is text with a line for each device") {
  const TemporaryFolder folder;
  TunedShapes shapes;
  shapes.keep(cpu, KernelShape{32, 2});
  shapes.write(folder.path());
  CHECK(readFile(tunedShapesFile(folder.path())) == goodFile);
}

TEST_CASE("without a file there are no tuned shapes, and nothing is said") {
  const TemporaryFolder folder;
  for (const auto& place : {folder.path(), folder / "no folder", std::filesystem::path()}) {
    const Reading reading(place);
    CHECK(reading.isEmpty());
    CHECK(reading.warnings.empty());
  }
}

TEST_CASE("a file of tuned shapes that is foreign, newer or damaged is ignored with a warning") {
  checkIgnored("", "no list of tuned work shapes");
  checkIgnored("{\"shapes\": []}\n", "no list of tuned work shapes");
  checkIgnored(std::string("\0\xff\x80\n", 4), "no list of tuned work shapes");
  checkIgnored("haarlight work shapes 2\nopencl 32x1\n", "newer haarlight");
  for (const char* version : {"", "0", "01", "-1", "1 ", "one", "99999999999"})
    checkIgnored(std::string("haarlight work shapes ") + version + "\nend\n", "damaged");
  checkIgnored(goodFile + "more\n", "damaged");
  for (const char* line : {"", "opencl\tSome CPU\t3.1\t32", "opencl\tSome CPU\t3.1\t32\t2\t1",
                           "opencl Some CPU 3.1 32 2", "opencl\tSome CPU\t3.1\t7\t2",
                           "opencl\tSome CPU\t3.1\t32\t9", "opencl\tSome CPU\t3.1\t32\t0",
                           "opencl\tSome CPU\t3.1\t-1\t2", "opencl\tSome CPU\t3.1\t32\t",
                           "opencl\tSome CPU\t3.1\t32\t2x", "cuda\tFast GPU\tCUDA 13.0\t32\t1"})
    checkIgnored(withLine(line), "damaged");
}

TEST_CASE("a file of tuned shapes that was cut anywhere is ignored") {
  for (std::size_t size = 0; size < goodFile.size(); ++size)
    checkIgnored(goodFile.substr(0, size), "is ignored");
}

TEST_CASE("what is no readable file of tuned shapes is ignored with a warning") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(tunedShapesFile(folder.path()));
  const Reading reading(folder.path());
  CHECK(reading.isEmpty());
  CHECK(reading.warnings.size() == 1);
  checkIgnored(goodFile + std::string(2 << 20, '\n'), "larger than");
}

TEST_CASE("a damaged file of tuned shapes is written anew") {
  const TemporaryFolder folder;
  writeFile(tunedShapesFile(folder.path()), "damaged");
  shapesOfThree().write(folder.path());
  const Reading reading(folder.path());
  CHECK(reading.warnings.empty());
  CHECK(reading.shapes.find(gpu) == KernelShape{1, 8});
}

TEST_CASE("tuned shapes that cannot be written are refused in words") {
  const TemporaryFolder folder;
  writeFile(folder / "file", "");
  CHECK_THROWS_AS(shapesOfThree().write(folder / "file"), InputError);
}
