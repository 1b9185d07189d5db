#include "app/picture_file.h"

#include "image/tonemap.h"

namespace haarlight {

void writePicture(const std::filesystem::path& path, const RenderedImage& picture, float stops,
                  const ImageAttributes& attributes) {
  if (path.extension() == ".exr")
    writeExr(path, {{"", picture.radiance}, {"albedo", picture.albedo}, {"N", picture.normal}},
             attributes);
  else
    writePng(path, tonemap(picture.radiance, stops));
}

}  // namespace haarlight
