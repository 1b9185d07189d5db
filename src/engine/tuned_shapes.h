#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/devices.h"
#include "engine/kernel_shape.h"

namespace haarlight {

/// The shapes of work that have been found to be the fastest on devices of this machine, by
/// `haarlight devices --tune`, as a text file in the cache folder keeps them. A device is known by
/// its engine, its name and the version of its driver: with another driver it is another device.
class TunedShapes {
 public:
  /// Reads the file in `folder`; none is no shapes. So is a file that is damaged, of another kind,
  /// from a newer haarlight or unreadable, and `onWarning` is told.
  static TunedShapes read(const std::filesystem::path& folder,
                          const std::function<void(const std::string&)>& onWarning = {});

  /// Writes the file, whole or not at all; makes the folder. Throws InputError.
  void write(const std::filesystem::path& folder) const;

  std::optional<KernelShape> find(const DeviceDescription& device) const;
  /// Keeps a shape for a device instead of what was kept before; nothing: forgets that.
  void keep(const DeviceDescription& device, std::optional<KernelShape> shape);

 private:
  struct Entry {
    std::string engine, device, driver;
    KernelShape shape;
  };
  static std::vector<Entry> parse(const std::string& text);
  static bool isOf(const Entry& entry, const DeviceDescription& device);

  std::vector<Entry> entries_;
};

/// The file in `folder` that read() and write() are about.
std::filesystem::path tunedShapesFile(const std::filesystem::path& folder);

}  // namespace haarlight
