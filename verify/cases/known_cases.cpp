#include "verify/cases/known_cases.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/file.h"
#include "embedded/known_answers.h"
#include "engine/shading_tables.h"
#include "verify/cases/case_lines.h"
#include "visibility/sphere_table.h"

namespace haarlight::verify {

namespace {

constexpr std::uint32_t noEntry = ~0u;

/// Reads one case, first the question, then the answers.
class KnownCaseLines {
 public:
  void read(LineReader& line) {
    const bool isQuestion = !hasAnswers_ && question_.read(line);
    if (isQuestion) return;
    readAnswer(line);
    line.endLine();
  }

  KnownCase finish(const LineReader& line) {
    startAnswers();
    known_.question = question_.finish(line);
    const std::size_t moved = known_.movedSpheres.size();
    if (moved != 0 && moved != known_.question.binding.sphereCount())
      line.fail("the case needs a line 'moved x y z radius' for each bound sphere");
    if (hasHaar_) {
      if (std::ranges::count(known_.tableEntries, noEntry))
        line.fail("the case lacks the table entries of a receiver; add a line 'entries …'");
    } else {
      if (hasBits_) line.fail("the case has bit cubes but no line 'haar hash'; add it");
      known_.tableEntries.clear();
      known_.exactBitCubes.clear();
      known_.tableBitCubes.clear();
    }
    return std::move(known_);
  }

 private:
  /// Makes room for the answers to the question.
  void startAnswers() {
    if (std::exchange(hasAnswers_, true)) return;
    const Case& question = question_.value();
    known_.tableEntries.assign(question.receivers.size() * question.spheres.size(), noEntry);
    known_.exactBitCubes.resize(question.receivers.size());
    known_.tableBitCubes.resize(question.receivers.size());
  }

  void readAnswer(LineReader& line) {
    startAnswers();
    const std::string_view keyword = line.keyword();
    if (keyword == "entries")
      readEntries(line);
    else if (keyword == "exact")
      readRows(line, known_.exactBitCubes);
    else if (keyword == "table")
      readRows(line, known_.tableBitCubes);
    else if (keyword == "haar")
      readHaar(line);
    else if (keyword == "radiance")
      readRadiance(line);
    else if (keyword == "moved")
      known_.movedSpheres.push_back(readSphere(line));
    else
      line.fail(
          "the line must be one of a case (before its answers) or begin with entries, exact, "
          "table, haar, radiance or moved");
  }

  std::size_t readReceiver(LineReader& line) {
    const std::size_t count = question_.value().receivers.size();
    if (count == 0) line.fail("the case has no receiver yet; its answers must follow the question");
    hasBits_ = true;
    return line.wholeNumber("the receiver", 0, count - 1);
  }

  void readEntries(LineReader& line) {
    const std::size_t count = question_.value().spheres.size(), first = readReceiver(line) * count;
    for (std::size_t i = 0; i < count; ++i)
      known_.tableEntries[first + i] =
          std::uint32_t(line.wholeNumber("a table entry", 0, sphereTableEntries - 1));
  }

  void readRows(LineReader& line, std::vector<BitCube>& cubes) {
    BitCube& cube = cubes[readReceiver(line)];
    for (auto row = line.wholeNumber("the first row", 0, bitCubeRows - 1); line.hasWord(); ++row) {
      if (row == bitCubeRows) line.fail("there are more words than the bit cube has rows");
      cube.rows[row] = std::uint32_t(line.hexadecimal("a row's word", 8));
    }
  }

  void readHaar(LineReader& line) {
    if (hasHaar_) line.fail("the case has a haar line already; remove one of them");
    hasHaar_ = true;
    known_.haarHash = line.hexadecimal("the hash", 16);
  }

  void readRadiance(LineReader& line) {
    KnownRadiance radiance;
    const std::string_view visibility = line.word("the visibility");
    if (visibility != "exact" && visibility != "table")
      line.fail("the visibility must be 'exact' or 'table'");
    radiance.visibility = visibility == "exact" ? VisibilityKind::exact : VisibilityKind::table;
    radiance.terms = int(line.wholeNumber("the number of terms", 0, maximumTerms));
    radiance.levels = int(line.wholeNumber("the number of levels", 1, 2));
    radiance.hash = line.hexadecimal("the hash", 16);
    known_.radiance.push_back(radiance);
  }

  static Sphere readSphere(LineReader& line) {
    const float x = line.number("x"), y = line.number("y"), z = line.number("z");
    return {{x, y, z}, line.number("the radius")};
  }

  CaseLines question_;
  KnownCase known_;
  bool hasAnswers_ = false, hasBits_ = false, hasHaar_ = false;
};

template <typename Value>
std::uint64_t hashOfBytes(std::span<const Value> values) {
  return checksum({reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()});
}

}  // namespace

std::vector<KnownCase> readKnownCases(const std::string& text, const std::string& source) {
  LineReader line(text, source);
  line.expectHeader("haarlight-known-answers");
  std::vector<KnownCase> cases;
  std::optional<KnownCaseLines> current;
  while (line.next()) {
    if (line.keyword() == "name") {
      if (current) cases.push_back(current->finish(line));
      current.emplace();
    }
    if (!current) line.fail("a case must begin with a line 'name …'");
    current->read(line);
  }
  if (current) cases.push_back(current->finish(line));
  return cases;
}

std::vector<KnownCase> knownCases() {
  const std::string_view text = embedded::known_answers("known_answers.txt");
  return readKnownCases(std::string(text), "known_answers.txt");
}

std::uint64_t hashOf(std::span<const OcclusionHaar> occlusion) {
  return hashOfBytes(occlusion);
}

std::uint64_t hashOf(std::span<const glm::vec4> radiance) {
  return hashOfBytes(radiance);
}

}  // namespace haarlight::verify
