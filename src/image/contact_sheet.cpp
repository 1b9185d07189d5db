#include "image/contact_sheet.h"

#include <stb_easy_font.h>

#include <algorithm>
#include <glm/vec2.hpp>
#include <span>

namespace haarlight {

namespace {

constexpr int textScale = 2;
constexpr int lineHeight = 12 * textScale;
const glm::vec3 textColor(0.85f);

/// Corner of a quad of stb_easy_font.
struct FontVertex {
  float x, y, z;
  unsigned char color[4];
};

/// A copy that stb_easy_font, which wants char* and knows printable ASCII only, can take.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

int textWidth(const std::string& label) {
  return stb_easy_font_width(printable(label).data()) * textScale;
}

void fillRectangle(Image& image, glm::ivec2 lower, glm::ivec2 upper, const glm::vec3& color) {
  for (int y = std::max(lower.y, 0); y < std::min(upper.y, image.height); ++y)
    for (int x = std::max(lower.x, 0); x < std::min(upper.x, image.width); ++x)
      image.at(x, y) = color;
}

void drawText(Image& image, glm::ivec2 position, const std::string& label) {
  constexpr std::size_t quadsPerCharacter = 32;
  std::vector<FontVertex> vertices(4 * quadsPerCharacter * label.size());
  const int quads = stb_easy_font_print(0, 0, printable(label).data(), nullptr, vertices.data(),
                                        int(vertices.size() * sizeof(FontVertex)));
  for (int quad = 0; quad < quads; ++quad) {
    const FontVertex &first = vertices[4 * quad], &last = vertices[4 * quad + 2];
    fillRectangle(image, position + textScale * glm::ivec2(first.x, first.y),
                  position + textScale * glm::ivec2(last.x, last.y), textColor);
  }
}

void copyImage(const Image& source, Image& target, glm::ivec2 position) {
  for (int y = 0; y < source.height; ++y)
    std::copy_n(&source.at(0, y), source.width, &target.at(position.x, position.y + y));
}

std::vector<int> columnWidths(const std::vector<std::vector<LabelledImage>>& rows) {
  std::vector<int> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max({widths[i], row[i].image.width, textWidth(row[i].label)});
  }
  return widths;
}

Image gridRow(const std::vector<LabelledImage>& pictures, const std::vector<int>& widths, int gap) {
  int width = gap, height = 0;
  for (const int column : widths) width += column + gap;
  for (const LabelledImage& picture : pictures) height = std::max(height, picture.image.height);
  Image sheet(width, height + lineHeight + 2 * gap);
  fillRectangle(sheet, {0, 0}, {sheet.width, sheet.height}, sheetBackground);
  int x = gap;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    drawText(sheet, {x, gap}, pictures[i].label);
    copyImage(pictures[i].image, sheet, {x, gap + lineHeight});
    x += widths[i] + gap;
  }
  return sheet;
}

}  // namespace

Image contactSheet(const std::vector<LabelledImage>& pictures, int gap) {
  return contactGrid({pictures}, gap);
}

Image contactGrid(const std::vector<std::vector<LabelledImage>>& rows, int gap) {
  const std::vector<int> widths = columnWidths(rows);
  Image grid;
  for (const auto& row : rows)
    grid =
        grid.height == 0 ? gridRow(row, widths, gap) : stackSheets(grid, gridRow(row, widths, gap));
  return grid;
}

Image stackSheets(const Image& upper, const Image& lower) {
  Image sheet(std::max(upper.width, lower.width), upper.height + lower.height);
  fillRectangle(sheet, {0, 0}, {sheet.width, sheet.height}, sheetBackground);
  copyImage(upper, sheet, {0, 0});
  copyImage(lower, sheet, {0, upper.height});
  return sheet;
}

}  // namespace haarlight
