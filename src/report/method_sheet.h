#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/compare.h"
#include "image/image.h"

namespace haarlight {

/// How many times as bright as they are absolute errors are shown.
inline constexpr int shownErrorScale = 4;

/// One method's picture of a view that other methods show too.
struct MethodPicture {
  std::string method;
  std::string note;  ///< in the label, behind the method's name: "0.5 s"; may be empty
  Image radiance;    ///< linear
};

/// A row of errors: each picture against one of them.
struct ErrorRow {
  std::size_t reference;           ///< index of the picture that the others are held against
  std::vector<ImageError> errors;  ///< one per picture; that of the reference itself is 0
};

/// Errors of all pictures against the one at `reference`, over the pixels of `mask`. Throws
/// InputError as compareImages does.
ErrorRow errorsAgainst(std::span<const MethodPicture> pictures, std::size_t reference,
                       std::span<const std::uint8_t> mask);

/// The pictures side by side at an exposure of `stops`, as in figure 7 of the paper, and below them
/// one row of error pictures (image/compare.h, differenceImage) for each of `rows`, labelled with
/// its relative root mean square error; in the place of the reference stands its name. Linear,
/// ready for writePng. Throws InputError when sizes differ.
Image methodSheet(std::span<const MethodPicture> pictures, std::span<const ErrorRow> rows,
                  float stops);

}  // namespace haarlight
