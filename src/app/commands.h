#pragma once

#include <CLI/CLI.hpp>

namespace haarlight {

/// Each adds its subcommand, with options and what it runs, to the command line.
void addBakeCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addDevicesCommand(CLI::App& app);
void addFitCommand(CLI::App& app);
void addInfoCommand(CLI::App& app);
void addPrtCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addShadowCommand(CLI::App& app);
void addSkiesCommand(CLI::App& app);
void addTrackCommand(CLI::App& app);
void addVerifyCommand(CLI::App& app);

}  // namespace haarlight
