#include "verify/cases/case_file.h"

#include <bit>
#include <cmath>
#include <initializer_list>

#include "base/canonical_order.h"
#include "base/file.h"
#include "base/text_format.h"
#include "verify/cases/case_lines.h"

namespace haarlight::verify {

namespace {

constexpr std::uint64_t largestFile = std::uint64_t(256) << 20;

void appendNumber(std::string& text, float value) {
  text += std::signbit(value) ? " -0x" : " 0x";
  text += numberText(std::abs(value), std::chars_format::hex);
}

void appendLine(std::string& text, const std::string& keyword,
                std::initializer_list<float> numbers) {
  text += keyword;
  for (const float number : numbers) appendNumber(text, number);
  text += '\n';
}

/// Also −0 is a value to keep.
bool isPlainZero(const glm::vec3& color) {
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  return (bits(color.r) | bits(color.g) | bits(color.b)) == 0;
}

/// Size of a list without the entries that fill it up, which a reader adds again.
std::size_t listSizeWithoutFilling(const SphereBinding& binding, std::size_t first,
                                   std::size_t size) {
  const auto isFilling = [&](std::size_t entry) {
    const glm::vec4& w = binding.weights[entry];
    return binding.vertices[entry] == binding.vertices[first] && isPlainZero(glm::vec3(w));
  };
  const std::size_t least = size - partialSums + 1;
  while (size > least && isFilling(first + size - 1)) --size;
  return size;
}

void appendBinding(std::string& text, const Case& value) {
  for (const glm::vec4& v : value.vertices) appendLine(text, "vertex", {v.x, v.y, v.z});
  const SphereBinding& binding = value.binding;
  for (std::size_t i = 0; i < binding.sphereCount(); ++i) {
    appendLine(text, "bound", {binding.radiusFactors[i].x, binding.radiusFactors[i].y});
    const std::size_t first = binding.listStarts[i];
    const std::size_t size =
        listSizeWithoutFilling(binding, first, binding.listStarts[i + 1] - first);
    for (std::size_t entry = first; entry < first + size; ++entry) {
      const glm::vec4& w = binding.weights[entry];
      appendLine(text, "follows " + std::to_string(binding.vertices[entry]), {w.x, w.y, w.z});
    }
  }
}

}  // namespace

std::string caseText(const Case& value) {
  std::string text = "haarlight-case 1\nname " + visible(value.name) + "\n";
  for (const Sphere& s : value.spheres)
    appendLine(text, "sphere", {s.center.x, s.center.y, s.center.z, s.radius});
  for (std::size_t i = 0; i < value.receivers.size(); ++i) {
    const glm::vec4 p = value.receivers.positions[i], n = value.receivers.normals[i];
    appendLine(text, "receiver", {p.x, p.y, p.z, n.x, n.y, n.z});
  }
  for (int texel = 0; texel < texelCount; ++texel)
    if (const glm::vec3 color = value.light[texel]; !isPlainZero(color))
      appendLine(text, "texel " + std::to_string(texel), {color.r, color.g, color.b});
  appendBinding(text, value);
  return text;
}

Case readCaseText(const std::string& text, const std::string& source) {
  LineReader line(text, source);
  line.expectHeader("haarlight-case");
  CaseLines lines;
  while (line.next())
    if (!lines.read(line))
      line.fail(
          "the line must begin with name, sphere, receiver, plane, light, texel, vertex, bound or "
          "follows");
  return lines.finish(line);
}

Case readCaseFile(const std::filesystem::path& path) {
  const auto bytes = readWholeFile(path, "case", largestFile);
  return readCaseText({bytes.begin(), bytes.end()}, path.string());
}

void writeCaseFile(const std::filesystem::path& path, const Case& value) {
  writeFileAtomically(path, caseText(value));
}

}  // namespace haarlight::verify
