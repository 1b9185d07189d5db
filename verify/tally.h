#pragma once

#include <functional>
#include <map>
#include <span>

#include "engine/engine.h"
#include "verify/expected.h"
#include "verify/injection.h"
#include "verify/report/report.h"

namespace haarlight::verify {

/// Collects one row of the report, case by case.
class Tally {
 public:
  /// A row with its labels, and its tolerance where the device has one.
  explicit Tally(Row labels) : row_(std::move(labels)) {}

  void addSeconds(double seconds) { row_.seconds += seconds; }
  void compareMovedSpheres(const Case& value, std::span<const Sphere> expected,
                           std::span<const Sphere> actual);
  void compareEntries(const Case& value, std::span<const std::uint32_t> expected,
                      std::span<const std::uint32_t> actual);
  void compareBitCubes(const Case& value, std::span<const BitCube> expected,
                       std::span<const BitCube> actual);
  void compareOcclusion(const Case& value, std::span<const OcclusionHaar> expected,
                        std::span<const OcclusionHaar> actual);
  /// `unshadowed` scales the tolerance of devices that have one: 10⁻⁵ of the light that would reach
  /// the brightest open receiver (method.md §8).
  void compareRadiance(const Case& value, std::span<const glm::vec4> expected,
                       std::span<const glm::vec4> actual, float unshadowed);

  /// One value for a whole result; a mismatch shows the lower halves of the checksums.
  void compareChecksums(const Case& value, std::uint64_t expected, std::uint64_t actual);

  Row finish() const;
  std::uint64_t mismatches() const { return row_.mismatches; }
  /// Where all mismatches are; kept only after keepPlaces().
  void keepPlaces() { keepsPlaces_ = true; }
  const std::vector<InjectedFault>& places() const { return places_; }

 private:
  void addWord(const Case& value, std::size_t sample, std::uint32_t expected, std::uint32_t actual,
               const std::function<Place()>& place);
  void addFloat(const Case& value, std::size_t sample, float expected, float actual,
                const std::function<Place()>& place, float tolerance = 0);
  void addMismatch(Mismatch mismatch);
  void addSizes(const Case& value, std::size_t expected, std::size_t actual);

  Row row_;
  bool keepsPlaces_ = false;
  std::vector<InjectedFault> places_;
  /// How often each distance occurred among floats.
  std::map<std::uint64_t, std::uint64_t> ulps_;
};

}  // namespace haarlight::verify
