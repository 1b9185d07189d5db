#pragma once

#include "verify/cases/random_cases.h"

namespace haarlight::verify {

/// Adds 1 … 70 spheres that follow 1 … 3,000 vertices, which lie around the origin or up to 10⁶
/// from it; some vertices coincide. Lists have any number of entries, at times just 31, 32, 33, 64
/// or 65, or as many as there are vertices; weights for centres have both signs and sum to about 1;
/// radii come from the mean, from the reach or from both. With `denormal` the vertices lie within
/// 10⁻⁴⁰ … 10⁻¹⁸ of the origin.
void addRandomBinding(PortableRandom& random, bool denormal, Case& value);

}  // namespace haarlight::verify
