#include "engine/bench/stability_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/bench/script.h"
#include "engine/core/sphere_intersections.h"

namespace moltact::bench {
namespace {

constexpr std::size_t kHeld = 500;
const Vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

double grownRadius(const scenes::Scene& s, std::size_t k) { return s.spheres[k].radius_A + s.probe_A; }

SphereCircle creaseOf(const scenes::Scene& bond) {
  return *circleOf(inflated(bond.spheres[0], bond.probe_A), inflated(bond.spheres[1], bond.probe_A));
}

// A pressed walk over the surface, then a hold.
StabilityScene walked(std::string name, std::string question, scenes::Scene scene, std::uint64_t seed) {
  Script script(scenes::walk(scene, 1, seed, 0.008).front());
  script.path(scenes::walk(scene, 4000, seed, 0.008)).hold(kHeld);
  StabilityScene out{std::move(name), std::move(question), std::move(scene)};
  out.held_ticks = kHeld;
  out.script = std::move(script.ticks);
  return out;
}

std::vector<StabilityScene> creases() {
  const scenes::Scene bond = scenes::bond();
  const SphereCircle circle = creaseOf(bond);
  const double x = circle.centre_A.x, r = circle.radius_A;
  const Vec3 middle(x, 0, 0);

  StabilityScene along{"crease, along", "Does the force stay even along the seam of two spheres?", bond};
  along.script =
      Script(middle + kY * (r + 0.5)).to(middle + kY * (r - 0.7)).arc(middle, kY, kZ, r - 0.7, 0, 1).hold(kHeld).ticks;
  along.held_ticks = kHeld;

  StabilityScene across{"crease, across", "Does the SCP pass from sphere to circle to sphere without a jump?", bond};
  Script over(middle + kY * (r + 0.6) - kX);
  for (int k = 0; k < 4; ++k) over.to(middle + kY * (r - 0.8) - kX).to(middle + kY * (r - 0.8) + kX);
  across.script = over.hold(kHeld).ticks;
  across.held_ticks = kHeld;
  return {along, across};
}

StabilityScene pit() {
  const scenes::Scene scene = scenes::pit();
  const double side = scene.spheres[1].centre_A.x, R = grownRadius(scene, 0);
  const Vec3 bottom(side / 2, side * std::sqrt(3.0) / 6, std::sqrt(R * R - side * side / 3));
  StabilityScene out{"pit of three", "Does the SCP rest in the point and leave it over the right circle?", scene};
  out.script = Script(bottom + kZ * 1.2)
                   .to(bottom - kZ * 0.9)
                   .hold(200)
                   .to(bottom - kZ * 0.9 + kX * 0.6)
                   .arc(bottom - kZ * 0.9, kX, kY, 0.6, 0, 2)
                   .to(bottom - kZ * 0.9)
                   .hold(kHeld)
                   .ticks;
  out.held_ticks = kHeld;
  return out;
}

// Sliding over the seam where two spheres touch or nearly touch.
StabilityScene seam(std::string name, scenes::Scene scene) {
  const double R = grownRadius(scene, 0);
  StabilityScene out{std::move(name), "Does a seam without width hold or trip the HIP?", std::move(scene)};
  out.script = Script(Vec3(R - 1.6, R + 0.4, 0.1))
                   .to({R - 1.6, 1.9, 0.1})
                   .to({R - 0.05, 0.9, 0.1})
                   .to({R + 1.6, 1.9, 0.1})
                   .to({R + 0.05, 0.4, -0.1})
                   .to({R - 1.6, 1.9, 0})
                   .to({R, 0.3, 0})
                   .hold(kHeld)
                   .ticks;
  out.held_ticks = kHeld;
  return out;
}

StabilityScene hole(double slack_A) {
  const scenes::Scene scene = scenes::ring(6, slack_A);
  const bool open = slack_A > 0;
  StabilityScene out{open ? "ring, hole larger than the probe" : "ring, hole smaller than the probe",
                     open ? "Does the probe get through a hole that is wide enough by 0.05 A?"
                          : "Does a hole too narrow by 0.05 A hold the probe?",
                     scene};
  out.script = Script(Vec3(0.013, 0.007, 4)).to({0.013, 0.007, open ? -4 : -1.2}).hold(kHeld).ticks;
  out.held_ticks = kHeld;
  return out;
}

StabilityScene tunnel() {
  scenes::Scene scene{"tunnel", {}};
  for (int k = 0; k < 10; ++k) {
    const scenes::Scene one = scenes::ring(12, 0.05);
    for (Sphere b : one.spheres) {
      const double turn = k % 2 ? std::numbers::pi / 12 : 0.0, c = std::cos(turn), s = std::sin(turn);
      b.centre_A = {c * b.centre_A.x - s * b.centre_A.y, s * b.centre_A.x + c * b.centre_A.y, -1.0 * k};
      scene.spheres.push_back(b);
    }
  }
  StabilityScene out{"tunnel that just fits",
                     "Does the probe pass a tunnel 0.05 A wider than itself, the hand trembling?", scene};
  Script script(Vec3(0, 0, 4));
  for (int k = 1; k <= 2600; ++k) {
    const double t = 0.02 * k;
    script.ticks.push_back({Vec3(0.2 * std::sin(t), 0.2 * std::cos(1.3 * t) - 0.2, 4 - 0.007 * k)});
  }
  out.script = std::move(script.ticks);
  return out;
}

StabilityScene graze() {
  const scenes::Scene scene = scenes::oneSphere();
  const double R = grownRadius(scene, 0);
  StabilityScene out{"thin graze", "Is a touch of 0.02 A felt, and let go of cleanly?", scene};
  Script script(Vec3(-2.0, R - 0.02, 0.01));
  out.script = script.to({2.0, R - 0.02, 0.01}, 0.01).to({-2.0, R - 0.02, 0.02}, 0.03).ticks;
  out.hand = false;
  return out;
}

StabilityScene passes(std::uint64_t seed) {
  const scenes::Scene scene = scenes::cluster(20, seed);
  StabilityScene out{"passes at 0.05 to 12 A a tick", "Is no sphere missed, however fast the HIP comes?", scene};
  // Each pass restarts outside: if the SCP were left behind, two answers would be correct.
  scenes::Random random(seed);
  Script script(Vec3(60, 0, 0));
  Vec3 low(1e300), high(-1e300);
  for (const Sphere& b : scene.spheres) low = glm::min(low, b.centre_A), high = glm::max(high, b.centre_A);
  for (int pass = 0; pass < 40; ++pass) {
    const double step = 0.05 * std::pow(240.0, random.uniform(0, 1));
    const Vec3 direction = random.direction(), aim = 0.5 * (low + high) + random.direction() * random.uniform(0, 3);
    script.ticks.push_back({aim - direction * 14.0});
    script.last().reset = true;
    script.to(aim + direction * 14.0, step);
  }
  out.script = std::move(script.ticks);
  out.hand = out.energy = out.jump = false;
  return out;
}

StabilityScene startInside() {
  const scenes::Scene scene = scenes::bond();
  StabilityScene out{"start inside", "Is there no force until the HIP has been outside once, and a sound one then?",
                     scene};
  out.script = Script(Vec3(0.3, 0.2, 0)).hold(200).to({0.3, 4.2, 0}).to({0.3, 2.4, 0}).hold(kHeld).ticks;
  out.held_ticks = kHeld;
  return out;
}

StabilityScene onCentre() {
  const scenes::Scene scene = scenes::bond();
  const double x = creaseOf(scene).centre_A.x;
  StabilityScene out{"HIP on a centre and on an axis", "Is the force finite and steady where all directions are alike?",
                     scene};
  // Exactly onto the first centre, along the axis through both, and back.
  Script script(Vec3(0, 4, 0));
  script.to({0, 0, 0}, 0.02)
      .hold(20)
      .to({scene.spheres[1].centre_A.x, 0, 0}, 0.02)
      .hold(20)
      .to({x, 0, 0}, 0.02)
      .to({x, 4, 0}, 0.02);
  out.script = std::move(script.ticks);
  out.hand = out.jump = false;
  return out;
}

StabilityScene deep(std::uint64_t seed) {
  const scenes::Scene scene = scenes::cluster(20, seed);
  StabilityScene out{"deeper than a radius",
                     "Does the SCP keep its place on the surface while the HIP crosses several spheres?", scene};
  Script script(Vec3(14, 0.3, 0.2));
  const double edge = std::cbrt(200.0) / 2;
  const Vec3 middle(edge);
  script.ticks.front().place_A = middle + Vec3(14, 0.3, 0.2);
  script.to(middle + Vec3(1.0, 0.3, 0.2), 0.02)
      .to(middle + Vec3(0.5, 1.6, -0.7), 0.02)
      .to(middle + Vec3(-1.0, -0.8, 0.9), 0.02)
      .to(middle + Vec3(1.0, 0.3, 0.2), 0.02)
      .to(middle + Vec3(14, 0.3, 0.2), 0.02);
  out.script = std::move(script.ticks);
  out.hand = false;
  return out;
}

StabilityScene disturbed(std::uint64_t seed) {
  const scenes::Scene scene = scenes::cluster(20, seed);
  StabilityScene out{"NaN, late, lost and doubled ticks", "Does a disturbed clock or reading leave no mark?", scene};
  Script script(scenes::walk(scene, 1, seed, 0.008).front());
  script.path(scenes::walk(scene, 4000, seed, 0.008));
  scenes::Random random(seed);
  for (StabilityTick& t : script.ticks) {
    const double dice = random.uniform(0, 1);
    t.fault = dice < 0.01   ? LoopFault::NotANumber
              : dice < 0.03 ? LoopFault::Lost
              : dice < 0.05 ? LoopFault::Doubled
              : dice < 0.07 ? LoopFault::Late
                            : LoopFault::None;
  }
  out.script = std::move(script.ticks);
  out.energy = false;
  return out;
}

StabilityScene teleports(std::uint64_t seed) {
  const scenes::Scene scene = scenes::cluster(20, seed);
  StabilityScene out{"teleports", "Does the SCP stay on the surface when the HIP jumps anywhere?", scene};
  Script script(Vec3(40, 0, 0));
  out.script = script.path(scenes::jumps(scene, 2000, seed)).ticks;
  out.hand = out.energy = out.jump = false;
  return out;
}

StabilityScene probeChanges() {
  const scenes::Scene scene = scenes::bond();
  StabilityScene out{"probe changed while touching",
                     "Does the surface carry the finger along when the probe grows and shrinks?", scene};
  Script script(Vec3(0.5, 4, 0));
  script.to({0.5, 2.2, 0.1});
  for (int k = 0; k < 600; ++k) {
    script.hold(1);
    script.last().probe_A = 1.4 + 0.6 * std::sin(0.013 * k);
  }
  script.hold(1).last().probe_A = 0.7;
  script.hold(100).last().probe_A = 2.1;
  script.hold(100).last().probe_A = 1.4;
  out.script = script.hold(int(kHeld)).ticks;
  out.held_ticks = kHeld;
  out.energy = out.jump = false;
  return out;
}

StabilityScene swapped() {
  StabilityScene out{"molecule swapped while touching",
                     "Is there no blow when the molecule under the finger is another one?", scenes::bond(),
                     scenes::pit()};
  Script script(Vec3(0.5, 4, 0));
  script.to({0.5, 2.2, 0.1}).hold(200);
  script.last().swap = true;
  out.script = script.hold(200).to({0.5, 4.2, 4}).to({1.2, 1.0, 1.8}).hold(int(kHeld)).ticks;
  out.held_ticks = kHeld;
  out.energy = out.jump = false;
  return out;
}

}  // namespace

std::vector<StabilityScene> stabilityScenes(std::uint64_t seed) {
  std::vector<StabilityScene> out = creases();
  out.push_back(pit());
  out.push_back(seam("touching in one point", scenes::touching()));
  out.push_back(seam("overlapping by a hair", scenes::barelyOverlapping()));
  out.push_back(walked("lattice, eight through a point", "Do many spheres through one point leave one answer?",
                       scenes::simpleCubic(3), seed + 1));
  out.push_back(walked("cubane-like", "The same on eight atoms of a cube.", scenes::cube(), seed + 2));
  out.push_back(walked("fullerene-like", "The same on sixty atoms of a shell.", scenes::shell(), seed + 3));
  out.push_back(hole(-0.05));
  out.push_back(hole(0.05));
  out.push_back(tunnel());
  out.push_back(graze());
  out.push_back(passes(seed + 4));
  out.push_back(startInside());
  out.push_back(walked("nested spheres", "Do spheres inside others stay unfelt?", scenes::nested(), seed + 5));
  out.push_back(
      walked("duplicate spheres", "Is an atom that is there twice felt once?", scenes::duplicates(), seed + 6));
  out.push_back(onCentre());
  out.push_back(deep(seed + 7));
  out.push_back(teleports(seed + 8));
  out.push_back(disturbed(seed + 9));
  out.push_back(probeChanges());
  out.push_back(swapped());
  scenes::Scene far = scenes::shifted(scenes::cluster(20, seed + 10), Vec3(1e6, -1e6, 1e6), "a million angstroms away");
  out.push_back(
      walked("a million A from the origin", "Do digits run out far from the origin?", std::move(far), seed + 10));
  for (StabilityScene& scene : movingScenes()) out.push_back(std::move(scene));
  for (StabilityScene& scene : frictionScenes(seed)) out.push_back(std::move(scene));
  return out;
}

bool StabilityScene::rough() const {
  return friction.coefficient > 0 ||
         std::any_of(script.begin(), script.end(), [](const StabilityTick& t) { return t.friction >= 0; });
}

StabilityScene turned(StabilityScene scene, std::uint64_t seed) {
  scenes::Random random(seed);
  const Vec3 z = random.direction(), x = glm::normalize(glm::cross(z, random.direction())), y = glm::cross(z, x);
  const Vec3 middle = middleOf(scene.scene);
  const auto turn = [&](Vec3& place) {
    const Vec3 p = place - middle;
    place = middle + x * p.x + y * p.y + z * p.z;
  };
  for (Sphere& b : scene.scene.spheres) turn(b.centre_A);
  if (scene.second)
    for (Sphere& b : scene.second->spheres) turn(b.centre_A);
  for (StabilityMotion& m : scene.motions)
    for (Sphere& b : m.to) turn(b.centre_A);
  for (StabilityTick& t : scene.script) turn(t.place_A);
  return scene;
}

std::vector<StabilityScene> drawnScenes(std::uint64_t seed, std::size_t draw) {
  if (draw == 0) return stabilityScenes(seed);
  std::vector<StabilityScene> out = stabilityScenes(seed + draw);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = turned(std::move(out[k]), 1000 * (seed + draw) + k);
  return out;
}

Vec3 middleOf(const scenes::Scene& scene) {
  Vec3 low(1e300), high(-1e300);
  for (const Sphere& b : scene.spheres) low = glm::min(low, b.centre_A), high = glm::max(high, b.centre_A);
  return 0.5 * (low + high);
}

}  // namespace moltact::bench
