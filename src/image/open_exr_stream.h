#pragma once

#include <IexBaseExc.h>
#include <ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace haarlight {

/// Lets OpenEXR read from memory.
class OpenExrInput : public Imf::IStream {
 public:
  explicit OpenExrInput(std::span<const std::uint8_t> bytes)
      : Imf::IStream("image"), bytes_(bytes) {}

  bool read(char destination[], int count) override {
    if (count < 0 || position_ > bytes_.size() || bytes_.size() - position_ < std::size_t(count))
      throw Iex::InputExc("the file ends too early");
    std::memcpy(destination, bytes_.data() + position_, count);
    position_ += count;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::uint64_t position_ = 0;
};

/// Lets OpenEXR write to memory.
class OpenExrOutput : public Imf::OStream {
 public:
  OpenExrOutput() : Imf::OStream("image") {}

  void write(const char source[], int count) override {
    bytes_.resize(std::max<std::size_t>(bytes_.size(), position_ + count));
    std::memcpy(bytes_.data() + position_, source, count);
    position_ += count;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint64_t position_ = 0;
};

}  // namespace haarlight
