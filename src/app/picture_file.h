#pragma once

#include <filesystem>

#include "image/write_image.h"
#include "render/render_image.h"

namespace haarlight {

/// Writes a picture: .exr with radiance, albedo and normals, linear; every other name as PNG,
/// exposed by `stops`.
void writePicture(const std::filesystem::path& path, const RenderedImage& picture, float stops,
                  const ImageAttributes& attributes);

}  // namespace haarlight
