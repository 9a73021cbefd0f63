// The HID devices of the umockdev tests, and helpers that these share.
#pragma once

#include <chrono>
#include <memory>
#include <thread>

#include "engine/device/driver.h"
#include "engine/device/hid/hid_kind.h"
#include "engine/device/packet/report_bytes.h"
#include "tests/device/hid_testbed.h"
#include "tests/device/open_firmware.h"

namespace moltact::test {

inline const MockedHid kSpaceMouse{"256F", "C635", "3Dconnexion SpaceMouse Compact", hidDescriptor(1, 8)};
inline const MockedHid kWoodenHaptics{"1234", "0006", "Forsslund WoodenHaptics", hidDescriptor(0xFF00, 2)};

inline const MockedHid kDualSensePad{"054C", "0CE6", "Sony DualSense Wireless Controller", hidDescriptor(1, 5)};
inline const MockedHid kDualShock{"054C", "09CC", "Sony Wireless Controller", hidDescriptor(1, 5)};

inline MockedHid openLayout(const OpenFirmware& firmware) {
  const auto description = firmware.description();
  return {"1209", "0001", "Workshop Stylus", Bytes(std::begin(kOpenReportDescriptor), std::end(kOpenReportDescriptor)),
          Bytes(description.begin(), description.end())};
}

/// WoodenHaptics' report: the counts of its three encoders.
inline Bytes counts(int a, int b, int c) {
  Bytes report(8);
  putInt16(report, 0, a);
  putInt16(report, 2, b);
  putInt16(report, 4, c);
  return report;
}

inline std::unique_ptr<Device> opened(std::string_view name) {
  auto device = openDevice(name);
  REQUIRE_MESSAGE(device, (device ? "" : device.problem().text()));
  return std::move(*device);
}

/// Waits a few seconds for `done`; the caller checks the result.
template <class Done>
void waitFor(Done done) {
  for (int k = 0; k < 5000 && !done(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// The user's calibration of WoodenHaptics: the links are upright, which is count 0 here.
inline void holdUpright(HidTestbed& bed, Device& device) {
  waitFor([&] { return (bed.send(counts(0, 0, 0)), device.read(0.001).position.mm.z < -219); });
  device.calibrate();
  waitFor([&] { return device.status().ready; });
  CHECK(device.status().ready);
}

}  // namespace moltact::test
