#include "image/read_image.h"
#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;

namespace {

/// A machine without CUDA devices whose OpenCL kernels have one file, `name`, of this text.
class BrokenOpenCl {
 public:
  BrokenOpenCl(const std::string& name, const std::string& text) {
    writeFile(kernels_ / name, text);
    surroundings.environment["HAARLIGHT_KERNELS"] = kernels_.path();
    surroundings.environment["POCL_CACHE_DIR"] = cache_.path();
    surroundings.environment["CUDA_VISIBLE_DEVICES"] = "";
  }

  Surroundings surroundings;

 private:
  TemporaryFolder kernels_, cache_;
};

/// One sign of the diagonal coefficient is wrong.
BrokenOpenCl wrongSign() {
  const std::string file = "transform_occlusion.cl", right = "((a - b) - (c - d)) * scale";
  std::string text = readFile(HAARLIGHT_SOURCE_FOLDER "/opencl/" + file);
  const std::size_t place = text.find(right);
  REQUIRE(place != text.npos);
  text.replace(place, right.size(), "((a - b) + (c - d)) * scale");
  return BrokenOpenCl(file, text);
}

const Arguments verifyOpenCl{"verify", "--engine", "opencl", "--cases", "0", "--without-scenes"};

nlohmann::json brokenReport(const BrokenOpenCl& broken) {
  const Outcome outcome = runHaarlight(joined(verifyOpenCl, {"--json"}), broken.surroundings);
  CHECK(outcome.exitCode == 1);
  CHECK(contains(outcome.errors, "do not agree"));
  auto report = nlohmann::json::parse(outcome.output, nullptr, false);
  REQUIRE(report.is_object());
  CHECK(report.at("agrees") == false);
  return report;
}

Arguments render(const std::string& engine, const std::string& target) {
  return {"render", "--engine",  engine, "--size", "16x9", "--samples",
          "1",      "--spheres", "8",    "-o",     target, "--quiet"};
}

}  // namespace

TEST_CASE("verify names the stage and the place where a broken device goes wrong") {
  if (!haveOpenCl()) return;
  const auto report = brokenReport(wrongSign());
  bool found = false;
  for (const auto& row : report.at("rows")) {
    CAPTURE(row.dump());
    const std::string stage = row.at("stage");
    const bool wrong = row.at("engine") == "opencl" && stage == "haar_coefficients";
    if (stage != "frame") CHECK((row.at("verdict") == "differs") == wrong);
    if (!wrong) continue;
    found = true;
    for (const auto& mismatch : row.at("first_mismatches"))
      CHECK(contains(mismatch.at("place"), "diagonal coefficient"));
  }
  CHECK(found);
  CHECK_FALSE(report.at("absent").empty());
  for (const auto& absent : report.at("absent")) {
    CHECK(absent.at("failed") == true);
    CHECK(contains(absent.at("reason"), "its Haar coefficients are not the right ones"));
  }
}

TEST_CASE("verify shows a device that builds no kernels as failed") {
  if (!haveOpenCl()) return;
  const auto report = brokenReport(BrokenOpenCl("triple_product.cl", "no kernel"));
  for (const auto& row : report.at("rows")) CHECK(row.at("engine") == "reference");
  CHECK_FALSE(report.at("absent").empty());
  for (const auto& absent : report.at("absent")) {
    CHECK(absent.at("failed") == true);
    CHECK(contains(absent.at("reason"), "OpenCL kernels do not build"));
  }
}

TEST_CASE("a device that fails the self test renders nothing") {
  if (!haveOpenCl()) return;
  const BrokenOpenCl broken = wrongSign();
  const TemporaryFolder folder;
  checkRefused(render("opencl", folder / "x.png"),
               "fails the self test: its Haar coefficients are not the right ones",
               broken.surroundings);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("the engine auto passes over a device that fails the self test") {
  if (!haveOpenCl()) return;
  const BrokenOpenCl broken = wrongSign();
  const TemporaryFolder folder;
  const Outcome outcome = runHaarlight(render("auto", folder / "auto.exr"), broken.surroundings);
  CHECK(outcome.exitCode == 0);
  CHECK(contains(outcome.output, "device: reference"));
  CHECK(outcome.errors.starts_with("haarlight: warning: opencl on "));
  CHECK(contains(outcome.errors, "fails the self test"));
  CHECK(contains(outcome.errors, "using the scalar reference engine"));
  CHECK(runHaarlight(render("reference", folder / "reference.exr")).exitCode == 0);
  CHECK(haarlight::readImage(folder / "auto.exr").image.pixels ==
        haarlight::readImage(folder / "reference.exr").image.pixels);
}
