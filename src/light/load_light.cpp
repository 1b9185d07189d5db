#include "light/load_light.h"

#include <algorithm>

#include "base/error.h"
#include "image/read_image.h"
#include "light/builtin_lights.h"
#include "light/image_environment.h"

namespace haarlight {

namespace {

bool isBlack(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(),
                     [](const glm::vec3& pixel) { return pixel == glm::vec3(0.0f); });
}

}  // namespace

LoadedLight loadLight(const std::string& nameOrPath, const std::string& layoutName,
                      const SkySettings& skySettings) {
  if (nameOrPath.starts_with("builtin:")) {
    if (!layoutName.empty())
      throw InputError("the light " + nameOrPath + " has no layout; leave out \"" + layoutName +
                       "\"");
    return {makeBuiltinLight(nameOrPath, skySettings), {}};
  }
  ImageFile file = readImage(nameOrPath);
  if (isBlack(file.image)) file.warnings.push_back("every pixel is black");
  for (std::string& warning : file.warnings) warning = nameOrPath + ": " + warning;
  try {
    return {std::make_unique<ImageEnvironment>(std::move(file.image), layoutName, nameOrPath),
            std::move(file.warnings)};
  } catch (const InputError& error) {
    throw InputError("cannot use light " + nameOrPath + ": " + error.what());
  }
}

}  // namespace haarlight
