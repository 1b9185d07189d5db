#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/fit_report.h"
#include "report/measures_json.h"
#include "scene/names.h"

namespace haarlight {

namespace {

using Json = nlohmann::ordered_json;

Json valueOrNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json meshJson(const FitReport& report) {
  const SphereSet& set = report.fit.set;
  const MeshTopology& topology = report.mesh.topology;
  return {{"name", set.meshName},
          {"hash", fmt::format("{:016x}", set.meshHash)},
          {"triangles", report.mesh.mesh.triangles.size()},
          {"vertices", topology.vertices},
          {"closed", topology.closed},
          {"parts", topology.components}};
}

Json requestedJson(const FitReport& report) {
  const SphereSet& set = report.fit.set;
  return {{"objective", nameOf(set.objective)},
          {"spheres", report.requestedSpheres},
          {"maximum_error", valueOrNull(report.maximumError)},
          {"time_limit", valueOrNull(report.timeLimit)},
          {"seed", set.seed}};
}

Json resultJson(const SphereFit& fit) {
  Json result{{"spheres", fit.set.spheres.size()},
              {"method", fit.set.method},
              {"stop", stopName(fit.stop)},
              {"seconds", fit.seconds}};
  result.update(measuresJson(fit.set.measures));
  return result;
}

Json historyJson(const SphereFit& fit) {
  Json history = Json::array();
  for (const FitStep& step : fit.history)
    history.push_back({{"phase", step.phase},
                       {"seconds", step.seconds},
                       {"spheres", step.spheres},
                       {"error", step.error}});
  return history;
}

Json warningsJson(const FitReport& report) {
  Json warnings = report.mesh.warnings;
  for (const std::string& warning : report.fit.warnings) warnings.push_back(warning);
  return warnings;
}

Json spheresJson(const SphereSet& set) {
  Json spheres = Json::array();
  for (const Sphere& sphere : set.spheres) {
    const glm::vec3& c = sphere.center;
    spheres.push_back({{"center", {c.x, c.y, c.z}}, {"radius", sphere.radius}});
  }
  return spheres;
}

}  // namespace

std::string fitReportJson(const FitReport& report) {
  const Json root{{"program", report.program},
                  {"host", report.host},
                  {"date", report.date},
                  {"mesh", meshJson(report)},
                  {"requested", requestedJson(report)},
                  {"result", resultJson(report.fit)},
                  {"history", historyJson(report.fit)},
                  {"warnings", warningsJson(report)},
                  {"spheres", spheresJson(report.fit.set)}};
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace haarlight
