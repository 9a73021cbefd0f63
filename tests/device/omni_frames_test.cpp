// Failing frames of an Omni: the driver reports an error, opens no frame, and keeps the force of the last good one.
// (Ordered after omni_device_test.cpp, whose first test requires that the library is not loaded yet.)
#include <doctest/doctest.h>

#include "engine/device/driver.h"
#include "tests/device/omni/stand_in.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr int kForGood = 1'000'000;

// Steps frames until the output is on, which the guard's thread decides; each step is a frame.
void untilOn(const StandIn& omni) {
  for (int k = 0; k < 10'000 && !omni.forcesOn(); ++k) {
    omni.step(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  REQUIRE(omni.forcesOn());
}

}  // namespace

TEST_CASE(
    "Omni: 300 frames that cannot be begun under 0.7 N, by each of 4 errors: the output is off in the first of them, "
    "the pose is a fault until frames succeed, and the force then begins below 0.1 N") {
  for (const std::uint32_t code : {hd::kIllegalBegin, hd::kFrameError, hd::kInvalidOperation, hd::kForceError}) {
    CAPTURE(code);
    const StandIn omni;
    const auto device = opened();
    Loop loop(*device);
    press(omni, loop);
    omni.failBegins(300, code);
    omni.step(1);
    CHECK(omni.force() >= 0.69);  // the driver still has it
    CHECK(omni.driven() == 0.0);
    for (int k = 0; k < 299; ++k) {
      omni.step(1);
      REQUIRE(omni.driven() == 0.0);
      REQUIRE(glm::length(loop.last.force.N) == 0.0);
      REQUIRE(loop.last.limits.has(Limit::DeviceFault));
    }
    omni.step(1);
    CHECK(omni.force() == 0.0);
    untilOn(omni);
    omni.step(1);
    CHECK(omni.driven() < 0.1);
    press(omni, loop);
  }
}

TEST_CASE("Omni: a frame whose end leaves one of 3 errors of calls switches the output off in that tick") {
  for (const std::uint32_t code : {hd::kIllegalEnd, hd::kFrameError, hd::kInvalidValue}) {
    CAPTURE(code);
    const StandIn omni;
    const auto device = opened();
    Loop loop(*device);
    press(omni, loop);
    omni.errorAtEnd(code);
    omni.step(1);
    CHECK(omni.driven() == 0.0);
    untilOn(omni);
    press(omni, loop);
  }
}

TEST_CASE("Omni: warm motors and a force that the driver has cut are no failed frame: the output stays on") {
  for (const std::uint32_t code : {hd::kWarmMotors, hd::kExceededMaxForce, hd::kExceededVelocity}) {
    CAPTURE(code);
    const StandIn omni;
    const auto device = opened();
    Loop loop(*device);
    press(omni, loop);
    omni.errorAtEnd(code);
    omni.step(1);
    CHECK(omni.forcesOn());
  }
}

TEST_CASE(
    "Omni: a session that ends, by stopClock() and by the destructor, while no frame can be begun: the output is off "
    "before the scheduler stops, and a clock that is started again gives no force before two frames have succeeded") {
  const StandIn omni;
  auto device = opened();
  {
    Loop loop(*device);
    press(omni, loop);
    omni.failBegins(kForGood, hd::kIllegalBegin);
    // No frame comes before the end: the last one is tried after the scheduler has stopped, and fails too.
  }
  CHECK(omni.force() >= 0.69);
  CHECK(omni.driven() == 0.0);
  omni.failBegins(0, hd::kNoError);
  {
    Loop loop(*device);
    omni.step(1);
    CHECK(omni.driven() == 0.0);
    CHECK(omni.force() == 0.0);
    untilOn(omni);
    press(omni, loop);
    omni.failBegins(kForGood, hd::kIllegalBegin);
    omni.step(3);
  }
  CHECK(omni.driven() == 0.0);
  device.reset();
  CHECK_FALSE(omni.forcesOn());
}

TEST_CASE(
    "Omni: each third frame fails for 3000 ticks under a pressing hand: no failed frame leaves the motors driven") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  for (int k = 0; k < 1000; ++k) {
    omni.failBegins(1, hd::kIllegalBegin);
    omni.step(1);
    REQUIRE(omni.driven() == 0.0);
    omni.step(2);
  }
}
