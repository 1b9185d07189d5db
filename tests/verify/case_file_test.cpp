#include "verify/cases/case_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "test_support.h"
#include "verify/cases/random_cases.h"

using namespace haarlight;
using namespace haarlight::test;
using namespace haarlight::verify;

namespace {

/// The same bits, so that −0 differs from 0.
template <typename Value>
bool sameBits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

void checkSame(const Case& a, const Case& b) {
  CHECK(a.name == b.name);
  CHECK(sameBits(a.spheres, b.spheres));
  CHECK(sameBits(a.receivers.positions, b.receivers.positions));
  CHECK(sameBits(a.receivers.normals, b.receivers.normals));
  CHECK(sameBits(a.receivers.lobes, b.receivers.lobes));
  CHECK(sameBits(a.light.texels, b.light.texels));
  CHECK(sameBits(a.vertices, b.vertices));
  CHECK(a.binding.listStarts == b.binding.listStarts);
  CHECK(a.binding.vertices == b.binding.vertices);
  CHECK(sameBits(a.binding.weights, b.binding.weights));
  CHECK(sameBits(a.binding.radiusFactors, b.binding.radiusFactors));
  CHECK(a.hasDenormals == b.hasDenormals);
}

const std::string start = "haarlight-case 1\nname small\n";
const std::string receiver = "receiver 0 0 0 0 1 0\n";

void refused(const std::string& text, const std::string& message) {
  CAPTURE(text);
  CHECK_THROWS_WITH_AS(readCaseText(text, "f"), message.c_str(), InputError);
}

}  // namespace

TEST_CASE("random cases survive writing and reading bit by bit") {
  for (std::size_t index = 0; index < 24; ++index) {
    const Case written = randomCase(5, index);
    checkSame(readCaseText(caseText(written), "text"), written);
  }
}

TEST_CASE("denormal numbers, -0 and the largest number survive writing and reading") {
  const float least = std::numeric_limits<float>::denorm_min();
  const float largest = std::numeric_limits<float>::max();
  Case written;
  written.name = "extremes, with blanks";
  written.spheres = {{{-0.0f, least, -least}, least},
                     {{largest, -largest, 0x1.fffffcp-127f}, largest}};
  written.receivers.add({-0.0f, 0, least}, {-0.0f, -1, 0});
  written.light[0] = {-0.0f, 0, 0};
  written.light[6143] = {least, largest, 0.1f};
  written.vertices = {{-0.0f, least, 1, 0}};
  written.binding.add(std::vector<std::uint32_t>{0, 0},
                      std::vector<glm::vec4>{{least, 1, 1, 0}, {}}, {least, 1});
  written.hasDenormals = true;
  const Case read = readCaseText(caseText(written), "text");
  checkSame(read, written);
  CHECK(std::signbit(read.light[0].r));
}

TEST_CASE("what a person writes by hand is read") {
  const Case read = readCaseText(
      "# two comments\r\n\n  # and blanks\nhaarlight-case 1\r\n\tname  by hand \r\n"
      "sphere 1 -2.5 +0x1.8p+1 1e-40\nplane 2 0.5\nreceiver 0 0 0 0 0 -1\nlight constant 1 2 3",
      "text");
  CHECK(read.name == "by hand");
  REQUIRE(read.spheres.size() == 1);
  CHECK(read.spheres[0].center == glm::vec3(1, -2.5f, 3));
  CHECK(read.spheres[0].radius == 1e-40f);
  REQUIRE(read.receivers.size() == 5);
  CHECK(read.receivers.positions[0] == glm::vec4(-0.25f, 0, -0.25f, 0));
  CHECK(read.receivers.positions[1] == glm::vec4(0.25f, 0, -0.25f, 0));
  CHECK(read.receivers.normals[3] == glm::vec4(0, 1, 0, 0));
  CHECK(read.receivers.normals[4] == glm::vec4(0, 0, -1, 0));
  CHECK(read.light[17] == glm::vec3(1, 2, 3));
  CHECK(read.hasDenormals);
}

TEST_CASE("entries without weight stay, also where a list is filled up") {
  const Case read =
      readCaseText(start + receiver + "vertex 0 0 0\nvertex 0 3 4\nbound 0 1\nfollows 0 1 0 0\n" +
                       "follows 1 0 0 1\nfollows 1 0 0 0\nfollows 0 -0 0 0\nfollows 0 0 0 0\n",
                   "text");
  CHECK(read.binding.listStarts == std::vector<std::uint32_t>{0, 32});
  CHECK(std::signbit(read.binding.weights[3].x));
  CHECK(moveSpheres(read.binding, read.vertices)[0].radius == 5);
  checkSame(readCaseText(caseText(read), "text"), read);

  Case full = read;
  full.binding = {};
  full.binding.add(std::vector<std::uint32_t>(64, 1), std::vector<glm::vec4>(64, glm::vec4(0)),
                   {1, 0});
  checkSame(readCaseText(caseText(full), "text"), full);
}

TEST_CASE("bound spheres that lack something or go too far are refused") {
  const std::string vertex = receiver + "vertex 1 2 3\n", bound = vertex + "bound 1 0\n";
  refused(start + vertex + "follows 0 1 0 0\n",
          "f:5: a line 'bound mean reach' must come before what the sphere follows");
  refused(start + "bound 1 0\nfollows 0 1 0 0\n",
          "f:4: the case has no vertex yet; add a line 'vertex x y z' before");
  refused(start + bound, "f:5: a bound sphere follows nothing; add a line 'follows vertex a b g'");
  refused(start + bound + "bound 1 0\n",
          "f:6: a bound sphere follows nothing; add a line 'follows vertex a b g'");
  refused(start + bound + "follows 1 1 0 0\n",
          "f:6: the number of a vertex must be a whole number from 0 to 0, not '1'");
  refused(start + bound + "follows 0 1 -1 0\n",
          "f:6: the weight for the mean must not be negative");
  refused(start + bound + "follows 0 1 0 -0\n",
          "f:6: the weight for the reach must not be negative");
  refused(start + bound + "follows 0 1 0\n",
          "f:6: the weight for the reach is missing; add it to the line");
  refused(start + vertex + "bound -1 0\n", "f:5: the factor of the mean must not be negative");
  refused(start + vertex + "bound 1\n",
          "f:5: the factor of the reach is missing; add it to the line");
  refused(start + receiver + "vertex 1 2\n",
          "f:4: the z of a vertex is missing; add it to the line");
  refused(start + receiver + "vertex 0 0 0\nvertex 1e30 0 0\nbound 1 0\n" +
              "follows 0 1 1 0\nfollows 1 0 1 0\n",
          "f:8: a bound sphere leaves the range of float32; choose smaller numbers");
}

TEST_CASE("a light by its seed is that of random cases") {
  const Case read = readCaseText(start + receiver + "light random 18446744073709551615\n", "text");
  CHECK(sameBits(read.light.texels, randomLight(~std::uint64_t(0)).texels));
  CHECK(readCaseText(start + receiver, "text").light[0] == glm::vec3(0));
}

TEST_CASE("headers that are missing, wrong or double are refused") {
  refused("", "f:0: the text must begin with the line 'haarlight-case 1'");
  refused("name x\n", "f:1: the text must begin with the line 'haarlight-case 1'");
  refused("haarlight-case 2\n",
          "f:1: the format's version must be a whole number from 1 to 1, not '2'");
  refused("haarlight-case 1 2\n", "f:1: remove '2' at the end of the line");
  refused(start + "haarlight-case 1\n",
          "f:3: the line must begin with name, sphere, receiver, plane, light, texel, vertex, "
          "bound or follows");
  refused(start + "name other\n", "f:3: this is the second name of a case; remove the line");
  refused("haarlight-case 1\nname\n", "f:2: the name is missing; add it to the line");
  refused("haarlight-case 1\n" + receiver, "f:2: the case has no name; add a line 'name …'");
  refused(start, "f:2: the case has no receiver; add a line 'receiver x y z nx ny nz'");
  refused(start + "light constant 1 1 1\nlight random 1\n",
          "f:4: a case has one light, which it has already; remove the line");
  refused(start + "light constant 1 1 1\ntexel 0 1 1 1\n",
          "f:4: a case has a light line or texels; remove one of them");
  refused(start + "texel 9 1 1 1\ntexel 9 1 1 1\n",
          "f:4: this texel has a line already; remove one of them");
}

TEST_CASE("values out of range are refused") {
  refused(start + "sphere 0 0 0 0\n", "f:3: a sphere's radius must be greater than zero");
  refused(start + "sphere 0 0 0 -1\n", "f:3: a sphere's radius must be greater than zero");
  refused(start + "sphere 0 0 0\n", "f:3: a sphere's radius is missing; add it to the line");
  refused(start + "sphere 0 0 0 1 1\n", "f:3: remove '1' at the end of the line");
  for (const std::string word :
       {"nan", "inf", "-inf", "1e39", "1e-60", "1,5", "0x", "--1", "+-1", "0x-1", "1x", "0x1.8q"})
    refused(start + "sphere " + word + " 0 0 1\n",
            "f:3: the x of a sphere's centre must be a finite number that float32 holds, not '" +
                word + "'");
  refused(start + "receiver 0 0 0 0 1.0011 0\n",
          "f:3: a receiver's normal must have length 1 within 0.001");
  refused(start + "receiver 0 0 0 0 0 0\n",
          "f:3: a receiver's normal must have length 1 within 0.001");
  refused(start + "texel 6144 1 1 1\n",
          "f:3: the index of a texel must be a whole number from 0 to 6143, not '6144'");
  refused(start + "texel -1 1 1 1\n",
          "f:3: the index of a texel must be a whole number from 0 to 6143, not '-1'");
  refused(start + "light blue\n", "f:3: the kind of light must be 'constant' or 'random'");
  refused(start + "plane 1025 1\n",
          "f:3: the receivers per side of a plane must be a whole number from 1 to 1024, not "
          "'1025'");
}

TEST_CASE("no text makes the reader or its messages grow") {
  refused(start + "sphere " + std::string(5000, '1') + "\n",
          "f:3: the line is longer than 4096 characters; is this the right file?");
  refused(start + "sphere " + std::string(50, 'a') + "\n",
          "f:3: the x of a sphere's centre must be a finite number that float32 holds, not '" +
              std::string(40, 'a') + "…'");
  refused(start + "sphere \x1b[2J\n",
          "f:3: the x of a sphere's centre must be a finite number that float32 holds, not "
          "'\\x1b[2J'");
  refused(start + "plane 1024 1\n" + receiver,
          "f:4: a case has at most 1048576 receivers; remove some");
  std::string spheres = start;
  for (int i = 0; i < 65537; ++i) spheres += "sphere 0 0 0 1\n";
  CHECK_THROWS_WITH_AS(readCaseText(spheres, "f"),
                       "f:65539: a case has at most 65536 spheres; remove some", InputError);
  std::string bound = start + "vertex 0 0 0\n", vertices = start;
  for (int i = 0; i < 65537; ++i) bound += "bound 0 0\nfollows 0 1 0 0\n";
  CHECK_THROWS_WITH_AS(readCaseText(bound, "f"),
                       "f:131076: a case has at most 65536 bound spheres; remove some", InputError);
  for (int i = 0; i < 1048577; ++i) vertices += "vertex 0 0 0\n";
  CHECK_THROWS_WITH_AS(readCaseText(vertices, "f"),
                       "f:1048579: a case has at most 1048576 vertices; remove some", InputError);
}

TEST_CASE("case files are written and read, and missing ones are named") {
  const TemporaryFolder folder;
  const Case written = randomCase(6, 1);
  writeCaseFile(folder / "case.txt", written);
  checkSame(readCaseFile(folder / "case.txt"), written);
  CHECK_THROWS_AS(readCaseFile(folder / "missing.txt"), InputError);
  writeFile(folder / "wrong.txt", "wrong");
  CHECK_THROWS_WITH_AS(
      readCaseFile(folder / "wrong.txt"),
      ((folder / "wrong.txt").string() + ":1: the text must begin with the line 'haarlight-case 1'")
          .c_str(),
      InputError);
}

TEST_CASE("a name of several lines stays on its line") {
  Case written = randomCase(7, 0);
  written.name = "first\nsecond\x1b";
  CHECK(readCaseText(caseText(written), "text").name == "first\\nsecond\\x1b");
}
