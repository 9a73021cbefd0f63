// Parsing of reports from SpaceMouse and game pads.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "engine/device/hid/play_station.h"
#include "engine/device/hid/space_mouse.h"

using namespace moltact;

namespace {

using Report = std::vector<std::uint8_t>;

}  // namespace

TEST_CASE(
    "SpaceMouse: two reports of 7 bytes and one of 13 mean the same axes; x right, up against z, toward the person y") {
  // Half a push to the right (175), none away, a full one up (-350); turned by a quarter round y.
  const Report push{1, 175, 0, 0, 0, 0xA2, 0xFE}, turn{2, 0, 0, 0, 0, 87, 0},
      both{1, 175, 0, 0, 0, 0xA2, 0xFE, 0, 0, 0, 0, 87, 0};
  SpaceMouseProtocol old, newer;
  DevicePose pose;
  CHECK(old.parseReport(push, pose));
  CHECK(old.parseReport(turn, pose));
  CHECK(newer.parseReport(both, pose));
  for (const SpaceMouseProtocol* one : {&old, &newer}) {
    CHECK(one->axes().push.x == doctest::Approx(0.5));
    CHECK(one->axes().push.y == doctest::Approx(1.0));
    CHECK(one->axes().push.z == 0.0);
    CHECK(one->axes().rotation.y == doctest::Approx(-87.0 / 350));
  }
  CHECK(old.parseReport(Report{3, 0x05, 0x01}, pose));
  CHECK(pose.buttons == 0x0104u);  // the first switches between hand and view
}

TEST_CASE(
    "SpaceMouse: a full push moves the hand by 60 mm a second, a breath of one not at all, and 80 mm is the end of the "
    "way") {
  SpaceMouseProtocol mouse;
  DevicePose pose;
  mouse.parseReport(Report{1, 0x5E, 0x01, 0, 0, 0, 0}, pose);
  for (int k = 0; k < 100; ++k) mouse.advance(0.002, pose);
  CHECK(pose.position.mm.x == doctest::Approx(12.0));
  for (int k = 0; k < 2000; ++k) {
    mouse.parseReport(Report{1, 0x5E, 0x01, 0, 0, 0, 0}, pose);
    mouse.advance(0.002, pose);
  }
  CHECK(pose.position.mm.x == 80.0);
  mouse.parseReport(Report{1, 0xEF, 0xFF, 0, 0, 0, 0}, pose);  // -17 of 350
  mouse.advance(0.1, pose);
  CHECK(pose.position.mm.x == 80.0);
}

TEST_CASE(
    "SpaceMouse: a turn that is stronger than the push turns the view and leaves the hand; the first button gives the "
    "push to the view, too") {
  SpaceMouseProtocol mouse;
  DevicePose pose;
  // Pushed right by 100 of 350, turned round the axis that points down by -350: seen from above to the left.
  const Report both{1, 100, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xA2, 0xFE}, push{1, 0x5E, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  mouse.parseReport(both, pose);
  mouse.advance(0.01, pose);
  CHECK(pose.position.mm == Vec3(0));
  CHECK(mouse.viewMotion().rotation.y == doctest::Approx(1.0));
  CHECK(mouse.viewMotion().move == Vec3(0));
  mouse.parseReport(push, pose);
  mouse.advance(0.01, pose);
  CHECK(pose.position.mm.x == doctest::Approx(0.6));
  CHECK(mouse.viewMotion().rotation == Vec3(0));
  mouse.parseReport(Report{3, 1}, pose);
  mouse.parseReport(Report{3, 0}, pose);
  CHECK(pose.buttons == 0);
  mouse.advance(0.01, pose);
  CHECK(pose.position.mm.x == doctest::Approx(0.6));
  CHECK(mouse.viewMotion().move.x == doctest::Approx(1.0));
  mouse.parseReport(Report{3, 1}, pose);
  mouse.advance(0.01, pose);
  CHECK(pose.position.mm.x == doctest::Approx(1.2));
  CHECK(mouse.viewMotion().move == Vec3(0));
}

TEST_CASE(
    "SpaceMouse and pad: where a body is felt a full turn turns it by 1.5 rad a second and leaves the view; back again "
    "the view turns") {
  SpaceMouseProtocol mouse;
  PlayStationProtocol pad;
  DevicePose held, padded;
  Report stick(64);
  stick[0] = 1, stick[1] = stick[2] = 128, stick[3] = 255, stick[4] = 128,
  stick[5] = 8;  // the right stick to the right
  mouse.rotateHand(true);
  pad.rotateHand(true);
  for (int k = 0; k < 100; ++k) {
    mouse.parseReport(Report{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xA2, 0xFE}, held);
    mouse.advance(0.01, held);
    pad.parseReport(stick, padded);
    pad.advance(0.01, padded);
  }
  for (const DevicePose* one : {&held, &padded}) {
    CHECK(rotationBetween(kNoRotation, one->orientation).y == doctest::Approx(1.5).epsilon(0.02));
    CHECK(one->position.mm == Vec3(0));
  }
  CHECK(mouse.viewMotion().rotation == Vec3(0));
  CHECK(pad.viewMotion().rotation == Vec3(0));
  mouse.rotateHand(false);
  mouse.advance(0.01, held);
  CHECK(mouse.viewMotion().rotation.y > 0.9);
}

TEST_CASE(
    "DualShock 4: left stick right and up, right trigger in, right stick the view; sticks that rest beside their "
    "middle move nothing") {
  PlayStationProtocol pad;
  DevicePose pose;
  Report report(64);
  report[0] = 1, report[1] = 120, report[2] = 133, report[3] = 128, report[4] = 128, report[5] = 8;
  CHECK(pad.parseReport(report, pose));
  for (int k = 0; k < 100; ++k) pad.advance(0.01, pose), pad.parseReport(report, pose);
  CHECK(pose.position.mm == Vec3(0));
  CHECK(pose.buttons == 0);
  report[1] = 255, report[2] = 128, report[5] = 0x20 | 8;  // right, with the cross
  pad.parseReport(report, pose);
  pad.advance(0.1, pose);
  CHECK(pose.position.mm.x == doctest::Approx(6.0));
  CHECK(pose.buttons == 1);
  report[1] = 128, report[2] = 0, report[5] = 0x40 | 8;  // up, with the circle
  pad.parseReport(report, pose);
  pad.advance(0.1, pose);
  CHECK(pose.position.mm.y == doctest::Approx(6.0));
  CHECK(pose.buttons == 2);
  report[2] = 128, report[9] = 255, report[3] = 255;
  pad.parseReport(report, pose);
  pad.advance(0.1, pose);
  CHECK(pose.position.mm.z == doctest::Approx(-6.0));
  CHECK(pad.viewMotion().rotation.y == doctest::Approx(1.0));
  pad.advance(0.3, pose);  // the report of letting go was lost
  pad.advance(0.1, pose);
  CHECK(pose.position.mm.z > -30.0);
  CHECK(pad.viewMotion().rotation == Vec3(0));
  CHECK_FALSE(pad.parseReport(Report(63), pose));
}

TEST_CASE(
    "DualSense: triggers, buttons and motors stand elsewhere by USB, by Bluetooth where the DualShock 4 has them") {
  PlayStationProtocol pad(kDualSense);
  DevicePose pose;
  Report usb(64), bluetooth(10);
  for (Report* one : {&usb, &bluetooth}) (*one)[0] = 1, (*one)[1] = (*one)[2] = (*one)[3] = (*one)[4] = 128;
  usb[6] = 255, usb[8] = 0x20 | 8;  // right trigger, cross
  CHECK(pad.parseReport(usb, pose));
  pad.advance(0.1, pose);
  CHECK(pose.position.mm.z == doctest::Approx(-6.0));
  CHECK(pose.buttons == 1);
  std::array<std::uint8_t, 64> out{};
  CHECK(pad.encode({.force = {Vec3(0, 3.3, 0)}}, out) == 48);
  CHECK((out[0] == 2 && out[1] == 3 && out[2] == 0 && out[3] == 255 && out[4] == 255));
  bluetooth[8] = 255, bluetooth[5] = 0x40 | 8;  // left trigger, circle
  CHECK(pad.parseReport(bluetooth, pose));
  pad.advance(0.1, pose);
  CHECK(pose.position.mm.z == doctest::Approx(0.0));
  CHECK(pose.buttons == 2);
  CHECK(pad.encode({.force = {Vec3(0.1, 0, 0)}}, out) == 0);
}

TEST_CASE(
    "DualShock 4: it rumbles by the force over USB, a report where the strength changes; at 3.3 N both motors fully, "
    "at none not, over Bluetooth never") {
  PlayStationProtocol pad;
  DevicePose pose;
  std::array<std::uint8_t, 64> out{};
  Report usb(64), bluetooth(10);
  usb[0] = bluetooth[0] = 1;
  pad.parseReport(bluetooth, pose);
  CHECK(pad.encode({.force = {Vec3(3.3, 0, 0)}}, out) == 0);
  pad.parseReport(usb, pose);
  CHECK(pad.encode({.force = {Vec3(0, 3.3, 0)}}, out) == 32);
  CHECK((out[0] == 5 && out[1] == 1 && out[4] == 255 && out[5] == 255));
  CHECK(pad.encode({.force = {Vec3(0, 0, 3.3)}}, out) == 0);
  CHECK(pad.encode({.force = {Vec3(0.5, 0, 0)}}, out) == 32);
  CHECK((out[4] > 0 && out[4] < 80 && out[5] == 0));
  CHECK(pad.encode({.force = {Vec3(std::nan(""), 0, 0)}}, out) == 32);
  CHECK((out[4] == 0 && out[5] == 0));
}

TEST_CASE("SpaceMouse: when the report of letting go is lost the hand stands after a quarter of a second") {
  SpaceMouseProtocol mouse;
  DevicePose pose;
  mouse.parseReport(Report{1, 0x5E, 0x01, 0, 0, 0, 0}, pose);
  for (int k = 0; k < 1000; ++k) mouse.advance(0.002, pose);
  CHECK(pose.position.mm.x < 60 * 0.26);
}
