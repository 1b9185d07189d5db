#include "verify/known_answers.h"

#include <bit>
#include <chrono>

#include "base/file.h"
#include "engine/engine.h"
#include "material/cosine_lobe.h"
#include "verify/cases/known_cases.h"
#include "verify/subjects.h"
#include "verify/tally.h"

namespace haarlight::verify {

namespace {

/// Checksum of some lobes as the C library of the known answers prepares them.
constexpr std::uint64_t knownLobesChecksum = 0x58693723cdbeae5b;

std::uint64_t lobesChecksum() {
  constexpr int everyHundredth = 100;
  std::vector<float> coefficients;
  for (int lobe = 0; lobe < lobeCount; lobe += everyHundredth)
    for (const HaarFace<float>& face : lobeHaar(lobe))
      coefficients.insert(coefficients.end(), face.coefficients.begin(), face.coefficients.end());
  return checksum({reinterpret_cast<const std::uint8_t*>(coefficients.data()),
                   coefficients.size() * sizeof(float)});
}

/// The rows for one kind of visibility.
class ReferenceRows {
 public:
  /// `knowsRadiance`: whether the known radiances hold with this machine's lobes.
  ReferenceRows(VisibilityKind visibility, std::shared_ptr<const SphereTable> table,
                bool knowsRadiance)
      : visibility_(visibility),
        knowsRadiance_(knowsRadiance),
        reference_(makeReferenceEngine(visibility == VisibilityKind::table ? table : nullptr)) {}

  void compare(const KnownCase& known) {
    const Case& question = known.question;
    const bool byTable = visibility_ == VisibilityKind::table;
    if (!byTable && !known.movedSpheres.empty()) compareMovedSpheres(known);
    if (known.haarHash != 0) {
      if (byTable)
        entries_.compareEntries(
            question, known.tableEntries,
            reference_->sphereTableEntries(question.spheres, question.receivers));
      const auto cubes = reference_->mergeBitCubes(question.spheres, question.receivers);
      cubes_.compareBitCubes(question, byTable ? known.tableBitCubes : known.exactBitCubes, cubes);
      if (!byTable)
        haar_.compareChecksums(question, known.haarHash,
                               hashOf(reference_->transformOcclusion(cubes)));
    }
    for (const KnownRadiance& radiance : known.radiance)
      if (knowsRadiance_ && radiance.visibility == visibility_) compareFrame(question, radiance);
  }

  void finishInto(std::vector<Row>& rows) const {
    for (const Tally* tally : {&moved_, &entries_, &cubes_, &haar_, &frames_})
      if (const Row row = tally->finish(); row.compared > 0 || row.skipped()) rows.push_back(row);
  }

 private:
  void compareMovedSpheres(const KnownCase& known) {
    reference_->setSphereBinding(known.question.binding);
    moved_.compareMovedSpheres(known.question, known.movedSpheres,
                               reference_->moveSpheres(known.question.vertices));
  }

  void compareFrame(const Case& question, const KnownRadiance& known) {
    ShadingSettings settings;
    settings.terms = known.terms;
    settings.levels = known.levels;
    reference_->setShading(
        buildShadingTables(question.light, settings, countLobes(question.receivers.lobes)));
    frames_.compareChecksums(question, known.hash,
                             hashOf(reference_->shade(question.spheres, question.receivers)));
  }

  Tally tallyOf(Stage stage) const {
    Row row;
    row.stage = stage;
    row.visibility = nameOf(visibility_);
    row.setting = "known answers";
    row.engine = reference_->name();
    row.device = reference_->deviceName();
    if (stage == Stage::frame && !knowsRadiance_)
      row.skipReason =
          "the C library of this machine prepares lobes with other last digits than "
          "the one the known radiances come from";
    return Tally(row);
  }

  VisibilityKind visibility_;
  bool knowsRadiance_;
  std::unique_ptr<Engine> reference_;
  Tally moved_ = tallyOf(Stage::movedSpheres), entries_ = tallyOf(Stage::tableEntries),
        cubes_ = tallyOf(Stage::bitCubes), haar_ = tallyOf(Stage::haar),
        frames_ = tallyOf(Stage::frame);
};

}  // namespace

std::vector<Row> compareReferenceWithKnownAnswers(std::shared_ptr<const SphereTable> table) {
  const std::vector<KnownCase> cases = knownCases();
  const bool knowsRadiance = lobesChecksum() == knownLobesChecksum;
  std::vector<Row> rows;
  for (const VisibilityKind visibility : {VisibilityKind::exact, VisibilityKind::table}) {
    ReferenceRows reference(visibility, table, knowsRadiance);
    for (const KnownCase& known : cases) reference.compare(known);
    reference.finishInto(rows);
  }
  return rows;
}

}  // namespace haarlight::verify
