#include "report/measures_json.h"

namespace haarlight {

nlohmann::ordered_json measuresJson(const SphereMeasures& measures) {
  nlohmann::ordered_json json{{"covered_surface", measures.coveredFraction}};
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) json[name] = *value;
  };
  add("outside_volume_ratio", measures.outsideVolumeRatio);
  add("union_outside_ratio", measures.unionOutsideRatio);
  add("uncovered_volume_ratio", measures.uncoveredVolumeRatio);
  if (const auto& error = measures.silhouette)
    json["silhouette_error"] = {{"mean", error->mean},
                                {"worst", error->worst},
                                {"over", error->over},
                                {"under", error->under}};
  return json;
}

}  // namespace haarlight
