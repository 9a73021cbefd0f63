// A rigid body in the hand through the servo step: a bar with a spring at either end above a wall, and a torsion
// spring. Their forces and torques are known in closed form.
#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "engine/servo/servo_step.h"
#include "tests/haptics/without_memory.h"

using namespace moltact;

namespace {

// Two points on the body's x-axis, 2 A from its middle, each pushed out of the half-space z < 0.
class Bar final : public test::WithoutMemory<Interaction> {
 public:
  static constexpr double kArm_A = 2.0;
  Response respond(const PoseA& pose) noexcept override {
    Response out;
    out.contact.scp = pose.place;
    if (!finite(pose.place.A)) return {.contact = {.scp = pose.place, .fault = Fault::NotFinite}};
    for (const double end : {-kArm_A, kArm_A}) {
      const Vec3 arm = pose.orientation * Vec3(end, 0, 0);
      const double deep = -(pose.place.A + arm).z;
      if (deep <= 0.0) continue;
      const Vec3 pull(0, 0, deep);
      out.contact.feature = Feature::Sphere;
      out.contact.displacement_A += pull;
      out.contact.energy_A2 += 0.5 * deep * deep;
      out.torque_A2 += glm::cross(arm, pull);
    }
    return out;
  }
};

// A spring that holds the body upright and not in its place; on its way back it pulls `honest` times as hard.
class Torsion final : public test::WithoutMemory<Interaction> {
 public:
  explicit Torsion(double honest) : honest_(honest) {}
  Response respond(const PoseA& pose) noexcept override {
    Response out;
    out.contact.scp = pose.place;
    const Vec3 angle = rotationBetween(kNoRotation, pose.orientation);
    const bool back = glm::length(angle) < glm::length(last_);
    last_ = angle;
    out.torque_A2 = angle * (-kStiff_A2 * (back ? honest_ : 1.0));
    out.contact.energy_A2 = 0.5 * kStiff_A2 * glm::dot(angle, angle);
    return out;
  }

 private:
  static constexpr double kStiff_A2 = 20.0;
  double honest_;
  Vec3 last_{0.0};
};

// An Omni that could also turn the hand, and whose motors never get warm.
DeviceSpecs turning() {
  DeviceSpecs specs = shownForceFigures();
  specs.dof_in = specs.dof_out = 6;
  specs.gives_force = true;
  specs.max_torque_N_mm = 400.0;
  return specs;
}

struct Hand {
  explicit Hand(const DeviceSpecs& specs) : step(specs) { settings.stiffness_N_per_mm = 0.3; }
  ServoSample at(Interaction& felt, Vec3 mm, const Quat& orientation, int ticks = 1) {
    ServoSample last;
    for (int k = 0; k < ticks; ++k) last = step.tick(settings, &felt, {.position = {mm}, .orientation = orientation});
    return last;
  }
  /// Goes there in small steps, so that no limit of speed acts.
  ServoSample to(Interaction& felt, Vec3 mm, const Quat& orientation, int ticks = 1200) {
    const Vec3 from = here, angle = rotationBetween(turned, orientation);
    const Quat turned_from = turned;
    for (int k = 1; k <= ticks; ++k) {
      const double part = double(k) / ticks, size = glm::length(angle);
      here = from + (mm - from) * part;
      turned = size > 0 ? glm::normalize(glm::angleAxis(part * size, angle / size) * turned_from) : turned_from;
      at(felt, here, turned);
    }
    return at(felt, here, turned, 700);
  }
  ServoStep step;
  ServoSettings settings;
  Vec3 here{0, 0, 20};
  Quat turned = kNoRotation;
};

const Quat kTilted = glm::angleAxis(0.4, Vec3(0, 1, 0));

}  // namespace

TEST_CASE(
    "a bar pressed flat 0.5 A deep is pushed out by both springs and not turned; tilted by 0.4 rad it is turned back "
    "by "
    "the lower one") {
  Bar bar;
  Hand hand(turning());
  const double k = 0.3, s = hand.settings.workspace.A_per_mm;
  const ServoSample flat = hand.to(bar, {0, 0, -0.5 / s}, kNoRotation);
  CHECK(flat.force.N.z == doctest::Approx(k / s * 2 * 0.5).epsilon(1e-9));
  CHECK(glm::length(flat.torque_N_mm) < 1e-9);
  // After a rotation about y, the end on +x moves down by 2 A sin 0.4; the other end moves up and out.
  const ServoSample tilted = hand.to(bar, {0, 0, -0.5 / s}, kTilted);
  const double down = Bar::kArm_A * std::sin(0.4), deep = 0.5 + down, across = Bar::kArm_A * std::cos(0.4);
  REQUIRE(down > 0.5);
  CHECK(tilted.force.N.z == doctest::Approx(k / s * deep).epsilon(1e-9));
  CHECK(tilted.torque_N_mm.y == doctest::Approx(-k / (s * s) * across * deep).epsilon(1e-9));  // (across, 0, -down) x z
  CHECK(std::abs(tilted.torque_N_mm.x) + std::abs(tilted.torque_N_mm.z) < 1e-9);
  CHECK_FALSE(tilted.limits.any());
}

TEST_CASE("a device that drives three degrees of freedom is given the same force and no torque") {
  Bar bar;
  DeviceSpecs specs = turning();
  Hand whole(specs);
  specs.dof_out = 3;
  Hand point(specs);
  const ServoSample a = whole.to(bar, {0, 0, -2}, kTilted), b = point.to(bar, {0, 0, -2}, kTilted);
  CHECK(a.force.N == b.force.N);
  CHECK(glm::length(a.torque_N_mm) > 5.0);
  CHECK(b.torque_N_mm == Vec3(0.0));
}

TEST_CASE("the molecule turned under the device turns pose, force and torque alike") {
  Bar bar;
  Hand upright(turning()), turned(turning());
  // The device's z is the molecule's x there: a hand that comes along -y of the device comes along -z of the molecule.
  turned.settings.workspace.rotation = glm::dmat3(Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0));
  turned.here = {0, 20, 0};
  const ServoSample a = upright.to(bar, {0, 0, -2}, kTilted);
  const Quat frame = glm::quat_cast(turned.settings.workspace.rotation);
  turned.turned = glm::conjugate(frame);  // so that the bar lies as for the other
  turned.step.tick(turned.settings, nullptr, {.position = {turned.here}, .orientation = turned.turned});
  const ServoSample b = turned.to(bar, {0, -2, 0}, glm::conjugate(frame) * kTilted);
  CHECK(glm::distance(turned.settings.workspace.rotation * b.force.N, a.force.N) < 1e-9);
  CHECK(glm::distance(turned.settings.workspace.rotation * b.torque_N_mm, a.torque_N_mm) < 1e-7);
  CHECK(glm::length(a.torque_N_mm) > 5.0);
}

TEST_CASE("what the bar stores falls by the work of its force and of its torque") {
  Bar bar;
  const auto pose = [](double t) {
    return PoseA{{Vec3(0.3 * t, 0.1, -0.6 - 0.2 * std::sin(t))},
                 glm::angleAxis(0.5 * std::sin(0.7 * t), Vec3(0, 1, 0))};
  };
  double worked = 0;
  const double begun = bar.respond(pose(0)).contact.energy_A2;
  constexpr int kSteps = 20'000;
  for (int n = 0; n < kSteps; ++n) {
    const PoseA a = pose(6.0 * n / kSteps), b = pose(6.0 * (n + 1) / kSteps);
    const Response ra = bar.respond(a), rb = bar.respond(b);
    worked += 0.5 * glm::dot(ra.contact.displacement_A + rb.contact.displacement_A, b.place.A - a.place.A) +
              0.5 * glm::dot(ra.torque_A2 + rb.torque_A2, rotationBetween(a.orientation, b.orientation));
  }
  CHECK(begun - bar.respond(pose(6)).contact.energy_A2 == doctest::Approx(worked).epsilon(1e-5));
}

TEST_CASE(
    "force and torque are cut together to the device's greatest, and both come softly, change by no more than the slew "
    "and end in the tick of a fault") {
  Bar bar;
  DeviceSpecs specs = turning();
  specs.max_torque_N_mm = 10.0;
  Hand hand(specs);
  double torque = 0, most_change = 0;
  Vec3 last(0.0);
  for (int k = 0; k < 1500; ++k) {
    const double z = std::max(-4.0, 10.0 - 0.02 * k);
    const ServoSample s = hand.at(bar, {0, 0, z}, kTilted);
    torque = glm::length(s.torque_N_mm);
    most_change = std::max(most_change, glm::length(s.torque_N_mm - last));
    last = s.torque_N_mm;
    CHECK(torque <= 10.0 + 1e-9);
    if (k < 400) CHECK(torque <= 10.0 * (k + 1) / 500.0 + 1e-9);
  }
  CHECK(torque == doctest::Approx(10.0));
  CHECK(most_change <= 10.0 / 3.3 + 1e-9);
  const ServoSample cut = hand.at(bar, {0, 0, -4}, kTilted);
  CHECK(cut.limits.has(Limit::Clamp));
  // With its middle 1 A deep both ends press, by 1 A more and less than 2 A sin 0.4: lever and force keep their ratio.
  const double lever_A = Bar::kArm_A * std::cos(0.4) * Bar::kArm_A * std::sin(0.4) / 1.0;
  CHECK(cut.torque_N_mm.y / cut.force.N.z ==
        doctest::Approx(-lever_A / hand.settings.workspace.A_per_mm).epsilon(1e-6));
  hand.settings.panic = true;
  const ServoSample stopped = hand.at(bar, {0, 0, -4}, kTilted);
  CHECK(stopped.force.N == Vec3(0.0));
  CHECK(stopped.torque_N_mm == Vec3(0.0));
}

TEST_CASE("a hand that is turned by 1 rad in a tick, or by an invalid rotation, gets no force in that tick") {
  const Quat bad[] = {glm::angleAxis(1.4, Vec3(0, 1, 0)), Quat(std::nan(""), 0, 0, 0), Quat(0, 0, 0, 0),
                      Quat(2, 0, 0, 0)};
  for (const Quat& q : bad) {
    Bar bar;
    Hand hand(turning());
    CHECK(glm::length(hand.to(bar, {0, 0, -2}, kTilted).torque_N_mm) > 5.0);
    const ServoSample s = hand.at(bar, {0, 0, -2}, q);
    CHECK(s.force.N == Vec3(0.0));
    CHECK(s.torque_N_mm == Vec3(0.0));
    CHECK((s.limits.has(Limit::Jump) || s.limits.has(Limit::NotFinite)));
    CHECK(glm::length(hand.at(bar, {0, 0, -2}, kTilted).torque_N_mm) < 0.1);  // and it comes back softly
  }
}

TEST_CASE(
    "a torsion spring turned to and fro 60 times is not cut; one that pulls three times as hard on the way back, which "
    "would give the hand 2.9 J, is braked to less than 0.1 mJ") {
  for (const int dof_out : {3, 6})
    for (const bool dishonest : {false, true}) {
      if (dishonest && dof_out == 3) continue;  // nothing is given
      Torsion spring(dishonest ? 3.0 : 1.0);
      DeviceSpecs specs = turning();
      specs.dof_out = dof_out;
      specs.delay_s = 0.0;
      Hand hand(specs);
      hand.at(spring, {0, 0, 0}, kNoRotation, 700);
      int cuts = 0;
      double greatest = 0, worked_J = 0, before = 0;
      Vec3 held(0.0);
      for (int k = 0; k < 60'000; ++k) {
        const double angle = 0.5 * std::sin(0.00628318 * k);  // one turn to and fro a second
        const ServoSample s = hand.at(spring, {0, 0, 0}, glm::angleAxis(angle, Vec3(0, 0, 1)));
        cuts += s.limits.has(Limit::EnergyCut);
        worked_J += 1e-3 * held.z * (angle - std::exchange(before, angle));
        held = s.torque_N_mm;
        greatest = std::max(greatest, glm::length(s.torque_N_mm));
      }
      CAPTURE(dishonest);
      CHECK((dof_out == 6 ? greatest > 20.0 : greatest == 0.0));
      CHECK(worked_J < 1e-4);
      CHECK(cuts == 0);
    }
}
