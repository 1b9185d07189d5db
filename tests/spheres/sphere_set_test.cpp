#include "spheres/sphere_set.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "mesh/random.h"
#include "test_support.h"

using namespace haarlight;
using haarlight::test::TemporaryFolder;

namespace {

const std::string validText =
    R"({"format": "haarlight-spheres", "version": 1, "mesh": {"name": "m", "hash": "00000000000000ff"},
        "method": "x", "seed": 3, "measures": {"coveredFraction": 1, "outsideVolumeRatio": null},
        "spheres": [{"center": [0, 1, 2], "radius": 1}, {"center": [0.5, 1e-3, 2], "radius": 0.25}]})";

/// The error when `from` in the valid text is replaced by `to`.
std::string errorWith(const std::string& from, const std::string& to) {
  const TemporaryFolder folder;
  std::string text = validText;
  const std::size_t at = text.rfind(from);
  REQUIRE(at != std::string::npos);
  test::writeFile(folder / "a.json", text.replace(at, from.size(), to));
  try {
    readSphereSet(folder / "a.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void checkError(const std::string& from, const std::string& to, const std::string& expected) {
  const std::string error = errorWith(from, to);
  INFO(error);
  CHECK(error.find(expected) != std::string::npos);
  CHECK(error.find("a.json") != std::string::npos);
  CHECK(error.find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("a sphere set comes back as it was written, to the bit") {
  const TemporaryFolder folder;
  SphereSet set;
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const auto number = [&] {
      return static_cast<float>(std::ldexp(random.uniform() - 0.5, int(random.next() % 60) - 30));
    };
    set.spheres.push_back({{number(), number(), number()}, std::abs(number()) + 1e-30f});
  }
  set.spheres.push_back(
      {{std::numeric_limits<float>::denorm_min(), -0.1f, std::numeric_limits<float>::max()},
       std::numeric_limits<float>::denorm_min()});
  set.meshName = "a \"mesh\" \xc3\xbc.obj";
  set.meshHash = 0xfedcba9876543210;
  set.measures = {0.99951, 0.1 + 0.2};
  set.method = "by hand";
  set.seed = std::numeric_limits<std::uint64_t>::max();
  writeSphereSet(folder / "set.json", set);
  const SphereSet back = readSphereSet(folder / "set.json");
  REQUIRE(back.spheres.size() == set.spheres.size());
  for (std::size_t i = 0; i < set.spheres.size(); ++i) {
    CHECK(back.spheres[i].center == set.spheres[i].center);
    CHECK(back.spheres[i].radius == set.spheres[i].radius);
  }
  CHECK(back.meshName == set.meshName);
  CHECK(back.meshHash == set.meshHash);
  CHECK(back.measures.coveredFraction == set.measures.coveredFraction);
  CHECK(back.measures.outsideVolumeRatio == set.measures.outsideVolumeRatio);
  CHECK(back.method == set.method);
  CHECK(back.seed == set.seed);
}

TEST_CASE("valid text is read") {
  const TemporaryFolder folder;
  test::writeFile(folder / "a.json", validText);
  const SphereSet set = readSphereSet(folder / "a.json");
  CHECK(set.spheres.size() == 2);
  CHECK(set.meshHash == 255);
  CHECK(set.spheres[1].radius == 0.25f);
  CHECK_FALSE(set.measures.outsideVolumeRatio);
}

TEST_CASE("every fault is named with its place") {
  checkError("\"radius\": 0.25", "\"radios\": 0.25", "/spheres/1/radius is missing");
  checkError("0.25", "-0.25", "/spheres/1/radius must be greater than zero");
  checkError("0.25", "0", "/spheres/1/radius must be greater than zero");
  checkError("0.25", "1e-60", "/spheres/1/radius must be greater than zero");
  checkError("0.25", "1e60", "/spheres/1/radius is too large");
  checkError("0.25", "NaN", ": line ");
  checkError("0.25", "1e999", ": line ");
  checkError("0.25", "\"1\"", "/spheres/1/radius must be a number");
  checkError("[0.5, 1e-3, 2]", "[0.5, 1e-3]", "/spheres/1/center must have three numbers");
  checkError("[0.5, 1e-3, 2]", "[0.5, true, 2]", "/spheres/1/center/1 must be a number");
  checkError("[0.5, 1e-3, 2]", "7", "/spheres/1/center must be an array");
  checkError("\"version\": 1", "\"version\": 2", "/version must be 1");
  checkError("haarlight-spheres", "other", "/format must be");
  checkError("\"format\"", "\"forma\"", "/format is missing");
  checkError("00000000000000ff", "0xff", "/mesh/hash must be 16 hexadecimal digits");
  checkError("{\"name\": \"m\", \"hash\": \"00000000000000ff\"}", "[]", "/mesh must be an object");
  checkError("\"seed\": 3", "\"seed\": -3", "/seed must be a whole number");
  checkError("\"coveredFraction\": 1", "\"coveredFraction\": 1.5", "at most one");
  checkError("null", "-1", "/measures/outsideVolumeRatio must be zero or more");
  checkError("}]}", "}]", ": line ");
  checkError(validText, "", ": line ");
  checkError(validText, "[]", "the whole must be an object");
  checkError(validText.substr(validText.find("[{")), "[]}", "/spheres must hold 1 to 65536");
  std::string many = "[{\"center\": [0, 0, 0], \"radius\": 1}";
  const std::string one = ", {\"center\": [0, 0, 0], \"radius\": 1}";
  for (std::size_t i = 0; i < maximumSphereCount; ++i) many += one;
  checkError(validText.substr(validText.find("[{")), many + "]}", "not 65537");
}

TEST_CASE("files that cannot be read or written are named") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(readSphereSet(folder / "none.json"), InputError);
  CHECK_THROWS_AS(readSphereSet(folder.path()), InputError);
  CHECK_THROWS_AS(writeSphereSet(folder / "no" / "a.json", SphereSet{}), InputError);
}
