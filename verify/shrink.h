#pragma once

#include <functional>

#include "verify/cases/case.h"

namespace haarlight::verify {

/// The smallest part of `failing` that `fails`: receivers first, then spheres, then bound spheres,
/// what they follow and vertices are left out as long as it still does (delta debugging of Zeller
/// and Hildebrandt, "Simplifying and isolating failure-inducing input", 2002). `fails` is true of
/// `failing` itself.
Case shrunk(const Case& failing, const std::function<bool(const Case&)>& fails);

}  // namespace haarlight::verify
