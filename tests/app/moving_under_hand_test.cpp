// In a scene with two structures, the atoms move under a pressing hand for every motion of the slider.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/moving_states.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/sweep.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {

namespace {

// Adenylate kinase, open and shut, its probe a water.
std::string doorLesson(const ScratchFolder& scratch) {
  const auto file = scratch.path / "door.md";
  writeFile(file,
            "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: 4ake, 1ake\nauthor: A\nlicence: L\n---\n## One\n"
            "```scene\nmolecule: 4ake\nprobe: 1.4 Å\n"
            "then: 1ake, superposed on residue 1-29 60-121 160-214\n```\nText.\n");
  return file.string();
}

}  // namespace

TEST_CASE(
    "a mouse presses anywhere on adenylate kinase while the slider jumps 40 times between open and shut: in 1 200 "
    "frames "
    "the contact is never over 1e-6 A inside a sphere as it is at that tick, the force is finite and at most 3.3 N, "
    "and "
    "back at its beginning every sphere is where it was read; seed 26") {
  const ScratchFolder scratch;
  const auto d = startWith(doorLesson(scratch));
  Application& app = d->app();
  d->frames(10);
  MovingStates& states = app.extensions().movers.get<MovingStates>();
  REQUIRE(states.ready());
  scenes::Random random(26);
  int touching = 0, moving = 0;
  double deepest_A = 0.0, greatest_N = 0.0;
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    states.goTo(round % 5 == 0 ? double(round % 2) : random.uniform(0, 1));
    d->point("view", random.uniform(0.35, 0.65), random.uniform(0.3, 0.7));
    d->press();
    for (int frame = 0; frame < 30; ++frame) {
      if (frame % 10 == 5) states.goTo(random.uniform(0, 1));
      if (frame == 15) d->point("view", random.uniform(0.35, 0.65), random.uniform(0.3, 0.7));
      d->frames(1);
      const ServoSample& now = app.scene.log().latest();
      REQUIRE(finite(now.force.N));
      greatest_N = std::max(greatest_N, glm::length(now.force.N));
      const auto motion = app.scene.servo().motionOf(now);
      moving += motion && now.fraction < 1.0;
      if (!now.contact.touching()) continue;
      ++touching;
      const SphereGrid& spheres = motion ? motion->sweptSpheres() : *app.scene.stage().spheres;
      const double clear_A =
          clearance(spheres, app.scene.touch().probe_A, now.contact.scp.A, motion.get(), now.fraction);
      deepest_A = std::max(deepest_A, -clear_A);
    }
    d->release();
    d->frames(3);
  }
  MESSAGE("touching in ", touching, " frames, atoms on their way in ", moving, ", greatest force ", greatest_N, " N");
  CHECK(touching > 300);
  CHECK(moving > 300);
  CHECK(deepest_A <= 1e-6);
  CHECK(greatest_N <= 3.3);
  // Back where it was, the molecule is the one that was read.
  states.goTo(0.0);
  d->frames(300);
  REQUIRE(states.share() == 0.0);
  const auto spheres = app.scene.stage().spheres->spheres();
  const auto& atoms = app.scene.atoms().resting().molecule->atoms;
  REQUIRE(spheres.size() == atoms.size());
  double farthest_A = 0.0;
  for (std::size_t k = 0; k < atoms.size(); ++k)
    farthest_A = std::max(farthest_A, glm::distance(spheres[k].centre_A, spheres[k].centre_A));
  CHECK(farthest_A < 1e-9);
}

namespace {

// HIV protease with amprenavir in the hand, its flaps on the slider.
std::string drugLesson(const ScratchFolder& scratch) {
  const auto file = scratch.path / "drug.md";
  writeFile(file,
            "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: 1hpv, 1hpv-open\nauthor: A\nlicence: L\n---\n## One\n"
            "```scene\nmolecule: 1hpv\nin-hand: ligand\nthen: 1hpv-open\n```\nText.\n");
  return file.string();
}

// The largest overlap of the drawn body with the spheres where they are at that tick, over all pairs.
double overlap_A(const Application& app, const ServoSample& now) {
  const HeldBody& body = *app.scene.stage().body;
  const SphereGrid& rest = *app.scene.stage().spheres;
  const auto motion = app.scene.servo().motionOf(now);
  const PoseA pose = now.shownBody();
  double most = -1e9;
  for (std::uint32_t i = 0; i < rest.size(); ++i) {
    if (!rest.touchable(i)) continue;
    const Sphere other = motion ? (*motion)[i].at(now.fraction) : rest[i];
    for (const Sphere& s : body.spheres)
      most = std::max(most, s.radius_A + other.radius_A -
                                glm::distance(pose.place.A + pose.orientation * s.centre_A, other.centre_A));
  }
  return most;
}

}  // namespace

TEST_CASE(
    "a mouse presses the drug against HIV protease while its flaps open and shut 30 times: in 900 frames it overlaps "
    "no "
    "atom by more than 1e-6 A where the atoms are at that tick, the force is at most 3.3 N, and it is zero wherever "
    "the "
    "flaps have crushed it; seed 5") {
  const ScratchFolder scratch;
  const auto d = startWith(drugLesson(scratch));
  Application& app = d->app();
  d->frames(10);
  MovingStates& states = app.extensions().movers.get<MovingStates>();
  REQUIRE(states.ready());
  REQUIRE(app.scene.stage().body);
  scenes::Random random(5);
  int touching = 0, moving = 0, crushed = 0;
  double deepest_A = -1e9, greatest_N = 0.0;
  for (int round = 0; round < 30; ++round) {
    CAPTURE(round);
    d->point("view", random.uniform(0.4, 0.6), random.uniform(0.35, 0.65));
    d->press();
    for (int frame = 0; frame < 30; ++frame) {
      if (frame % 10 == 3) states.goTo(random.uniform(0, 1));
      if (frame == 15) d->point("view", random.uniform(0.4, 0.6), random.uniform(0.35, 0.65));
      d->frames(1);
      const ServoSample& now = app.scene.log().latest();
      const double force_N = glm::length(now.force.N);
      REQUIRE(std::isfinite(force_N));
      greatest_N = std::max(greatest_N, force_N);
      const auto motion = app.scene.servo().motionOf(now);
      moving += motion && now.fraction < 1.0;
      if (now.contact.fault == Fault::StartedInside) {
        ++crushed;
        CHECK(force_N == 0.0);
        continue;
      }
      touching += now.contact.touching();
      deepest_A = std::max(deepest_A, overlap_A(app, now));
    }
    d->release();
    d->frames(3);
  }
  MESSAGE("touching in ", touching, " frames, atoms on their way in ", moving, ", crushed in ", crushed,
          ", greatest force ", greatest_N, " N, deepest ", deepest_A, " A");
  CHECK(touching > 200);
  CHECK(moving > 200);
  CHECK(deepest_A <= 1e-6);
  CHECK(greatest_N <= 3.3);
}

TEST_CASE(
    "flaps that shut over the docked drug leave it free: the slider goes from open to shut in 3 s, the drug overlaps "
    "nothing, and it rests within 0.3 A of its place in the crystal") {
  const ScratchFolder scratch;
  const auto d = startWith(drugLesson(scratch));
  Application& app = d->app();
  d->frames(10);
  MovingStates& states = app.extensions().movers.get<MovingStates>();
  REQUIRE(states.ready());
  const HeldBody& body = *app.scene.stage().body;
  states.goTo(1.0);
  d->frames(300);
  REQUIRE(states.share() == 1.0);
  app.scene.view().holdAt(PoseA{body.middle});
  d->frames(30);
  REQUIRE(glm::distance(app.scene.log().latest().shownBody().place.A, body.middle.A) < 0.3);
  states.goTo(0.0);
  double deepest_A = -1e9;
  for (int frame = 0; frame < 300; ++frame) {
    d->frames(1);
    const ServoSample& now = app.scene.log().latest();
    REQUIRE(now.contact.fault == Fault::None);
    deepest_A = std::max(deepest_A, overlap_A(app, now));
  }
  REQUIRE(states.share() == 0.0);
  CHECK(deepest_A <= 1e-6);
  CHECK(glm::distance(app.scene.log().latest().shownBody().place.A, body.middle.A) < 0.3);
}

}  // namespace moltact
