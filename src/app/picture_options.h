#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "scene/scene_description.h"

namespace haarlight {

/// What the command line changes about a scene's picture.
struct PictureOptions {
  std::string size;
  std::optional<int> samples;
  std::string exposure;
};

/// Adds --size, --samples and --exposure. `defaultSize` is for the help: what applies without
/// --size.
void addPictureOptions(CLI::App& command, PictureOptions& options, const std::string& defaultSize);

/// Throws InputError.
void applyPictureOptions(const PictureOptions& options, ImageDescription& image);

}  // namespace haarlight
