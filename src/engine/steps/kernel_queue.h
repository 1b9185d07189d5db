#pragma once

#include <initializer_list>
#include <ranges>

#include "engine/growing_buffer.h"
#include "engine/kernel_device.h"

namespace haarlight {

inline std::size_t roundedUp(std::size_t count, std::size_t multiple) {
  return (count + multiple - 1) / multiple * multiple;
}

/// A device's memory and launches, counted in samples. Work-groups are always full: what is
/// uploaded for samples is filled up with zeros to whole groups, there is room for as many results,
/// and nobody reads those.
class KernelQueue {
 public:
  explicit KernelQueue(std::unique_ptr<KernelDevice> device);

  KernelDevice& device() { return *device_; }
  const KernelDevice& device() const { return *device_; }
  /// Bytes of all buffers.
  std::uint64_t allocatedBytes() const { return allocatedBytes_; }
  std::size_t samplesPerGroup() const { return samplesPerGroup_; }

  KernelArgument room(GrowingBuffer& buffer, std::size_t bytes) {
    return &buffer.atLeast(*device_, bytes, allocatedBytes_);
  }
  KernelArgument roomForSamples(GrowingBuffer& buffer, std::size_t samples, std::size_t bytesEach) {
    return room(buffer, fullGroups(samples) * bytesEach);
  }

  template <std::ranges::contiguous_range Data>
  CommandSeconds upload(GrowingBuffer& buffer, const Data& data) {
    const auto bytes = std::as_bytes(std::span(data));
    return device_->write(buffer.atLeast(*device_, bytes.size(), allocatedBytes_), bytes);
  }

  /// Uploads one element per sample.
  template <std::ranges::contiguous_range Data>
  CommandSeconds uploadSamples(GrowingBuffer& buffer, const Data& data) {
    const std::size_t count = std::ranges::size(data), full = fullGroups(count);
    if (full == count) return upload(buffer, data);
    std::vector<std::ranges::range_value_t<Data>> padded(full);
    std::ranges::copy(data, padded.begin());
    return upload(buffer, padded);
  }

  template <std::ranges::contiguous_range Data>
  CommandSeconds download(const GrowingBuffer& buffer, Data&& data) {
    return device_->read(buffer.get(), std::as_writable_bytes(std::span(data)));
  }

  /// Runs a kernel that takes a sample for each 32 lanes.
  CommandSeconds launch(std::string_view kernel, std::size_t samples,
                        std::initializer_list<KernelArgument> arguments);

  /// Runs a kernel that merges: where an item has all lanes, it takes a tile of samples.
  CommandSeconds launchTiles(std::string_view kernel, std::size_t samples,
                             std::initializer_list<KernelArgument> arguments);

 private:
  std::size_t fullGroups(std::size_t samples) const;

  std::unique_ptr<KernelDevice> device_;
  std::size_t samplesPerGroup_;
  std::size_t tileSamples_;  ///< of an item where kernels merge
  std::uint64_t allocatedBytes_ = 0;
};

}  // namespace haarlight
