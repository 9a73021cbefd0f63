// The tasks that judge where something is led: dock and pass, fed with samples made by hand. Oracles: poses
// whose distance from the goal has a closed form.
#include <cmath>
#include <numbers>

#include "engine/lesson/tasks/held_way.h"
#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

// Two atoms 4 A apart along x, round the origin, and six of a ring of 5 A round the z axis at z = 20.
Molecule scene() {
  MoleculeByHand b;
  b.made.id = "made";
  b.residue("B", "LIG", 1, ResidueKind::Ligand).atom("C1", 6, {-2, 0, 0}).atom("C2", 6, {2, 0, 0});
  b.residue("A", "ALA", 1, ResidueKind::AminoAcid);
  for (int k = 0; k < 6; ++k)
    b.atom("C", 6, {5.0 * std::cos(k * std::numbers::pi / 3.0), 5.0 * std::sin(k * std::numbers::pi / 3.0), 20.0});
  return b.molecule();
}

std::shared_ptr<const HeldBody> held() {
  const std::uint32_t atoms[] = {0, 1};
  return heldBody(scene().spheres, atoms);
}

Quat about(const Vec3& axis, double deg) { return glm::angleAxis(glm::radians(deg), axis); }

std::unique_ptr<Task> docking(Keys keys = {}) {
  keys.insert(keys.begin(), {"dock", "file"});
  auto out = task("dock", keys, scene());
  out->takeInHand(held());
  return out;
}

// A hand that leads a body, or a probe, at 1 kHz.
struct Leader {
  Task& task;
  double time_s = 0.0;
  bool body = true;
  TouchSample next = {};

  void put(const Vec3& place, const Quat& q = kNoRotation, double dt_s = 0.001) {
    next.time_s = time_s += dt_s;
    next.hip.A = next.contact.scp.A = place;
    next.orientation = q;
    if (body) next.body = PoseA{{place}, q};
    task.feed(next);
    next.contact_reset = false;
  }
  void stay(double for_s) {
    for (const double end_s = time_s + for_s; time_s < end_s;) put(next.hip.A, next.orientation);
  }
  void lead(const Vec3& to, double A_per_s = 20.0) {
    const Vec3 from = next.hip.A;
    const int ticks = std::max(1, int(glm::distance(from, to) / A_per_s * 1000.0));
    for (int k = 1; k <= ticks; ++k) put(from + (to - from) * (double(k) / ticks), next.orientation);
  }
};

}  // namespace

TEST_CASE(
    "two atoms at 2 A from the middle that are shifted by d and turned by t across their line are d^2 + (4 sin(t/2))^2 "
    "off, square root, whatever the axis across") {
  const PoseGoal goal(held(), PoseA{});
  for (const double d : {0.0, 0.7, 3.0})
    for (const double deg : {0.0, 10.0, 90.0, 180.0}) {
      const double chord = 4.0 * std::sin(glm::radians(deg) / 2.0);
      for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0, 1, 0), glm::normalize(Vec3(0, 1, 1))})
        CHECK(goal.rmsd_A({{Vec3(0, 0, d)}, about(axis, deg)}) ==
              doctest::Approx(std::sqrt(d * d + chord * chord)).epsilon(1e-12));
      // Round their own line nothing moves, and yet it is turned.
      CHECK(goal.rmsd_A({{Vec3(d, 0, 0)}, about({1, 0, 0}, deg)}) == doctest::Approx(d).epsilon(1e-12));
      CHECK(goal.turned_rad({{}, about({1, 0, 0}, deg)}) == doctest::Approx(glm::radians(deg)).epsilon(1e-12));
    }
}

TEST_CASE(
    "dock is solved by who leads the body from 5 A or more away to within 1 A and 20 degrees and stays for 1 s, not "
    "0.9 s; 1.05 A or 25 degrees off are not there") {
  for (const double stays_s : {0.9, 1.1}) {
    const auto t = docking();
    Leader hand{*t};
    hand.put({0, 0, 12});
    hand.lead({0, 0, 0.95});
    hand.stay(stays_s);
    CHECK(t->solved() == (stays_s > 1.0));
    CHECK(figure(*t, "nearest") == doctest::Approx(0.95));
  }
  for (const auto& [place, q] :
       {std::pair{Vec3(0, 0, 1.05), kNoRotation}, std::pair{Vec3(0.0), about({1, 0, 0}, 25.0)}}) {
    const auto t = docking();
    Leader hand{*t};
    hand.put({0, 0, 12}, q);
    hand.lead(place);
    hand.stay(5.0);
    CHECK_FALSE(t->done());
  }
  const auto turned = docking({{"turned", "30"}});
  Leader hand{*turned};
  hand.put({0, 0, 12}, about({1, 0, 0}, 25.0));
  hand.lead({0, 0, 0});
  hand.stay(1.1);
  CHECK(turned->solved());
}

TEST_CASE(
    "who is put down in the pose, jumps or has a gap of time on the way, begins at 4.9 A, or is thrown through the "
    "pose "
    "has not docked; drawn out to 5 A and led in again it counts") {
  {
    const auto t = docking();
    Leader hand{*t};
    hand.put({0, 0, 12});
    hand.next.contact_reset = true;
    hand.put({0, 0, 0});
    hand.stay(5.0);
    CHECK_FALSE(t->done());
    CHECK(t->sentence() == "It was put down there. Draw it out, then lead it in.");
    hand.lead({0, 0, 4.9});
    hand.lead({0, 0, 0});
    hand.stay(5.0);
    CHECK_FALSE(t->done());
    hand.lead({0, 0, 5.01});
    hand.lead({0, 0, 0});
    hand.stay(1.1);
    CHECK(t->solved());
  }
  for (const double gap_s : {0.001, 0.4}) {  // a step of 3.5 A in a tick; a gap in which anything may have happened
    CAPTURE(gap_s);
    const auto t = docking();
    Leader hand{*t};
    hand.put({0, 0, 12});
    hand.lead({0, 0, gap_s > 0.1 ? 2.0 : 3.5});
    hand.put({0, 0, 0}, kNoRotation, gap_s);
    hand.stay(5.0);
    CHECK_FALSE(t->done());
  }
  {
    const auto t = docking();  // turned over in a tick
    Leader hand{*t};
    hand.put({0, 0, 12}, about({0, 1, 0}, 90.0));
    hand.lead({0, 0, 0});
    hand.put({0, 0, 0});
    hand.stay(5.0);
    CHECK_FALSE(t->done());
  }
  const auto t = docking();
  Leader hand{*t};
  hand.put({0, 0, 12});
  for (int k = 0; k < 50; ++k) {
    hand.lead({0, 0, -12}, 60.0);
    hand.lead({0, 0, 12}, 60.0);
  }
  CHECK_FALSE(t->done());
  CHECK(t->progress() < 0.2);
}

TEST_CASE(
    "springs stretched to 1.5 A in the mean say that the atoms are elsewhere, though the body is drawn in place") {
  const auto t = docking();
  Leader hand{*t};
  hand.put({0, 0, 12});
  hand.lead({0, 0, 0});
  hand.next.contact.energy_A2 = 2 * 0.5 * 1.5 * 1.5;
  hand.stay(5.0);
  CHECK_FALSE(t->done());
  hand.next.contact.energy_A2 = 2 * 0.5 * 0.9 * 0.9;
  hand.stay(1.1);
  CHECK(t->solved());
}

TEST_CASE("an exact body in its pose is in place however far the hand presses, 10 A here") {
  const auto t = docking();
  Leader hand{*t};
  hand.next.one_spring = true;
  hand.put({0, 0, 12});
  hand.lead({0, 0, 0});
  hand.next.contact.energy_A2 = 0.5 * 10.0 * 10.0;
  hand.stay(1.1);
  CHECK(t->solved());
}

TEST_CASE(
    "the hand begins turned by 60 degrees or more off the pose, otherwise for each seed and after a new start, and as "
    "the file has it where the author says so; 400 draws are even over the sides") {
  const auto t = docking();
  Vec3 mean(0.0);
  double least_deg = 180.0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    t->drawBy(seed);
    REQUIRE(t->stage().body_turned);
    const Quat q = *t->stage().body_turned;
    least_deg = std::min(least_deg, glm::degrees(glm::length(rotationBetween(kNoRotation, q))));
    mean += q * Vec3(0, 0, 1) / 400.0;
    t->drawBy(seed);
    CHECK(*t->stage().body_turned == q);
  }
  CHECK(least_deg >= 60.0);
  CHECK(glm::length(Vec3(mean.x, mean.y, 0.0)) < 0.1);
  const TaskStage before = t->stage();
  t->reset();
  CHECK(t->stage().presentation != before.presentation);
  CHECK(t->stage().body_turned != before.body_turned);
  CHECK_FALSE(docking({{"turn", "none"}})->stage().body_turned);
}

TEST_CASE(
    "a written pose is the goal in place of the file's; a pose of two numbers and 'away' under twice 'within' are "
    "errors") {
  const auto t = task("dock", {{"dock", "0, 0, 30, 0.7071, 0, 0, 0.7071"}}, scene());
  t->takeInHand(held());
  Leader hand{*t};
  hand.put({0, 0, 40}, about({0, 0, 1}, 90.0));
  hand.lead({0, 0, 30});
  hand.stay(1.1);
  CHECK(t->solved());
  CHECK(problemOf("dock", {{"dock", "1, 2"}}) == "a pose has 3 or 7 numbers, here are 2");
  CHECK(problemOf("dock", {{"dock", "file"}, {"within", "3 Å"}}) ==
        "the body would begin nearly where it is to be docked");
}

TEST_CASE(
    "pass is solved by a lead through the ring from either side, 2 A before to 2 A behind; not round it, not by "
    "turning "
    "back, not by a jump over the plane, and not by a hand put down behind it") {
  const auto passing = [] { return task("pass", {{"pass", "chain A"}}, scene()); };
  for (const double from : {1.0, -1.0})
    for (const bool body : {false, true}) {
      const auto t = passing();
      if (body) t->takeInHand(held());
      Leader hand{.task = *t, .body = body};
      hand.put({1, 0, 20 + from * 6});
      hand.lead({1, 0, 20 - from * 1.9});
      CHECK_FALSE(t->done());
      CHECK(t->sentence() == "You are in the opening. Go on, through to the other side.");
      hand.lead({1, 0, 20 - from * 2.1});
      CHECK(t->solved());
    }
  const std::vector<std::vector<Vec3>> wrong{
      {{1, 0, 26}, {9, 0, 26}, {9, 0, 14}, {1, 0, 14}},                           // round
      {{1, 0, 26}, {1, 0, 19}, {1, 0, 26}},                                       // back
      {{1, 0, 26}, {1, 0, 21}, {9, 0, 21}, {9, 0, 19}, {1, 0, 19}, {1, 0, 14}}};  // out at the side and in again behind
  for (const auto& way : wrong) {
    const auto t = passing();
    Leader hand{.task = *t, .body = false};
    hand.put(way.front());
    for (const Vec3& to : way) hand.lead(to);
    CHECK_FALSE(t->done());
  }
  for (const bool placed : {true, false}) {
    const auto t = passing();
    Leader hand{.task = *t, .body = false};
    hand.put({1, 0, 26});
    hand.lead({1, 0, 21.6});
    hand.next.contact_reset = placed;
    hand.put({1, 0, placed ? 19.6 : 17.9});  // 3.7 A in a tick
    hand.lead({1, 0, 14});
    CHECK_FALSE(t->done());
  }
  CHECK(problemOf("pass", {}) == "touch needs the key 'pass'");
}
