#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "verify/report/report.h"
#include "visibility/visibility_kind.h"

namespace haarlight::verify {

/// An engine on a device, in one shape and with one kind of visibility, to be compared with the
/// reference.
struct Subject {
  std::string engineName, device, shape;
  VisibilityKind visibility = VisibilityKind::exact;
  std::unique_ptr<Engine> engine;
};

struct Subjects {
  std::vector<Subject> list;
  /// Devices that are not there, and those that fail.
  std::vector<Absent> absent;
};

/// Opens every engine on every device in several shapes, exact and with `table`; `engines` names
/// those wanted, empty: all. Devices that fail the self test are noted as failed and compared
/// nevertheless, so that the report says where they go wrong. `progress` is told what is being
/// opened. Throws InputError for an engine that does not exist.
Subjects openSubjects(const std::vector<std::string>& engines,
                      std::shared_ptr<const SphereTable> table,
                      const std::function<void(const std::string&)>& progress);

/// "exact" or "table".
std::string nameOf(VisibilityKind visibility);

}  // namespace haarlight::verify
