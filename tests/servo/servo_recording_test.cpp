// Recordings: what is written is read to the last bit and reproduces the forces. Torn files and other files are
// reported.
#include "engine/servo/servo_recording.h"

#include <doctest/doctest.h>
#include <unistd.h>
#include <zlib.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <thread>

#include "engine/bench/scenes.h"
#include "engine/device/mouse_device.h"
#include "engine/device/simulated_device.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/servo/device_switch.h"
#include "engine/servo/playback_device.h"
#include "engine/servo/servo_thread.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

std::unique_ptr<Tracker> servoRecordingNewTracker() {
  return methods().front().make(test::makeScene(scenes::cluster(20, 3).spheres), kWaterProbe_A);
}

std::filesystem::path servoRecordingScratch(const char* name) {
  return std::filesystem::temp_directory_path() / ("moltact_recording_" + std::to_string(getpid()) + name);
}

// 20 s of the simulated stylus with settings that change, a plug that is pulled, and a clock that is late now and then.
std::vector<RecordedTick> record(const std::filesystem::path& file) {
  MouseDevice mouse;
  SimulatedDevice stylus;
  DeviceSwitch devices(mouse, &stylus);
  ServoStep step;
  const auto tracker = servoRecordingNewTracker();
  ServoSettings settings;
  auto writer = ServoRecordingWriter::create(file, true);
  REQUIRE(writer);
  CHECK_FALSE(writer->begin({{"molecule", "cluster 20"}, {"method", "exact"}}, step));
  std::vector<RecordedTick> ticks;
  for (int k = 0; k < 20'000; ++k) {
    if (k == 7000) settings.stiffness_N_per_mm = 0.3;
    if (k == 9000) stylus.plug(false);
    if (k == 9100) stylus.plug(true);
    if (k == 15'000) settings.panic = true;
    if (k == 15'100) settings.panic = false;
    const TickTime time{.dt_s = k % 1000 == 999 ? 0.004 : 0.001, .delay_s = 1e-5};
    DevicePose pose = devices.read(kTick_s, step);
    pose.age_s = 1e-6f * float(k % 1000);
    const ServoSample s = step.tick(settings, tracker.get(), pose, time);
    devices.write({s.force});
    ticks.push_back({settings, pose, time, devices.info(), devices.other(), s.force, s.torque_N_mm});
    ticks.back().fallen_back = devices.fallenBack();
    CHECK_FALSE(writer->add(ticks.back()));
  }
  CHECK_FALSE(writer->finish());
  CHECK(writer->kept() == ticks.size());
  return ticks;
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void write(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE(
    "20 000 recorded ticks, unplugged and stopped on the way, come back whole and give the same forces to the last "
    "bit") {
  const auto file = servoRecordingScratch("whole");
  const std::vector<RecordedTick> ticks = record(file);
  const auto recording = readServoRecording(file);
  REQUIRE(recording);
  CHECK(recording->torn.empty());
  CHECK(recording->labels.at("molecule") == "cluster 20");
  REQUIRE(recording->start);
  REQUIRE(recording->ticks.size() == ticks.size());
  double greatest = 0;
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    REQUIRE(std::memcmp(&recording->ticks[k].force, &ticks[k].force, sizeof(ForceN)) == 0);
    REQUIRE(recording->ticks[k].pose.age_s == ticks[k].pose.age_s);
    REQUIRE(recording->ticks[k].pose.orientation == ticks[k].pose.orientation);
    REQUIRE(recording->ticks[k].fallen_back == ticks[k].fallen_back);
    greatest = std::max(greatest, glm::length(ticks[k].force.N));
  }
  CHECK(greatest > 0.8);
  const auto tracker = servoRecordingNewTracker();
  const ReplayResult again = replay(*recording, tracker.get());
  CHECK(again.ticks == ticks.size());
  CHECK_FALSE(again.first_difference);
  // With another scene it says where the forces part.
  const auto other = methods().front().make(test::makeScene(scenes::oneSphere().spheres), kWaterProbe_A);
  CHECK(replay(*recording, other.get()).first_difference);
  CHECK(std::filesystem::file_size(file) < 20'000 * 140);  // 138 bytes with an orientation and a torque
  std::filesystem::remove(file);
}

TEST_CASE("a recording cut at any of 200 places keeps its whole blocks and says after how many seconds it breaks off") {
  const auto file = servoRecordingScratch("cut");
  record(file);
  const std::string whole = bytesOf(file);
  for (int k = 0; k < 200; ++k) {
    const std::size_t size = whole.size() * std::size_t(k) / 200;
    write(file, whole.substr(0, size));
    const auto recording = readServoRecording(file);
    if (!recording) {
      CHECK(size < 2000);
      CHECK_FALSE(recording.problem().remedy.empty());
      continue;
    }
    CHECK(recording->ticks.size() % 256 == 0);
    CHECK((recording->torn.empty() || recording->torn.find("is truncated after ") != std::string::npos));
  }
  std::filesystem::remove(file);
}

TEST_CASE(
    "a recording with any of 200 bytes changed gives what is before the damage, a problem, or the same ticks; and no "
    "crash") {
  const auto file = servoRecordingScratch("damaged");
  record(file);
  const std::string whole = bytesOf(file);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    std::string bytes = whole;
    bytes[whole.size() * std::size_t(k) / 200] ^= char(1 << (k % 8));
    write(file, bytes);
    const auto recording = readServoRecording(file);
    if (recording)
      CHECK_FALSE(recording->torn.empty());
    else
      CHECK_FALSE(recording.problem().message.empty());
  }
  std::filesystem::remove(file);
}

TEST_CASE(
    "3000 recordings with hostile figures and right checksums: each is refused, cut before the figure, or its "
    "forces are finite, its replay differs by a finite force, and the hand that it plays gives finite forces; seed "
    "26") {
  const auto file = servoRecordingScratch("hostile");
  {
    MouseDevice mouse;
    SimulatedDevice stylus;
    DeviceSwitch devices(mouse, &stylus);
    ServoStep step;
    const auto tracker = servoRecordingNewTracker();
    ServoSettings settings;
    auto writer = ServoRecordingWriter::create(file, true);
    REQUIRE(writer);
    CHECK_FALSE(writer->begin({{"molecule", "cluster 20"}, {"method", "exact"}}, step));
    for (int k = 0; k < 300; ++k) {
      if (k == 100) settings.stiffness_N_per_mm = 0.3;
      if (k == 200) stylus.plug(false);
      const TickTime time{.dt_s = 0.001, .delay_s = 1e-5};
      const DevicePose pose = devices.read(kTick_s, step);
      const ServoSample s = step.tick(settings, tracker.get(), pose, time);
      devices.write({s.force});
      CHECK_FALSE(writer->add({settings, pose, time, devices.info(), devices.other(), s.force, s.torque_N_mm}));
    }
    CHECK_FALSE(writer->finish());
  }
  const std::string whole = bytesOf(file);
  const auto numberAt = [&](const std::string& bytes, std::size_t at) {
    std::uint32_t out = 0;
    std::memcpy(&out, bytes.data() + at, 4);
    return std::size_t(out);
  };
  const auto sealed = [](std::string& bytes, std::size_t at, std::size_t from, std::size_t size) {
    const auto crc = std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + from), uInt(size)));
    std::memcpy(bytes.data() + at, &crc, 4);
  };
  // The head, which ends with its checksum; then blocks: magic, ticks, size, checksum, contents.
  const std::size_t state_from = 20 + numberAt(whole, 8) + numberAt(whole, 12), head = state_from + numberAt(whole, 16);
  struct Block {
    std::size_t crc, from, size;
  };
  std::vector<Block> blocks;
  const std::size_t magic = std::string_view("BLK1").size();
  for (std::size_t at = head + 4; at + magic + 12 <= whole.size();) {
    const std::size_t size = numberAt(whole, at + magic + 4);
    blocks.push_back({at + magic + 8, at + magic + 12, size});
    at += magic + 12 + size;
  }
  REQUIRE(blocks.size() == 2);
  REQUIRE(blocks.back().from + blocks.back().size == whole.size());
  const double hostile[] = {std::nan(""), INFINITY, -INFINITY, 1e308, -1e308, 1e-308, -1.0, 1e9, -1e9, 1e30, 0.0};
  const char* const hostile_text[] = {"nan",    "inf", "-inf", "1e308", "-1e308", "-1", "99999999999999999999",
                                      "1e-320", ""};
  scenes::Random random(26);
  int refused = 0, cut = 0, read = 0;
  for (int round = 0; round < 3000; ++round) {
    CAPTURE(round);
    std::string bytes = whole;
    if (round % 6 == 0) {  // a number of the state in which the first tick began
      std::vector<std::size_t> numbers;
      for (std::size_t at = state_from; at < head; ++at)
        if (bytes[at] == '=' || bytes[at] == ' ') numbers.push_back(at + 1);
      REQUIRE(numbers.size() > 20);
      const std::size_t from = numbers[std::size_t(random.uniform(0, double(numbers.size())))];
      const std::size_t to = std::min(bytes.find_first_of(" \n", from), head);
      const std::string text = hostile_text[std::size_t(random.uniform(0, std::size(hostile_text)))];
      bytes.replace(from, to - from, text);
      const auto size = std::uint32_t(numberAt(whole, 16) + text.size() - (to - from));
      std::memcpy(bytes.data() + 16, &size, 4);
      sealed(bytes, state_from + size, 0, state_from + size);
    } else {
      const Block block = blocks[std::size_t(random.uniform(0, 2))];
      const double value = hostile[std::size_t(random.uniform(0, std::size(hostile)))];
      const auto narrow = float(std::clamp(value, -3e38, 3e38));
      const std::size_t bytes_of = round % 3 == 0 ? 4 : 8;
      const std::size_t at = block.from + std::size_t(random.uniform(0, double(block.size - bytes_of)));
      std::memcpy(bytes.data() + at, bytes_of == 4 ? static_cast<const void*>(&narrow) : &value, bytes_of);
      sealed(bytes, block.crc, block.from, block.size);
    }
    write(file, bytes);
    const auto recording = readServoRecording(file);
    if (!recording) {
      ++refused;
      CHECK_FALSE(recording.problem().message.empty());
      continue;
    }
    ++(recording->torn.empty() ? read : cut);
    for (const RecordedTick& t : recording->ticks) {
      REQUIRE(finite(t.force.N));  // a place may be anything, for so may a device's
      REQUIRE(finite(t.torque_N_mm));
      REQUIRE(std::isfinite(t.settings.stiffness_N_per_mm));
    }
    const auto tracker = servoRecordingNewTracker();
    const ReplayResult again = replay(*recording, tracker.get());
    CHECK(std::isfinite(again.max_difference_N));
    CHECK(std::isfinite(again.max_difference_N_mm));
    // Played in the window: the recording leads, and whatever it says, its figures bound the force.
    const double max_N = recording->ticks.empty() ? 0.0 : recording->ticks.front().device.max_force_N;
    PlaybackDevice device(*recording);
    ServoStep step;
    const ServoSettings settings;
    while (!device.ended()) {
      const ServoSample s = step.tick(settings, tracker.get(), device.read(kTick_s), {});
      REQUIRE(finite(s.force.N));
      REQUIRE(glm::length(s.force.N) <= std::max(max_N, 0.0) + 10.0);
    }
  }
  MESSAGE("refused ", refused, ", cut ", cut, ", read ", read);
  CHECK(refused > 100);
  CHECK(cut > 300);
  CHECK(read > 300);
  std::filesystem::remove(file);
}

TEST_CASE("files that are not recordings are reported: an empty file, a text, a folder, a missing file") {
  const auto file = servoRecordingScratch("none");
  for (const std::string& bytes :
       {std::string(), std::string("ATOM      1  N   ALA"), std::string("MOLTRAC2"), std::string(100, '\xff')}) {
    write(file, bytes);
    CHECK_FALSE(readServoRecording(file));
  }
  write(file, "ATOM");
  CHECK(readServoRecording(file).problem().message == "this is no recording of a device");
  write(file, "MOLTRAC1" + std::string(100, '\0'));
  CHECK(readServoRecording(file).problem().message == "this recording is of an earlier version, whose ticks hold less");
  std::filesystem::remove(file);
  CHECK_FALSE(readServoRecording(file));
  CHECK_FALSE(readServoRecording(std::filesystem::temp_directory_path()));
}

TEST_CASE("a recorded hand played back as a device goes the same way and stays at its end") {
  const auto file = servoRecordingScratch("play");
  const std::vector<RecordedTick> ticks = record(file);
  const auto recording = readServoRecording(file);
  REQUIRE(recording);
  PlaybackDevice device(*recording);
  for (const RecordedTick& tick : ticks) REQUIRE(device.read(kTick_s).position.mm == tick.pose.position.mm);
  CHECK(device.read(kTick_s).position.mm == ticks.back().pose.position.mm);
  CHECK(PlaybackDevice(ServoRecording()).read(kTick_s).position.mm == Vec3(0));
  std::filesystem::remove(file);
}

TEST_CASE("what the haptic thread itself records in 1500 ticks of its own clock replays to the last bit") {
  MouseDevice mouse;
  ServoThread servo(mouse);
  servo.setDevice(std::make_unique<SimulatedDevice>());
  servo.record(true);
  servo.loop().setInteraction(servoRecordingNewTracker());
  ServoRecording recording;
  recording.start.emplace();
  while (recording.ticks.size() < 1500) {
    servo.loop().drainRecording(*recording.start, [&](const RecordedTick& tick) { recording.ticks.push_back(tick); });
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(servo.loop().lostOfRecording() == 0);
  const auto tracker = servoRecordingNewTracker();
  CHECK_FALSE(replay(recording, tracker.get()).first_difference);
}

TEST_CASE(
    "a recording that is there stays as it is, unless it may be replaced; then the file holds the new one alone") {
  const auto file = servoRecordingScratch("there");
  write(file, std::string(100'000, 'x'));
  const auto refused = ServoRecordingWriter::create(file);
  REQUIRE_FALSE(refused);
  CHECK(refused.problem().message == "it is already there");
  CHECK(bytesOf(file) == std::string(100'000, 'x'));
  auto writer = ServoRecordingWriter::create(file, true);
  REQUIRE(writer);
  CHECK_FALSE(writer->begin({}, ServoStep()));
  for (int k = 0; k < 300; ++k) CHECK_FALSE(writer->add({}));
  CHECK(writer->kept() == 256);
  CHECK_FALSE(ServoRecordingWriter::create(file, true));  // another one is writing it
  CHECK_FALSE(writer->finish());
  CHECK(writer->kept() == 300);
  const auto recording = readServoRecording(file);
  REQUIRE(recording);
  CHECK(recording->ticks.size() == 300);
  CHECK(recording->torn.empty());
  std::filesystem::remove(file);
  CHECK_FALSE(ServoRecordingWriter::create(file / "no folder"));
}

TEST_CASE("every figure of a device that comes in the middle is in the recording") {
  const auto file = servoRecordingScratch("figures");
  DeviceSpecs figures;
  figures.workspace_mm = Vec3(1, 2, 3);
  figures.dof_in = 4, figures.dof_out = 5;
  figures.max_force_N = 6, figures.continuous_force_N = 7, figures.max_stiffness_N_per_mm = 8,
  figures.max_damping_N_s_per_m = 9;
  figures.damping_N_s_per_m = 10, figures.friction_N = 11, figures.resolution_mm = 12, figures.delay_s = 13;
  figures.speed_limit_m_per_s = 14, figures.slew_limit_N_per_s = 15;
  figures.gives_force = true;
  auto writer = ServoRecordingWriter::create(file, true);
  REQUIRE(writer);
  CHECK_FALSE(writer->begin({}, ServoStep()));
  CHECK_FALSE(writer->add({}));
  RecordedTick tick;
  tick.device = figures;
  tick.other_device = true;
  CHECK_FALSE(writer->add(tick));
  CHECK_FALSE(writer->finish());
  const auto recording = readServoRecording(file);
  REQUIRE(recording);
  REQUIRE(recording->ticks.size() == 2);
  CHECK(recording->ticks[1].device == figures);
  std::filesystem::remove(file);
}

TEST_CASE("a recording of the version before, which knew places alone, is read as it was, but for the state") {
  const auto file = servoRecordingScratch("before");
  auto writer = ServoRecordingWriter::create(file, true);
  REQUIRE(writer);
  CHECK_FALSE(writer->begin({{"method", "exact"}}, ServoStep()));
  RecordedTick tick;
  for (int k = 0; k < 300; ++k) {
    tick.pose.position.mm.x = 0.1 * k;
    CHECK_FALSE(writer->add(tick));
  }
  CHECK_FALSE(writer->finish());
  // Ticks without an orientation and another device are the same in both.
  std::string bytes = bytesOf(file);
  REQUIRE(bytes.starts_with("MOLTRAC7"));
  bytes[7] = '3';
  std::uint32_t head = 20;
  for (std::size_t at = 8; at < 20; at += 4) {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + at, 4);
    head += size;
  }
  const auto crc = std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), head));
  std::memcpy(bytes.data() + head, &crc, 4);
  write(file, bytes);
  const auto recording = readServoRecording(file);
  REQUIRE_MESSAGE(recording, (recording ? "" : recording.problem().text()));
  CHECK(recording->torn.empty());
  CHECK_FALSE(recording->start);
  CHECK(recording->labels.at("method") == "exact");
  REQUIRE(recording->ticks.size() == 300);
  CHECK(recording->ticks[299].pose.position.mm.x == 0.1 * 299);
  CHECK(recording->ticks[299].pose.orientation == kNoRotation);
  std::filesystem::remove(file);
}

TEST_CASE(
    "friction that a slider changes is in the ticks: 4000 ticks of a walk give the same forces to the last bit; "
    "without it they "
    "part") {
  const auto file = servoRecordingScratch("friction");
  const scenes::Scene scene = scenes::cluster(20, 3);
  InteractionInput input{.spheres = test::makeScene(scene.spheres)};
  ServoSettings settings;
  settings.probe_A = scene.probe_A;
  const auto record = [&](bool rough) {
    ServoStep step;
    const auto felt = makeInteraction(input);
    auto writer = ServoRecordingWriter::create(file, true);
    REQUIRE(writer);
    CHECK_FALSE(writer->begin({{"method", "exact"}}, step));
    double force_N = 0.0;
    int k = 0;
    for (const Vec3& place : scenes::walk(scene, 4000, 5)) {
      settings.surface.friction = rough ? Friction{0.1 * (k / 500), k > 2000 ? 0.5 : 0.0} : Friction{};
      RecordedTick tick;
      tick.settings = settings;
      tick.pose.position = settings.workspace.toDevice({place});
      tick.force = step.tick(settings, felt.get(), tick.pose, tick.time).force;
      force_N += glm::length(tick.force.N);
      CHECK_FALSE(writer->add(tick));
      ++k;
    }
    CHECK_FALSE(writer->finish());
    return force_N;
  };
  const double even_N = record(false);
  CHECK(record(true) != doctest::Approx(even_N));
  const auto recording = readServoRecording(file);
  REQUIRE(recording);
  REQUIRE(recording->ticks.size() == 4000);
  CHECK(recording->ticks[3999].settings.surface.friction == Friction{0.1 * 7, 0.5});
  CHECK(touchOf(*recording).friction == 0.0);
  CHECK_FALSE(replay(*recording, makeInteraction(input).get()).first_difference);
  // Without the friction the forces part.
  ServoRecording even = *recording;
  for (RecordedTick& tick : even.ticks) tick.settings.surface.friction = {};
  CHECK(replay(even, makeInteraction(input).get()).first_difference);
  std::filesystem::remove(file);
}

TEST_CASE(
    "every touch setting that needs no rebuild, changed alone, passes through the servo settings and through a "
    "recording "
    "unchanged") {
  const auto file = servoRecordingScratch("live");
  for (const TouchProperty& p : touchProperties()) {
    if (p.requires_rebuild) continue;
    CAPTURE(std::string(p.key));
    TouchSetup touch;
    if (const auto* number = std::get_if<double TouchSetup::*>(&p.member))
      touch.** number = 0.25 * p.in_scenes.min + 0.75 * p.in_scenes.max;
    else if (const auto* flag = std::get_if<bool TouchSetup::*>(&p.member))
      touch.** flag = !(touch.**flag);
    else
      FAIL("a text cannot be followed within a tick");
    REQUIRE_FALSE(touchValue(touch, p) == touchValue(TouchSetup(), p));
    RecordedTick tick;
    tick.settings.take(touch);
    TouchSetup back;
    tick.settings.giveTo(back);
    CHECK(touchValue(back, p) == touchValue(touch, p));
    ServoStep step;
    auto writer = ServoRecordingWriter::create(file, true);
    REQUIRE(writer);
    REQUIRE_FALSE(writer->begin({}, step));
    REQUIRE_FALSE(writer->add(tick));
    REQUIRE_FALSE(writer->finish());
    const auto recording = readServoRecording(file);
    REQUIRE(recording);
    REQUIRE(recording->ticks.size() == 1);
    TouchSetup recorded;
    recording->ticks[0].settings.giveTo(recorded);
    CHECK(touchValue(recorded, p) == touchValue(touch, p));
  }
  std::filesystem::remove(file);
}

TEST_CASE("a full disk is reported in the first tick that it does not take, not at the end") {
  auto writer = ServoRecordingWriter::create("/dev/full", true);
  REQUIRE(writer);
  const auto problem = writer->begin({}, ServoStep());
  REQUIRE(problem);
  CHECK(problem->text() == "/dev/full: the disk is full; free some space on it");
  for (int k = 1; k < 256; ++k) CHECK_FALSE(writer->add({}));
  CHECK(writer->add({}));
  CHECK(writer->finish());
  CHECK(writer->kept() == 0);
}
