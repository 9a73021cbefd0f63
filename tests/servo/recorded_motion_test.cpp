// Recordings of a hand on spheres that move. Oracle: the forces of the recorded run itself, to the last bit.
#include "engine/servo/recorded_motion.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <random>

#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"
#include "engine/servo/servo_recording.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

std::filesystem::path motionScratch(const char* name) {
  return std::filesystem::temp_directory_path() / ("moltact_recorded_motion_" + std::to_string(getpid()) + name);
}

// Every sphere displaced by at most 0.3 A along each axis and grown by at most 0.05 A.
std::vector<Sphere> shaken(std::span<const Sphere> spheres, std::mt19937& random) {
  std::uniform_real_distribution<double> step(-0.3, 0.3);
  std::vector<Sphere> out(spheres.begin(), spheres.end());
  for (Sphere& s : out) {
    s.centre_A += Vec3(step(random), step(random), step(random));
    s.radius_A += 0.05 * std::abs(step(random));
  }
  return out;
}

}  // namespace

TEST_CASE(
    "a hand on spheres that move is replayed to the last bit: at rest, in eight motions of which each continues the "
    "one "
    "before, in one that begins elsewhere, and at rest again after its end; without the motions the forces differ") {
  const auto scene = test::makeScene(scenes::cluster(20, 3).spheres);
  const auto file = motionScratch("walk");
  const auto tracker = methods().front().make(scene, kWaterProbe_A);
  ServoStep step;
  auto writer = ServoRecordingWriter::create(file, true);
  REQUIRE(writer);
  CHECK_FALSE(writer->begin({}, step));
  std::mt19937 random(20261127);
  std::unique_ptr<const SphereMotion> now, before;
  std::uint32_t number = 0;
  std::int32_t motion_tick = 0;
  int touching = 0, moving = 0;
  const ServoSettings settings;
  for (int k = 0; k < 3000; ++k) {
    const bool begins = k >= 500 && k < 500 + 9 * 100 && k % 100 == 0;
    if (begins) {
      const bool elsewhere = number == 8;
      const std::vector<Sphere> from = now ? now->at(1.0) : scene->spheres().copy();
      auto made = now && !elsewhere ? SphereMotion::after(*now, shaken(from, random), 60)
                                    : SphereMotion::make(shaken(from, random), shaken(from, random), 90);
      REQUIRE(made);
      before = std::exchange(now, *std::move(made));
      const bool continues = before && now->continues(*before);
      CHECK(continues == (number > 0 && !elsewhere));
      const RecordedMotion recorded = recordedMotion(*now, before.get());
      CHECK(recorded.from.empty() == continues);
      CHECK_FALSE(writer->addMotion(recorded));
      ++number;
      motion_tick = 0;
    }
    MotionPhase phase;
    if (now) {
      motion_tick = std::min(motion_tick + 1, now->ticks());
      phase = {now.get(), double(motion_tick) / now->ticks()};
    }
    const double turn = 0.002 * k;
    const DevicePose pose{
        .position = {Vec3(30.0 * std::cos(turn), 20.0 * std::sin(3.0 * turn), 25.0 * std::sin(turn))}};
    const ServoSample s = step.tick(settings, tracker.get(), pose, {}, phase);
    touching += s.contact.touching();
    moving += s.contact.touching() && phase.motion && phase.fraction < 1.0;
    RecordedTick tick{settings, pose, {}, shownForceFigures(), k == 0, s.force, s.torque_N_mm, s.body_pose, s.at_rest};
    tick.motion = number;
    tick.motion_tick = motion_tick;
    CHECK_FALSE(writer->add(tick));
  }
  CHECK_FALSE(writer->finish());
  MESSAGE(touching, " ticks in contact, ", moving, " of them while spheres moved");
  CHECK(touching > 300);
  CHECK(moving > 50);
  Expected<ServoRecording> read = readServoRecording(file);
  REQUIRE(read);
  CHECK(read->torn.empty());
  CHECK(read->motions.size() == 9);
  CHECK(read->placed.empty());
  const auto replayed = [&] { return replay(*read, methods().front().make(scene, kWaterProbe_A).get(), scene.get()); };
  CHECK(replayed().ticks == 3000);
  CHECK(replayed().motion_unknown == 0);
  CHECK_FALSE(replayed().first_difference);
  // The first motion begins with tick 500; those that continue it begin elsewhere then.
  for (RecordedMotion::Change& change : read->motions[0].changes) change.displacement_A.x += 1e-3;
  CHECK(replayed().first_difference.value_or(0) >= 500);
  for (RecordedTick& tick : read->ticks) tick.motion = kUnknownMotion;
  CHECK(replayed().motion_unknown == 3000);
  CHECK(replayed().first_difference);
  std::filesystem::remove(file);
}

TEST_CASE(
    "a sphere that shrinks to nothing, is elsewhere and grows there is recorded in at most 32 bytes a sphere and "
    "piece, "
    "and its motions are reconstructed to the last bit, felt as they were") {
  const std::vector<Sphere> here{{{0.1, 0, 0}, 1.7}, {{6.2, 0, 0}, 1.6}};
  std::vector<Sphere> shrunk = here, away = here, grows = here;
  shrunk[1].radius_A = 0.0;
  away[1] = {{-13.4, 0.3, 0}, 0.0};
  grows[1] = {{-13.3, 0.3, 0}, 0.33};
  const SphereGrid scene(here);
  std::vector<std::unique_ptr<const SphereMotion>> motions;
  std::vector<RecordedMotion> recorded;
  for (const std::vector<Sphere>& to : {shrunk, away, grows}) {
    auto made = motions.empty() ? SphereMotion::make(here, to, 33) : SphereMotion::after(*motions.back(), to, 33);
    REQUIRE(made);
    recorded.push_back(recordedMotion(**made, motions.empty() ? nullptr : motions.back().get()));
    motions.push_back(*std::move(made));
  }
  CHECK(bytesOf(recorded[0]).size() == 9 + 2 * (32 + 32));  // with the places at the start
  CHECK(bytesOf(recorded[1]).size() == 9 + 2 * 24);
  CHECK(bytesOf(recorded[2]).size() == 9 + 2 * 32);
  CHECK_FALSE(motions[1]->continues(*motions[0]));
  CHECK_FALSE(motions[2]->continues(*motions[1]));
  MotionReplay replay(recorded, scene);
  for (std::uint32_t number = 1; number <= 3; ++number) {
    const auto phase = replay.at(number, 20);
    REQUIRE(phase);
    const SphereMotion &a = *motions[number - 1], &b = *phase->motion;
    CHECK(a.sweptSpheres().untouchable() == b.sweptSpheres().untouchable());
    const std::vector<Sphere> at = a.at(20.0 / 33), again = b.at(20.0 / 33);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(at[i].centre_A == again[i].centre_A);
      CHECK(at[i].radius_A == again[i].radius_A);
    }
  }
}

TEST_CASE(
    "a motion of which a byte is missing or added is refused; one that cannot be reconstructed counts as unknown") {
  RecordedMotion motion{.ticks = 5, .from = {{{0, 0, 0}, 1.0}, {{3, 0, 0}, 1.5}}, .changes = {{Vec3(1, 0, 0)}, {}}};
  const std::string bytes = bytesOf(motion);
  CHECK(bytes.size() == 9 + 2 * (32 + 24));
  REQUIRE(motionOfBytes(bytes));
  CHECK(motionOfBytes(bytes)->changes[0].displacement_A.x == 1.0);
  for (std::size_t length = 0; length < bytes.size(); ++length) CHECK_FALSE(motionOfBytes(bytes.substr(0, length)));
  CHECK_FALSE(motionOfBytes(bytes + '\0'));
  motion.changes[1].growth_A = 0.25;
  CHECK(bytesOf(motion).size() == 9 + 2 * (32 + 32));
  CHECK(motionOfBytes(bytesOf(motion))->changes[1].growth_A == 0.25);
  CHECK_FALSE(spheresOfBytes(std::string(33, '\0')));
  CHECK(spheresOfBytes(std::string(64, '\0'))->size() == 2);

  const SphereGrid two(motion.from);
  const auto phaseOf = [&two](RecordedMotion changed, std::uint32_t number, std::int32_t tick) {
    const std::vector<RecordedMotion> all{std::move(changed)};
    return MotionReplay(all, two).at(number, tick);
  };
  CHECK(phaseOf(motion, 0, 0));
  REQUIRE(phaseOf(motion, 1, 5));
  CHECK_FALSE(phaseOf(motion, 1, 6));
  CHECK_FALSE(phaseOf(motion, 1, -1));
  CHECK_FALSE(phaseOf(motion, 2, 1));
  RecordedMotion odd = motion;
  odd.ticks = 0;
  CHECK_FALSE(phaseOf(odd, 1, 0));
  odd = motion;
  odd.changes[0].displacement_A.y = NAN;
  CHECK_FALSE(phaseOf(odd, 1, 1));
  odd = motion;
  odd.from.clear();  // it continues a motion that is not there
  CHECK_FALSE(phaseOf(odd, 1, 1));
  const SphereGrid one(std::vector<Sphere>{{{0, 0, 0}, 1.0}});
  CHECK_FALSE(MotionReplay(std::vector<RecordedMotion>{motion}, one).at(1, 1));
}
