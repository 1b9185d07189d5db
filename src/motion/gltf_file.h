#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/text_format.h"

namespace haarlight {

/// A glTF 2.0 file as tinygltf gives it, with all buffers loaded. Numbers that point to other parts
/// are not checked yet: element() does that where one is followed.
struct GltfFile {
  std::filesystem::path path;
  tinygltf::Model model;

  /// Throws InputError "cannot read mesh <path>: <place>: <problem>".
  [[noreturn]] void fail(const std::string& place, const std::string& problem) const;

  /// list[index]. Throws InputError when there is no such element; `kind` is what the list is of.
  template <typename Element>
  const Element& element(const std::vector<Element>& list, int index, const std::string& kind,
                         const std::string& place) const {
    if (index < 0 || std::size_t(index) >= list.size())
      fail(place, "there is no " + kind + " " + std::to_string(index) + ", the file has " +
                      countText(list.size(), kind) + "; export it again");
    return list[std::size_t(index)];
  }
};

/// Vertices, corners, offsets of morph targets, influences of joints and keys of animations that
/// are loaded at most, each counted as often as it is used: so that a small file, whose parts may
/// share accessors, cannot ask for any amount of memory.
inline constexpr std::size_t largestGltfCount = std::size_t(1) << 28;

/// Adds `more` to `count`. Throws InputError when that goes beyond largestGltfCount.
void addToGltfCount(const GltfFile& file, std::size_t& count, std::size_t more);

/// Reads a .gltf (with buffers embedded or in files beside it) or .glb of at most 8 GiB. Images are
/// neither read nor needed. Throws InputError when a file is missing or damaged (gltf_container.h,
/// gltf_prepare.h, gltf_buffers.h).
GltfFile readGltf(const std::filesystem::path& path);

}  // namespace haarlight
