// The device drivers and the devices that they find. A new device needs its own files and a row in drivers.cpp.
// Window's thread and commands; finding devices may block for some tens of milliseconds.
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

/// One device found by a driver.
struct FoundDevice {
  /// The name in `moltact device check NAME`: the driver's name, with ":2" etc. from the second device on, or with an
  /// address.
  std::string name = {};
  std::string title =
      {};  ///< the device's own title, or an English name by this program; pass it through `tr` to show it
  std::string place = {};  ///< port or path in the driver's notation; may be empty
  bool usable = false;
  std::string why = {};  ///< if not usable: the reason and the remedy; else empty
  bool gives_force = false;
  double max_torque_N_mm = 0.0;            ///< peak torque; 0: it drives none
  double rotational_damping_N_mm_s = 0.0;  ///< b_r of the mechanism, per radian; 0: not known
  bool auto_selectable = false;            ///< may be selected without a request by the user
  std::string note = {};                   ///< information for the user before the device is used; may be empty
};

/// One row of the table of drivers.
struct DeviceDriver {
  std::string_view name;      ///< "omni"
  std::string_view sentence;  ///< description
  /// Lists the devices of this driver. A driver that cannot search returns one entry with the reason.
  std::vector<FoundDevice> (*find)();
  /// Describes the device at an address given by the user (NAME:ADDRESS), without contacting it. The address is in
  /// FoundDevice::place. The result is not usable if the text is not an address. Null: the driver takes no address.
  FoundDevice (*find_at)(std::string_view address) = nullptr;
  std::string_view address_example = {};  ///< set if find_at is
  Expected<std::unique_ptr<Device>> (*open)(const FoundDevice& device);
};

/// All drivers. The default device is the first one found that is usable and `auto_selectable`; the mouse is last.
std::span<const DeviceDriver> deviceDrivers();

/// Finds the driver of a device name, "omni" or "omni:2"; null if there is none.
const DeviceDriver* findDriver(std::string_view name);

/// Lists the devices of all drivers, in the drivers' order.
std::vector<FoundDevice> findDevices();

/// Finds the device of that name by its driver alone; empty if there is no such driver or device.
std::optional<FoundDevice> findDevice(std::string_view name);

/// The device to use without a choice by the user. It never fails, because the mouse is always present.
const FoundDevice& defaultDevice(const std::vector<FoundDevice>& found);

/// Opens the device of that name. Returns a Problem if there is none (with a list of the available devices), if it
/// cannot be used, or if opening fails.
Expected<std::unique_ptr<Device>> openDevice(std::string_view name);

/// True in a browser, where a page sees only devices that the user has selected. askForDevice() then opens the
/// browser's dialog for the selection; it must be called within a second of a click. Elsewhere false.
bool devicesAreAskedFor() noexcept;
void askForDevice();

}  // namespace moltact
