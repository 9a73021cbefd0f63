// The way to a HID device: reports in, reports out, through hidapi. A port is used by one thread at a time; a read may
// wait.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// One interface of a HID device as the system lists it.
struct HidEntry {
  std::string path = {};   ///< "/dev/hidraw0"
  std::string title = {};  ///< maker and product, as the device says it
  std::string serial = {};
  std::uint16_t vendor = 0, product = 0, usage_page = 0, usage = 0;
};

class HidPort {
 public:
  virtual ~HidPort() = default;
  /// One report, its id first where the device numbers its reports. 0: none came within `wait_ms`; -1: the device is
  /// gone.
  virtual int read(std::span<std::uint8_t> report, int wait_ms) = 0;
  /// One report, its id first (0 where the device does not number them). False: the device is gone.
  virtual bool write(std::span<const std::uint8_t> report) = 0;
  /// The feature report whose id is in report[0]. Its length; -1 where there is none.
  virtual int feature(std::span<std::uint8_t> report) = 0;
  /// The report that ends all force, for when the process dies and nobody can write any more (platform/force_inhibit.h).
  virtual void lastReport(std::span<const std::uint8_t>) {}
};

/// All HID interfaces that the system shows. Any thread.
std::vector<HidEntry> listHid();
/// A Problem with the reason, most often a missing right, and the way to get it.
Expected<std::unique_ptr<HidPort>> openHid(const HidEntry& entry);

}  // namespace moltact
