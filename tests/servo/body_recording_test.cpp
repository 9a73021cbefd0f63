// Recordings of a body in the hand: its pose, torque and rest, and the labels that restore it.
#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>

#include "engine/haptics/interactions.h"
#include "engine/servo/servo_recording.h"
#include "engine/servo/servo_step.h"

using namespace moltact;

namespace {

std::filesystem::path scratch(const char* name) {
  return std::filesystem::temp_directory_path() / ("moltact_body_recording_" + std::to_string(getpid()) + name);
}

}  // namespace

TEST_CASE(
    "a rigid body's recording stores its pose and torque, and its labels restore the body: the "
    "replay gives both to the last bit, and reports a torque that differs") {
  const std::vector<Sphere> spheres{{{0, 0, 0}, 3.0}, {{10, 0, 0}, 1.6}, {{12, 0, 0}, 1.6}, {{12, 2, 0}, 1.6}};
  const std::vector<std::uint32_t> held{1, 2, 3};
  const auto scene = std::make_shared<const SphereGrid>(spheres, held);
  const auto body = heldBody(spheres, held);
  const TouchSetup touch = resolveInteraction({}, true);
  const auto felt = makeInteraction({.spheres = scene, .touch = touch, .body = body});
  DeviceSpecs device = shownForceFigures();
  device.dof_in = device.dof_out = 6;
  device.gives_force = true;
  device.max_torque_N_mm = 400.0;
  ServoStep step(device);
  const auto file = scratch("body");
  auto writer = ServoRecordingWriter::create(file, true);
  REQUIRE(writer);
  auto labels = sceneLabels(*scene, body.get());
  labels.merge(touchLabels(touch));
  CHECK_FALSE(writer->begin(labels, step));
  ServoSettings settings;
  double most_N_mm = 0.0;
  Vec3 last(0.0);
  for (int k = 0; k < 3000; ++k) {
    DevicePose pose{.position = {Vec3(std::max(14.0, 40.0 - 0.02 * k), 0, 0)},
                    .orientation = glm::angleAxis(2e-4 * k, glm::normalize(Vec3(1, 2, 3)))};
    const ServoSample s = step.tick(settings, felt.get(), pose);
    most_N_mm = std::max(most_N_mm, glm::length(s.torque_N_mm));
    last = s.torque_N_mm;
    CHECK_FALSE(writer->add({settings, pose, {}, device, k == 0, s.force, s.torque_N_mm, s.body_pose, s.at_rest}));
  }
  CHECK_FALSE(writer->finish());
  CHECK(most_N_mm > 0.5);
  Expected<ServoRecording> read = readServoRecording(file);
  REQUIRE(read);
  CHECK(read->labels.at("held") == "1-3");
  CHECK(read->labels.at("untouchable") == "1-3");
  CHECK(read->ticks.back().torque_N_mm == last);
  const RecordedScene again = recordedScene(read->labels, spheres);
  REQUIRE(again.body);
  CHECK(again.body->atoms == held);
  CHECK(fingerprint(*again.spheres) == fingerprint(*scene));
  const auto replayed = [&] {
    return replay(*read,
                  makeInteraction({.spheres = again.spheres, .touch = touchOf(*read), .body = again.body}).get());
  };
  CHECK_FALSE(replayed().first_difference);
  read->ticks[2500].torque_N_mm.x += 0.25;
  CHECK(replayed().first_difference == 2500);
  CHECK(replayed().max_difference_N == 0.0);
  CHECK(replayed().max_difference_N_mm == doctest::Approx(0.25));
  read->torques = false;  // as of a file of the version before
  CHECK_FALSE(replayed().first_difference);
  std::filesystem::remove(file);
}

namespace {

// A body that rests apart from the hand: 0.25 A above it, turned half as far, and not found yet in every tenth tick.
class RestingApart final : public Interaction {
 public:
  Response respond(const PoseA& hand) noexcept override {
    Response out;
    out.body_pose = PoseA{{hand.place.A + Vec3(0, 0.25, 0)}, glm::slerp(kNoRotation, hand.orientation, 0.5)};
    out.at_rest = ++asked_ % 10 != 0;
    return out;
  }
  void reset() noexcept override {}
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  MemoryUsage memoryUsage() const noexcept override { return {}; }
  bool hasOrientation() const noexcept override { return true; }

 private:
  int asked_ = 0;
};

}  // namespace

TEST_CASE(
    "a recording keeps the pose in which a body rests and whether it was found, and a replay tells a pose that "
    "differs; a "
    "file of the version before has neither") {
  const auto file = scratch("resting");
  RestingApart felt;
  const ServoStep start;
  ServoStep step = start;
  auto writer = ServoRecordingWriter::create(file, true);
  REQUIRE(writer);
  CHECK_FALSE(writer->begin({}, start));
  const ServoSettings settings;
  std::vector<ServoSample> samples;
  for (int k = 0; k < 300; ++k) {
    const DevicePose pose{.position = {Vec3(0.1 * k, 0, 0)}, .orientation = glm::angleAxis(0.01 * k, Vec3(0, 0, 1))};
    samples.push_back(step.tick(settings, &felt, pose));
    const ServoSample& s = samples.back();
    CHECK(s.holds_body);
    CHECK_FALSE(
        writer->add({settings, pose, {}, shownForceFigures(), k == 0, s.force, s.torque_N_mm, s.body_pose, s.at_rest}));
  }
  CHECK_FALSE(writer->finish());
  Expected<ServoRecording> read = readServoRecording(file);
  REQUIRE(read);
  REQUIRE(read->ticks.size() == 300);
  std::size_t unrested = 0;
  for (std::size_t k = 0; k < 300; ++k) {
    REQUIRE(read->ticks[k].body_pose);
    CHECK(read->ticks[k].body_pose->place == samples[k].body_pose->place);
    CHECK(read->ticks[k].body_pose->orientation == samples[k].body_pose->orientation);
    CHECK(read->ticks[k].at_rest == samples[k].at_rest);
    unrested += !read->ticks[k].at_rest;
  }
  CHECK(unrested == 30);
  RestingApart again;
  CHECK_FALSE(replay(*read, &again).first_difference);
  read->ticks[200].body_pose->place.A.z += 0.5;
  CHECK(replay(*read, &again).first_difference == 200);
  CHECK(replay(*read, &again).max_difference_A == doctest::Approx(0.5));
  read->body_poses = false;
  CHECK_FALSE(replay(*read, &again).first_difference);
  std::filesystem::remove(file);
}

TEST_CASE("labels that list spheres which there are not, or are no list, name none") {
  const std::vector<Sphere> spheres(9, Sphere{{0, 0, 0}, 1.0});
  for (const char* text : {"9", "0-9", "3-2", "2,2", "1-", "x", "1,,2", "-1", "4294967296", "1 2"}) {
    CAPTURE(text);
    const RecordedScene scene = recordedScene({{"held", text}, {"untouchable", text}}, spheres);
    CHECK_FALSE(scene.body);
    CHECK_FALSE(scene.spheres->hasUntouchable());
  }
  CHECK(recordedScene({{"held", "0,2-4,8"}}, spheres).body->atoms == std::vector<std::uint32_t>{0, 2, 3, 4, 8});
}
