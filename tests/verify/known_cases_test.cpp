// Where the known answers come from: oracle.h computes them from the definitions. Hashes of
// radiance alone come from the scalar reference, and only their kind is checked independently:
// radiance with all terms against the sum over texels.
//
// With HAARLIGHT_WRITE_KNOWN_ANSWERS=<file> in the environment, the first test writes the answers
// to the cases of tests/data/known_answers.txt to <file> instead of checking them.

#include "verify/cases/known_cases.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "engine/engine.h"
#include "known_answers_writer.h"
#include "oracle.h"
#include "test_support.h"
#include "visibility/sphere_table.h"

using namespace haarlight;
using namespace haarlight::test;
using namespace haarlight::verify;

namespace {

const std::string answersFile = HAARLIGHT_KNOWN_ANSWERS "/known_answers.txt";

Engine& referenceEngine(VisibilityKind visibility) {
  static const auto exact = makeReferenceEngine(nullptr);
  static const auto table =
      makeReferenceEngine(std::make_shared<const SphereTable>(SphereTable::load(cacheFolder())));
  return visibility == VisibilityKind::exact ? *exact : *table;
}

std::vector<glm::vec4> referenceRadiance(const Case& question, const KnownRadiance& setting) {
  Engine& engine = referenceEngine(setting.visibility);
  ShadingSettings settings;
  settings.terms = setting.terms;
  settings.levels = setting.levels;
  engine.setShading(
      buildShadingTables(question.light, settings, countLobes(question.receivers.lobes)));
  return engine.shade(question.spheres, question.receivers);
}

/// A whole frame is pinned by its radiance only.
bool isFrame(const Case& question) {
  return question.receivers.size() > 64;
}

/// Answers from the oracle, but for the hashes of radiance.
KnownCase answered(const Case& question) {
  KnownCase known;
  known.question = question;
  known.movedSpheres = oracleMovedSpheres(question.binding, question.vertices);
  if (isFrame(question)) {
    for (const auto visibility : {VisibilityKind::exact, VisibilityKind::table})
      known.radiance.push_back({visibility, 200, 2, 0});
    return known;
  }
  std::vector<OcclusionHaar> occlusion;
  for (std::size_t i = 0; i < question.receivers.size(); ++i) {
    const glm::dvec3 position(question.receivers.positions[i]),
        normal(question.receivers.normals[i]);
    std::vector<std::uint32_t> entries;
    for (const Sphere& sphere : question.spheres)
      entries.push_back(oracleTableEntry(sphere, position, normal));
    known.tableEntries.insert(known.tableEntries.end(), entries.begin(), entries.end());
    known.exactBitCubes.push_back(oracleExactBitCube(question.spheres, position, normal));
    known.tableBitCubes.push_back(oracleTableBitCube(entries));
    occlusion.push_back(oracleOcclusion(known.exactBitCubes.back()));
  }
  known.haarHash = hashOf(occlusion);
  for (const auto visibility : {VisibilityKind::exact, VisibilityKind::table})
    for (const int terms : {50, 200, 6144})
      for (const int levels : {1, 2}) known.radiance.push_back({visibility, terms, levels, 0});
  return known;
}

void checkSameSpheres(const std::vector<Sphere>& found, const std::vector<Sphere>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i].center == expected[i].center);
    CHECK(found[i].radius == expected[i].radius);
  }
}

std::vector<KnownCase> answersOfFile() {
  std::vector<KnownCase> known;
  for (const KnownCase& asked : readKnownCases(readFile(answersFile), answersFile))
    known.push_back(answered(asked.question));
  return known;
}

bool writesAnswers() {
  const char* target = std::getenv("HAARLIGHT_WRITE_KNOWN_ANSWERS");
  if (!target) return false;
  auto known = answersOfFile();
  for (KnownCase& one : known)
    for (KnownRadiance& radiance : one.radiance)
      radiance.hash = hashOf(referenceRadiance(one.question, radiance));
  writeFileAtomically(target, withAnswers(readFile(answersFile), known));
  return true;
}

}  // namespace

TEST_CASE("every known answer about bits follows from the definitions") {
  if (writesAnswers()) return;
  const auto known = knownCases();
  REQUIRE(known.size() >= 22);
  for (const KnownCase& one : known) {
    CAPTURE(one.question.name);
    const KnownCase expected = answered(one.question);
    checkSameSpheres(one.movedSpheres, expected.movedSpheres);
    CHECK(one.tableEntries == expected.tableEntries);
    REQUIRE(one.exactBitCubes.size() == expected.exactBitCubes.size());
    for (std::size_t i = 0; i < expected.exactBitCubes.size(); ++i) {
      CAPTURE(i);
      CHECK(one.exactBitCubes[i] == expected.exactBitCubes[i]);
      CHECK(one.tableBitCubes[i] == expected.tableBitCubes[i]);
    }
    CHECK(one.haarHash == expected.haarHash);
    REQUIRE(one.radiance.size() == expected.radiance.size());
    for (std::size_t i = 0; i < expected.radiance.size(); ++i) {
      CHECK(one.radiance[i].visibility == expected.radiance[i].visibility);
      CHECK(one.radiance[i].terms == expected.radiance[i].terms);
      CHECK(one.radiance[i].levels == expected.radiance[i].levels);
    }
  }
}

TEST_CASE("the scalar reference gives the known bits") {
  for (const KnownCase& one : knownCases()) {
    if (isFrame(one.question)) continue;
    CAPTURE(one.question.name);
    const auto& [spheres, receivers] = std::tie(one.question.spheres, one.question.receivers);
    Engine& exact = referenceEngine(VisibilityKind::exact);
    checkSameSpheres(moveSpheres(one.question.binding, one.question.vertices), one.movedSpheres);
    CHECK(exact.sphereTableEntries(spheres, receivers) == one.tableEntries);
    CHECK(exact.mergeBitCubes(spheres, receivers) == one.exactBitCubes);
    CHECK(referenceEngine(VisibilityKind::table).mergeBitCubes(spheres, receivers) ==
          one.tableBitCubes);
    CHECK(hashOf(exact.transformOcclusion(one.exactBitCubes)) == one.haarHash);
  }
}

TEST_CASE("the scalar reference gives the pinned radiance") {
  for (const KnownCase& one : knownCases())
    for (const KnownRadiance& radiance : one.radiance) {
      CAPTURE(one.question.name);
      CAPTURE(radiance.terms);
      CAPTURE(radiance.levels);
      CHECK(hashOf(referenceRadiance(one.question, radiance)) == radiance.hash);
    }
}

TEST_CASE("the radiance that is pinned for all terms is the sum over texels") {
  for (const KnownCase& one : knownCases()) {
    if (isFrame(one.question)) continue;
    CAPTURE(one.question.name);
    for (const auto visibility : {VisibilityKind::exact, VisibilityKind::table}) {
      const auto& cubes =
          visibility == VisibilityKind::exact ? one.exactBitCubes : one.tableBitCubes;
      const auto radiance = referenceRadiance(one.question, {visibility, 6144, 2, 0});
      for (std::size_t i = 0; i < radiance.size(); ++i) {
        const auto expected =
            oracleRadiance(one.question.light, cubes[i], one.question.receivers.lobes[i]);
        for (int channel = 0; channel < 3; ++channel)
          CHECK(std::abs(radiance[i][channel] - expected.shadowed[channel]) <=
                1e-6 * expected.unshadowed[channel]);
      }
    }
  }
}

TEST_CASE("the known cases meet what they are named for") {
  std::map<std::string, KnownCase> cases;
  for (KnownCase& one : knownCases()) cases[one.question.name] = std::move(one);
  const auto blockedTexels = [&](const std::string& name, std::size_t receiver) {
    int count = 0;
    for (int texel = 0; texel < texelCount; ++texel)
      count += cases.at("known: " + name).exactBitCubes[receiver].blocked(texel);
    return count;
  };
  CHECK(blockedTexels("nothing in the way", 0) == 0);
  CHECK(blockedTexels("inside a sphere whose centre is above", 0) == texelCount / 2);
  const std::string below = "centres below the tangent plane";
  for (const std::size_t receiver : {0, 1, 2, 3})
    CHECK(blockedTexels(below, receiver) >= blockedTexels(below, receiver + 1));
  CHECK(blockedTexels(below, 2) > 0);
  CHECK(blockedTexels(below, 4) == 0);
  // The ground, half of all directions, does not block a receiver that lies on it, but one upright.
  CHECK(blockedTexels("huge spheres", 0) < texelCount / 4);
  CHECK(blockedTexels("huge spheres", 1) == texelCount / 2 + blockedTexels("huge spheres", 0) / 2);
  CHECK(cases.at("known: 33 spheres").question.spheres.size() == 33);
  std::set<std::uint32_t> facesHit;
  for (const auto entry : cases.at("known: a sphere beside each axis").tableEntries)
    facesHit.insert(entry / 32 / texelsPerFace);
  CHECK(facesHit.size() == 6);
}

TEST_CASE("the known moved spheres follow a box as they should") {
  std::map<std::string, std::vector<Sphere>> spheres;
  for (const KnownCase& one : knownCases()) spheres[one.question.name] = one.movedSpheres;
  const auto& box = spheres.at("known: spheres that follow a box");
  REQUIRE(box.size() == 12);
  for (int i = 0; i < 3; ++i) {
    const auto& [center, radius] = box[i];
    CHECK(box[3 + i].center == center + glm::vec3(1000.5f, -64, 0.25f));
    CHECK(box[6 + i].center == glm::vec3(center.x, -center.z, center.y));
    CHECK(box[9 + i].center == 2.0f * center);
    CHECK(radius == (i < 2 ? 3 : 7));
    for (const int pose : {1, 2}) CHECK(box[3 * pose + i].radius == radius);
    CHECK(box[9 + i].radius == 2 * radius);
  }
  for (const Sphere& sphere : spheres.at("known: spheres that follow one point"))
    CHECK(sphere.radius == 0);
  CHECK(spheres.at("known: lists of 32, 33 and 64 vertices").size() == 3);
  CHECK(spheres.at("known: 33 spheres along a chain").size() == 33);
}

TEST_CASE("known answers that do not fit their case are refused by name of the line") {
  const std::string start =
      "haarlight-known-answers 1\nname a\nlight constant 1 1 1\nsphere 0 2 0 1\n"
      "receiver 0 0 0 0 1 0\n";
  const auto refused = [&](const std::string& lines, const std::string& message) {
    CAPTURE(lines);
    CHECK_THROWS_WITH_AS(readKnownCases(start + lines, "f"), message.c_str(), InputError);
  };
  CHECK(readKnownCases(start + "entries 0 5\nexact 0 0 0000ffff\nhaar 0123456789abcdef\n", "f")[0]
            .exactBitCubes[0]
            .rows[0] == 0xffff);
  refused("entries 1 5\n", "f:6: the receiver must be a whole number from 0 to 0, not '1'");
  refused("entries 0\n", "f:6: a table entry is missing; add it to the line");
  refused("entries 0 5 6\n", "f:6: remove '6' at the end of the line");
  refused("haar 0123456789abcdef\n",
          "f:6: the case lacks the table entries of a receiver; add a line 'entries …'");
  refused("entries 0 5\n", "f:6: the case has bit cubes but no line 'haar hash'; add it");
  refused("exact 0 191 00000001 00000002\n",
          "f:6: there are more words than the bit cube has rows");
  refused("exact 0 0 1\n", "f:6: a row's word must be 8 hexadecimal digits, not '1'");
  refused("radiance other 50 1 0123456789abcdef\n",
          "f:6: the visibility must be 'exact' or 'table'");
  refused("entries 0 5\nsphere 0 0 0 1\n",
          "f:7: the line must be one of a case (before its answers) or begin with entries, exact, "
          "table, haar, radiance or moved");
  const std::string bound = "vertex 1 2 3\nbound 1 0\nfollows 0 1 1 0\n";
  CHECK(readKnownCases(start + bound + "moved 1 2 3 0\n", "f")[0].movedSpheres[0].center ==
        glm::vec3(1, 2, 3));
  refused("vertex 1 2 3\nbound 1 0\nfollows 0 1 1 0\n" + bound + "moved 1 2 3 0\n",
          "f:12: the case needs a line 'moved x y z radius' for each bound sphere");
  refused(bound + "moved 1 2 3 0\nmoved 1 2 3 0\n",
          "f:10: the case needs a line 'moved x y z radius' for each bound sphere");
  refused(bound + "moved 1 2 3\n", "f:9: the radius is missing; add it to the line");
  CHECK_THROWS_WITH_AS(readKnownCases("haarlight-known-answers 1\nlight constant 1 1 1\n", "f"),
                       "f:2: a case must begin with a line 'name …'", InputError);
}
