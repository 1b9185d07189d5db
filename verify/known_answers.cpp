#include "verify/known_answers.h"

#include <bit>
#include <chrono>

#include "engine/engine.h"
#include "verify/cases/known_cases.h"
#include "verify/subjects.h"
#include "verify/tally.h"

namespace haarlight::verify {

namespace {

/// The rows for one kind of visibility.
class ReferenceRows {
 public:
  ReferenceRows(VisibilityKind visibility, std::shared_ptr<const SphereTable> table)
      : visibility_(visibility),
        reference_(makeReferenceEngine(visibility == VisibilityKind::table ? table : nullptr)) {}

  void compare(const KnownCase& known) {
    const Case& question = known.question;
    const bool byTable = visibility_ == VisibilityKind::table;
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
      if (radiance.visibility == visibility_) compareFrame(question, radiance);
  }

  void finishInto(std::vector<Row>& rows) const {
    for (const Tally* tally : {&entries_, &cubes_, &haar_, &frames_})
      if (const Row row = tally->finish(); row.compared > 0) rows.push_back(row);
  }

 private:
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
    return Tally(row);
  }

  VisibilityKind visibility_;
  std::unique_ptr<Engine> reference_;
  Tally entries_ = tallyOf(Stage::tableEntries), cubes_ = tallyOf(Stage::bitCubes),
        haar_ = tallyOf(Stage::haar), frames_ = tallyOf(Stage::frame);
};

}  // namespace

std::vector<Row> compareReferenceWithKnownAnswers(std::shared_ptr<const SphereTable> table) {
  const std::vector<KnownCase> cases = knownCases();
  std::vector<Row> rows;
  for (const VisibilityKind visibility : {VisibilityKind::exact, VisibilityKind::table}) {
    ReferenceRows reference(visibility, table);
    for (const KnownCase& known : cases) reference.compare(known);
    reference.finishInto(rows);
  }
  return rows;
}

}  // namespace haarlight::verify
