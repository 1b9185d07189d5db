#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "app/commands.h"
#include "app/console.h"
#include "app/version.h"
#include "base/error.h"

namespace {

std::string commandName(const CLI::App& app) {
  const auto used = app.get_subcommands();
  return used.empty() ? app.get_name() : app.get_name() + " " + used.front()->get_name();
}

std::string commandList(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands({}))
    names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

/// 0 done, 1 failed, 2 bad usage or input.
int run(int argc, char** argv) {
  CLI::App app(
      "haarlight: all-frequency soft shadows of dynamic scenes under HDR environment light",
      "haarlight");
  app.set_version_flag("--version", "haarlight " HAARLIGHT_VERSION);
  app.require_subcommand(0, 1);  // so that an unknown command is named instead of called missing
  app.get_formatter()->column_width(28);
  app.footer("`haarlight COMMAND --help` explains a command. Try: haarlight render -o picture.png");
  haarlight::addRenderCommand(app);
  haarlight::addCompareCommand(app);
  haarlight::addShadowCommand(app);
  haarlight::addBakeCommand(app);
  haarlight::addFitCommand(app);
  haarlight::addPrtCommand(app);
  haarlight::addInfoCommand(app);
  haarlight::addSkiesCommand(app);
  haarlight::addTrackCommand(app);
  haarlight::addDevicesCommand(app);
  haarlight::addVerifyCommand(app);
  haarlight::addBenchCommand(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    throw haarlight::InputError(error.what() + ("; see " + commandName(app)) + " --help");
  }
  if (app.get_subcommands().empty())
    throw haarlight::InputError("give a command: " + commandList(app) + "; see haarlight --help");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int status = run(argc, argv);
    // An earlier write may have failed too, when a flush of its own has reported it to nobody.
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw haarlight::InputError("cannot write to standard output");
    return status;
  } catch (const haarlight::InputError& error) {
    haarlight::printToStderr("error", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    haarlight::printToStderr("error", "out of memory");
    return 1;
  } catch (const std::exception& error) {
    haarlight::printToStderr("error", error.what());
    return 1;
  }
}
