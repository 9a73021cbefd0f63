#include <algorithm>

#include "engine/device/driver.h"
#include "engine/language/catalogue.h"

// One line per driver, the default first and the mouse last: k<Name>Driver, defined in the file of its kind.
#ifdef __EMSCRIPTEN__  // a page can use HID devices that the user selects, but no vendor's library
#define MOLTACT_DRIVERS(X) \
  X(OpenLayout)            \
  X(SpaceMouse)            \
  X(Simulated)             \
  X(Mouse)
#else
#define MOLTACT_DRIVERS(X) \
  X(Omni)                  \
  X(WoodenHaptics)         \
  X(OpenLayout)            \
  X(OpenTcp)               \
  X(SpaceMouse)            \
  X(DualShock4)            \
  X(DualSense)             \
  X(Simulated)             \
  X(Mouse)
#endif

namespace moltact {

#define MOLTACT_DECLARE(Name) extern const DeviceDriver k##Name##Driver;
MOLTACT_DRIVERS(MOLTACT_DECLARE)
#undef MOLTACT_DECLARE

std::span<const DeviceDriver> deviceDrivers() {
#define MOLTACT_ROW(Name) k##Name##Driver,
  static const DeviceDriver kAll[] = {MOLTACT_DRIVERS(MOLTACT_ROW)};
#undef MOLTACT_ROW
  return kAll;
}

namespace {

std::vector<FoundDevice> findWith(const DeviceDriver& driver) {
  std::vector<FoundDevice> some = driver.find();
  for (std::size_t k = 0; k < some.size(); ++k) {
    some[k].name = driver.name;
    if (k > 0) some[k].name += ':' + std::to_string(k + 1);
  }
  return some;
}

}  // namespace

const DeviceDriver* findDriver(std::string_view name) {
  for (const DeviceDriver& driver : deviceDrivers())
    if (driver.name == name.substr(0, name.find(':'))) return &driver;
  return nullptr;
}

std::vector<FoundDevice> findDevices() {
  std::vector<FoundDevice> all;
  for (const DeviceDriver& driver : deviceDrivers())
    for (FoundDevice& one : findWith(driver)) all.push_back(std::move(one));
  return all;
}

std::optional<FoundDevice> findDevice(std::string_view name) {
  const DeviceDriver* const driver = findDriver(name);
  if (!driver) return std::nullopt;
  if (const std::size_t colon = name.find(':'); driver->find_at && colon != std::string_view::npos) {
    FoundDevice one = driver->find_at(name.substr(colon + 1));
    one.name = name;
    return one;
  }
  for (FoundDevice& one : findWith(*driver))
    if (one.name == name) return std::move(one);
  return std::nullopt;
}

const FoundDevice& defaultDevice(const std::vector<FoundDevice>& found) {
  const auto best = std::find_if(found.begin(), found.end(),
                                 [](const FoundDevice& one) { return one.usable && one.auto_selectable; });
  return best != found.end() ? *best : found.back();
}

Expected<std::unique_ptr<Device>> openDevice(std::string_view name) {
  if (const std::optional<FoundDevice> one = findDevice(name)) {
    if (!one->usable) return Problem{"", 0, 0, trf("{0} cannot be used", tr(one->title.c_str())), one->why};
    return findDriver(name)->open(*one);
  }
  std::string names;
  for (const FoundDevice& one : findDevices()) names += (names.empty() ? "" : ", ") + one.name;
  return Problem{"", 0, 0, trf("there is no device \"{0}\"", name), trf("these are known: {0}", names)};
}

}  // namespace moltact
