#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <stdexcept>

#include "base/error.h"
#include "base/file.h"
#include "image/open_exr_stream.h"
#include "image/write_image.h"

namespace haarlight {

namespace {

Imf::TypedAttribute<std::string> toAttribute(const std::string& value) {
  return Imf::StringAttribute(value);
}
Imf::TypedAttribute<int> toAttribute(int value) {
  return Imf::IntAttribute(value);
}
Imf::TypedAttribute<float> toAttribute(float value) {
  return Imf::FloatAttribute(value);
}

Imf::Header makeHeader(const Image& image, const ImageAttributes& attributes) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, value] : attributes) {
    if (header.find(name) != header.end())
      throw InputError("OpenEXR attribute " + name + " has a fixed meaning; use another name");
    std::visit([&](const auto& v) { header.insert(name, toAttribute(v)); }, value);
  }
  Imf::addChromaticities(header, Imf::Chromaticities());
  return header;
}

void addLayer(Imf::Header& header, Imf::FrameBuffer& frame, const ImageLayer& layer) {
  const Image& image = layer.image;
  for (int c = 0; c < 3; ++c) {
    const std::string channel = (layer.name.empty() ? "" : layer.name + ".") + "RGB"[c];
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][c], header.dataWindow(),
                                           sizeof(glm::vec3), sizeof(glm::vec3) * image.width));
  }
}

std::vector<std::uint8_t> encode(const std::vector<ImageLayer>& layers,
                                 const ImageAttributes& attributes) {
  Imf::Header header = makeHeader(layers.front().image, attributes);
  Imf::FrameBuffer frame;
  for (const ImageLayer& layer : layers) addLayer(header, frame, layer);
  OpenExrOutput stream;
  {
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(layers.front().image.height);
  }
  return stream.bytes();
}

void checkLayers(const std::vector<ImageLayer>& layers) {
  if (layers.empty() || layers.front().image.pixels.empty())
    throw std::invalid_argument("writeExr needs a layer with pixels");
  for (const ImageLayer& layer : layers)
    if (layer.image.width != layers.front().image.width ||
        layer.image.height != layers.front().image.height)
      throw std::invalid_argument("writeExr needs layers of equal size");
}

}  // namespace

void writeExr(const std::filesystem::path& path, const std::vector<ImageLayer>& layers,
              const ImageAttributes& attributes) {
  checkLayers(layers);
  std::vector<std::uint8_t> bytes;
  try {
    bytes = encode(layers, attributes);
  } catch (const Iex::BaseExc& error) {
    throw InputError("cannot write " + path.string() + ": " + error.what());
  }
  writeFileAtomically(path, bytes);
}

}  // namespace haarlight
