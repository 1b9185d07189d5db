#include "verify/subjects.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "engine/devices.h"
#include "engine/kernel_shape.h"
#include "engine/self_test.h"

namespace haarlight::verify {

namespace {

/// What engines use by themselves on CPUs and on GPUs, and, where the hardware runs work-groups at
/// once, groups of one sample and full ones.
std::vector<KernelShape> shapesOf(const DeviceDescription& device) {
  if (device.emulation) return {{1, 4}};
  if (device.isCpu) return {{32, 1}, {1, 4}};
  if (device.engine == "opencl") return {{1, 1}, {1, 4}, {1, 8}, {32, 1}};
  return {{1, 1}, {1, 4}, {1, 8}};
}

/// Opens one subject; a failure becomes a note.
void open(const DeviceDescription& device, const KernelShape& shape,
          const std::shared_ptr<const SphereTable>& table, Subjects& subjects) {
  EngineOptions options = optionsFor(device);
  options.lanesPerItem = shape.lanesPerItem;
  options.samplesPerGroup = shape.samplesPerGroup;
  options.selfTest = false;
  const auto note = [&](const std::string& reason) {
    subjects.absent.push_back({device.engine, device.name, nameOf(shape) + ": " + reason, true});
  };
  try {
    auto engine = makeEngine(options, table);
    if (const std::string failure = selfTestFailure(*engine, table); !failure.empty())
      note("fails the self test: " + failure);
    subjects.list.push_back({device.engine, device.name, nameOf(shape),
                             table ? VisibilityKind::table : VisibilityKind::exact,
                             std::move(engine)});
  } catch (const std::exception& problem) {
    note(problem.what());
  }
}

void checkNames(const std::vector<std::string>& engines) {
  constexpr std::array known{"reference", "opencl", "cuda", "cuda-host"};
  for (const std::string& name : engines)
    if (std::ranges::find(known, name) == known.end())
      throw InputError("unknown engine '" + name + "': use opencl, cuda or cuda-host");
}

}  // namespace

std::string nameOf(VisibilityKind visibility) {
  return visibility == VisibilityKind::table ? "table" : "exact";
}

Subjects openSubjects(const std::vector<std::string>& engines,
                      std::shared_ptr<const SphereTable> table,
                      const std::function<void(const std::string&)>& progress) {
  checkNames(engines);
  const auto wanted = [&](const std::string& engine) {
    return engines.empty() || std::ranges::find(engines, engine) != engines.end();
  };
  Subjects subjects;
  for (const DeviceDescription& device : listDevices()) {
    if (device.engine == "reference" || !wanted(device.engine)) continue;
    if (!device.problem.empty()) {
      subjects.absent.push_back({device.engine, device.name, device.problem, false});
      continue;
    }
    for (const KernelShape& shape : shapesOf(device)) {
      progress(device.engine + " on " + device.name + ", " + nameOf(shape));
      open(device, shape, nullptr, subjects);
      open(device, shape, table, subjects);
    }
  }
  if (const std::string advice = openClAdvice(); !advice.empty() && wanted("opencl"))
    subjects.absent.push_back({"opencl", "", advice, false});
  return subjects;
}

}  // namespace haarlight::verify
