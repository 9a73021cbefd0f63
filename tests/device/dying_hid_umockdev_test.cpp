// A process that ends while it applies a force to a HID device, in every way but SIGKILL, through the real libhidapi:
// the last report to the device has no force. Runs under umockdev-wrapper; the child is another process on the same
// mocked devices.
#include <cstdlib>

#include "engine/device/hid/open_layout.h"
#include "engine/device/hid/play_station.h"
#include "engine/device/packet/report_bytes.h"
#include "tests/device/dying.h"
#include "tests/device/hid_testbed.h"
#include "tests/device/mocked_hids.h"

using namespace moltact;
using namespace moltact::test;

namespace {

// The far end of a device: it sends its position and interprets the force in received reports.
struct FarEnd {
  const char* driver;
  MockedHid listed;
  Bytes place, later;                   // first, and when it is pressed
  std::size_t report_bytes;             // as they come
  double (*size)(const std::uint8_t*);  // of the force in one
};

double currents(const std::uint8_t* r) {
  const std::span<const std::uint8_t> bytes(r, 9);  // the first is 0, which the kernel would take off
  return std::abs(int16At(bytes, 1)) + std::abs(int16At(bytes, 3)) + std::abs(int16At(bytes, 5));
}
double openForce(const std::uint8_t* r) {
  const std::span<const std::uint8_t> bytes(r, open_layout::kForceBytes);
  return r[9] ? std::abs(int16At(bytes, 3)) + std::abs(int16At(bytes, 5)) + std::abs(int16At(bytes, 7)) : 0.0;
}
template <const PadLayout& kPad>
double rumble(const std::uint8_t* r) {
  return r[kPad.weak_motor] + r[kPad.strong_motor];
}

// What came from the child, whole reports one after the other.
class Reports {
 public:
  explicit Reports(const FarEnd& end) : end_(end) {}
  void take(const Bytes& bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    for (; bytes_.size() >= end_.report_bytes;
         bytes_.erase(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(end_.report_bytes))) {
      last_ = end_.size(bytes_.data());
      greatest_ = std::max(greatest_, last_);
      if (last_ > 0.0) forced_ns_ = monotonic_ns();
    }
  }
  double last() const { return last_; }
  double greatest() const { return greatest_; }
  std::int64_t forced_ns() const { return forced_ns_; }
  std::size_t rest() const { return bytes_.size(); }

 private:
  const FarEnd& end_;
  Bytes bytes_;
  double last_ = -1, greatest_ = 0;
  std::int64_t forced_ns_ = 0;
};

}  // namespace

TEST_CASE(
    "HID devices: a process that gives force and is killed by any signal that can be seen, crashes on any thread, in "
    "its tick or by "
    "a full stack, exits or throws: the last report has none") {
  OpenFirmware firmware;
  const auto still = firmware.tick({});
  Bytes pad(64, 128);
  pad[0] = 1;
  const FarEnd ends[] = {
      // Upright a pull to the right has no lever.
      {"woodenhaptics", kWoodenHaptics, counts(0, 0, 0), counts(0, -6000, 0), 9, currents},
      {"open", openLayout(firmware), Bytes(still.begin(), still.end()), Bytes(still.begin(), still.end()),
       open_layout::kForceBytes, openForce},
      {"gamepad", kDualShock, pad, pad, kDualShock4.bytes, rumble<kDualShock4>},
      {"dualsense", kDualSensePad, pad, pad, kDualSense.bytes, rumble<kDualSense>},
  };
  for (const FarEnd& end : ends) {
    double worst_ms = 0;
    for (const WayToDie& one : kWaysToDie) {
      CAPTURE(std::string(end.driver));
      CAPTURE(std::string(one.way));
      CAPTURE(one.signal);
      HidTestbed bed;
      bed.plug(end.listed);
      Reports reports(end);
      Dying child(end.driver, one.way);
      std::uint16_t number = 0;
      Bytes place = end.place;
      const auto send = [&] {
        if (place.size() == 25) putInt16(place, 1, ++number);  // the open layout's reports are counted
        bed.sendAtOnce(place);
        reports.take(bed.written());
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      };
      std::string said;
      for (int k = 0; k < 60'000 && said.empty() && !child.over(); ++k) send(), said = child.line(0);
      REQUIRE(said == "pressing");
      place = end.later;
      for (int k = 0; k < 60'000 && !(reports.last() > 0.0); ++k) send();
      REQUIRE(reports.last() > 0.0);
      if (std::string(one.way) == "wait")
        child.send(one.signal);
      else
        child.go();
      for (int k = 0; k < 60'000 && !child.over(); ++k) send();
      CHECK((one.signal ? child.killedBy(one.signal) : child.exitedWith(7)));
      reports.take(bed.written());
      CHECK(reports.rest() == 0);
      CHECK(reports.greatest() > 0.0);
      CHECK(reports.last() == 0.0);
      const double forced_ms = 1e-6 * double(reports.forced_ns() - child.at_ns());
      CHECK(forced_ms < kBusy_ms);
      if (std::string(one.way) != "stack") worst_ms = std::max(worst_ms, forced_ms);  // filling it takes time
    }
    MESSAGE(std::string(end.driver) << ": " << std::size(kWaysToDie) << " ways, at most " << worst_ms
                                    << " ms until the last report with force was read");
  }
}
