#pragma once

#include <string>
#include <vector>

#include "verify/cases/known_cases.h"

namespace haarlight::test {

/// The text of a file of known answers with its answers replaced by those of `known`, one for each
/// of its cases; everything else stays as it is.
std::string withAnswers(const std::string& text, const std::vector<verify::KnownCase>& known);

}  // namespace haarlight::test
