#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfIntAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "base/error.h"
#include "image/image_decoding.h"
#include "image/open_exr_stream.h"
#include "image/rec709.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;

/// The names of the red, green and blue channels of a part; three times the same for luminance.
using ColorChannels = std::array<std::string, 3>;

struct ColorPart {
  int index;
  ColorChannels channels;
};

std::optional<ColorChannels> findColorChannels(const Imf::ChannelList& channels) {
  std::set<std::string> layers;
  channels.layers(layers);
  std::vector<std::string> prefixes{""};
  for (const std::string& layer : layers) prefixes.push_back(layer + ".");
  const auto has = [&](const std::string& name) { return channels.findChannel(name) != nullptr; };
  for (const std::string& prefix : prefixes) {
    if (has(prefix + "R") && has(prefix + "G") && has(prefix + "B"))
      return ColorChannels{prefix + "R", prefix + "G", prefix + "B"};
    if (const std::string y = prefix + "Y"; has(y) && !has(prefix + "RY") && !has(prefix + "BY"))
      return ColorChannels{y, y, y};
  }
  return std::nullopt;
}

std::vector<std::string> channelNames(const Imf::ChannelList& channels) {
  std::vector<std::string> names;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
    names.push_back(channel.name());
  return names;
}

std::string joined(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
  return result;
}

/// The first part that is no deep image and has colour.
ColorPart findColorPart(const Imf::MultiPartInputFile& file, const fs::path& path) {
  std::vector<std::string> names;
  bool deep = false;
  for (int part = 0; part < file.parts(); ++part) {
    const Imf::Header& header = file.header(part);
    if (header.hasType() && !Imf::isImage(header.type())) {
      deep = true;
      continue;
    }
    if (const auto channels = findColorChannels(header.channels())) return {part, *channels};
    for (const std::string& name : channelNames(header.channels())) names.push_back(name);
  }
  if (deep)
    cannotReadImage(path, "deep OpenEXR images are not supported; flatten it to R, G, B first");
  cannotReadImage(path, "it has no channels R, G, B or Y alone, only " +
                            (names.empty() ? "none at all" : joined(names)));
}

/// An image of the size of a part's data window.
Image makeImage(const Imf::Header& header, std::size_t fileBytes, const fs::path& path) {
  const Imath::Box2i window = header.dataWindow();
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
  const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
  checkImageSize(width, height, fileBytes, path);
  if (header.hasTileDescription())
    checkImageSize(header.tileDescription().xSize, header.tileDescription().ySize, fileBytes, path);
  return {int(width), int(height)};
}

/// Reads a part's data window; the channels' values land in the image's red, green and blue.
Image readPixels(Imf::MultiPartInputFile& file, const ColorPart& color, std::size_t fileBytes,
                 const fs::path& path) {
  const Imf::Header& header = file.header(color.index);
  const Imath::Box2i window = header.dataWindow();
  Image image = makeImage(header, fileBytes, path);
  Imf::FrameBuffer frame;
  for (int c = 0; c < 3; ++c) {
    const Imf::Channel& channel = header.channels()[color.channels[c]];
    if (channel.xSampling != 1 || channel.ySampling != 1)
      cannotReadImage(path, "its channel " + color.channels[c] + " is stored at lower resolution");
    frame.insert(color.channels[c],
                 Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][c], window, sizeof(glm::vec3),
                                  sizeof(glm::vec3) * image.width));
  }
  Imf::InputPart part(file, color.index);
  part.setFrameBuffer(frame);
  part.readPixels(window.min.y, window.max.y);
  // Luminance was read into blue only, as one channel has one place.
  if (color.channels[0] == color.channels[1])
    for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(pixel.b);
  return image;
}

void convertToRec709(Image& image, const Imf::Header& header) {
  if (!Imf::hasChromaticities(header) || Imf::chromaticities(header) == Imf::Chromaticities())
    return;
  const glm::dmat3 matrix = rec709From(Imf::chromaticities(header));
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(matrix * glm::dvec3(pixel));
}

std::vector<std::pair<std::string, std::string>> readAttributes(const Imf::Header& header) {
  std::vector<std::pair<std::string, std::string>> result;
  for (auto i = header.begin(); i != header.end(); ++i) {
    const Imf::Attribute* attribute = &i.attribute();
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(attribute))
      result.emplace_back(i.name(), text->value());
    else if (const auto* whole = dynamic_cast<const Imf::IntAttribute*>(attribute))
      result.emplace_back(i.name(), std::to_string(whole->value()));
    else if (const auto* real = dynamic_cast<const Imf::FloatAttribute*>(attribute))
      result.emplace_back(i.name(), fmt::format("{}", real->value()));
    else if (const auto* precise = dynamic_cast<const Imf::DoubleAttribute*>(attribute))
      result.emplace_back(i.name(), fmt::format("{}", precise->value()));
  }
  return result;
}

ImageFile decodeParts(std::span<const std::uint8_t> bytes, const fs::path& path) {
  OpenExrInput stream(bytes);
  Imf::MultiPartInputFile file(stream, 0);
  const ColorPart color = findColorPart(file, path);
  const Imf::Header& header = file.header(color.index);
  ImageFile result;
  result.format = "OpenEXR";
  result.image = readPixels(file, color, bytes.size(), path);
  convertToRec709(result.image, header);
  result.channels = channelNames(header.channels());
  result.attributes = readAttributes(header);
  return result;
}

}  // namespace

ImageFile decodeOpenExr(std::span<const std::uint8_t> bytes, const fs::path& path) {
  try {
    return decodeParts(bytes, path);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    cannotReadImage(path, "it is damaged or not supported: " + reason);
  }
}

}  // namespace haarlight
