// The scenes of stability_scenes.h in which the surface moves, or has friction.
#include <cmath>

#include "engine/bench/script.h"
#include "engine/bench/stability_scenes.h"
#include "engine/core/sphere_intersections.h"

namespace moltact::bench {
namespace {

constexpr std::size_t kHeldMoving = 500;
constexpr int kSettling = 1000;  // ticks in which a contact that has just slipped comes to rest
constexpr double kCarbon_A = 1.7;

// 5 by 5 carbons in the plane of u and v about `middle`.
void addPlate(std::vector<Sphere>& out, const Vec3& middle, const Vec3& u, const Vec3& v, double apart_A = 2.0) {
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) out.push_back({middle + apart_A * (double(i) * u + double(j) * v), kCarbon_A});
}

std::vector<Sphere> movedBy(std::vector<Sphere> spheres, const Vec3& way) {
  for (Sphere& s : spheres) s.centre_A += way;
  return spheres;
}

// Composes script and motions together.
class MovingScript {
 public:
  MovingScript(StabilityScene& scene, const Vec3& start) : scene_(scene), script_(start) {}
  MovingScript& to(const Vec3& place, double step_A = 0.008) {
    script_.to(place, step_A);
    return *this;
  }
  MovingScript& hold(int ticks) {
    script_.hold(ticks);
    return *this;
  }
  // The spheres go to `to` while the hand's target goes straight to `hand` (by default it stays).
  MovingScript& move(std::vector<Sphere> to, int ticks) { return move(std::move(to), ticks, last().place_A); }
  MovingScript& move(std::vector<Sphere> to, int ticks, const Vec3& hand) {
    const Vec3 from = last().place_A;
    for (int k = 1; k <= ticks; ++k) {
      script_.ticks.push_back({from + (hand - from) * (double(k) / ticks)});
      if (k == 1) last().motion = int(scene_.motions.size());
    }
    scene_.motions.push_back({std::move(to), ticks});
    return *this;
  }
  StabilityTick& last() { return script_.last(); }
  StabilityScene& done() {
    script_.hold(int(kHeldMoving));
    scene_.held_ticks = kHeldMoving;
    scene_.script = std::move(script_.ticks);
    return scene_;
  }

 private:
  StabilityScene& scene_;
  Script script_;
};

StabilityScene named(std::string name, std::string question, std::vector<Sphere> spheres) {
  StabilityScene out{name, std::move(question), scenes::Scene{name, std::move(spheres)}};
  return out;
}

StabilityScene wallThatComes() {
  std::vector<Sphere> wall;
  addPlate(wall, Vec3(0.0), Vec3(1, 0, 0), Vec3(0, 1, 0));
  StabilityScene out = named(
      "a wall that comes", "Does a wall that moves against a resting hand push it along, and let it go cleanly?", wall);
  MovingScript script(out, {0.4, 0.3, 4.2});
  const Vec3 up(0, 0, 2.5), aside(1.7, 0.6, 2.5);
  script.hold(50).move(movedBy(wall, up), 250).hold(200).move(movedBy(wall, aside), 300).hold(100);
  script.move(movedBy(wall, Vec3(1.7, 0.6, -1.0)), 150).hold(200).move(movedBy(wall, Vec3(0, 0, 2.0)), 900);
  return script.done();
}

StabilityScene vanishingAtom() {
  std::vector<Sphere> spheres;
  addPlate(spheres, Vec3(0.0), Vec3(1, 0, 0), Vec3(0, 1, 0));
  spheres.push_back({Vec3(0, 0, 2.6), kCarbon_A});
  std::vector<Sphere> gone = spheres;
  gone.back().centre_A.z = -200.0;
  StabilityScene out = named("an atom that vanishes",
                             "Does the force end with the atom, and is the surface below it felt then?", spheres);
  MovingScript script(out, {0.2, 0.1, 6.5});
  script.to({0.2, 0.1, 4.8}).hold(300).move(std::move(gone), 1).hold(300).to({0.2, 0.1, 2.2});
  return script.done();
}

StabilityScene closingHinge() {
  // Two plates of 5 by 5 carbons that meet in the y-axis, each this far from the middle plane (unit: radian).
  const auto hinge = [](double half_angle) {
    std::vector<Sphere> out;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 along(std::cos(half_angle), 0, side * std::sin(half_angle));
      addPlate(out, 6.0 * along, along, Vec3(0, 1, 0), 2.2);
    }
    return out;
  };
  constexpr double kOpen = 1.05, kClosed = 0.62;
  StabilityScene out = named("a hinge that closes on the hand",
                             "Is a probe between two closing walls pressed out, and not through?", hinge(kOpen));
  MovingScript script(out, {9.0, 0.3, 0.1});
  script.to({3.2, 0.3, 0.1}).hold(100);
  // Rotations in straight pieces of two degrees.
  const auto turn = [&](double from, double to, int pieces, int ticks) {
    for (int k = 1; k <= pieces; ++k) script.move(hinge(from + (to - from) * k / pieces), ticks);
  };
  turn(kOpen, kClosed, 12, 70);
  script.hold(200);
  turn(kClosed, kOpen, 12, 35);
  script.hold(100);
  turn(kOpen, kClosed, 12, 35);
  return script.done();
}

StabilityScene pulledAtom() {
  std::vector<Sphere> spheres;
  addPlate(spheres, Vec3(0.0), Vec3(1, 0, 0), Vec3(0, 1, 0));
  const std::size_t atom = spheres.size();
  spheres.push_back({Vec3(0, 0, 1.6), kCarbon_A});
  std::vector<Sphere> pulled = spheres;
  pulled[atom].centre_A = Vec3(0.6, 0.3, 4.6);
  StabilityScene out = named("a pulled atom let go at 10 N/A",
                             "Does the pull end with the grip, and is the atom felt again where it has gone?", spheres);
  out.stiffness_N_per_mm = 2.5;  // 10 N/A at 0.25 A/mm
  out.energy = false;            // the grip is not the method's
  MovingScript script(out, {0.1, 0.1, 5.5});
  script.to({0.1, 0.1, 4.6}).hold(100);
  script.hold(1).last().take = int(atom);
  // The hand is ahead of the atom by the way that 2 N stretch its own spring.
  script.move(pulled, 400, {0.7, 0.4, 9.0}).hold(200);
  script.hold(1).last().let_go = true;
  // Back within the time constant with which the program follows a simulation.
  script.move(spheres, 40, {0.7, 0.4, 9.0}).hold(300).to({0.1, 0.1, 4.5}, 0.016);
  return script.done();
}

StabilityScene rough(std::string name, std::string question, scenes::Scene scene, const Friction& friction) {
  StabilityScene out{std::move(name), std::move(question), std::move(scene)};
  out.friction = friction;
  out.held_ticks = kHeldMoving;
  return out;
}

// Straight to and fro across the crease of two atoms, pressed.
StabilityScene roughCrease() {
  const scenes::Scene bond = scenes::bond();
  const SphereCircle circle =
      *circleOf(inflated(bond.spheres[0], bond.probe_A), inflated(bond.spheres[1], bond.probe_A));
  const Vec3 over = circle.centre_A + Vec3(0, circle.radius_A - 0.8, 0), half(1.2, 0, 0.3);
  StabilityScene out =
      rough("friction of 0.5, across a crease",
            "Does a contact slide evenly over a crease, and is the drag only taken from the hand?", bond, {0.5, 0.0});
  Script script(over - half + Vec3(0, 1.4, 0));
  script.to(over - half);
  for (int k = 0; k < 3; ++k) script.to(over + half).to(over - half);
  out.script = script.hold(int(kHeldMoving)).ticks;
  return out;
}

StabilityScene stickAndSlip() {
  const scenes::Scene bond = scenes::bond();
  const SphereCircle circle =
      *circleOf(inflated(bond.spheres[0], bond.probe_A), inflated(bond.spheres[1], bond.probe_A));
  const Vec3 middle = circle.centre_A;
  StabilityScene out =
      rough("sticks and slips round a bond", "Does a contact that sticks and slips come to rest, and make no energy?",
            bond, {0.4, 0.5});
  const double r = circle.radius_A - 0.6;
  const Vec3 aside(0.5, 0, 0);
  Script script(middle + aside + Vec3(0, r + 1.1, 0));
  script.to(middle + aside + Vec3(0, r, 0)).arc(middle + aside, Vec3(0, 1, 0), Vec3(0, 0, 1), r, 0, 1);
  out.script = script.hold(kSettling).hold(int(kHeldMoving)).ticks;
  return out;
}

StabilityScene roughWalk(std::uint64_t seed) {
  StabilityScene out = rough("friction of 0.3 on 20 atoms", "The same over many creases and pits.",
                             scenes::cluster(20, seed), {0.3, 0.0});
  Script script(scenes::walk(out.scene, 1, seed, 0.008).front());
  script.path(scenes::walk(out.scene, 4000, seed, 0.008)).hold(int(kHeldMoving));
  out.script = std::move(script.ticks);
  return out;
}

StabilityScene changedFriction() {
  const scenes::Scene sphere = scenes::oneSphere();
  StabilityScene out =
      rough("friction changed under the hand",
            "Does the contact stick and slip without a blow when the coefficient rises and falls?", sphere, {0.0, 0.0});
  out.energy = false;
  const double R = sphere.spheres[0].radius_A + sphere.probe_A;
  Script script(Vec3(-1.5, 0.2, R + 0.5));
  script.to({-1.5, 0.2, 1.9});
  for (int k = 0; k < 1200; ++k) {
    const double t = kTwoPi * k / 1200.0;
    script.ticks.push_back({Vec3(-1.5 * std::cos(t), 0.2, 1.9)});
    script.last().friction = 0.4 - 0.4 * std::cos(3.0 * t);
  }
  out.script = script.hold(kSettling).hold(int(kHeldMoving)).ticks;
  return out;
}

// A wall with friction takes a resting hand along.
StabilityScene carriedAlong() {
  std::vector<Sphere> wall;
  addPlate(wall, Vec3(0.0), Vec3(1, 0, 0), Vec3(0, 1, 0));
  StabilityScene out = named("a rough wall that slides away",
                             "Does a stuck contact go with its atoms until the drag is too much, and then slip?", wall);
  out.friction = {0.8, 0.0};
  MovingScript script(out, {0.4, 0.3, 4.2});
  script.to({0.4, 0.3, 2.0}).hold(100).move(movedBy(wall, Vec3(1.5, 0.4, 0)), 400).hold(100);
  script.move(movedBy(wall, Vec3(0.0)), 400).hold(100);
  return script.done();
}

}  // namespace

std::vector<StabilityScene> movingScenes() { return {wallThatComes(), vanishingAtom(), closingHinge(), pulledAtom()}; }

std::vector<StabilityScene> frictionScenes(std::uint64_t seed) {
  return {roughCrease(), stickAndSlip(), roughWalk(seed + 11), changedFriction(), carriedAlong()};
}

}  // namespace moltact::bench
