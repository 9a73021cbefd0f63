// The transport of a device that speaks in packets: one report in, one report out. The HID one is hid/hid_port.h; a
// serial or network device brings its own, which finds the beginning and the end of a report and checks it. One thread
// at a time uses a port; a read may wait.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace moltact {

/// No report is longer (unit: bytes), with its id.
inline constexpr std::size_t kMaxReportBytes = 64;
/// Memory for one report.
using ReportBuffer = std::span<std::uint8_t, kMaxReportBytes>;

class PacketPort {
 public:
  virtual ~PacketPort() = default;
  /// Reads one report, its id first where the device numbers its reports. Returns its length; 0: none came within
  /// `wait_ms`; -1: the device is gone.
  virtual int read(std::span<std::uint8_t> report, int wait_ms) = 0;
  /// Writes one report, its id first (for HID 0 where the device does not number them). False: the device is gone.
  virtual bool write(std::span<const std::uint8_t> report) = 0;
  /// Reads the device's description of itself: for HID the feature report whose id is in report[0]. Returns its length;
  /// -1 where there is none.
  virtual int feature(std::span<std::uint8_t>) { return -1; }
  /// Keeps the report that ends all force. It is written when the process dies and nobody else can write any more
  /// (platform/force_inhibit.h).
  virtual void lastReport(std::span<const std::uint8_t>) {}
};

}  // namespace moltact
