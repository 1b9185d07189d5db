#include "light/load_light.h"

#include "image/write_image.h"
#include "light_test_support.h"

namespace haarlight::test {

TEST_CASE("a light is loaded by built-in name or by file") {
  CHECK(loadLight("builtin:sky").environment->description() ==
        "builtin:sky (sun glow of 55° radius, bright sky)");
  Image image(8, 4);
  for (glm::vec3& pixel : image.pixels) pixel = {1, 2, 3};
  const TemporaryFolder folder;
  const std::string path = (folder / "light.exr").string();
  writeExr(path, {{"", image}});
  const LoadedLight light = loadLight(path);
  CHECK(light.warnings.empty());
  CHECK(light.environment->radiance({1, 2, 3}) == glm::vec3(1, 2, 3));
  CHECK(light.environment->description() == path + " (8×4, latlong)");
}

TEST_CASE("warnings about a light name its file") {
  Image image(8, 4);
  image.at(0, 0).r = -1;
  const TemporaryFolder folder;
  const std::string path = (folder / "light.exr").string();
  writeExr(path, {{"", image}});
  const LoadedLight light = loadLight(path);
  REQUIRE(light.warnings.size() == 2);
  CHECK(contains(light.warnings[0], path + ": negative values in 1 of 32 pixels"));
  CHECK(light.warnings[1] == path + ": every pixel is black");
}

TEST_CASE("lights that cannot be used are refused in words") {
  const TemporaryFolder folder;
  const std::string path = (folder / "light.exr").string();
  writeExr(path, {{"", Image(8, 5)}});
  CHECK(contains(inputErrorOf([&] { loadLight(path); }),
                 "cannot use light " + path + ": a light of 8×5 pixels has no known layout"));
  CHECK(contains(inputErrorOf([&] { loadLight(path, "angular"); }), "which is square"));
  CHECK(contains(inputErrorOf([] { loadLight("builtin:lamp"); }), "builtin:lamps"));
  CHECK(contains(inputErrorOf([] { loadLight("builtin:sky", "vcross"); }), "has no layout"));
  CHECK(contains(inputErrorOf([&] { loadLight((folder / "none.hdr").string()); }), "cannot read"));
}

}  // namespace haarlight::test
