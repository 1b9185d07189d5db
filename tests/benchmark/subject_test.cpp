#include "benchmark/subject.h"

#include <doctest/doctest.h>

#include "base/error.h"

using namespace haarlight;
using namespace haarlight::benchmark;

namespace {

DeviceDescription deviceNamed(const std::string& engine, int index, const std::string& name) {
  DeviceDescription device;
  device.engine = engine;
  device.index = index;
  device.name = name;
  return device;
}

std::vector<DeviceDescription> devices() {
  std::vector<DeviceDescription> list{
      deviceNamed("reference", 0, "scalar"), deviceNamed("opencl", 0, "Some CPU"),
      deviceNamed("opencl", 1, "Old GPU"), deviceNamed("opencl", 2, "Fast GPU"),
      deviceNamed("cuda-host", 0, "the host")};
  list[2].problem = "no compiler";
  list[4].emulation = true;
  return list;
}

std::vector<std::string> namesOf(const SubjectFilter& filter) {
  std::vector<std::string> names;
  for (const Subject& subject : selectSubjects(devices(), filter, "advice"))
    names.push_back(subject.name());
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("all fast usable devices are measured, each both ways with both visibilities") {
  CHECK(namesOf({}) ==
        Names{"opencl · Some CPU · exact · fused", "opencl · Some CPU · exact · staged",
              "opencl · Some CPU · table · fused", "opencl · Some CPU · table · staged",
              "opencl · Fast GPU · exact · fused", "opencl · Fast GPU · exact · staged",
              "opencl · Fast GPU · table · fused", "opencl · Fast GPU · table · staged"});
}

TEST_CASE("engines, devices, visibilities and paths narrow the choice") {
  SubjectFilter filter;
  filter.visibilities = {VisibilityKind::table};
  filter.paths = {FramePath::fused};
  filter.device = "fast g";
  CHECK(namesOf(filter) == Names{"opencl · Fast GPU · table · fused"});
  filter.device = "0";
  CHECK(namesOf(filter) == Names{"opencl · Some CPU · table · fused"});
  filter.device = "";
  filter.engines = {"cuda-host", "reference"};
  CHECK(namesOf(filter) ==
        Names{"reference · scalar · table · staged", "cuda-host · the host · table · fused"});
}

TEST_CASE("what leaves nothing to measure is refused in words") {
  CHECK_THROWS_WITH_AS(namesOf({.engines = {"magic"}}), doctest::Contains("--engine magic"),
                       InputError);
  CHECK_THROWS_WITH_AS(namesOf({.engines = {"cuda"}}), doctest::Contains("advice"), InputError);
  CHECK_THROWS_WITH_AS(namesOf({.engines = {}, .device = "Old"}), doctest::Contains("'Old'"),
                       InputError);
}
