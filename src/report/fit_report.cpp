#include "report/fit_report.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text_format.h"

namespace haarlight {

bool FitReport::complete() const {
  if (maximumError) return fit.stop == FitStop::errorReached;
  return fit.stop == FitStop::converged;
}

std::string FitReport::conclusion() const {
  const SphereSet& set = fit.set;
  std::string text = countText(set.spheres.size(), "sphere") +
                     (set.spheres.size() == 1 ? " stands" : " stand") + " in for " +
                     visible(set.meshName);
  if (const auto& error = set.measures.silhouette)
    text += ": the silhouettes differ by " + percentText(error->mean, 1) +
            " of the mesh's on average (" + percentText(error->over, 1) + " too much, " +
            percentText(error->under, 1) + " too little)";
  else
    text += ": " + percentText(set.measures.coveredFraction, 1) + " of the surface is covered";
  if (complete()) return text;
  const bool notReached = maximumError && fit.stop == FitStop::converged;
  return text + "; " + (notReached ? "the error asked for was not reached" : stopText(fit.stop));
}

std::string stopText(FitStop stop) {
  switch (stop) {
    case FitStop::converged:
      return "no further step made the error smaller";
    case FitStop::errorReached:
      return "the error asked for was reached";
    case FitStop::timeLimit:
      return "the time limit cut the fit off";
    case FitStop::cancelled:
      return "the fit was cancelled";
  }
  return {};
}

std::string stopName(FitStop stop) {
  switch (stop) {
    case FitStop::converged:
      return "converged";
    case FitStop::errorReached:
      return "error_reached";
    case FitStop::timeLimit:
      return "time_limit";
    case FitStop::cancelled:
      return "cancelled";
  }
  return {};
}

void writeFitReport(const std::filesystem::path& path, const FitReport& report) {
  const std::string extension = path.extension().string();
  if (extension == ".html")
    writeFileAtomically(path, fitReportHtml(report));
  else if (extension == ".json")
    writeFileAtomically(path, fitReportJson(report));
  else
    throw InputError("cannot write report " + path.string() +
                     ": its name must end in .html or .json");
}

}  // namespace haarlight
