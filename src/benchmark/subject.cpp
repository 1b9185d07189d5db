#include "benchmark/subject.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text_format.h"

namespace haarlight::benchmark {

namespace {

std::string lowerCase(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool isNumber(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c); });
}

void checkNames(const std::vector<std::string>& engines) {
  constexpr std::array known{"reference", "opencl", "cuda", "cuda-host"};
  for (const std::string& name : engines)
    if (std::ranges::find(known, name) == known.end())
      throw InputError("--engine " + name + ": use opencl, cuda, reference or cuda-host");
}

bool isWanted(const DeviceDescription& device, const SubjectFilter& filter) {
  if (!device.problem.empty()) return false;
  const bool isSlow = device.engine == "reference" || device.emulation;
  if (filter.engines.empty()
          ? isSlow
          : std::ranges::find(filter.engines, device.engine) == filter.engines.end())
    return false;
  if (filter.device.empty()) return true;
  if (isNumber(filter.device)) return filter.device == std::to_string(device.index);
  return lowerCase(device.name).find(lowerCase(filter.device)) != std::string::npos;
}

std::vector<FramePath> pathsOf(const DeviceDescription& device, const SubjectFilter& filter) {
  return device.engine == "reference" ? std::vector{FramePath::staged} : filter.paths;
}

template <typename Names, typename Choice>
std::string nameIn(const Names& names, Choice choice) {
  return std::string(
      std::ranges::find(names, choice, [](const auto& n) { return n.choice; })->name);
}

}  // namespace

std::string Subject::visibilityName() const {
  return nameIn(visibilityKindNames, visibility);
}

std::string Subject::pathName() const {
  return nameIn(framePathNames, path);
}

std::string Subject::name() const {
  return joined({device.engine, device.name, visibilityName(), pathName()}, " · ");
}

std::vector<DeviceDescription> selectDevices(const std::vector<DeviceDescription>& devices,
                                             const SubjectFilter& filter) {
  checkNames(filter.engines);
  std::vector<DeviceDescription> wanted;
  for (const DeviceDescription& device : devices)
    if (isWanted(device, filter)) wanted.push_back(device);
  return wanted;
}

std::vector<Subject> selectSubjects(const std::vector<DeviceDescription>& devices,
                                    const SubjectFilter& filter, const std::string& advice) {
  std::vector<Subject> subjects;
  for (const DeviceDescription& device : selectDevices(devices, filter))
    for (const VisibilityKind visibility : filter.visibilities)
      for (const FramePath path : pathsOf(device, filter))
        subjects.push_back({device, visibility, path});
  if (!subjects.empty()) return subjects;
  const std::string device = filter.device.empty() ? "" : " '" + filter.device + "'";
  throw InputError(joined({"no usable device" + device + " to measure",
                           filter.device.empty() ? advice : "see haarlight devices",
                           filter.engines.empty() ? "or give --engine reference" : ""},
                          "; "));
}

OpenSubject openSubject(const Subject& subject, std::shared_ptr<const SphereTable> table) {
  EngineOptions options = optionsFor(subject.device);
  options.path = subject.path;
  const Stopwatch watch;
  OpenSubject opened{subject, nullptr, 0};
  opened.engine =
      makeEngine(options, subject.visibility == VisibilityKind::table ? std::move(table) : nullptr);
  opened.openSeconds = watch.total();
  return opened;
}

}  // namespace haarlight::benchmark
