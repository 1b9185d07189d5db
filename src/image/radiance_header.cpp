#include "image/radiance_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

#include "image/image_decoding.h"

namespace haarlight {

namespace {

class HeaderParser {
 public:
  HeaderParser(std::span<const std::uint8_t> bytes, const std::filesystem::path& path)
      : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), path_(path) {}

  RadianceHeader parse() {
    const std::string_view identifier = nextLine();
    for (std::string_view line = nextLine(); !line.empty(); line = nextLine()) parseVariable(line);
    if (!hasFormat_ && identifier != "#?RADIANCE" && identifier != "#?RGBE")
      cannotReadImage(path_, "its header has neither a FORMAT line nor #?RADIANCE in line 1");
    parseResolution(nextLine());
    header_.dataOffset = position_;
    checkImageSize(header_.width, header_.height, text_.size(), path_);
    return header_;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    cannotReadImage(path_, "header line " + std::to_string(lineNumber_) + " " + reason);
  }

  std::string_view nextLine() {
    const std::size_t end = text_.find('\n', position_);
    ++lineNumber_;
    if (end == std::string_view::npos) fail("is missing: the file ends within its header");
    std::string_view line = text_.substr(position_, end - position_);
    position_ = end + 1;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    return line;
  }

  void parseVariable(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos || line.front() == '#' || line.front() == '\t') return;
    const std::string name(line.substr(0, equals));
    const std::string value(
        line.substr(std::min(line.find_first_not_of(' ', equals + 1), line.size())));
    if (name == "FORMAT") parseFormat(value);
    if (name == "EXPOSURE") multiplyExposure(value, 1);
    if (name == "COLORCORR") multiplyExposure(value, 3);
    header_.variables.emplace_back(name, value);
  }

  void parseFormat(const std::string& value) {
    if (value != "32-bit_rle_rgbe" && value != "32-bit_rle_xyze")
      fail("says FORMAT=" + value + "; only 32-bit_rle_rgbe and 32-bit_rle_xyze can be read");
    header_.isXyz = value == "32-bit_rle_xyze";
    hasFormat_ = true;
  }

  void multiplyExposure(const std::string& value, int count) {
    std::istringstream in(value);
    glm::dvec3 factor(1.0);
    for (int i = 0; i < count; ++i)
      if (!(in >> factor[i]) || !std::isfinite(factor[i]) || factor[i] <= 0)
        fail("needs " + std::to_string(count) + " positive numbers, not \"" + value + "\"");
    header_.exposure *= count == 1 ? glm::dvec3(factor[0]) : factor;
  }

  int parseSize(const std::string& word) const {
    int size = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), size);
    if (error != std::errc() || end != word.data() + word.size() || size < 1)
      fail("has no usable image size: \"" + word + "\"");
    return size;
  }

  void parseResolution(std::string_view line) {
    std::istringstream in{std::string(line)};
    std::string first, second, firstSize, secondSize, rest;
    in >> first >> firstSize >> second >> secondSize;
    const auto isAxis = [](const std::string& word, char letter) {
      return word.size() == 2 && (word[0] == '+' || word[0] == '-') && word[1] == letter;
    };
    const bool rows = isAxis(first, 'Y') && isAxis(second, 'X');
    const bool columns = isAxis(first, 'X') && isAxis(second, 'Y');
    if ((!rows && !columns) || in >> rest)
      fail("should be the image size, such as \"-Y 512 +X 1024\"");
    header_.orientation = {columns, (rows ? first : second)[0] == '+',
                           (rows ? second : first)[0] == '-'};
    header_.width = parseSize(rows ? secondSize : firstSize);
    header_.height = parseSize(rows ? firstSize : secondSize);
  }

  std::string_view text_;
  const std::filesystem::path& path_;
  std::size_t position_ = 0;
  int lineNumber_ = 0;
  bool hasFormat_ = false;
  RadianceHeader header_;
};

}  // namespace

glm::ivec2 RadianceHeader::pixelPosition(int scanline, int index) const {
  const int x = orientation.scanlinesAreColumns ? scanline : index;
  const int y = orientation.scanlinesAreColumns ? index : scanline;
  return {orientation.rightToLeft ? width - 1 - x : x,
          orientation.bottomToTop ? height - 1 - y : y};
}

RadianceHeader parseRadianceHeader(std::span<const std::uint8_t> bytes,
                                   const std::filesystem::path& path) {
  return HeaderParser(bytes, path).parse();
}

}  // namespace haarlight
