#pragma once

#include <memory>
#include <vector>

#include "verify/report/report.h"
#include "visibility/sphere_table.h"

namespace haarlight::verify {

/// Rows that compare the scalar reference with the known answers (verify/cases/known_cases.h).
/// Their bit cubes are compared word by word; coefficients and radiance by checksum, one per case.
std::vector<Row> compareReferenceWithKnownAnswers(std::shared_ptr<const SphereTable> table);

}  // namespace haarlight::verify
