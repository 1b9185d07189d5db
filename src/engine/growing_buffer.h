#pragma once

#include <algorithm>
#include <memory>

#include "engine/kernel_device.h"

namespace haarlight {

/// Device memory that grows to what is asked of it and is kept. `allocated` is the sum over all.
class GrowingBuffer {
 public:
  DeviceBuffer& atLeast(KernelDevice& device, std::size_t bytes, std::uint64_t& allocated) {
    bytes = std::max(bytes, smallestBuffer);
    if (bytes > size_) {
      buffer_.reset();
      buffer_ = device.allocate(bytes);
      allocated += bytes - size_;
      size_ = bytes;
    }
    return *buffer_;
  }
  operator KernelArgument() const { return buffer_.get(); }
  const DeviceBuffer& get() const { return *buffer_; }

 private:
  /// So that small frames need not grow theirs.
  static constexpr std::size_t smallestBuffer = 64 << 10;

  std::unique_ptr<DeviceBuffer> buffer_;
  std::size_t size_ = 0;
};

}  // namespace haarlight
