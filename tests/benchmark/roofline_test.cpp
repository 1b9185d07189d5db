#include "benchmark/roofline.h"

#include <limits>
#include <set>

#include "base/file.h"
#include "example_record.h"
#include "test_support.h"
#include "verify/cases/paper_frame.h"
#include "visibility/exact_visibility.h"

using namespace haarlight;
using namespace haarlight::benchmark;
using namespace haarlight::test;

namespace {

/// One sample, two spheres.
FrameCounts smallCounts() {
  FrameCounts counts;
  counts.samples = 1;
  counts.spheres = 2;
  counts.lobes = counts.differentLobes = 1;
  counts.squares = 160;
  counts.blockedRows = counts.weightRows = counts.differentBlockedRows = 3;
  counts.maskGroups = counts.maskGroupsOfTiles = counts.maskGroupsOfFrame = 4;
  counts.masksOfTiles = counts.masksOfFrame = 2;
  counts.reachedFaces = 3;
  counts.reachedRows = 20;
  return counts;
}

using StageTime = double StageTimes::*;

const StageWork& stageOf(const std::vector<StageWork>& work, StageTime stage) {
  for (const StageWork& one : work)
    if (one.stage == stage) return one;
  FAIL("no such stage");
  return work.front();
}

/// A row on a plane, so short that the whole frame can be counted by hand.
Receivers fewReceivers() {
  const Receivers all = verify::paperFrame(1).receivers;
  Receivers few;
  for (std::size_t i = 0; i < 40; ++i)
    few.add(glm::vec3(all.positions[8250 + i]), glm::vec3(all.normals[8250 + i]));
  return few;
}

const Ceilings ceilings{2,
                        "vectors",
                        {{"L1", 1024, 2048, 100, 80},
                         {"L2", 8192, 16384, 10, 20},
                         {"RAM", 65536, std::numeric_limits<double>::infinity(), 1, 2}},
                        1000,
                        500};

}  // namespace

TEST_CASE("the model counts a small frame as one does by hand") {
  const FrameCounts counts = smallCounts();
  const auto table = frameWork(counts, VisibilityKind::table, FramePath::fused);
  REQUIRE(table.size() == 3);
  // 2 spheres of 8 + 120, 4 groups of 16 words, 3 groups of 16 rows of 96 weights.
  const StageWork& fused = stageOf(table, &StageTimes::fused);
  CHECK(fused.operations == 2 * 128 + 4 * 16 + 3 * 96);
  // 2 entries of 4 bytes, 4 groups of 64, position and normal, weights of 4 bytes.
  CHECK(fused.bytes() == 2 * 4 + 4 * 64 + 32 + 3 * 96 * 4);
  CHECK(stageOf(table, &StageTimes::upload).bytes() == 2 * 64);
  CHECK(stageOf(table, &StageTimes::readBack).bytes() == 2 * 16);
  CHECK(stageOf(table, &StageTimes::upload).operations == 0);

  const auto staged = frameWork(counts, VisibilityKind::exact, FramePath::staged);
  REQUIRE(staged.size() == 5);
  const StageWork& merge = stageOf(staged, &StageTimes::merge);
  CHECK(merge.operations == 2 * (8 + 890 / 16.0 + 25) + 3 * 29 + 20 * 52);
  CHECK(merge.bytes() == 32 + 768);
  CHECK(stageOf(staged, &StageTimes::transform).operations == 384 * 29 + 126 * 12);
  CHECK(stageOf(staged, &StageTimes::transform).bytes() == 768 + 2808);
  CHECK(stageOf(staged, &StageTimes::tripleProduct).operations == 160 * 24);
  CHECK(stageOf(staged, &StageTimes::tripleProduct).bytes() == 2808 + 160 * 48);
}

TEST_CASE("what a tile has read before comes from the nearest memory") {
  FrameCounts counts = smallCounts();
  counts.samples = 16;
  counts.maskGroups = 60;
  const auto work = frame_model::merge(counts, VisibilityKind::table);
  CHECK(work.traffic[0].bytes == 32 * 4 + 60 * 64 - (2 * 4 + 4 * 64));
  CHECK(work.traffic[0].workingSet == 0);
  CHECK(work.traffic[1].bytes == 2 * 4 + 4 * 64);
  CHECK(work.traffic[1].workingSet == 2 * 4 + 4 * 64);
}

TEST_CASE("the least time is that of the narrowest ceiling") {
  const auto limitOf = [](double operations, std::vector<Traffic> traffic) {
    return timeLimit({&StageTimes::merge, operations, std::move(traffic)}, ceilings);
  };
  CHECK(limitOf(3000, {}).seconds == 3);
  CHECK(limitOf(3000, {}).boundBy == "operations");
  // The faster of copying and reading counts, and a set at the limit is still held.
  CHECK(limitOf(0, {{200, 2048}}).seconds == 2);
  CHECK(limitOf(0, {{200, 2048}}).boundBy == "L1");
  CHECK(limitOf(0, {{200, 2049}}).seconds == 10);
  CHECK(limitOf(0, {{200, 2049}}).boundBy == "L2");
  CHECK(limitOf(0, {{200, 1e9}}).boundBy == "RAM");
  // Everything passes the nearest memory, far bytes also those between.
  CHECK(limitOf(0, {{200, 0}, {20, 5000}}).seconds == doctest::Approx(2.2));
  CHECK(limitOf(0, {{200, 5000}, {2, 1e9}}).seconds == doctest::Approx(10.1));
}

TEST_CASE("more work is never done in less time") {
  const auto seconds = [](const FrameCounts& counts, VisibilityKind visibility, FramePath path) {
    double sum = 0;
    for (const StageWork& work : frameWork(counts, visibility, path))
      sum += timeLimit(work, ceilings).seconds;
    return sum;
  };
  for (const auto visibility : {VisibilityKind::exact, VisibilityKind::table})
    for (const auto path : {FramePath::fused, FramePath::staged}) {
      const double before = seconds(smallCounts(), visibility, path);
      for (double FrameCounts::*count :
           {&FrameCounts::samples, &FrameCounts::spheres, &FrameCounts::squares,
            &FrameCounts::blockedRows, &FrameCounts::maskGroups, &FrameCounts::reachedRows}) {
        FrameCounts more = smallCounts();
        more.*count *= 2;
        CHECK(seconds(more, visibility, path) >= before);
      }
      FrameCounts twice = smallCounts();
      twice.samples *= 2;
      CHECK(seconds(twice, visibility, path) > before);
    }
}

TEST_CASE("rows and faces that spheres reach are counted on the frame") {
  const Receivers receivers = fewReceivers();
  const auto spheres = verify::paperFrame(3).spheres;
  const FrameCounts counts = countFrame(spheres, receivers, nullptr, 160);
  double rows = 0, faces = 0, blockedRows = 0, weights = 0;
  std::set<int> different, ofTwo;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    std::set<int> blocked;
    for (const Sphere& sphere : spheres) {
      std::set<int> ownFaces;
      const BitCube cube =
          exactBitCube(std::span(&sphere, 1), receivers.positions[i], receivers.normals[i]);
      for (int row = 0; row < bitCubeRows; ++row) {
        if (!cube.rows[row]) continue;
        ++rows;
        ownFaces.insert(row / 32);
        blocked.insert(row);
      }
      faces += double(ownFaces.size());
    }
    blockedRows += double(blocked.size());
    different.insert(blocked.begin(), blocked.end());
    ofTwo.insert(blocked.begin(), blocked.end());
    if (i % 2 == 1) {
      weights += double(ofTwo.size());
      ofTwo.clear();
    }
  }
  CHECK(rows > 0);
  CHECK(counts.reachedRows == rows);
  CHECK(counts.reachedFaces == faces);
  CHECK(counts.blockedRows == blockedRows);  // one lobe: the plane's normal is tabulated
  CHECK(counts.weightRows == weights);
  CHECK(counts.differentBlockedRows == double(different.size()));
  CHECK(counts.samples == 40);
  CHECK(counts.spheres == 3);
  CHECK(counts.lobes == 40);
  CHECK(counts.differentLobes == 1);
  CHECK(counts.squares == 160);
  CHECK(counts.maskGroups == 0);
}

TEST_CASE("samples without another, or with other lobes, read weights alone") {
  const Receivers few = fewReceivers();
  const auto spheres = verify::paperFrame(64).spheres;
  const auto countsOf = [&](const Receivers& receivers) {
    return countFrame(spheres, receivers, nullptr, 160);
  };
  Receivers one, two, turned;
  one.add(glm::vec3(few.positions[0]), {0, 1, 0});
  for (int i = 0; i < 2; ++i) {
    two.add(glm::vec3(few.positions[0]), {0, 1, 0});
    turned.add(glm::vec3(few.positions[0]), {i, 1 - i, 0});
  }
  const double alone = countsOf(one).weightRows;
  CHECK(alone > 0);
  CHECK(countsOf(one).blockedRows == alone);
  CHECK(countsOf(two).weightRows == alone);
  CHECK(countsOf(two).blockedRows == 2 * alone);
  CHECK(countsOf(turned).weightRows == countsOf(turned).blockedRows);
  CHECK(countsOf(turned).differentLobes == 2);
}

TEST_CASE("groups of masks are counted once a sample, once a tile and once a frame") {
  const SphereTable table = SphereTable::load(cacheFolder());
  const Receivers receivers = fewReceivers();
  const auto spheres = verify::paperFrame(3).spheres;
  const FrameCounts counts = countFrame(spheres, receivers, &table, 160);
  const auto groupsOf = [&](int entry) {
    std::set<int> groups;
    const BitCube mask = table.mask(entry);
    for (int row = 0; row < bitCubeRows; ++row)
      if (mask.rows[row]) groups.insert(row / 16);
    return double(groups.size());
  };
  std::set<int> ofFrame;
  std::set<std::pair<std::size_t, int>> ofTiles;
  double all = 0, frame = 0, tiles = 0;
  for (std::size_t i = 0; i < receivers.size(); ++i)
    for (const Sphere& sphere : spheres) {
      const int entry = sphereTableEntry(sphere, receivers.positions[i], receivers.normals[i]);
      all += groupsOf(entry);
      if (ofFrame.insert(entry).second) frame += groupsOf(entry);
      if (ofTiles.insert({i / 16, entry}).second) tiles += groupsOf(entry);
    }
  CHECK(counts.maskGroups == all);
  CHECK(counts.maskGroupsOfTiles == tiles);
  CHECK(counts.maskGroupsOfFrame == frame);
  CHECK(counts.masksOfTiles == double(ofTiles.size()));
  CHECK(counts.masksOfFrame == double(ofFrame.size()));
  CHECK(frame < all);
  CHECK(counts.reachedRows == 0);
}

TEST_CASE("a row's stages are those that were timed") {
  const Record record = exampleRecord();
  const RowRoofline roofline = rooflineOf(record, 2, smallCounts(), ceilings);
  REQUIRE(roofline.stages.size() == 1);  // the example has merging only
  const StageRoofline& merge = roofline.stages[0];
  CHECK(merge.work.stage == &StageTimes::merge);
  CHECK(merge.measuredSeconds == record.rows[2].stageMedians.merge);
  CHECK(merge.share() == doctest::Approx(merge.limit.seconds / 0.006));
  CHECK(roofline.leastSeconds() == merge.limit.seconds);
}
