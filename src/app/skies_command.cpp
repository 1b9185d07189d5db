#include "app/commands.h"
#include "app/options.h"
#include "base/parallel.h"
#include "image/write_image.h"
#include "light/sky_environment.h"
#include "report/sky_sheet.h"
#include "scene/field_ranges.h"

namespace haarlight {

namespace {

struct SkiesOptions {
  GeneralOptions general;
  std::optional<std::string> sun, output;
  double sunDisc = 0;
  int side = 180;
};

nlohmann::ordered_json describeSky(const SkyModel& model, SkySettings settings) {
  settings.zenithRadiance = 1;
  const SkyEnvironment sky(model, settings);
  return {{"name", model.name},
          {"title", model.title},
          {"sky_irradiance_per_zenith_radiance", sky.skyIrradiance()},
          {"sun_irradiance_per_zenith_radiance", sky.sunIrradiance()}};
}

void showSkies(const SkiesOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  SkySettings settings;
  if (options.output) checkTarget(*options.output, {".png"});
  if (options.sun) parseSun(*options.sun, settings);
  settings.sunDisc = withinRange(options.sunDisc, sunDiscRange, "--sun-disc");
  nlohmann::ordered_json skies = nlohmann::ordered_json::array();
  for (const SkyModel& model : skyModels()) skies.push_back(describeSky(model, settings));
  nlohmann::ordered_json results{{"sun_azimuth_degrees", settings.sunAzimuthDegrees},
                                 {"sun_elevation_degrees", settings.sunElevationDegrees},
                                 {"sky", skies}};
  if (options.output) {
    writePng(*options.output, skySheet(settings, options.side));
    results["sheet"] = *options.output;
  }
  console.results(results);
}

}  // namespace

void addSkiesCommand(CLI::App& app) {
  const auto options = std::make_shared<SkiesOptions>();
  CLI::App* command =
      app.add_subcommand("skies", "List the built-in skies and show them on one sheet");
  command->footer("Example: haarlight skies --sun 120,30 -o skies.png");
  command->add_option("-o,--output", options->output, "Sheet to write (.png)");
  command->add_option(
      "--sun", options->sun,
      "AZIMUTH,ELEVATION in degrees, from +Z towards +X and from the horizon [40,45]");
  command
      ->add_option("--sun-disc", options->sunDisc, "The sun's disc, 1: as bright as on a clear day")
      ->capture_default_str();
  command->add_option("--side", options->side, "Pixels a side of each picture")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  addGeneralOptions(*command, options->general);
  command->callback([options] { showSkies(*options); });
}

}  // namespace haarlight
