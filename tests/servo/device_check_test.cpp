// The check of a device, on the simulated stylus whose own hand presses on what it is offered.
#include "engine/servo/device_check.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/device/simulated_device.h"

using namespace moltact;

namespace {

// A stylus that loses its plug after some reads.
class LoseableDevice final : public Device {
 public:
  const DeviceInfo& info() const noexcept override { return inner_.info(); }
  DevicePose read(double dt_s) noexcept override {
    if (++reads_ == 60) inner_.plug(false);
    return inner_.read(dt_s);
  }
  void write(ForceN force) noexcept override { inner_.write(force); }
  DeviceStatus status() override { return inner_.status(); }

 private:
  SimulatedDevice inner_;
  int reads_ = 0;
};

}  // namespace

TEST_CASE("the simulated stylus passes all four parts of the check, each asked for but the first") {
  int asked = 0;
  const auto parts = checkDevice(std::make_unique<SimulatedDevice>(), {.ask = [&](const std::string&) { ++asked; return true; }, .tell = {}, .part_s = 0.6});
  REQUIRE(parts.size() == 4);
  for (const CheckedPart& part : parts) {
    CAPTURE(part.name);
    CHECK(part.done);
    CHECK_MESSAGE(part.passed, part.found);
  }
  CHECK(asked == 3);
}

TEST_CASE("a part that the person does not want is left out and gives no force") {
  const auto parts = checkDevice(std::make_unique<SimulatedDevice>(), {.ask = [](const std::string&) { return false; }, .tell = {}, .part_s = 0.1});
  REQUIRE(parts.size() == 4);
  CHECK(parts.front().passed);
  for (std::size_t k = 1; k < 4; ++k) {
    CHECK_FALSE(parts[k].done);
    CHECK(parts[k].found == "left out");
  }
}

TEST_CASE("a device that is unplugged in the first part fails it, and the parts with force are left out") {
  const auto parts = checkDevice(std::make_unique<LoseableDevice>(), {.ask = [](const std::string&) { return true; }, .tell = {}, .part_s = 0.4});
  CHECK_FALSE(parts.front().passed);
  for (std::size_t k = 1; k < parts.size(); ++k) CHECK_FALSE(parts[k].done);
}
