#include "verify/tally.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "verify/places.h"
#include "verify/report/picture.h"

namespace haarlight::verify {

namespace {

constexpr std::size_t mismatchesShown = 5;
constexpr std::size_t picturesShown = 2;

/// The distance in the middle of all; between two, their mean.
double medianOf(const std::map<std::uint64_t, std::uint64_t>& counts) {
  std::uint64_t total = 0;
  for (const auto& [ulp, count] : counts) total += count;
  if (total == 0) return 0;
  const auto at = [&](std::uint64_t rank) {
    for (const auto& [ulp, count] : counts) {
      if (rank < count) return double(ulp);
      rank -= count;
    }
    return 0.0;
  };
  return (at((total - 1) / 2) + at(total / 2)) / 2;
}

std::vector<glm::vec4> pictureOf(const Case& value, std::span<const glm::vec4> radiance) {
  std::vector<glm::vec4> picture(std::size_t(value.frameWidth) * std::size_t(value.frameHeight));
  for (std::size_t i = 0; i < radiance.size(); ++i) picture[value.pixels[i]] = radiance[i];
  return picture;
}

}  // namespace

void Tally::addMismatch(Mismatch mismatch) {
  ++row_.mismatches;
  if (keepsPlaces_) places_.push_back({mismatch.caseName, mismatch.sample, mismatch.place});
  if (row_.firstMismatches.size() < mismatchesShown)
    row_.firstMismatches.push_back(std::move(mismatch));
}

void Tally::addWord(const Case& value, std::size_t sample, std::uint32_t expected,
                    std::uint32_t actual, const std::function<Place()>& place) {
  ++row_.compared;
  if (expected == actual) return;
  addMismatch({value.name, sample, place(), false, expected, actual, 0});
}

void Tally::addFloat(const Case& value, std::size_t sample, float expected, float actual,
                     const std::function<Place()>& place, float tolerance) {
  ++row_.compared;
  const std::uint64_t ulp = ulpDistance(expected, actual);
  ++ulps_[ulp];
  // Without a tolerance 0 and −0 differ too.
  if (ulp == 0 || (tolerance > 0 && std::abs(expected - actual) <= tolerance)) return;
  addMismatch({value.name, sample, place(), true, std::bit_cast<std::uint32_t>(expected),
               std::bit_cast<std::uint32_t>(actual), ulp});
}

/// A result with too few or too many values is a mismatch of its own.
void Tally::addSizes(const Case& value, std::size_t expected, std::size_t actual) {
  if (expected != actual)
    addMismatch({value.name, 0, "number of results", false, std::uint32_t(expected),
                 std::uint32_t(actual), 0});
}

void Tally::compareMovedSpheres(const Case& value, std::span<const Sphere> expected,
                                std::span<const Sphere> actual) {
  addSizes(value, expected.size(), actual.size());
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i) {
    const glm::vec4 wanted(expected[i].center, expected[i].radius);
    const glm::vec4 found(actual[i].center, actual[i].radius);
    for (int number = 0; number < 4; ++number)
      addFloat(value, i, wanted[number], found[number],
               [&] { return movedSpherePlace(i, number); });
  }
}

void Tally::compareEntries(const Case& value, std::span<const std::uint32_t> expected,
                           std::span<const std::uint32_t> actual) {
  addSizes(value, expected.size(), actual.size());
  const std::size_t spheres = value.spheres.size();
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i)
    addWord(value, i / spheres, expected[i], actual[i],
            [&] { return entryPlace(i % spheres, expected[i]); });
}

void Tally::compareBitCubes(const Case& value, std::span<const BitCube> expected,
                            std::span<const BitCube> actual) {
  addSizes(value, expected.size(), actual.size());
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i) {
    const auto& [wanted, found] = std::tie(expected[i].rows, actual[i].rows);
    for (int word = 0; word < bitCubeRows; ++word)
      addWord(value, i, wanted[word], found[word],
              [&] { return bitPlace(word, std::countr_zero(wanted[word] ^ found[word])); });
    if (wanted != found && row_.pictures.size() < picturesShown)
      row_.pictures.push_back(bitCubePicture(
          value.name + ", sample " + std::to_string(i) + ": bit cube", expected[i], actual[i]));
  }
}

void Tally::compareOcclusion(const Case& value, std::span<const OcclusionHaar> expected,
                             std::span<const OcclusionHaar> actual) {
  addSizes(value, expected.size(), actual.size());
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i) {
    const OcclusionHaar &wanted = expected[i], &found = actual[i];
    for (std::size_t k = 0; k < wanted.coefficients.size(); ++k)
      addFloat(value, i, wanted.coefficients[k], found.coefficients[k],
               [&] { return coefficientPlace(int(k)); });
    for (std::size_t k = 0; k < wanted.means.size(); ++k)
      addFloat(value, i, wanted.means[k], found.means[k], [&] { return meanPlace(int(k)); });
    for (std::size_t k = 0; k < wanted.blocks.size(); ++k)
      addWord(value, i, wanted.blocks[k], found.blocks[k], [&] { return blockPlace(int(k)); });
  }
}

void Tally::compareRadiance(const Case& value, std::span<const glm::vec4> expected,
                            std::span<const glm::vec4> actual, float unshadowed) {
  addSizes(value, expected.size(), actual.size());
  const std::uint64_t before = row_.mismatches;
  const float tolerance = row_.tolerance.empty() ? 0 : 1e-5f * unshadowed;
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i)
    for (int channel = 0; channel < 4; ++channel)
      addFloat(
          value, i, expected[i][channel], actual[i][channel], [&] { return channelPlace(channel); },
          tolerance);
  const bool isPicture = value.frameWidth > 0 && expected.size() == actual.size();
  if (row_.mismatches > before && isPicture && row_.pictures.size() < picturesShown)
    row_.pictures.push_back(framePicture(value.name, value.frameWidth, value.frameHeight,
                                         pictureOf(value, expected), pictureOf(value, actual)));
}

void Tally::compareChecksums(const Case& value, std::uint64_t expected, std::uint64_t actual) {
  ++row_.compared;
  if (expected != actual)
    addMismatch({value.name, 0, "checksum of all samples", false, std::uint32_t(expected),
                 std::uint32_t(actual), 0});
}

Row Tally::finish() const {
  Row row = row_;
  if (!ulps_.empty()) row.maximumUlp = ulps_.rbegin()->first;
  row.medianUlp = medianOf(ulps_);
  return row;
}

}  // namespace haarlight::verify
