// The open layout: docs/device-protocol.md, the reference firmware and the driver must agree.
#include "engine/device/hid/open_layout.h"

#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>
#include <vector>

#include "engine/device/mouse_device.h"
#include "engine/device/packet/packet_device.h"
#include "engine/device/packet/report_bytes.h"
#include "engine/servo/plain_trackers.h"
#include "engine/servo/servo_thread.h"
#include "tests/device/open_firmware.h"

using namespace moltact;
using namespace moltact::open_layout;

namespace {

using OpenLayoutReport = std::vector<std::uint8_t>;
OpenLayoutReport of(const auto& bytes) { return {bytes.begin(), bytes.end()}; }

// A device that answers the feature report, sends places when asked, and keeps the last report that it was written.
struct FarEnd {
  std::mutex mutex;
  test::OpenFirmware firmware;
  OpenLayoutReport feature = of(firmware.description()), last;
  bool sends = false;
};
class FarEndPort final : public PacketPort {
 public:
  explicit FarEndPort(FarEnd& end) : end_(end) {}
  int read(std::span<std::uint8_t> report, int wait_ms) override {
    if (wait_ms == 0) return 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(end_.mutex);
    if (!end_.sends) return 0;
    const auto place = end_.firmware.tick({1, 2, 3});
    std::copy(place.begin(), place.end(), report.begin());
    return int(place.size());
  }
  bool write(std::span<const std::uint8_t> report) override {
    const std::lock_guard lock(end_.mutex);
    end_.firmware.take(report);
    end_.last = of(report);
    return true;
  }
  int feature(std::span<std::uint8_t> report) override {
    std::copy(end_.feature.begin(), end_.feature.end(), report.begin());
    return int(end_.feature.size());
  }

 private:
  FarEnd& end_;
};

// What the driver makes of the reference description with some of its numbers changed: byte, number.
std::optional<Problem> begun(const std::map<std::size_t, int>& changed, DeviceInfo& info) {
  FarEnd end;
  for (const auto& [at, value] : changed) putInt16(end.feature, at, value);
  FarEndPort port(end);
  return OpenLayoutProtocol().begin(port, info);
}
OpenLayoutProtocol openedLayout() {
  FarEnd end;
  FarEndPort port(end);
  OpenLayoutProtocol open;
  DeviceInfo info;
  REQUIRE_FALSE(open.begin(port, info));
  return open;
}

// A report descriptor read item by item, as HID 1.11 has them.
struct Declared {
  unsigned page = 0, usage = 0;
  std::map<std::pair<char, unsigned>, unsigned> bytes;  // of input, output and feature reports by id, behind the id
};
Declared parsed(const OpenLayoutReport& descriptor) {
  Declared out;
  unsigned size_bits = 0, count = 0, id = 0;
  bool collected = false;
  for (std::size_t at = 0; at < descriptor.size();) {
    const unsigned item = descriptor[at] & 0xFC;
    std::size_t length = descriptor[at] & 3;
    if (length == 3) length = 4;
    REQUIRE(at + length < descriptor.size() + (item == 0xC0));
    unsigned value = 0;
    for (std::size_t k = 0; k < length; ++k) value |= unsigned(descriptor[at + 1 + k]) << (8 * k);
    at += 1 + length;
    if (item == 0x04 && !collected) out.page = value;
    if (item == 0x08 && !collected) out.usage = value;
    if (item == 0xA0) collected = true;
    if (item == 0x74) size_bits = value;
    if (item == 0x84) id = value;
    if (item == 0x94) count = value;
    if (item == 0x80 || item == 0x90 || item == 0xB0)
      out.bytes[{item == 0x80 ? 'I' : item == 0x90 ? 'O' : 'F', id}] += size_bits * count / 8;
  }
  return out;
}

// The hexadecimal bytes that begin the indented lines after "The report descriptor".
OpenLayoutReport descriptorInDocs() {
  std::ifstream in(MOLTACT_SOURCE_DIR "/docs/device-protocol.md");
  std::string line;
  while (std::getline(in, line) && !line.starts_with("The report descriptor")) {
  }
  OpenLayoutReport out;
  while (std::getline(in, line) && !line.starts_with("|")) {
    if (!line.starts_with("    ")) continue;
    std::istringstream words(line);
    for (std::string word;
         words >> word && word.size() == 2 && word.find_first_not_of("0123456789ABCDEF") == std::string::npos;)
      out.push_back(std::uint8_t(std::stoi(word, nullptr, 16)));
  }
  return out;
}

template <class Done>
void waitFor(Done done) {
  for (int k = 0; k < 5000 && !done(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace

TEST_CASE(
    "the descriptor in docs/device-protocol.md is the reference firmware's 39 bytes, and declares the driver's usage, "
    "ids and lengths") {
  const OpenLayoutReport reference(std::begin(test::kOpenReportDescriptor), std::end(test::kOpenReportDescriptor));
  CHECK(reference.size() == 39);
  CHECK(descriptorInDocs() == reference);
  const Declared declared = parsed(reference);
  CHECK(declared.page == kUsagePage);
  CHECK(declared.usage == kUsage);
  CHECK(declared.bytes == std::map<std::pair<char, unsigned>, unsigned>{{{'I', kPlaceReport}, kPlaceBytes - 1},
                                                                        {{'O', kForceReport}, kForceBytes - 1},
                                                                        {{'F', kDescription}, kDescriptionBytes - 1}});
}

TEST_CASE(
    "a description with which nothing could be felt, or that places cannot reach, is refused in words that name the "
    "field") {
  DeviceInfo info;
  const auto words = [&](const std::map<std::size_t, int>& changed) {
    const auto problem = begun(changed, info);
    REQUIRE(problem);
    CHECK_FALSE(problem->remedy.empty());
    return problem->text();
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  CHECK(has(words({{6, 0}}), "unit (byte 6) is 0"));
  CHECK(has(words({{10, 0}}), "greatest force for good (byte 10) is 0"));
  CHECK(has(words({{12, 0}}), "room along x (byte 12) is 0"));
  CHECK(has(words({{14, 0}}), "room along y (byte 14) is 0"));
  CHECK(has(words({{16, 0}}), "room along z (byte 16) is 0"));
  CHECK(has(words({{8, 40'000}}), "greatest force (byte 8) is 40000 mN"));
  // 32767 steps of 1 um are 32.8 mm; 200 mm are needed from the middle, 200e6 nm / 32767 = 6103.7 nm.
  const std::string far = words({{6, 1000}, {12, 400}});
  CHECK(has(far, "steps of 1000 nm (byte 6) reach 32.8\u00a0mm"));
  CHECK(has(far, "room of 400 mm"));
  CHECK(has(far, "at least 6104 nm"));
  CHECK_FALSE(begun({{6, 6104}, {12, 400}}, info));
}

TEST_CASE(
    "0 for what is not known counts on the careful side: 0.3 N/mm, 2 ms; friction stays 0 for the safety stage; "
    "without any force all is well") {
  DeviceInfo info;
  CHECK_FALSE(begun({{18, 0}, {20, 0}, {22, 0}, {24, 0}, {26, 0}}, info));
  CHECK(info.max_stiffness_N_per_mm == 0.3);
  CHECK(info.delay_s == 0.002);
  CHECK(info.friction_N == 0.0);
  CHECK(info.damping_N_s_per_m == 0.0);
  CHECK(info.max_damping_N_s_per_m == 0.0);
  CHECK(info.gives_force);
  CHECK_FALSE(begun({{8, 0}, {10, 0}}, info));
  CHECK_FALSE(info.gives_force);
}

TEST_CASE(
    "the motors are on with force and without; off when stopped, with a force that is no number, and "
    "while fault, calibration or watchdog are reported") {
  OpenLayoutProtocol open = openedLayout();
  test::OpenFirmware firmware;
  DevicePose pose;
  std::array<std::uint8_t, 64> out{};
  const auto on = [&] { return open.encode({.force = {Vec3(1, 0, 0)}}, out), out[9] == 1 && int16At(out, 3) == 1000; };
  const auto off = [&] { return open.encode({.force = {Vec3(1, 0, 0)}}, out), out[9] == 0 && int16At(out, 3) == 0; };
  CHECK(open.encode({}, out) == kForceBytes);
  CHECK(out[9] == 1);
  CHECK(on());
  CHECK(open.encodeStop(out) == kForceBytes);
  CHECK((out[9] == 0 && int16At(out, 3) == 0));
  open.encode({.force = {Vec3(std::nan(""), 0, 0)}}, out);
  CHECK(out[9] == 0);
  for (bool* state : {&firmware.fault, &firmware.calibrated}) {
    *state = !*state;
    open.parseReport(of(firmware.tick({})), pose);
    CHECK(pose.fault);
    CHECK(off());
    *state = !*state;
    open.parseReport(of(firmware.tick({})), pose);
    CHECK_FALSE(pose.fault);
    CHECK(on());
  }
  firmware.take({out.data(), kForceBytes});
  for (int k = 0; k < 51; ++k) open.parseReport(of(firmware.tick({})), pose);
  CHECK(pose.fault);
  CHECK(off());
}

TEST_CASE("the quaternion turns the hand where the description says that it is measured, and only as a rotation") {
  FarEnd end;
  putInt16(end.feature, 28, kMeasuresOrientation);
  FarEndPort port(end);
  OpenLayoutProtocol open;
  DeviceInfo info;
  REQUIRE_FALSE(open.begin(port, info));
  CHECK(info.dof_in == 6);
  DevicePose pose;
  OpenLayoutReport place(kPlaceBytes);
  place[0] = kPlaceReport;
  const auto turned = [&](std::uint8_t number, double x, double y, double z, double w) {
    place[1] = number;
    const double parts[] = {x, y, z, w};
    for (std::size_t k = 0; k < 4; ++k) putInt16(place, 13 + 2 * k, int(std::lround(32767 * parts[k])));
    CHECK(open.parseReport(place, pose));
  };
  const double half = std::sqrt(0.5);
  turned(1, 0, half, 0, half);  // a quarter turn about y: x becomes -z
  CHECK(glm::distance(pose.orientation * Vec3(1, 0, 0), Vec3(0, 0, -1)) < 1e-4);
  CHECK(rotates(pose.orientation));
  turned(2, 0, 0, 0, 0);
  turned(3, 0, 0.5, 0, 0.5);
  CHECK(glm::distance(pose.orientation * Vec3(1, 0, 0), Vec3(0, 0, -1)) < 1e-4);

  OpenLayoutProtocol silent = openedLayout();
  DevicePose upright;
  turned(4, 0, half, 0, half);
  CHECK(silent.parseReport(place, upright));
  CHECK(upright.orientation == kNoRotation);
}

TEST_CASE(
    "a cut by the device's watchdog is reported for 20 ms even when the next places come at once, "
    "and then no more") {
  OpenLayoutProtocol open = openedLayout();
  DevicePose pose;
  OpenLayoutReport place(kPlaceBytes);
  place[0] = kPlaceReport, place[22] = kWatchdogTripped;
  open.parseReport(place, pose);
  place[22] = 0;
  for (std::uint8_t k = 1; k < 64; ++k) place[1] = k, open.parseReport(place, pose);
  open.advance(0.05, pose);  // the thread had stood
  CHECK(pose.fault);
  for (int k = 0; k < 18; ++k) open.advance(0.001, pose);
  CHECK(pose.fault);
  for (int k = 0; k < 3; ++k) open.advance(0.001, pose);
  CHECK_FALSE(pose.fault);
}

TEST_CASE(
    "60 ms of lost force reports while places continue: the firmware cuts, and afterwards the force of 0.8 N comes "
    "back "
    "within half a second, not at once") {
  OpenLayoutProtocol open = openedLayout();
  test::OpenFirmware firmware;
  DeviceInfo info;
  begun({}, info);
  ServoStep step(info);
  ServoSettings settings;
  settings.workspace.A_per_mm = 1.0;
  ConstantForceTracker pull(1.6);
  DevicePose pose;
  std::array<std::uint8_t, 64> out{};
  const auto tick = [&](bool arrives) {
    pose.fresh = open.parseReport(of(firmware.tick({})), pose);
    open.advance(0.001, pose);
    const ForceN force = step.tick(settings, &pull, pose).force;
    const std::size_t length = open.encode({.force = force}, out);
    if (arrives) firmware.take({out.data(), length});
    return glm::length(firmware.force_N());
  };
  double full = 0;
  for (int k = 0; k < 1000; ++k) full = tick(true);
  REQUIRE(full > 0.7);
  for (int k = 0; k < 60; ++k) tick(false);
  CHECK(firmware.force_N() == Vec3(0));
  for (int k = 1; k <= 500; ++k) {
    const double now = tick(true);
    REQUIRE(now <= full * k / 500 + 0.002);
  }
  for (int k = 0; k < 100; ++k) tick(true);
  CHECK(glm::length(firmware.force_N()) == doctest::Approx(full).epsilon(0.01));
}

TEST_CASE(
    "in the haptic thread: motors on while it leads, off by the panic key, on again after it, and off in the last "
    "report") {
  FarEnd end;
  end.sends = true;
  MouseDevice mouse;
  ServoThread servo(mouse);
  const auto opener = [&](const PacketDevice::Accept& accept) -> Expected<std::unique_ptr<PacketPort>> {
    std::unique_ptr<PacketPort> port = std::make_unique<FarEndPort>(end);
    if (const auto problem = accept(*port)) return *problem;
    return port;
  };
  auto device = PacketDevice::open(opener, std::make_unique<OpenLayoutProtocol>(), {});
  REQUIRE(device);
  servo.setDevice(std::move(*device));
  const auto motors = [&] {
    const std::lock_guard lock(end.mutex);
    return end.last.size() == kForceBytes ? int(end.last[9]) : -1;
  };
  waitFor([&] { return motors() == 1; });
  CHECK(motors() == 1);
  ServoSettings settings;
  settings.panic = true;
  servo.loop().setSettings(settings);
  waitFor([&] { return motors() == 0; });
  CHECK(motors() == 0);
  settings.panic = false;
  servo.loop().setSettings(settings);
  waitFor([&] { return motors() == 1; });
  CHECK(motors() == 1);
  servo.setDevice(nullptr);
  CHECK(motors() == 0);
}

TEST_CASE(
    "the reference firmware: a place beyond 16 bits stays at their end, 163.8 mm, and does not come back from the "
    "other side") {
  OpenLayoutProtocol open = openedLayout();
  test::OpenFirmware firmware;
  DevicePose pose;
  open.parseReport(of(firmware.tick({200, -200, 0})), pose);
  CHECK(pose.position.mm.x == doctest::Approx(163.835));
  CHECK(pose.position.mm.y == doctest::Approx(-163.835));
}

TEST_CASE("the reference firmware ignores a force report of 10 or 12 bytes or of another id") {
  test::OpenFirmware firmware;
  OpenLayoutReport force(kForceBytes);
  force[0] = kForceReport, force[9] = 1;
  putInt16(force, 3, 1000);
  for (OpenLayoutReport wrong : {OpenLayoutReport(force.begin(), force.end() - 1), force, force}) {
    if (wrong.size() == kForceBytes) wrong[0] = 1;
    firmware.take(wrong);
    CHECK(firmware.force_N() == Vec3(0));
  }
  OpenLayoutReport longer = force;
  longer.push_back(0);
  firmware.take(longer);
  CHECK(firmware.force_N() == Vec3(0));
  firmware.take(force);
  CHECK(firmware.force_N().x == 1.0);
}

TEST_CASE(
    "the reference firmware cuts the motors 50 ms after the last force report though it can send no place, also while "
    "its clock runs over") {
  for (const std::uint32_t begin_us : {0u, 0xFFFFFFFFu - 20'000u}) {
    test::ReferenceFirmware firmware;
    const std::uint8_t force[11] = {2, 1, 0, 0xE8, 3, 0, 0, 0, 0, 1, 50};
    firmware.take(force, sizeof force, begin_us);
    CHECK(firmware.motors(begin_us + 50'000u)[0] == 1.0);
    CHECK(firmware.motors(begin_us + 50'001u)[0] == 0.0);
    CHECK((firmware.report({}, 0, begin_us + 60'000u)[22] & kWatchdogTripped) != 0);
  }
}
