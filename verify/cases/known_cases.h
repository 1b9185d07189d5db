#pragma once

/// Cases with answers that no engine of this program has computed, from
/// tests/data/known_answers.txt, which is part of the library. tests/verify/known_cases_test.cpp
/// says where they come from.
///
/// The file begins with the line `haarlight-known-answers 1`. Every case is its name and the lines
/// of a case file (verify/cases/case_file.h), and then its answers:
///
///   entries receiver entry …               table entries of all spheres
///   exact receiver row word …              rows face·32 + row, + 1, … of the exact bit cube, in
///                                          hexadecimal; rows not named are 0
///   table receiver row word …              the same by the sphere table
///   haar hash                              see KnownCase::haarHash
///   radiance visibility terms levels hash  see KnownRadiance
///   moved x y z radius                     the next of the bound spheres
///
/// A case without a haar line answers for no bits of its receivers, one without moved lines for no
/// bound spheres.

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "cube/bit_cube.h"
#include "haar/occlusion_transform.h"
#include "verify/cases/case.h"
#include "visibility/visibility_kind.h"

namespace haarlight::verify {

/// Radiance of all receivers of a known case with one setting, terms ranked as by default.
struct KnownRadiance {
  VisibilityKind visibility = VisibilityKind::exact;
  int terms = 200;
  int levels = 2;
  /// hashOf() the radiance, receiver by receiver. Lobes, and with them radiance, are prepared with
  /// atan of the C library in double: the hash is that of the C library of Debian 12 (glibc 2.36)
  /// on x86-64, and another one may give other last bits.
  std::uint64_t hash = 0;
};

/// A case and its answers.
struct KnownCase {
  Case question;
  /// Where the bound spheres are; empty where the case does not say.
  std::vector<Sphere> movedSpheres;
  /// receiver · spheres + sphere. This, the bit cubes and haarHash are empty and 0 where the case
  /// answers for its radiance and moved spheres only.
  std::vector<std::uint32_t> tableEntries;
  /// One per receiver.
  std::vector<BitCube> exactBitCubes, tableBitCubes;
  /// hashOf() all receivers' Haar coefficients, of the exact bit cubes.
  std::uint64_t haarHash = 0;
  std::vector<KnownRadiance> radiance;
};

/// The cases of tests/data/known_answers.txt.
std::vector<KnownCase> knownCases();

/// Reads a text like that file. Throws InputError with the line's number.
std::vector<KnownCase> readKnownCases(const std::string& text, const std::string& source);

/// checksum() (base/file.h) of coefficients, means and blocks, as they lie in memory.
std::uint64_t hashOf(std::span<const OcclusionHaar> occlusion);
/// checksum() of radiance (RGB, 0), as it lies in memory.
std::uint64_t hashOf(std::span<const glm::vec4> radiance);

}  // namespace haarlight::verify
