// The transport of a device with packets: reports in and out. hid/hid_port.h implements HID; a serial or network port
// also finds and checks the boundaries of a report. One thread at a time uses a port; read() may block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace moltact {

/// The longest report, including its id (unit: byte).
inline constexpr std::size_t kMaxReportBytes = 64;
/// Memory for one report.
using ReportBuffer = std::span<std::uint8_t, kMaxReportBytes>;

class PacketPort {
 public:
  virtual ~PacketPort() = default;
  /// Reads one report, starting with its id if the device numbers its reports. Returns its length; 0: none arrived
  /// within `wait_ms`; -1: the device is disconnected.
  virtual int read(std::span<std::uint8_t> report, int wait_ms) = 0;
  /// Writes one report, starting with its id (for HID 0 without numbered reports). False: the device is disconnected.
  virtual bool write(std::span<const std::uint8_t> report) = 0;
  /// Reads the device's description of itself; for HID the feature report whose id is in report[0]. Returns its length;
  /// -1: there is none.
  virtual int feature(std::span<std::uint8_t>) { return -1; }
  /// Stores the report that ends all force. It is written when the process dies and no thread can write any more
  /// (platform/force_inhibit.h).
  virtual void lastReport(std::span<const std::uint8_t>) {}
};

}  // namespace moltact
