#include "verify/report/report.h"

#include <algorithm>
#include <bit>

#include "base/text_format.h"

namespace haarlight::verify {

namespace {

std::uint64_t rowsWith(Verdict verdict, const Report& report) {
  const auto same = [&](const Row& row) { return row.verdict() == verdict; };
  return std::uint64_t(std::count_if(report.rows.begin(), report.rows.end(), same));
}

std::uint64_t failedDevices(const Report& report) {
  const auto failed = [](const Absent& device) { return device.failed; };
  return std::uint64_t(std::count_if(report.absent.begin(), report.absent.end(), failed));
}

std::uint64_t sumOverRows(const Report& report, std::uint64_t Row::*count) {
  std::uint64_t sum = 0;
  for (const Row& row : report.rows) sum += row.*count;
  return sum;
}

}  // namespace

std::string nameOf(Stage stage) {
  switch (stage) {
    case Stage::movedSpheres:
      return "moved spheres";
    case Stage::tableEntries:
      return "table entries";
    case Stage::bitCubes:
      return "bit cubes";
    case Stage::haar:
      return "Haar coefficients";
    case Stage::tripleProduct:
      return "triple product";
    case Stage::fused:
      return "fused";
    case Stage::frame:
      return "frame";
    case Stage::exponentiation:
      return "exponentiation";
    case Stage::transfer:
      return "transfer";
  }
  return {};
}

bool givesFloats(Stage stage) {
  return stage != Stage::tableEntries && stage != Stage::bitCubes;
}

std::string nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::agrees:
      return "AGREES";
    case Verdict::withinTolerance:
      return "within tolerance";
    case Verdict::differs:
      return "DIFFERS";
    case Verdict::skipped:
      return "skipped";
  }
  return {};
}

Verdict Row::verdict() const {
  if (!agrees()) return Verdict::differs;
  if (skipped() || compared == 0) return Verdict::skipped;
  return tolerance.empty() ? Verdict::agrees : Verdict::withinTolerance;
}

std::string Row::note() const {
  switch (verdict()) {
    case Verdict::agrees:
      return {};
    case Verdict::skipped:
      return skipped() ? skipReason : "nothing was compared";
    default:
      return tolerance;
  }
}

std::string Row::name() const {
  return joined({nameOf(stage), visibility == "-" ? "" : visibility, setting}, ", ");
}

std::size_t Report::comparedRows() const {
  return rows.size() - rowsWith(Verdict::skipped, *this);
}

bool Report::agrees() const {
  return rowsWith(Verdict::differs, *this) == 0 && failedDevices(*this) == 0 && comparedRows() > 0;
}

std::string Report::conclusion() const {
  const std::uint64_t differing = rowsWith(Verdict::differs, *this);
  const std::uint64_t tolerated = rowsWith(Verdict::withinTolerance, *this);
  const std::uint64_t failures = failedDevices(*this);
  const std::string failed = failures == 0 ? "" : countText(failures, "device") + " failed";
  if (differing > 0)
    return "DIFFERS: " + joined({countText(sumOverRows(*this, &Row::mismatches), "value") + " in " +
                                     countText(differing, "row"),
                                 failed},
                                "; ");
  if (failures > 0) return "FAILED: " + failed;
  if (comparedRows() == 0) return "FAILED: nothing was compared";
  return "AGREES: " + countText(sumOverRows(*this, &Row::compared), "value") + " in " +
         countText(comparedRows(), "row") +
         (tolerated == 0 ? ", all with the reference's bits"
                         : ", " + countText(tolerated, "row") + " of them within a tolerance");
}

std::vector<RowGroup> groupsOf(const Report& report) {
  std::vector<RowGroup> groups;
  for (const Row& row : report.rows) {
    const auto sameGroup = [&](const RowGroup& group) {
      const Row& first = *group.rows.front();
      return first.engine == row.engine && first.device == row.device && first.shape == row.shape;
    };
    auto group = std::find_if(groups.begin(), groups.end(), sameGroup);
    if (group == groups.end())
      group = groups.insert(group, {joined({row.engine, row.device, row.shape}, " · "), {}});
    group->rows.push_back(&row);
  }
  return groups;
}

std::vector<std::string> notesOf(const Report& report) {
  std::vector<std::string> notes;
  for (const RowGroup& group : groupsOf(report))
    for (const Row* row : group.rows)
      if (const std::string note = row->note();
          !note.empty() && std::find(notes.begin(), notes.end(), note) == notes.end())
        notes.push_back(note);
  return notes;
}

std::string noteMark(const std::vector<std::string>& notes, const Row& row) {
  const auto note = std::find(notes.begin(), notes.end(), row.note());
  return note == notes.end() ? "" : "[" + numberText(note - notes.begin() + 1) + "]";
}

std::string valueText(const Mismatch& mismatch, std::uint32_t bits) {
  const std::string decimal =
      mismatch.isFloat ? floatText(std::bit_cast<float>(bits)) : countText(bits);
  return bitsText(bits) + " = " + decimal;
}

std::string nameOf(const FaultSummary& faults) {
  return joined({faults.kind, faults.engine, faults.device, faults.shape, faults.visibility},
                " · ");
}

std::string countsText(const FaultSummary& faults) {
  return countText(faults.injected) + " injected, " + countText(faults.located) + " located, " +
         countText(faults.unexplained) + " mismatches elsewhere";
}

std::vector<std::string> mismatchLines(const Row& row) {
  std::vector<std::string> lines;
  for (const Mismatch& mismatch : row.firstMismatches) {
    const std::string distance = mismatch.isFloat ? "   " + countText(mismatch.ulp) + " ULP" : "";
    lines.push_back(visible(mismatch.caseName) + " · sample " + countText(mismatch.sample) + " · " +
                    visible(mismatch.place));
    lines.push_back("  expected " + valueText(mismatch, mismatch.expectedBits) + "   actual " +
                    valueText(mismatch, mismatch.actualBits) + distance);
  }
  if (row.mismatches > row.firstMismatches.size())
    lines.push_back("and " + countText(row.mismatches - row.firstMismatches.size()) + " more");
  return lines;
}

std::string casesText(const Report& report) {
  return "seed " + numberText(report.seed) + " · " + countText(report.knownCases) + " known, " +
         countText(report.sceneCases) + " scene and " + countText(report.randomCases) +
         " random cases";
}

}  // namespace haarlight::verify
