#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

#include <cstdint>
#include <span>
#include <stdexcept>

#include "base/error.h"
#include "base/file.h"
#include "image/tonemap.h"
#include "image/write_image.h"

namespace haarlight {

namespace {

void appendBytes(void* target, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(target);
  const auto* first = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

}  // namespace

std::vector<std::uint8_t> encodePng(const Image& image) {
  if (image.pixels.empty()) throw std::invalid_argument("a PNG needs an image with pixels");
  std::vector<std::uint8_t> samples;
  samples.reserve(image.pixels.size() * 3);
  for (const glm::vec3& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) samples.push_back(srgbByte(pixel[c]));
  std::vector<std::uint8_t> file;
  if (!stbi_write_png_to_func(appendBytes, &file, image.width, image.height, 3, samples.data(),
                              image.width * 3))
    throw InputError("the picture is too large for PNG");
  return file;
}

void writePng(const std::filesystem::path& path, const Image& image) {
  writeFileAtomically(path, encodePng(image));  // stb reports no write errors
}

}  // namespace haarlight
