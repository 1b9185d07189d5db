#include "engine/device_selection.h"

#include <doctest/doctest.h>

#include "base/error.h"

using namespace haarlight;

namespace {

const std::vector<DeviceChoice> devices{{"Ryzen CPU", true, ""},
                                        {"Old GPU", false, "it is too old"},
                                        {"Fast GPU", false, ""},
                                        {"Faster GPU", false, ""}};

std::size_t choose(const std::string& selector) {
  return chooseDevice("OpenCL", devices, selector);
}

}  // namespace

TEST_CASE("without a selector the first usable device is chosen, GPUs first") {
  CHECK(choose("") == 2);
  CHECK(chooseDevice("OpenCL", {devices[1], devices[0]}, "") == 1);
}

TEST_CASE("a device is chosen by its number or a part of its name") {
  CHECK(choose("0") == 0);
  CHECK(choose("3") == 3);
  CHECK(choose("fast gpu") == 2);
  CHECK(choose("FASTER") == 3);
}

TEST_CASE("a device that is not there or not usable is refused in words") {
  CHECK_THROWS_WITH_AS(choose("4"),
                       "no OpenCL device is called or numbered '4'; `haarlight devices` lists them",
                       InputError);
  CHECK_THROWS_AS(choose("GeForce"), InputError);
  CHECK_THROWS_AS(choose("99999999999999999999"), InputError);
  CHECK_THROWS_WITH_AS(choose("1"), "OpenCL device Old GPU cannot be used: it is too old",
                       InputError);
  CHECK_THROWS_WITH_AS(chooseDevice("CUDA", {devices[1]}, ""),
                       "no CUDA device can be used; `haarlight devices` says why", InputError);
  CHECK_THROWS_AS(chooseDevice("CUDA", {}, ""), InputError);
}
