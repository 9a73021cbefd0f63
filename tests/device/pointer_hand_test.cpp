// The hand controlled by a mouse, with one sphere of radius 1.7 A seen from (0, 0, 40) A: positions and speeds in
// closed form.
#include "engine/device/pointer_hand.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "engine/device/mouse_device.h"
#include "tests/haptics/fields.h"

namespace moltact {
namespace {

constexpr double kRadius_A = 1.7;
constexpr double kProbe_A = 1.4;
constexpr double kReach_A = kRadius_A + kProbe_A;
constexpr double kFrame_s = 1.0 / 60.0;

SphereGrid oneSphere() { return SphereGrid({{Vec3(0.0), kRadius_A}}); }

PointerInput atMiddle() {
  PointerInput in;
  in.rays.eye_A = {0, 0, 40};
  in.rays.width_px = 800;
  in.rays.height_px = 600;
  in.pointer_px = glm::dvec2(400, 300);
  in.dt_s = kFrame_s;
  return in;
}

// The height over the sphere's inflated surface along the line of sight through the middle.
double height_A(PointA hip) { return hip.A.z - kReach_A; }

}  // namespace

TEST_CASE("the probe hovers 0.35 A before the surface under the pointer") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointA hip;
  for (int k = 0; k < 60; ++k) hip = hand.lead(atMiddle(), scene, kProbe_A);
  CHECK(height_A(hip) == doctest::Approx(0.35).epsilon(1e-9));
  CHECK(hand.depth_A() == 0.0);
}

TEST_CASE(
    "a hand that stood over the middle and left the surface with the pointer is back at the middle within 0.5 s while "
    "the "
    "pointer is on a control; without a control, pressed, or after an arrow key it stays") {
  const SphereGrid scene = oneSphere();
  // 200 px beside the middle the line of sight passes the sphere at 8 A; 60 frames of standing, 20 of moving away.
  const auto aside = [&](PointerHand& hand) {
    PointerInput in = atMiddle();
    for (int k = 0; k < 60; ++k) hand.lead(in, scene, kProbe_A);
    for (int k = 1; k <= 20; ++k) {
      in.pointer_px = glm::dvec2(400 + 10 * k, 300);
      hand.lead(in, scene, kProbe_A);
    }
    for (int k = 0; k < 30; ++k) hand.lead(in, scene, kProbe_A);
    CHECK(hand.aim_px().x == doctest::Approx(600.0).epsilon(1e-4));
    CHECK_FALSE(hand.overSurface());
    in.pointer_px.reset();
    return in;
  };
  PointerHand hand, left, pressed, by_keys;
  PointerInput in = aside(hand);
  in.over_control = true;
  PointA hip;
  for (int k = 0; k < 30; ++k) hip = hand.lead(in, scene, kProbe_A);
  CHECK(hand.aim_px().x == doctest::Approx(400.0).epsilon(1e-4));
  CHECK(hand.overSurface());
  CHECK(height_A(hip) == doctest::Approx(0.35).epsilon(0.01));
  in.pointer_px = glm::dvec2(600, 300), in.over_control = false;  // the pointer comes back into the view
  for (int k = 0; k < 30; ++k) hand.lead(in, scene, kProbe_A);
  CHECK(hand.aim_px().x == doctest::Approx(600.0).epsilon(1e-4));

  in = aside(left);
  for (int k = 0; k < 30; ++k) left.lead(in, scene, kProbe_A);
  CHECK(left.aim_px().x == doctest::Approx(600.0).epsilon(1e-4));
  in = aside(pressed);
  in.over_control = in.press = true;
  for (int k = 0; k < 30; ++k) pressed.lead(in, scene, kProbe_A);
  CHECK(pressed.aim_px().x == doctest::Approx(600.0).epsilon(1e-4));
  in = aside(by_keys);
  in.keys = {1.0, 0.0};
  by_keys.lead(in, scene, kProbe_A);
  in.keys = {0.0, 0.0}, in.over_control = true;
  const double there_px = by_keys.aim_px().x;
  for (int k = 0; k < 30; ++k) by_keys.lead(in, scene, kProbe_A);
  CHECK(by_keys.aim_px().x == there_px);
}

TEST_CASE("under no force a press sinks at 1.2 A/s once it has met the surface") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointerInput in = atMiddle();
  PointA hip = hand.lead(in, scene, kProbe_A);
  in.press = true;
  in.N_per_A = 0.0;
  while (hand.depth_A() == 0.0) hip = hand.lead(in, scene, kProbe_A);
  const double before = hand.depth_A();
  for (int k = 0; k < 30; ++k) hip = hand.lead(in, scene, kProbe_A);
  CHECK(hand.depth_A() - before == doctest::Approx(0.6).epsilon(1e-6));
  CHECK(height_A(hip) == doctest::Approx(-hand.depth_A()).epsilon(1e-9));
}

TEST_CASE("at 1 N the press sinks half as fast") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointerInput in = atMiddle();
  in.press = true;
  while (hand.depth_A() == 0.0) hand.lead(in, scene, kProbe_A);
  in.force_N = 1.0;
  const double before = hand.depth_A();
  for (int k = 0; k < 30; ++k) hand.lead(in, scene, kProbe_A);
  CHECK(hand.depth_A() - before == doctest::Approx(0.5 * 1.2 * 30 * kFrame_s).epsilon(1e-6));
}

TEST_CASE("pressed, the aim is at the pointer in the same frame, whatever the force; only a leap takes time") {
  const SphereGrid scene = oneSphere();
  // 40 A/s at 36.9 A from the eye, 600 px over a field of view of 2 x 0.3.
  const double most_px = PointerHand::kMaxSpeed_A_per_s * kFrame_s * 600.0 / (2.0 * 0.3 * (40.0 - kReach_A));
  for (const double force_N : {0.0, 1.0, 3.0}) {
    PointerHand hand;
    PointerInput in = atMiddle();
    in.force_N = force_N;
    hand.lead(in, scene, kProbe_A);
    in.press = true;
    hand.lead(in, scene, kProbe_A);
    for (int k = 0; k < 5; ++k) {
      in.pointer_px = *in.pointer_px + glm::dvec2(8, -3);
      hand.lead(in, scene, kProbe_A);
      CHECK(glm::distance(hand.aim_px(), *in.pointer_px) < 1e-9);
    }
    const glm::dvec2 before = hand.aim_px();
    in.pointer_px = before + glm::dvec2(0, 30);
    hand.lead(in, scene, kProbe_A);
    // The surface is met a little farther off at the sphere's flank.
    CHECK(glm::distance(hand.aim_px(), before) == doctest::Approx(most_px).epsilon(0.05));
    hand.lead(in, scene, kProbe_A);
    CHECK(glm::distance(hand.aim_px(), *in.pointer_px) < 1e-9);
  }
}

TEST_CASE("a hand that is let go while it touches is lifted where it is, and follows the pointer once it is free") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointerInput in = atMiddle();
  in.press = true;
  for (int k = 0; k < 60; ++k) in.hip = hand.lead(in, scene, kProbe_A);
  REQUIRE(hand.depth_A() > 0.0);
  in.press = false;
  in.touching = true;
  in.pointer_px = glm::dvec2(420, 300);
  for (int k = 0; k < 3; ++k) {
    const PointA lifted = hand.lead(in, scene, kProbe_A);
    CHECK(glm::length(glm::dvec2(lifted.A)) < 1e-9);
    CHECK(height_A(lifted) == doctest::Approx(PointerHand::kHover_A));
  }
  in.touching = false;
  for (int k = 0; k < 60; ++k) hand.lead(in, scene, kProbe_A);
  CHECK(hand.aim_px().x == doctest::Approx(420).epsilon(1e-3));
  // What never comes free does not hold the hand for longer than kLift_s.
  in.press = true;
  for (int k = 0; k < 60; ++k) in.hip = hand.lead(in, scene, kProbe_A);
  in.press = false;
  in.touching = true;
  in.pointer_px = glm::dvec2(380, 300);
  for (int k = 0; k < 60; ++k) hand.lead(in, scene, kProbe_A);
  CHECK(hand.aim_px().x == doctest::Approx(380).epsilon(1e-3));
}

TEST_CASE(
    "where a press comes to a surface 10 A nearer it waits before that one and sinks again; back it goes by no leap") {
  const SphereGrid scene({{Vec3(0.0), kRadius_A}, {Vec3(6.0, 0.0, 10.0), kRadius_A}});
  PointerHand hand;
  PointerInput in = atMiddle();
  in.rays.tan_half_fov = 0.3;
  in.press = true;
  for (int k = 0; k < 60; ++k) hand.lead(in, scene, kProbe_A);
  REQUIRE(hand.depth_A() > 0.3);
  int leaps = 0;
  double depth_there_A = 1.0;
  for (int k = 0; k < 60; ++k) {
    in.pointer_px = *in.pointer_px + glm::dvec2(3, 0);
    const PointA hip = hand.lead(in, scene, kProbe_A);
    if (!hand.leapt()) continue;
    ++leaps;
    depth_there_A = hand.depth_A();
    CHECK(glm::distance(hip.A, Vec3(0.0)) >= kReach_A);
    CHECK(glm::distance(hip.A, Vec3(6.0, 0.0, 10.0)) >= kReach_A);
  }
  CHECK(leaps == 1);
  CHECK(depth_there_A == 0.0);
  CHECK(hand.depth_A() > 0.3);
  for (int k = 0; k < 60; ++k) {
    in.pointer_px = *in.pointer_px - glm::dvec2(3, 0);
    hand.lead(in, scene, kProbe_A);
    CHECK_FALSE(hand.leapt());
  }
  // A hand that only hovers never leaps.
  in.press = false;
  for (int k = 0; k < 60; ++k) {
    in.pointer_px = *in.pointer_px + glm::dvec2(3, 0);
    hand.lead(in, scene, kProbe_A);
    CHECK_FALSE(hand.leapt());
  }
}

TEST_CASE("a press that is held comes to rest where the spring gives 0.6 N, and stays there") {
  const SphereGrid scene = oneSphere();
  for (const double N_per_A : {1.25, 3.3, 33.0}) {
    PointerHand hand;
    PointerInput in = atMiddle();
    in.press = true;
    in.N_per_A = N_per_A;
    for (int k = 0; k < 120; ++k) hand.lead(in, scene, kProbe_A);
    CAPTURE(N_per_A);
    CHECK(hand.depth_A() * N_per_A == doctest::Approx(0.6));
    const PointA rests = hand.lead(in, scene, kProbe_A);
    for (int k = 0; k < 600; ++k) hand.lead(in, scene, kProbe_A);
    CHECK(glm::distance(hand.lead(in, scene, kProbe_A).A, rests.A) < 1e-9);
  }
}

TEST_CASE(
    "each notch makes a held press 0.2 N harder or lighter at once, never lighter than 0.05 N, and letting go forgets "
    "it") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointerInput in = atMiddle();
  in.press = true;
  in.N_per_A = 3.3;
  for (int k = 0; k < 120; ++k) hand.lead(in, scene, kProbe_A);
  const auto forceAfter = [&](double notches) {
    in.push_notches = notches;
    hand.lead(in, scene, kProbe_A);
    in.push_notches = 0.0;
    for (int k = 0; k < 60; ++k) hand.lead(in, scene, kProbe_A);
    return hand.depth_A() * in.N_per_A;
  };
  CHECK(forceAfter(2.0) == doctest::Approx(1.0));
  CHECK(forceAfter(-3.0) == doctest::Approx(0.4));
  CHECK(forceAfter(-100.0) == doctest::Approx(0.05));
  CHECK(forceAfter(1.0) == doctest::Approx(0.25));
  in.press = false;
  hand.lead(in, scene, kProbe_A);
  in.press = true;
  CHECK(forceAfter(0.0) == doctest::Approx(0.6));
  // At once, in a frame that lasts no time.
  in.dt_s = 0.0;
  in.push_notches = 2.0;
  hand.lead(in, scene, kProbe_A);
  CHECK(hand.depth_A() * in.N_per_A == doctest::Approx(1.0));
}

TEST_CASE("no notch pushes deeper than 3 A, and one is at most 0.3 A where the surface hardly pushes back") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointerInput in = atMiddle();
  in.press = true;
  in.N_per_A = 0.0;
  for (int k = 0; k < 120; ++k) hand.lead(in, scene, kProbe_A);
  CHECK(hand.depth_A() == doctest::Approx(0.9));
  in.push_notches = 1.0;
  hand.lead(in, scene, kProbe_A);
  CHECK(hand.depth_A() == doctest::Approx(1.2));
  in.push_notches = 1000.0;
  hand.lead(in, scene, kProbe_A);
  CHECK(hand.depth_A() == doctest::Approx(PointerHand::kMaxDepth_A));
}

TEST_CASE("letting go brings the probe back to 0.35 A before the surface") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointerInput in = atMiddle();
  in.press = true;
  for (int k = 0; k < 60; ++k) hand.lead(in, scene, kProbe_A);
  in.press = false;
  CHECK(height_A(hand.lead(in, scene, kProbe_A)) == doctest::Approx(0.35));
}

TEST_CASE("input that is not finite leaves the hand where it was") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  const PointA before = hand.lead(atMiddle(), scene, kProbe_A);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (int which = 0; which < 8; ++which) {
    PointerInput in = atMiddle();
    in.press = true;
    if (which == 0) in.force_N = nan;
    if (which == 1) in.dt_s = inf;
    if (which == 2) in.push_notches = nan;
    if (which == 3) in.pointer_px->x = inf;
    if (which == 4) in.keys.y = nan;
    if (which == 5) in.rays.eye_A.z = nan;
    if (which == 6) in.N_per_A = nan;
    if (which == 7) in.hip.A.x = nan;
    CAPTURE(which);
    CHECK(hand.lead(in, scene, kProbe_A).A == before.A);
  }
  CHECK(hand.lead(atMiddle(), scene, kProbe_A).A == before.A);
}

TEST_CASE(
    "the arrow keys move the aim by 12 % of the view's height a second, and the pointer takes over when it moves") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointerInput in = atMiddle();
  in.pointer_px.reset();
  hand.lead(in, scene, kProbe_A);
  in.keys = {1, 0};
  for (int k = 0; k < 60; ++k) hand.lead(in, scene, kProbe_A);
  CHECK(hand.aim_px().x == doctest::Approx(400 + 0.12 * 600));
  in.keys = {0, 0};
  in.pointer_px = glm::dvec2(100, 100);
  for (int k = 0; k < 60; ++k) hand.lead(in, scene, kProbe_A);
  CHECK(hand.aim_px().x == doctest::Approx(100).epsilon(1e-3));
}

TEST_CASE("beside the molecule the probe stays at the depth where the surface was last met, outside every sphere") {
  const SphereGrid scene = oneSphere();
  PointerHand hand;
  PointerInput in = atMiddle();
  hand.lead(in, scene, kProbe_A);
  in.pointer_px = glm::dvec2(790, 300);
  PointA hip;
  for (int k = 0; k < 120; ++k) hip = hand.lead(in, scene, kProbe_A);
  CHECK(glm::length(hip.A) > kReach_A);
  CHECK(std::abs(hip.A.z) < kReach_A + 1.0);
}

namespace {

// A mouse's hand in a field, through the mouse's glide, felt tick by tick at its place; 16 ticks a frame.
struct InMouseHand {
  SphereGrid scene = oneSphere();
  PointerHand hand;
  MouseDevice mouse;
  Workspace workspace;
  PointerInput in = atMiddle();
  std::unique_ptr<Interaction> felt;
  Vec3 place_A{0.0};

  explicit InMouseHand(std::unique_ptr<Interaction> field) : felt(std::move(field)) {
    in.dt_s = 0.016;
    const PointA first = hand.lead(in, scene, kProbe_A);
    mouse.place(workspace.toDevice(first));
  }
  void frames(int n) {
    for (int k = 0; k < n; ++k) {
      for (int t = 0; t < 16; ++t) place_A = workspace.toMolecule(mouse.read(1e-3).position).A;
      const Response answer = felt->respond({{place_A}});
      const FeltForce pull = answer.total(2.0);
      in.hip = {place_A};
      in.field = answer.field.has_value();
      in.pull_N = pull.force_N;
      in.pull_N_per_A = pull.stiffness_N_per_A;
      in.well_N_A = answer.field ? answer.field->energy_N_A : 0.0;
      in.force_N = glm::length(pull.force_N);
      in.N_per_A = 2.0;
      mouse.lead(workspace.toDevice(hand.lead(in, scene, kProbe_A)));
    }
  }
};

// Two like charges, in N A of the hand.
struct Repelling {
  double at_1_A_N = 6.5;
  test::PairEnergy at(double r) const { return {at_1_A_N / r, -at_1_A_N / (r * r), 2.0 * at_1_A_N / (r * r * r)}; }
};

}  // namespace

TEST_CASE(
    "a press in a well of energy rests at its middle within 0.02 A after 2 s, 0.4 A beside the line of sight and "
    "before "
    "the surface, never passes it by more than 0.05 A, and stays for 10 s") {
  const Vec3 middle(0.4, -0.2, 3.9);
  auto well = std::make_unique<test::Harmonic>(std::make_unique<test::OpenSpace>(), test::HarmonicPair{1.2},
                                               std::vector<test::Harmonic::Atom>{{0, middle}});
  well->offset_N_A = -1.5;
  InMouseHand student(std::move(well));
  student.frames(30);
  const Vec3 hovering = student.place_A;
  CHECK(glm::distance(hovering, middle) > 0.6);
  student.in.press = true;
  double beyond_A = 0.0;
  const Vec3 way = glm::normalize(middle - hovering);
  for (int k = 0; k < 125; ++k) {
    student.frames(1);
    beyond_A = std::max(beyond_A, glm::dot(student.place_A - middle, way));
  }
  CHECK(student.hand.inWell());
  CHECK(glm::distance(student.place_A, middle) < 0.02);
  CHECK(beyond_A < 0.05);
  for (int k = 0; k < 625; ++k) {
    student.frames(1);
    CHECK(glm::distance(student.place_A, middle) < 0.02);
  }
  // The pointer moves it out; the force then points back. After the release it hovers under the pointer again.
  for (int k = 0; k < 40; ++k) {
    student.in.pointer_px = *student.in.pointer_px + glm::dvec2(6, 0);
    student.frames(1);
  }
  CHECK(student.place_A.x > middle.x + 0.5);
  student.in.press = false;
  student.frames(200);
  CHECK_FALSE(student.hand.inWell());
}

TEST_CASE(
    "a hand that waits in a well behind the sphere stays there until it is pressed, falls to the well's middle, and a "
    "notch "
    "of the wheel takes it 0.3 A along the view before the well draws it back") {
  const Vec3 middle(0.0, 0.0, -5.0), waits(0.3, 0.0, -5.2);
  auto well = std::make_unique<test::Harmonic>(std::make_unique<test::OpenSpace>(), test::HarmonicPair{1.2},
                                               std::vector<test::Harmonic::Atom>{{0, middle}});
  well->offset_N_A = -1.5;
  InMouseHand student(std::move(well));
  student.hand.reset();
  student.hand.waitAt({waits});
  student.mouse.place(student.workspace.toDevice({waits}));
  student.frames(60);
  CHECK(glm::distance(student.place_A, waits) < 1e-6);
  student.in.press = true;
  student.frames(125);
  CHECK(student.hand.inWell());
  CHECK(glm::distance(student.place_A, middle) < 0.02);
  student.in.push_notches = 1.0;
  student.frames(1);
  student.in.push_notches = 0.0;
  student.frames(2);
  CHECK(glm::dot(student.place_A - middle, student.in.rays.forward) > 0.15);
  student.frames(125);
  CHECK(glm::distance(student.place_A, middle) < 0.02);
}

TEST_CASE("a press toward an atom with the well of Lennard and Jones rests where its energy is least, 3.8 A from it") {
  InMouseHand student(std::make_unique<test::LennardJones>(std::make_unique<test::OpenSpace>(),
                                                           test::LennardJonesPair{.depth_N_A = 0.5, .rest_A = 3.8},
                                                           std::vector<test::LennardJones::Atom>{{0, Vec3(0.0)}}));
  student.in.press = true;
  student.frames(200);
  CHECK(glm::length(student.place_A) == doctest::Approx(3.8).epsilon(0.005));
}

TEST_CASE("a press against a charge that repels goes in until 0.6 N oppose it; a notch more makes that 0.8 N") {
  InMouseHand student(std::make_unique<test::InField<Repelling>>(
      std::make_unique<test::OpenSpace>(), Repelling(), std::vector<test::InField<Repelling>::Atom>{{0, Vec3(0.0)}}));
  student.frames(30);
  CHECK(glm::length(student.place_A) > 3.4);
  student.in.press = true;
  student.frames(300);
  CHECK(student.in.force_N == doctest::Approx(0.6).epsilon(0.05));
  student.in.push_notches = 1.0;
  student.frames(1);
  student.in.push_notches = 0.0;
  student.frames(300);
  CHECK(student.in.force_N == doctest::Approx(0.8).epsilon(0.05));
}

}  // namespace moltact
