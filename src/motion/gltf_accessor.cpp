#include "motion/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace haarlight {

namespace {

/// Bytes of a number; 0 for what glTF 2.0 does not know.
std::size_t componentSize(int componentType) {
  const bool known = componentType != TINYGLTF_COMPONENT_TYPE_INT &&
                     componentType != TINYGLTF_COMPONENT_TYPE_DOUBLE;
  return known ? std::size_t(
                     std::max(0, tinygltf::GetComponentSizeInBytes(std::uint32_t(componentType))))
               : 0;
}

template <typename Stored, typename Number>
Number converted(Stored stored, bool normalized) {
  if constexpr (std::integral<Stored> && std::same_as<Number, float>)
    if (normalized)
      return std::max(float(stored) / float(std::numeric_limits<Stored>::max()), -1.0f);
  return Number(stored);
}

template <typename Stored, typename Number>
void copyNumbers(const GltfElements& elements, std::size_t index, Number* numbers) {
  const std::uint8_t* bytes = elements.bytes + index * elements.stride;
  for (std::size_t i = 0; i < elements.components; ++i) {
    Stored stored;
    std::memcpy(&stored, bytes + i * sizeof stored, sizeof stored);
    numbers[i] = converted<Stored, Number>(stored, elements.normalized);
  }
}

template <typename Number>
void copyElement(const GltfElements& elements, std::size_t index, Number* numbers) {
  switch (elements.componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copyNumbers<std::uint8_t>(elements, index, numbers);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copyNumbers<std::uint16_t>(elements, index, numbers);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copyNumbers<std::uint32_t>(elements, index, numbers);
    default:
      break;
  }
  if constexpr (std::same_as<Number, float>) {
    if (elements.componentType == TINYGLTF_COMPONENT_TYPE_BYTE)
      copyNumbers<std::int8_t>(elements, index, numbers);
    else if (elements.componentType == TINYGLTF_COMPONENT_TYPE_SHORT)
      copyNumbers<std::int16_t>(elements, index, numbers);
    else
      copyNumbers<float>(elements, index, numbers);
  }
}

bool isUnsigned(int componentType) {
  return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// An element without bytes takes memory all the same; this bounds how much.
std::size_t totalBytes(const tinygltf::Model& model) {
  std::size_t bytes = 0;
  for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
  return bytes;
}

}  // namespace

GltfAccessorReader::GltfAccessorReader(const GltfFile& file, int accessor, std::size_t components,
                                       std::optional<std::size_t> count, const std::string& place)
    : file_(file), place_(place) {
  const tinygltf::Accessor& found = file.element(file.model.accessors, accessor, "accessor", place);
  place_ += ": accessor " + std::to_string(accessor);
  if (std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(found.type))) != components)
    fail("has elements of another type, not of " + countText(components, "number"));
  if (count && found.count != *count)
    fail("has " + countText(found.count, "element") + " instead of " + std::to_string(*count));
  if (found.count > totalBytes(file.model))
    fail("has " + countText(found.count, "element") + ", more than the file has bytes");
  if (componentSize(found.componentType) == 0)
    fail("has a component type that glTF 2.0 does not know");
  elements_ = {nullptr, found.count, components, 0, found.componentType, found.normalized};
  if (found.bufferView >= 0)
    elements_ = viewElements(found.bufferView, found.byteOffset, elements_);
  if (found.sparse.isSparse) locateSparse(found);
}

void GltfAccessorReader::fail(const std::string& problem) const {
  file_.fail(place_, problem + "; export it again");
}

/// All numbers of a prepared file are below 2^31, so that nothing here leaves 64 bits.
GltfElements GltfAccessorReader::viewElements(int bufferView, std::size_t offset,
                                              GltfElements elements) const {
  const tinygltf::BufferView& view =
      file_.element(file_.model.bufferViews, bufferView, "buffer view", place_);
  const std::vector<unsigned char>& bytes =
      file_.element(file_.model.buffers, view.buffer, "buffer", place_).data;
  const std::string viewName = "buffer view " + std::to_string(bufferView);
  if (view.byteOffset + view.byteLength > bytes.size())
    fail(viewName + " ends at byte " + std::to_string(view.byteOffset + view.byteLength) +
         " of a buffer of " + std::to_string(bytes.size()));
  const std::size_t size = elements.components * componentSize(elements.componentType);
  elements.stride = view.byteStride == 0 ? size : view.byteStride;
  if (elements.stride < size) fail(viewName + " has a stride shorter than an element");
  const std::size_t end =
      elements.count == 0 ? 0 : offset + (elements.count - 1) * elements.stride + size;
  if (end > view.byteLength)
    fail("ends at byte " + std::to_string(end) + " of " + viewName + ", which has " +
         std::to_string(view.byteLength));
  if (elements.count > 0) elements.bytes = bytes.data() + view.byteOffset + offset;
  return elements;
}

void GltfAccessorReader::locateSparse(const tinygltf::Accessor& accessor) {
  const auto& sparse = accessor.sparse;
  if (std::size_t(sparse.count) > elements_.count) fail("replaces more elements than it has");
  if (!isUnsigned(sparse.indices.componentType)) fail("has sparse indices of a wrong type");
  GltfElements indices{nullptr, std::size_t(sparse.count), 1, 0, sparse.indices.componentType};
  sparseIndices_ =
      viewElements(sparse.indices.bufferView, std::size_t(sparse.indices.byteOffset), indices);
  GltfElements values = elements_;
  values.count = std::size_t(sparse.count);
  sparseValues_ =
      viewElements(sparse.values.bufferView, std::size_t(sparse.values.byteOffset), values);
}

template <typename Number>
void GltfAccessorReader::readAll(Number* numbers) const {
  const std::size_t components = elements_.components;
  for (std::size_t i = 0; i < elements_.count; ++i) {
    if (elements_.bytes)
      copyElement(elements_, i, numbers + i * components);
    else
      std::fill_n(numbers + i * components, components, Number(0));
  }
  for (std::size_t i = 0; i < sparseIndices_.count; ++i) {
    std::uint32_t target = 0;
    copyElement(sparseIndices_, i, &target);
    if (target >= elements_.count)
      fail("replaces element " + std::to_string(target) + " of " + std::to_string(elements_.count));
    copyElement(sparseValues_, i, numbers + target * components);
  }
}

void GltfAccessorReader::read(float* numbers) const {
  readAll(numbers);
  for (std::size_t i = 0; i < elements_.count * elements_.components; ++i)
    if (!std::isfinite(numbers[i]))
      fail("element " + std::to_string(i / elements_.components) + " is not a finite number");
}

void GltfAccessorReader::read(std::uint32_t* numbers) const {
  if (!isUnsigned(elements_.componentType) || elements_.normalized)
    fail("does not have whole numbers, which are needed here");
  readAll(numbers);
}

}  // namespace haarlight
