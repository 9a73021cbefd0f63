// The device drivers, and the devices that they find. A device is added with its own files and a row in drivers.cpp.
// Window's thread and commands; finding may take some tens of milliseconds.
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

/// One device that a driver has found.
struct FoundDevice {
  /// As in `moltact device check NAME`: the driver's, with ":2" and so on from the second on, or with an address.
  std::string name = {};
  std::string title = {};  ///< the device's own title, or a name of ours in English; pass it through `tr` to show it
  std::string place = {};  ///< the port or path, in the driver's words; may be empty
  bool usable = false;
  std::string why = {};  ///< why it cannot be used and what would help; empty where it can
  bool gives_force = false;
  bool auto_selectable = false;  ///< may be chosen without a person asking for it
  std::string note = {};         ///< what a person must know before the device is used; may be empty
};

struct DeviceDriver {
  std::string_view name;      ///< "omni"
  std::string_view sentence;  ///< its purpose
  /// Lists the devices of this driver. A driver that cannot look at all returns one entry that says why.
  std::vector<FoundDevice> (*find)();
  /// Describes the device at an address that a person gives (NAME:ADDRESS), without contacting it. The address is in
  /// FoundDevice::place. Not usable where the text is no address. Null where the driver takes no address.
  FoundDevice (*find_at)(std::string_view address) = nullptr;
  std::string_view address_example = {};  ///< where find_at is set
  Expected<std::unique_ptr<Device>> (*open)(const FoundDevice& device);
};

/// Every driver. The default device is the first one found that is usable and `auto_selectable`; the mouse comes last.
std::span<const DeviceDriver> deviceDrivers();

/// The driver of a device's name, "omni" or "omni:2"; null where none has that name.
const DeviceDriver* findDriver(std::string_view name);

/// The devices that all drivers find, in the drivers' order.
std::vector<FoundDevice> findDevices();

/// The device of that name, found by its driver alone; nothing where no driver has that name or it does not list the
/// device.
std::optional<FoundDevice> findDevice(std::string_view name);

/// The device to use where nobody has chosen; never fails, for the mouse is always there.
const FoundDevice& defaultDevice(const std::vector<FoundDevice>& found);

/// Opens the device of that name. A Problem where no device has that name (it lists those there are), where it cannot
/// be used, or where opening fails.
Expected<std::unique_ptr<Device>> openDevice(std::string_view name);

/// A page in a browser sees only the devices that the person has shown it: askForDevice() then opens the browser's own
/// list of them, within a second of a click. Elsewhere false, and nothing to ask.
bool devicesAreAskedFor() noexcept;
void askForDevice();

}  // namespace moltact
