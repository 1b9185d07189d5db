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
    R"({"format": "haarlight-spheres", "version": 2, "mesh": {"name": "m", "hash": "00000000000000ff"},
        "objective": "shadow", "method": "x", "seed": 3,
        "measures": {"coveredFraction": 1, "outsideVolumeRatio": null, "unionOutsideRatio": 0.375,
                     "uncoveredVolumeRatio": 0.125, "silhouette":
                     {"mean": 0.0625, "worst": 0.75, "over": 0.046875, "under": 0.015625}},
        "spheres": [{"center": [0, 1, 2], "radius": 1}, {"center": [0.5, 1e-3, 2], "radius": 0.25}]})";

/// As version 0.1.0 wrote it.
const std::string firstVersionText =
    R"({"format": "haarlight-spheres", "version": 1, "mesh": {"name": "m", "hash": "00000000000000ff"},
        "method": "x", "seed": 3, "measures": {"coveredFraction": 0.5, "outsideVolumeRatio": 0.25},
        "spheres": [{"center": [0, 1, 2], "radius": 1}]})";

SphereSet readText(const std::string& text) {
  const TemporaryFolder folder;
  test::writeFile(folder / "a.json", text);
  return readSphereSet(folder / "a.json");
}

/// The error when `from` in the valid text is replaced by `to`.
std::string errorWith(const std::string& from, const std::string& to) {
  std::string text = validText;
  const std::size_t at = text.rfind(from);
  REQUIRE(at != std::string::npos);
  try {
    readText(text.replace(at, from.size(), to));
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

/// A set in which no two values are equal.
SphereSet variedSet() {
  SphereSet set;
  set.spheres = {{{-0.1f, 2, 3}, 4}};
  set.meshName = "a \"mesh\" \xc3\xbc.obj";
  set.meshHash = 0xfedcba9876543210;
  set.objective = FitObjective::shadow;
  set.measures = {0.99951, 0.1 + 0.2, 0.28, 0.0003, SilhouetteError{0.08, 0.17, 0.05, 0.03}};
  set.method = "by hand";
  set.seed = std::numeric_limits<std::uint64_t>::max();
  return set;
}

SphereSet writtenAndRead(const SphereSet& set) {
  const TemporaryFolder folder;
  writeSphereSet(folder / "set.json", set);
  return readSphereSet(folder / "set.json");
}

void checkEqual(const SilhouetteError& actual, const SilhouetteError& expected) {
  CHECK(actual.mean == expected.mean);
  CHECK(actual.worst == expected.worst);
  CHECK(actual.over == expected.over);
  CHECK(actual.under == expected.under);
}

}  // namespace

TEST_CASE("spheres come back as they were written, to the bit") {
  SphereSet set = variedSet();
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
  const SphereSet back = writtenAndRead(set);
  REQUIRE(back.spheres.size() == set.spheres.size());
  for (std::size_t i = 0; i < set.spheres.size(); ++i) {
    CHECK(back.spheres[i].center == set.spheres[i].center);
    CHECK(back.spheres[i].radius == set.spheres[i].radius);
  }
}

TEST_CASE("what a set says about itself comes back as it was written") {
  const SphereSet set = variedSet(), back = writtenAndRead(set);
  CHECK(back.meshName == set.meshName);
  CHECK(back.meshHash == set.meshHash);
  CHECK(back.objective == set.objective);
  CHECK(back.method == set.method);
  CHECK(back.seed == set.seed);
  CHECK(back.measures.coveredFraction == set.measures.coveredFraction);
  CHECK(back.measures.outsideVolumeRatio == set.measures.outsideVolumeRatio);
  CHECK(back.measures.unionOutsideRatio == set.measures.unionOutsideRatio);
  CHECK(back.measures.uncoveredVolumeRatio == set.measures.uncoveredVolumeRatio);
  REQUIRE(back.measures.silhouette);
  checkEqual(*back.measures.silhouette, *set.measures.silhouette);
}

TEST_CASE("measures that there are none of stay so") {
  SphereSet set = variedSet();
  set.objective = FitObjective::cover;
  set.measures = {1, std::nullopt, std::nullopt, std::nullopt, std::nullopt};
  const SphereSet back = writtenAndRead(set);
  CHECK(back.objective == FitObjective::cover);
  CHECK(back.measures.coveredFraction == 1);
  CHECK_FALSE(back.measures.outsideVolumeRatio);
  CHECK_FALSE(back.measures.unionOutsideRatio);
  CHECK_FALSE(back.measures.uncoveredVolumeRatio);
  CHECK_FALSE(back.measures.silhouette);
}

TEST_CASE("valid text is read") {
  const SphereSet set = readText(validText);
  CHECK(set.spheres.size() == 2);
  CHECK(set.meshHash == 255);
  CHECK(set.spheres[1].radius == 0.25f);
  CHECK(set.objective == FitObjective::shadow);
  CHECK_FALSE(set.measures.outsideVolumeRatio);
  CHECK(set.measures.unionOutsideRatio == 0.375);
  CHECK(set.measures.uncoveredVolumeRatio == 0.125);
  REQUIRE(set.measures.silhouette);
  checkEqual(*set.measures.silhouette, {0.0625, 0.75, 0.046875, 0.015625});
}

TEST_CASE("a file of format version 1 is a cover without the later measures") {
  const SphereSet set = readText(firstVersionText);
  CHECK(set.spheres.size() == 1);
  CHECK(set.method == "x");
  CHECK(set.seed == 3);
  CHECK(set.objective == FitObjective::cover);
  CHECK(set.measures.coveredFraction == 0.5);
  CHECK(set.measures.outsideVolumeRatio == 0.25);
  CHECK_FALSE(set.measures.unionOutsideRatio);
  CHECK_FALSE(set.measures.uncoveredVolumeRatio);
  CHECK_FALSE(set.measures.silhouette);
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
  checkError("\"version\": 2", "\"version\": 3", "/version must be from 1 to 2");
  checkError("\"version\": 2", "\"version\": 0", "/version must be from 1 to 2");
  checkError("\"version\": 2", "\"version\": 1.5", "/version must be a whole number");
  checkError("haarlight-spheres", "other", "/format must be");
  checkError("\"format\"", "\"forma\"", "/format is missing");
  checkError("00000000000000ff", "0xff", "/mesh/hash must be 16 hexadecimal digits");
  checkError("{\"name\": \"m\", \"hash\": \"00000000000000ff\"}", "[]", "/mesh must be an object");
  checkError("\"seed\": 3", "\"seed\": -3", "/seed must be a whole number");
  checkError("\"coveredFraction\": 1", "\"coveredFraction\": 1.5", "at most one");
  checkError("null", "-1", "/measures/outsideVolumeRatio must be zero or more");
  checkError("0.375", "-1", "/measures/unionOutsideRatio must be zero or more");
  checkError("0.375", "\"\"", "/measures/unionOutsideRatio must be a number");
  checkError("0.125", "-1", "/measures/uncoveredVolumeRatio must be zero or more");
  checkError("\"uncoveredVolumeRatio\"", "\"x\"", "/measures/uncoveredVolumeRatio is missing");
  checkError("\"silhouette\"", "\"x\"", "/measures/silhouette is missing");
  checkError("\"over\"", "\"x\"", "/measures/silhouette/over is missing");
  for (const char* part : {"mean", "worst", "over", "under"})
    checkError("\"" + std::string(part) + "\": 0", "\"" + std::string(part) + "\": -1",
               "/measures/silhouette/" + std::string(part) + " must be zero or more");
  checkError("\"shadow\"", "\"light\"", "/objective must be 'cover' or 'shadow'");
  checkError("\"shadow\"", "0", "/objective must be a string");
  checkError("\"objective\"", "\"x\"", "/objective is missing");
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
