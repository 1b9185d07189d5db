#pragma once

/// Cases as text files: one keyword a line, comments on lines that begin with #.
///
///   haarlight-case 1                   first line: format and version
///   name grazing spheres
///   sphere x y z radius                any number up to 65,536
///   receiver x y z nx ny nz            position and unit normal; the lobes follow from the normal
///   plane count spacing                count × count receivers of normal +Y around the origin,
///   rows
///                                      along Z, columns along X
///   light constant red green blue      the same radiance from everywhere
///   light random seed                  randomLight(seed)
///   texel index red green blue         or texel by texel; those not named are black
///   vertex x y z                       what spheres can follow; vertices are numbered from 0
///   bound mean reach                   a sphere that follows vertices, with its radius factors
///   follows vertex a b g               and one of its entries (visibility/sphere_binding.h)
///
/// Receivers and vertices are at most 1,048,576, bound spheres 65,536. Numbers are decimal or, so
/// that every bit is kept, hexadecimal as C's %a writes them.

#include <filesystem>
#include <string>

#include "verify/cases/case.h"

namespace haarlight::verify {

/// Writes a case as text, floats in hexadecimal so that every bit is kept. Whatever in the name is
/// no printable character is escaped.
std::string caseText(const Case& value);

/// Reads what caseText() wrote, or what was written by hand. `source` names the text in messages.
/// Throws InputError with the line's number.
Case readCaseText(const std::string& text, const std::string& source);

/// The same of a file of at most 256 MiB.
Case readCaseFile(const std::filesystem::path& path);
void writeCaseFile(const std::filesystem::path& path, const Case& value);

}  // namespace haarlight::verify
