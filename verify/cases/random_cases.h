#pragma once

#include <cstdint>

#include "verify/cases/case.h"

namespace haarlight::verify {

/// Numbers that are the same with every compiler and library (the distributions of <random> are
/// not): SplitMix64 of Steele, Lea and Flood, "Fast splittable pseudorandom number generators",
/// 2014.
class PortableRandom {
 public:
  explicit PortableRandom(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next();
  /// In [low, high), from 24 random bits.
  float uniform(float low, float high);
  /// In 0 … count − 1.
  int below(int count);

 private:
  std::uint64_t state_;
};

/// Case `index` of a run with `seed`: 1 … 256 spheres of all kinds (verify/cases/random_spheres.h)
/// around four receivers with any normal, and a light of a dim sky and a few lamps. Every eighth
/// case, and no other, has spheres at denormal distances; every eighth has nothing but small
/// spheres on bounds. Each also has spheres that follow vertices (verify/cases/random_binding.h).
Case randomCase(std::uint64_t seed, std::size_t index);

/// A light of a dim sky and a few lamps up to 10⁴ times brighter.
RadianceCube randomLight(std::uint64_t seed);

}  // namespace haarlight::verify
