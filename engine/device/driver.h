// The devices there are, and what stands in the way of those that cannot be used. A device is added with its own files
// and one line in drivers.cpp. Window's thread and commands; looking may take some tens of milliseconds.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/device/device.h"

namespace moltact {

/// One device that a driver knows of.
struct FoundDevice {
  std::string name = {};   ///< as in `moltact device check NAME`: the driver's, with ":2" and so on from the second on
  std::string title = {};  ///< what is written on it, or a name of ours in English; `tr` where it is shown
  std::string place = {};  ///< where it is plugged in, in the driver's words; may be empty
  bool usable = false;
  std::string why = {};  ///< why it cannot be used and what would mend it; empty where it can
  bool gives_force = false;
  bool auto_selectable = false;  ///< may be chosen without being asked for
};

struct DeviceDriver {
  std::string_view name;      ///< "omni"
  std::string_view sentence;  ///< what it is for
  /// What there is now. A driver that cannot look at all gives one entry that says why.
  std::vector<FoundDevice> (*find)();
  Expected<std::unique_ptr<Device>> (*open)(const FoundDevice& device);
};

/// Every driver; the first whose device is usable `auto_selectable` is the default, the mouse is the last.
std::span<const DeviceDriver> deviceDrivers();

/// What all drivers find, in their order.
std::vector<FoundDevice> findDevices();

/// What there is of that name, by its driver alone; nothing where no driver knows it or it lists none.
std::optional<FoundDevice> findDevice(std::string_view name);

/// The one to use where nobody chose; never fails, for the mouse is always there.
const FoundDevice& defaultDevice(const std::vector<FoundDevice>& found);

/// Opens the device of that name. A Problem where there is none of that name (it lists those there are), where it
/// cannot be used, or where it fails to open.
Expected<std::unique_ptr<Device>> openDevice(std::string_view name);

}  // namespace moltact
