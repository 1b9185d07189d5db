#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/devices.h"
#include "scene/names.h"
#include "visibility/visibility_kind.h"

namespace haarlight::benchmark {

inline constexpr std::array<Named<FramePath>, 2> framePathNames{{
    {"fused", FramePath::fused},
    {"staged", FramePath::staged},
}};

/// What is measured: an engine on a device with one kind of visibility, on one path.
struct Subject {
  DeviceDescription device;
  VisibilityKind visibility = VisibilityKind::exact;
  FramePath path = FramePath::fused;

  /// "exact" or "table".
  std::string visibilityName() const;
  /// "fused" or "staged".
  std::string pathName() const;
  /// "opencl · Some CPU · exact · fused".
  std::string name() const;
};

/// Which subjects are wanted.
struct SubjectFilter {
  /// Empty: all but the slow ones, reference and the emulation of CUDA on the host.
  std::vector<std::string> engines = {};
  /// Index within its engine, or a part of the name (case does not matter); empty: all.
  std::string device = {};
  std::vector<VisibilityKind> visibilities{VisibilityKind::exact, VisibilityKind::table};
  std::vector<FramePath> paths{FramePath::fused, FramePath::staged};
};

/// The usable ones among `devices`; paths and kinds of visibility do not matter. Throws InputError
/// when an engine is unknown.
std::vector<DeviceDescription> selectDevices(const std::vector<DeviceDescription>& devices,
                                             const SubjectFilter& filter);

/// Those devices, each with every kind of visibility and path asked for; the
/// reference has one path, which stands for both. Throws InputError when an engine is unknown or
/// none is left, with `advice` on what could be done.
std::vector<Subject> selectSubjects(const std::vector<DeviceDescription>& devices,
                                    const SubjectFilter& filter, const std::string& advice);

/// A subject that is ready for frames.
struct OpenSubject {
  Subject subject;
  std::shared_ptr<Engine> engine;
  /// Seconds it took: compiling or loading kernels, upload of the sphere table, self test.
  double openSeconds = 0;
};

/// `table` is used where the subject's visibility is that of the table. Throws what makeEngine
/// does.
OpenSubject openSubject(const Subject& subject, std::shared_ptr<const SphereTable> table);

}  // namespace haarlight::benchmark
