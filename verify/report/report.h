#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cube/bit_cube.h"

namespace haarlight::verify {

/// The stages of a frame, each compared on its own: every stage gets the reference's results of the
/// stage before, so that a mismatch is reported where it arises. Only `frame` runs all of them, but
/// for `movedSpheres`, which has spheres of its own, and `exponentiation` and `transfer`, which are
/// other ways to shade.
enum class Stage {
  movedSpheres,
  tableEntries,
  bitCubes,
  haar,
  tripleProduct,
  fused,
  frame,
  exponentiation,
  transfer
};
inline constexpr std::array allStages{Stage::movedSpheres, Stage::tableEntries,   Stage::bitCubes,
                                      Stage::haar,         Stage::tripleProduct,  Stage::fused,
                                      Stage::frame,        Stage::exponentiation, Stage::transfer};

/// "moved spheres", "table entries", "bit cubes", "Haar coefficients", "triple product", "fused",
/// "frame", "exponentiation", "transfer".
std::string nameOf(Stage stage);

/// Whether a stage's results are float32 (else unsigned integers, which have no ULP).
bool givesFloats(Stage stage);

/// What a row says of its engine. `withinTolerance`: nothing differs by more than the row's
/// tolerance allows.
enum class Verdict { agrees, withinTolerance, differs, skipped };

/// "AGREES", "within tolerance", "DIFFERS", "skipped".
std::string nameOf(Verdict verdict);

/// Where one value stands, in words: "face +X, row 3, column 17", "face -Y, level 2, row 1,
/// column 0, diagonal", "sphere 12: column", "sphere 12: radius", "green", …
using Place = std::string;

/// A value that differs from the reference's.
struct Mismatch {
  std::string caseName;
  /// The receiver; of moved spheres, the sphere.
  std::size_t sample = 0;
  Place place;
  /// Whether the values are float32 (else unsigned integers).
  bool isFloat = false;
  std::uint32_t expectedBits = 0;
  std::uint32_t actualBits = 0;
  /// Steps between two float32 values; 0 for integers.
  std::uint64_t ulp = 0;
};

/// A picture of one mismatch: expected beside actual.
struct DifferencePicture {
  std::string title;
  int width = 0, height = 0;
  /// Row by row, 3 bytes (sRGB) a pixel. Bit cubes are 6 faces of 32×32 beside each other.
  std::vector<std::uint8_t> expected, actual, difference;
};

/// One line of the table: one stage of one engine on one device against the scalar reference.
struct Row {
  Stage stage = Stage::bitCubes;
  /// "exact" or "table"; "-" for stages that visibility does not touch.
  std::string visibility = "-";
  /// "50 terms, level I", … for sums, "order 4", … for exponentiation, "order 5, grey, 1 light", …
  /// for transfer; else empty.
  std::string setting;
  std::string engine;
  std::string device;
  /// "32 lanes, 1 sample a group", …
  std::string shape;

  /// Values compared, and those of them that differ (with a tolerance: differ beyond it).
  std::uint64_t compared = 0;
  std::uint64_t mismatches = 0;
  /// Over all compared floats (0 = equal bits); integers count as 0.
  std::uint64_t maximumUlp = 0;
  double medianUlp = 0;
  double seconds = 0;
  /// Why the bar is a tolerance on this device and not equal bits; empty: equal bits.
  std::string tolerance;
  /// Why nothing was compared; empty when something was.
  std::string skipReason;
  /// The first five.
  std::vector<Mismatch> firstMismatches;
  std::vector<DifferencePicture> pictures;

  bool skipped() const { return !skipReason.empty(); }
  bool agrees() const { return mismatches == 0; }
  Verdict verdict() const;
  /// Why it was skipped, or why it may differ from the reference as it does; else empty.
  std::string note() const;
  /// "triple product, exact, 50 terms, level I".
  std::string name() const;
};

/// An engine or device that was not run at all, or that failed before anything could be compared.
struct Absent {
  std::string engine;
  std::string device;
  std::string reason;
  /// A device that is there and does not work (fails its self test, does not build the kernels) is
  /// a failure; one that is not there is only shown.
  bool failed = false;
};

/// What became of the faults that were put into one engine's results (verify/injection.h).
struct FaultSummary {
  /// "sphere", "bit", "coefficient", "ulp", "exponentiation" or "transfer".
  std::string kind;
  std::string engine, device, shape, visibility;
  std::uint64_t injected = 0;
  /// Faults that a mismatch names with their case, sample and place.
  std::uint64_t located = 0;
  /// Mismatches where no fault was put.
  std::uint64_t unexplained = 0;

  bool allLocated() const { return injected > 0 && located == injected && unexplained == 0; }
};

/// Everything a run found.
struct Report {
  /// "haarlight 0.1.0", host processor, date in ISO 8601 UTC: what a reader needs to know which run
  /// it was.
  std::string program, host, date;
  std::uint64_t seed = 0;
  std::size_t knownCases = 0, sceneCases = 0, randomCases = 0;
  double seconds = 0;
  std::vector<Row> rows;
  std::vector<Absent> absent;
  std::vector<FaultSummary> faults;

  /// Rows that were not skipped.
  std::size_t comparedRows() const;
  /// Whether every row agrees, no device failed, and at least one row compared something.
  bool agrees() const;
  /// The same in one line for people; starts with "AGREES", "DIFFERS" or "FAILED".
  std::string conclusion() const;
};

/// The rows of one engine on one device in one shape, in the report's order.
struct RowGroup {
  /// "opencl · NVIDIA H200 · 32 lanes, 1 sample a group".
  std::string name;
  std::vector<const Row*> rows;
};

/// All rows in groups, in order of their first rows. The rows stay the report's.
std::vector<RowGroup> groupsOf(const Report& report);
std::vector<RowGroup> groupsOf(Report&&) = delete;

/// All different notes of the rows, in order of their first rows.
std::vector<std::string> notesOf(const Report& report);

/// "[2]" where notes[1] is the row's note; empty for a row without one.
std::string noteMark(const std::vector<std::string>& notes, const Row& row);

/// "0x3f800000 = 1": a value of a mismatch in hexadecimal and decimal.
std::string valueText(const Mismatch& mismatch, std::uint32_t bits);

/// "bit · opencl · NVIDIA H200 · 32 lanes, 1 sample a group · exact".
std::string nameOf(const FaultSummary& faults);

/// "500 injected, 500 located, 0 mismatches elsewhere".
std::string countsText(const FaultSummary& faults);

/// A row's first mismatches in words, two lines each, and how many more there are. Foreign text in
/// them is visible() (base/text_format.h).
std::vector<std::string> mismatchLines(const Row& row);

/// "seed 1 · 12 known, 4 scene and 500 random cases".
std::string casesText(const Report& report);

}  // namespace haarlight::verify
