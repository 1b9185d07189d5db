#include "motion/point_cache.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <limits>

#include "motion/point_cache_bytes.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr std::size_t points = 5;

std::unique_ptr<VertexMotion> openBytes(const TemporaryFolder& folder, const std::string& name,
                                        const std::string& bytes, std::size_t vertices = points,
                                        double framesPerSecond = 24) {
  std::filesystem::remove(folder / name);  // some file systems are slow at writing over files
  writeFile(folder / name, bytes);
  return openPointCache(folder / name, meshWithVertices(vertices), framesPerSecond);
}

/// The message with which opening or posing any of three frames is refused: the middle one takes
/// part at any time between the others.
std::string refusalIn(const TemporaryFolder& folder, const std::string& name,
                      const std::string& bytes, std::size_t vertices = points) {
  return inputErrorOf([&] {
    const auto motion = openBytes(folder, name, bytes, vertices);
    for (const double part : {0.0, 0.5, 1.0}) motion->positions(motion->duration() * part);
  });
}

std::string refusalOf(const std::string& name, const std::string& bytes,
                      std::size_t vertices = points) {
  return refusalIn(TemporaryFolder(), name, bytes, vertices);
}

template <typename Number>
std::string changed(std::string bytes, std::size_t at, Number number, bool bigEndian = false) {
  std::string raw;
  append(raw, number, bigEndian);
  return bytes.replace(at, raw.size(), raw);
}

glm::vec3 between(const glm::vec3& a, const glm::vec3& b, double part) {
  return glm::vec3(glm::dvec3(a) * (1 - part) + glm::dvec3(b) * part);
}

}  // namespace

TEST_CASE("a pc2 gives its samples to the bit, and straight lines between them") {
  const TemporaryFolder folder;
  const Frames frames = randomFrames(4, points, 1);
  const auto motion = openBytes(folder, "a.pc2", pc2Bytes(frames, 17, 2), points, 16);
  CHECK(motion->vertexCount() == points);
  CHECK(motion->duration() == 3 * 2.0 / 16);
  for (std::size_t i = 0; i < frames.size(); ++i)
    CHECK(sameBits(motion->positions(double(i) / 8), frames[i]));
  for (std::size_t i = 0; i + 1 < frames.size(); ++i)
    for (const double part : {0.25, 0.5}) {
      const auto positions = motion->positions((double(i) + part) / 8);
      for (std::size_t v = 0; v < points; ++v)
        CHECK(positions[v] == between(frames[i][v], frames[i + 1][v], part));
    }
  CHECK(sameBits(motion->positions(-1), frames.front()));
  CHECK(sameBits(motion->positions(100), frames.back()));
  CHECK(sameBits(motion->positions(std::nan("")), frames.front()));
}

TEST_CASE("an mdd gives its samples at its own seconds, from the first on") {
  const TemporaryFolder folder;
  const Frames frames = randomFrames(3, points, 2);
  const auto motion = openBytes(folder, "a.MDD", mddBytes(frames, {10, 10.5f, 12}));
  CHECK(motion->duration() == 2);
  CHECK(sameBits(motion->positions(0), frames[0]));
  CHECK(sameBits(motion->positions(0.5), frames[1]));
  CHECK(sameBits(motion->positions(2), frames[2]));
  const auto positions = motion->positions(0.875);
  for (std::size_t v = 0; v < points; ++v)
    CHECK(positions[v] == between(frames[1][v], frames[2][v], 0.25));
}

TEST_CASE("a cache of one sample stands still") {
  const TemporaryFolder folder;
  const Frames frames = randomFrames(1, points, 3);
  for (const auto& [name, bytes] :
       {std::pair{"a.pc2", pc2Bytes(frames)}, std::pair{"a.mdd", mddBytes(frames, {3})}}) {
    const auto motion = openBytes(folder, name, bytes);
    CHECK(motion->duration() == 0);
    CHECK(sameBits(motion->positions(7), frames[0]));
  }
}

TEST_CASE("a vertex that loading repeats moves with the file's one") {
  const TemporaryFolder folder;
  const Frames frames = randomFrames(2, points, 4);
  writeFile(folder / "a.pc2", pc2Bytes(frames));
  LoadedMesh mesh = meshWithVertices(points);
  for (const std::uint32_t repeated : {3u, 1u, 3u}) {
    mesh.sourceVertices.push_back(repeated);
    mesh.mesh.positions.emplace_back(0);
  }
  const auto motion = openPointCache(folder / "a.pc2", mesh, 24);
  CHECK(motion->vertexCount() == points + 3);
  std::vector<glm::vec3> expected = frames[1];
  for (const std::size_t repeated : {3, 1, 3}) expected.push_back(frames[1][repeated]);
  CHECK(sameBits(motion->positions(1.0 / 24), expected));
}

TEST_CASE("a cache gives the same bits in whatever order times are asked for") {
  const TemporaryFolder folder;
  const auto bytes = pc2Bytes(randomFrames(9, points, 5));
  const auto forwards = openBytes(folder, "a.pc2", bytes);
  const auto mixed = openBytes(folder, "b.pc2", bytes);
  Random random(6);
  std::vector<double> times(200);
  for (double& time : times) time = random.uniform() * 10 / 24;
  std::vector<std::vector<glm::vec3>> inMixedOrder;
  for (const double time : times) inMixedOrder.push_back(mixed->positions(time));
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::size_t i) { return times[i]; });
  for (const std::size_t i : order) CHECK(sameBits(forwards->positions(times[i]), inMixedOrder[i]));
}

TEST_CASE("bad headers are refused by name") {
  const std::string pc2 = pc2Bytes(randomFrames(3, points, 7));
  const std::string mdd = mddBytes(randomFrames(3, points, 7), {0, 1, 2});
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  CHECK(contains(refusalOf("a.pc2", changed(pc2, 3, 'X')), "begin with POINTCACHE2"));
  CHECK(contains(refusalOf("a.pc2", changed(pc2, 12, std::int32_t(2))), "version 2"));
  CHECK(contains(refusalOf("a.pc2", changed(pc2, 16, std::int32_t(-5))), "-5 points"));
  CHECK(contains(refusalOf("a.pc2", changed(pc2, 16, std::int32_t(0)), 0), "0 points"));
  CHECK(contains(refusalOf("a.pc2", changed(pc2, 20, nan)), "start frame"));
  for (const float rate : {nan, 0.f, -1.f, infinity})
    CHECK(contains(refusalOf("a.pc2", changed(pc2, 24, rate)), "sample rate"));
  for (const std::int32_t samples : {0, -1, std::numeric_limits<std::int32_t>::max()})
    CHECK(contains(refusalOf("a.pc2", changed(pc2, 28, samples)),
                   "says " + std::to_string(samples) + " samples"));
  CHECK(contains(refusalOf("a.mdd", changed(mdd, 0, std::int32_t(0), true)), "says 0 samples"));
  CHECK(contains(refusalOf("a.mdd", changed(mdd, 4, std::int32_t(-1), true)), "-1 points"));
  for (const float second : {0.f, -1.f, nan, 2.f, infinity})
    CHECK(contains(refusalOf("a.mdd", changed(mdd, 12, second, true)), "(from 0) is not a number"));
  CHECK(contains(refusalOf("a.obj", pc2), "none of .mdd, .pc2"));
}

TEST_CASE("a cache whose size or points do not agree is refused with both numbers") {
  const std::string pc2 = pc2Bytes(randomFrames(3, points, 8));
  const std::string mdd = mddBytes(randomFrames(3, points, 8), {0, 1, 2});
  CHECK(contains(refusalOf("a.pc2", pc2, 7), "5 points, but the mesh's file has 7 vertices"));
  CHECK(contains(refusalOf("a.mdd", mdd, 7), "5 points, but the mesh's file has 7 vertices"));
  CHECK(contains(refusalOf("a.pc2", pc2.substr(0, 211)),
                 "it holds 211 bytes, but 3 samples of 5 points take 212"));
  CHECK(contains(refusalOf("a.pc2", pc2 + "x"), "it holds 213 bytes"));
  CHECK(contains(refusalOf("a.mdd", mdd + "x"),
                 "it holds 201 bytes, but 3 samples of 5 points take 200"));
  CHECK(contains(refusalOf("a.pc2", changed(pc2, 28, std::int32_t(4))),
                 "it holds 212 bytes, but 4 samples of 5 points take 272"));
  CHECK(contains(refusalOf("a.pc2", pc2.substr(0, 20)), "its header alone takes 32"));
  CHECK(contains(refusalOf("a.pc2", ""), "it holds 0 bytes"));
}

TEST_CASE("positions that are no numbers are refused with frame and vertex") {
  const std::string pc2 = pc2Bytes(randomFrames(3, points, 9));
  const std::string mdd = mddBytes(randomFrames(3, points, 9), {0, 1, 2});
  const std::size_t at = 4 * (3 * (2 * points + 4) + 1);
  for (const float value : {std::nanf(""), -std::numeric_limits<float>::infinity(), 1.1e9f}) {
    CHECK(contains(refusalOf("a.pc2", changed(pc2, 32 + at, value)), "vertex 4 of frame 2"));
    CHECK(contains(refusalOf("a.mdd", changed(mdd, 20 + at, value, true)), "vertex 4 of frame 2"));
  }
  CHECK(refusalOf("a.pc2", changed(pc2, 32 + at, 1e9f)).empty());

  // The other frames can still be used.
  const TemporaryFolder folder;
  const auto motion = openBytes(folder, "a.pc2", changed(pc2, 32 + at, std::nanf("")));
  CHECK_THROWS_AS(motion->positions(1.5 / 24), InputError);
  CHECK_THROWS_AS(motion->positions(2.0 / 24), InputError);
  CHECK(sameBits(motion->positions(1.0 / 24), randomFrames(3, points, 9)[1]));
}

TEST_CASE("a cache that changes while it is open is refused") {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const std::string bytes = pc2Bytes(randomFrames(3, points, 10));
  const auto pose = [&](const auto& change) {
    const auto motion = openBytes(folder, "a.pc2", bytes);
    motion->positions(0);
    change();
    return inputErrorOf([&] { motion->positions(2.0 / 24); });
  };
  const fs::path file = folder / "a.pc2";
  CHECK(pose([] {}).empty());
  CHECK(contains(pose([&] { fs::resize_file(file, 100); }),
                 "held 212 bytes when it was opened and now holds 100"));
  CHECK(contains(pose([&] { fs::resize_file(file, 1000); }), "now holds 1000"));
  CHECK(contains(
      pose([&] { fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(1)); }),
      "written to after"));
  CHECK(contains(pose([&] { fs::remove(file); }), "No such file"));
}

TEST_CASE("missing caches and folders are refused") {
  const TemporaryFolder folder;
  const auto open = [&](const std::string& name) {
    return inputErrorOf([&] { openPointCache(folder / name, meshWithVertices(points), 24); });
  };
  CHECK(contains(open("none.pc2"), "none.pc2: No such file"));
  std::filesystem::create_directory(folder / "folder.pc2");
  CHECK(contains(open("folder.pc2"), "it is a folder"));
}

TEST_CASE("damaged caches give all frames or an InputError, never anything else") {
  const Frames frames = randomFrames(3, points, 11);
  const std::pair<std::string, std::string> sources[] = {{"a.pc2", pc2Bytes(frames)},
                                                         {"a.mdd", mddBytes(frames, {0, 1, 2})}};
  const TemporaryFolder folder;
  Random random(12);
  for (const auto& [name, bytes] : sources) {
    for (std::size_t size = 0; size < bytes.size(); ++size)
      CHECK_FALSE(refusalIn(folder, name, bytes.substr(0, size)).empty());
    int loaded = 0;
    for (int round = 0; round < 2000; ++round) {
      std::string damaged = bytes;
      damaged[random.next() % damaged.size()] = char(random.next());
      loaded += refusalIn(folder, name, damaged).empty();
    }
    CHECK(loaded > 500);   // most bytes belong to coordinates
    CHECK(loaded < 2000);  // of which some become too large
  }
}

TEST_CASE("the elephant walks through its 115 samples") {
  const auto cache = testData("elephant/elephant_walk.pc2");
  const auto file = testData("elephant/elephant.obj");
  if (!cache || !file) return;
  const LoadedMesh elephant = loadMesh(*file);
  const auto motion = openPointCache(*cache, elephant, 24);
  CHECK(motion->vertexCount() == 6034);
  CHECK(motion->duration() == 114.0 / 24);
  const std::vector<glm::vec3> start = motion->positions(0);
  for (std::size_t i = 0; i < start.size(); ++i)
    CHECK(glm::distance(start[i], elephant.mesh.positions[i]) < 1e-4f);  // of 186 in size
  // Figures of the file's numbers, computed without this program.
  CHECK(motion->positions(57.0 / 24)[1234] == glm::vec3(39.88579178f, 7.83100510f, -4.89995193f));
  const auto halfWay = motion->positions(57.5 / 24)[1234];
  CHECK(glm::distance(halfWay, glm::vec3(31.6306820f, 6.0758946f, -14.1583424f)) < 1e-5f);
  std::vector<glm::vec3> before = start;
  double largestStep = 0, sumOfSteps = 0;
  for (int frame = 1; frame < 115; ++frame) {
    const std::vector<glm::vec3> now = motion->positions(frame / 24.0);
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double step = glm::distance(glm::dvec3(before[i]), glm::dvec3(now[i]));
      largestStep = std::max(largestStep, step);
      sumOfSteps += step;
    }
    before = now;
  }
  CHECK(largestStep == doctest::Approx(85.18762793486897).epsilon(1e-9));
  CHECK(sumOfSteps / (114 * 6034) == doctest::Approx(10.30796669823791).epsilon(1e-9));
}
