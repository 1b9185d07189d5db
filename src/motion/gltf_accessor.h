#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "motion/gltf_file.h"

namespace haarlight {

/// `count` numbers times `components`, somewhere in a buffer and checked to lie within it.
struct GltfElements {
  const std::uint8_t* bytes = nullptr;  ///< null: all are zero
  std::size_t count = 0, components = 0, stride = 0;
  int componentType = 0;
  bool normalized = false;
};

/// Reads an accessor of glTF 2.0 (section 3.6.2): elements in a buffer view with any stride, or
/// zeros, some of them replaced (sparse accessors). Integers that are marked as normalized become
/// numbers from 0 to 1 or from −1 to 1, others keep their value.
class GltfAccessorReader {
 public:
  /// Throws InputError, naming `place`, when there is no such accessor, its elements do not have
  /// `components` numbers, there are not `count` of them (where a count is given), or they do not
  /// lie within buffer views and buffers.
  GltfAccessorReader(const GltfFile& file, int accessor, std::size_t components,
                     std::optional<std::size_t> count, const std::string& place);

  std::size_t count() const { return elements_.count; }

  /// Writes count() · components numbers. Throws InputError at a number that is not finite.
  void read(float* numbers) const;
  /// The same for accessors of unsigned integers; throws InputError for others.
  void read(std::uint32_t* numbers) const;

 private:
  template <typename Number>
  void readAll(Number* numbers) const;
  GltfElements viewElements(int bufferView, std::size_t offset, GltfElements elements) const;
  void locateSparse(const tinygltf::Accessor& accessor);
  [[noreturn]] void fail(const std::string& problem) const;

  const GltfFile& file_;
  std::string place_;
  GltfElements elements_, sparseIndices_, sparseValues_;
};

/// All elements of an accessor. Element is float, std::uint32_t, or a vector or matrix of them.
template <typename Element>
std::vector<Element> readGltfElements(const GltfFile& file, int accessor, const std::string& place,
                                      std::optional<std::size_t> count = {}) {
  constexpr bool integers = [] {
    if constexpr (std::is_class_v<Element>)
      return std::integral<typename Element::value_type>;
    else
      return std::integral<Element>;
  }();
  using Number = std::conditional_t<integers, std::uint32_t, float>;
  static_assert(sizeof(Element) % sizeof(Number) == 0);
  const GltfAccessorReader reader(file, accessor, sizeof(Element) / sizeof(Number), count, place);
  std::vector<Element> elements(reader.count());
  reader.read(reinterpret_cast<Number*>(elements.data()));
  return elements;
}

}  // namespace haarlight
