// The tracker of Algorithm 1: the three cases of Figure 4, agreement with the oracle where the algorithm is correct,
// and each of its known faults (docs/paper-algorithm.md), which are reproduced deliberately.
#include "engine/haptics/paper/paper_tracker.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/bench/oracle.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"

using namespace moltact;

namespace {

PaperTracker trackerOn(std::vector<Sphere> spheres, double probe_A = 0) {
  return PaperTracker(std::make_shared<const SphereGrid>(std::move(spheres)), probe_A);
}

// Moves the HIP in steps of 0.02 A or less and gives the last contact.
Contact slide(Tracker& tracker, Vec3 from, Vec3 to) {
  const int steps = int(glm::distance(from, to) / 0.02) + 1;
  Contact c;
  for (int k = 0; k <= steps; ++k) c = tracker.step({from + (to - from) * (double(k) / steps)});
  return c;
}

// Two spheres of radius 5, 6 apart: circle of radius 4 in the plane x = 0.
const std::vector<Sphere> kCrease{{{-3, 0, 0}, 5.0}, {{3, 0, 0}, 5.0}};

// Three spheres of radius 5 with centres 3 from the z axis: points 4 up and down it.
std::vector<Sphere> pitSpheres() {
  std::vector<Sphere> out;
  for (const double t : {0.0, 2.0943951023931953, 4.1887902047863905})
    out.push_back({{3 * std::cos(t), 3 * std::sin(t), 0}, 5.0});
  return out;
}

// A sphere of radius 5 with a wall of three small ones over its top, between the patches x < 0 and x > 0.
const std::vector<Sphere> kWall{{{0, 0, 0}, 5.0}, {{0, 0, 5}, 0.5}, {{0, 0.6, 5}, 0.5}, {{0, -0.6, 5}, 0.5}};

struct Agreement {
  int ticks = 0, same = 0;
};
Agreement agreement(const scenes::Scene& scene, const scenes::Path& path) {
  PaperTracker tracker = trackerOn(scene.spheres, scene.probe_A);
  oracle::Oracle judge(scene.spheres, scene.probe_A);
  Agreement out;
  for (const Vec3& hip : path) {
    const Contact c = tracker.step({hip});
    const auto right = judge.step(hip);
    if (!right.decided) continue;
    ++out.ticks;
    out.same += c.touching() == right.contact && glm::distance(c.scp.A, right.scp_A) < 1e-7;
  }
  return out;
}

}  // namespace

TEST_CASE("Figure 4, case 1: on the left sphere the SCP lies over the HIP at radius 5") {
  PaperTracker t = trackerOn(kCrease);
  t.step({{-3, 0, 6}});
  const Contact c = t.step({{-4, 0, 3}});
  CHECK(c.feature == Feature::Sphere);
  CHECK(c.atoms == std::array{0, -1, -1});
  CHECK(glm::distance(c.scp.A, Vec3(-3, 0, 0) + Vec3(-1, 0, 3) * (5 / std::sqrt(10.0))) < 1e-14);
}

TEST_CASE("Figure 4, case 2: under the crease the SCP lies on the circle of radius 4, across the base too") {
  PaperTracker t = trackerOn(kCrease);
  Contact c = slide(t, {-3, 0, 6}, {-0.5, 0, 2});
  CHECK(c.feature == Feature::Circle);
  CHECK(c.atoms == std::array{0, 1, -1});
  CHECK(glm::distance(c.scp.A, {0, 0, 4}) < 1e-14);
  c = slide(t, {-0.5, 0, 2}, {0.5, 1, 1});
  CHECK(c.feature == Feature::Circle);
  CHECK(glm::distance(c.scp.A, Vec3(0, 1, 1) * (4 / std::sqrt(2.0))) < 1e-14);
  c = slide(t, {0.5, 1, 1}, {4, 0, 2});
  CHECK(c.feature == Feature::Sphere);
  CHECK(c.atoms == std::array{1, -1, -1});
}

TEST_CASE(
    "Figure 4, case 3: in the pit of three spheres the SCP is the point 4 up the axis until a plane is "
    "crossed") {
  PaperTracker t = trackerOn(pitSpheres());
  Contact c = slide(t, {0.3, 0.1, 6}, {0.3, 0.1, 2});
  CHECK(c.feature == Feature::Point);
  CHECK(c.atoms == std::array{0, 1, 2});
  CHECK(glm::distance(c.scp.A, {0, 0, 4}) < 1e-13);
  // Outward between spheres 0 and 1: past the plane of their circle.
  c = slide(t, {0.3, 0.1, 2}, Vec3(0.5, std::sqrt(0.75), 0) * 2.0 + Vec3(0, 0, 2));
  CHECK(c.feature == Feature::Circle);
  CHECK(c.atoms == std::array{0, 1, -1});
  // Inward again, and out over sphere 2.
  slide(t, Vec3(0.5, std::sqrt(0.75), 0) * 2.0 + Vec3(0, 0, 2), {0, 0, 2});
  c = slide(t, {0, 0, 2}, Vec3(-0.5, -std::sqrt(0.75), 0) * 4.0 + Vec3(0, 0, 3));
  CHECK(c.feature == Feature::Sphere);
  CHECK(c.atoms == std::array{2, -1, -1});
}

TEST_CASE(
    "a walk of 0.02 A a tick on one sphere, a bond and a sphere touching another agrees with the oracle on every "
    "tick") {
  const std::uint64_t seed = 3;
  CAPTURE(seed);
  for (const auto& scene : {scenes::oneSphere(), scenes::bond(), scenes::touching(), scenes::barelyOverlapping()}) {
    CAPTURE(scene.name);
    const Agreement a = agreement(scene, scenes::walk(scene, 5000, seed));
    CHECK(a.ticks > 4900);
    CHECK(a.same == a.ticks);
  }
}

TEST_CASE(
    "ten times faster, 0.2 A a tick, more than 1 tick in 20 on a cluster of 50 atoms differs from the "
    "oracle") {
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  const auto scene = scenes::cluster(50, 3);
  const Agreement slow = agreement(scene, scenes::walk(scene, 5000, seed, 0.02));
  const Agreement fast = agreement(scene, scenes::walk(scene, 5000, seed, 0.2));
  CHECK(slow.same > 0.97 * slow.ticks);
  CHECK(fast.same < 0.95 * fast.ticks);
}

TEST_CASE("a walk of 0.02 A a tick in the pit of three carbons agrees with the oracle on 99 of 100 ticks") {
  const std::uint64_t seed = 4;
  CAPTURE(seed);
  const Agreement a = agreement(scenes::pit(), scenes::walk(scenes::pit(), 20000, seed));
  CHECK(a.ticks > 19000);
  CHECK(a.same > 0.99 * a.ticks);
}

TEST_CASE("fault kept: a HIP that leaves its sphere for the next in one tick has no contact for one tick") {
  PaperTracker t = trackerOn(kCrease);
  t.step({{-6, 0, 6}});
  CHECK(t.step({{-4, 0, 4}}).touching());
  const Contact between = t.step({{4, 0, 4}});  // 4.1 from the centre of the right sphere
  CHECK(oracle::deepest(kCrease, 0, {4, 0, 4}) > 0.8);
  CHECK_FALSE(between.touching());
  CHECK(between.scp.A == Vec3(4, 0, 4));
  CHECK(t.step({{4, 0, 4}}).atoms == std::array{1, -1, -1});
}

TEST_CASE("fault kept: a fast HIP jumps over a wall's circles, and both patches of the sphere are one state") {
  PaperTracker t = trackerOn(kWall);
  oracle::Oracle right(kWall, 0);
  for (const Vec3& hip : {Vec3(-2, 0.05, 6), Vec3(-2, 0.05, 4), Vec3(-1, 0.05, 4)}) {
    t.step({hip});
    right.step(hip);
  }
  const Contact c = t.step({{1.5, 0.05, 4}});
  CHECK(c.feature == Feature::Sphere);
  CHECK(c.atoms == std::array{0, -1, -1});
  CHECK(c.scp.A.x > 1.5);
  const auto held = right.step({1.5, 0.05, 4});
  CHECK(held.decided);
  CHECK(held.scp_A.x < 0);
}

TEST_CASE("fault kept: a HIP 4.9 A deep jumps over the wall at 0.05 A a tick, where its cones are 0.02 A wide") {
  PaperTracker t = trackerOn(kWall);
  slide(t, {-6, 0, 0.1}, {-0.0251, 0, 0.1});
  const Contact before = t.step({{-0.0251, 0, 0.1}}), after = t.step({{0.0249, 0, 0.1}});
  CHECK(before.feature == Feature::Sphere);
  CHECK(before.scp.A.x < -1);
  CHECK(after.feature == Feature::Sphere);
  CHECK(after.scp.A.x > 1);
}

TEST_CASE(
    "fault kept: a point more than epsilon from the SCP is missed, and the SCP sinks 0.6 A under the "
    "surface") {
  const auto spheres = pitSpheres();
  PaperTracker t = trackerOn(spheres);
  const Vec3 crease = Vec3(0.5, std::sqrt(0.75), 0) * 2.5;
  slide(t, crease + Vec3(0, 0, 5), crease + Vec3(0, 0, 3));
  const Vec3 under(-0.05, -0.0866, 2);  // in the point's volume, 2 A below it
  const Contact c = t.step({under});
  CHECK(c.feature == Feature::Circle);
  CHECK(glm::distance(c.scp.A, {0, 0, 4}) > PaperTracker::kEpsilon_A);
  CHECK(oracle::deepest(spheres, 0, c.scp.A) > 0.6);
  // The same way in small steps finds the point.
  PaperTracker slow = trackerOn(spheres);
  slide(slow, crease + Vec3(0, 0, 5), crease + Vec3(0, 0, 3));
  CHECK(slide(slow, crease + Vec3(0, 0, 3), under).feature == Feature::Point);
}

TEST_CASE(
    "fault kept: a circle behind the atom's centre is missed by a step to beside it, and the SCP is 0.5 A "
    "inside the neighbour") {
  // Radii 2 and 5, centres 4 apart: the circle, of radius 1.9, lies 0.625 behind the small sphere's centre.
  const std::vector<Sphere> spheres{{{0, 0, 0}, 2.0}, {{4, 0, 0}, 5.0}};
  PaperTracker t = trackerOn(spheres);
  t.step({{-3, 1.95, 0}});
  CHECK(t.step({{-1.2, 1.5, 0}}).atoms == std::array{0, -1, -1});
  const Contact c = t.step({{0, 1.95, 0}});
  CHECK(c.feature == Feature::Sphere);
  CHECK(c.atoms == std::array{0, -1, -1});
  CHECK(oracle::deepest(spheres, 0, c.scp.A) > 0.5);
}

TEST_CASE(
    "fault kept: a circle behind the atom's centre continues to hold the SCP where the HIP is over the free "
    "sphere") {
  // Radii 13 and 20, centres 11 apart: circle of radius 12, 5 behind the first centre. (-4.5, 9) lies under
  // the cap that the first sphere shows, for 4.5 / 9 is more than 5 / 12, but inside the second sphere's cone as
  // well.
  const std::vector<Sphere> spheres{{{0, 0, 0}, 13.0}, {{11, 0, 0}, 20.0}};
  PaperTracker t = trackerOn(spheres);
  oracle::Oracle right(spheres, 0);
  const auto both = [&](Vec3 from, Vec3 to) {
    for (int k = 0; k < 200; ++k) right.step(from + (to - from) * (k / 200.0));
    right.step(to);
    return slide(t, from, to);
  };
  both({-6, 13, 0}, {-4.5, 11, 0});
  const Contact c = both({-4.5, 11, 0}, {-4.5, 9, 0});
  CHECK(c.feature == Feature::Circle);
  CHECK(glm::distance(c.scp.A, {-5, 12, 0}) < 1e-13);
  const Vec3 over = Vec3(-4.5, 9, 0) * (13 / std::sqrt(101.25));
  CHECK(glm::distance(right.step({-4.5, 9, 0}).scp_A, over) < 1e-12);
  CHECK(glm::distance(c.scp.A, over) > 0.8);
}

TEST_CASE(
    "fault kept: a HIP pushed through a pit is out of contact on the far side, where the surface would hold "
    "it") {
  const auto spheres = pitSpheres();
  PaperTracker t = trackerOn(spheres);
  oracle::Oracle right(spheres, 0);
  oracle::Oracle::Answer held;
  Contact c;
  for (double z = 5; z > -5; z -= 0.02) {
    c = t.step({{0.3, 0.1, z}});
    held = right.step({0.3, 0.1, z});
  }
  CHECK(held.decided);
  CHECK(held.contact);
  CHECK(glm::distance(held.scp_A, {0, 0, 4}) < 1e-12);
  CHECK_FALSE(c.touching());
}

TEST_CASE(
    "fault kept: after a jump, buried circle and point hold the SCP 0.9 A inside a fourth sphere, tick after "
    "tick") {
  // The pit with its bottom filled by a sphere of radius 1 round the point (0, 0, 4), which is not on the
  // surface then.
  auto spheres = pitSpheres();
  spheres.push_back({{0, 0, 4}, 1.0});
  PaperTracker t = trackerOn(spheres);
  const Vec3 outward(0.5, std::sqrt(0.75), 0);  // between spheres 0 and 1
  Contact c = slide(t, outward * 2.5 + Vec3(0, 0, 5), outward * 2.5 + Vec3(0, 0, 3));
  CHECK(c.atoms == std::array{0, 1, -1});
  c = t.step({outward * 0.5 + Vec3(0, 0, 2.8)});
  for (int k = 0; k < 100; ++k) c = t.step({outward * (0.5 - 0.0002 * k) + Vec3(0, 0, 2.8)});
  CHECK(c.feature == Feature::Circle);
  CHECK(oracle::deepest(spheres, 0, c.scp.A) > 0.9);
  for (int k = 0; k < 100; ++k) c = t.step({outward * (0.48 - 0.002 * k) + Vec3(0, 0, 2.8)});
  CHECK(c.feature == Feature::Point);
  CHECK(c.atoms == std::array{0, 1, 2});
  CHECK(oracle::deepest(spheres, 0, c.scp.A) > 0.99);
}

TEST_CASE(
    "whatever the scene and path, probe changes included, the SCP is finite, named by its atoms, and the HIP "
    "when free") {
  const std::uint64_t seed = 21;
  CAPTURE(seed);
  for (const auto& scene : scenes::all(seed)) {
    CAPTURE(scene.name);
    PaperTracker t = trackerOn(scene.spheres, scene.probe_A);
    scenes::Random random(seed);
    bool good = true;
    int touching = 0;
    for (const auto& path :
         {scenes::walk(scene, 1000, seed), scenes::jumps(scene, 1000, seed), scenes::passes(scene, 500, seed)})
      for (std::size_t k = 0; k < path.size(); ++k) {
        if (k % 50 == 0) t.setProbe(k % 150 == 0 ? scene.probe_A : random.uniform(0, 3));
        const Contact c = t.step({path[k]});
        touching += c.touching();
        const auto& a = c.atoms;
        const int named = int(c.feature);  // Free 0, Sphere 1, Circle 2, Point 3
        good = good && std::isfinite(c.scp.A.x + c.scp.A.y + c.scp.A.z) && (c.touching() || c.scp.A == path[k]);
        for (int m = 0; m < 3; ++m)
          good = good && (m < named ? a[m] >= 0 && a[m] < int(scene.spheres.size()) : a[m] == -1);
        good = good && (named < 2 || a[0] < a[1]) && (named < 3 || a[1] < a[2]);
        // The SCP lies on every sphere it is said to be held by.
        for (int m = 0; m < named; ++m) {
          const Sphere& b = scene.spheres[std::size_t(a[m])];
          const double off = glm::distance(c.scp.A, b.centre_A) - b.radius_A - t.probe_A();
          good = good && std::abs(off) < (glm::length(path[k]) > 1e5 ? 1e-4 : 1e-6);
        }
        CAPTURE(k);
        REQUIRE(good);
      }
    CHECK(touching > 500);
  }
}

TEST_CASE("a HIP that starts inside gives StartedInside until it has been outside once, and again after a reset") {
  PaperTracker t = trackerOn(scenes::oneSphere().spheres, 1.4);
  CHECK(t.step({{0, 0, 1}}).fault == Fault::StartedInside);
  CHECK(t.step({{0, 0, 3}}).scp.A == Vec3(0, 0, 3));
  CHECK(t.step({{0, 0, 3.2}}).fault == Fault::None);
  CHECK(t.step({{0, 0, 3}}).touching());
  t.reset();
  CHECK(t.step({{0, 0, 3}}).fault == Fault::StartedInside);
}

TEST_CASE("a HIP that is not finite gives NotFinite and leaves the state as it was") {
  PaperTracker t = trackerOn(scenes::oneSphere().spheres, 1.4);
  t.step({{0, 0, 4}});
  const Contact before = t.step({{0, 0, 3}});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 2e9}) {
    const Contact c = t.step({{0, bad, 0}});
    CHECK(c.fault == Fault::NotFinite);
    CHECK_FALSE(c.touching());
    CHECK(std::isfinite(c.scp.A.y));
  }
  CHECK(t.step({{0, 0, 3}}).scp.A == before.scp.A);
}

TEST_CASE("a probe that grows from 1 to 1.5 carries sphere, circle and point along with the surface") {
  PaperTracker t = trackerOn(kCrease, 0);
  slide(t, {-3, 0, 6}, {-0.5, 0, 2});
  t.setProbe(std::sqrt(34.0) - 5);  // R^2 = 34: circle of radius 5
  Contact c = t.step({{-0.5, 0, 2}});
  CHECK(c.feature == Feature::Circle);
  CHECK(glm::distance(c.scp.A, {0, 0, 5}) < 1e-13);

  PaperTracker p = trackerOn(pitSpheres(), 0);
  slide(p, {0.3, 0.1, 6}, {0.3, 0.1, 2});
  p.setProbe(std::sqrt(34.0) - 5);  // the point is 5 up the axis
  c = p.step({{0.3, 0.1, 2}});
  CHECK(c.feature == Feature::Point);
  CHECK(glm::distance(c.scp.A, {0, 0, 5}) < 1e-13);

  p.setProbe(-1);
  CHECK(p.probe_A() == 0);
  p.setProbe(1e6);
  CHECK(p.probe_A() == kMaxProbe_A);
  p.setProbe(std::numeric_limits<double>::quiet_NaN());
  CHECK(p.probe_A() == kMaxProbe_A);
}

TEST_CASE(
    "nothing is modelled before a touch, one atom after it, and never more than 16; memory stays what it "
    "was") {
  const auto scene = scenes::cluster(200, 5);
  PaperTracker t = trackerOn(scene.spheres, scene.probe_A);
  const MemoryUsage start = t.memoryUsage();
  CHECK(start.atoms_modelled == 0);
  const auto path = scenes::walk(scene, 5000, 5, 0.1);
  std::size_t most = 0;
  bool first = true;
  for (const Vec3& hip : path) {
    const bool touching = t.step({hip}).touching();
    if (touching && first) CHECK(t.memoryUsage().atoms_modelled == 1);
    first = first && !touching;
    most = std::max(most, t.memoryUsage().atoms_modelled);
  }
  CHECK(most == paper::kModels);
  CHECK(t.memoryUsage().bytes == start.bytes);
}

TEST_CASE(
    "an atom with 400 neighbours models the 128 that cut deepest and at most 4096 points, each on three "
    "spheres") {
  std::vector<Sphere> spheres{{{0, 0, 0}, 3.0}};
  scenes::Random random(9);
  for (int k = 0; k < 400; ++k) spheres.push_back({random.direction() * random.uniform(2.0, 5.5), 3.0});
  const SphereGrid scene(spheres);
  paper::AtomModels models(scene);
  const auto m = models.model(scene, 0, 0.0);
  CHECK(m.cones.size() == paper::kMaxCones);
  CHECK(m.points.size() == paper::kMaxPoints);
  double worst = 0;
  for (const auto& p : m.points)
    for (const int atom : {0, p.second, p.third})
      worst = std::max(worst, std::abs(glm::distance(p.P, spheres[std::size_t(atom)].centre_A) - 3.0));
  CHECK(worst < 1e-9);
  std::vector<double> heights;
  for (std::size_t k = 1; k < spheres.size(); ++k)
    heights.push_back(glm::length(spheres[k].centre_A) / 2);  // equal radii: x = d / 2
  std::sort(heights.begin(), heights.end());
  CHECK(m.cones.back().circle.height == doctest::Approx(heights[paper::kMaxCones - 1]));
}

TEST_CASE("where two of three spheres only touch, their one place is no point") {
  const auto scene = scenes::touchingAcross();
  const SphereGrid spheres(scene.spheres);
  paper::AtomModels models(spheres);
  for (int atom = 0; atom < 3; ++atom) CHECK(models.model(spheres, atom, scene.probe_A).points.empty());
}

TEST_CASE("the method is found by its name, and an empty scene is free everywhere") {
  const Method* method = findMethod("paper");
  REQUIRE(method);
  const auto t = method->make(std::make_shared<const SphereGrid>(std::vector<Sphere>{}), 1.4);
  CHECK_FALSE(t->step({{0, 0, 0}}).touching());
  CHECK(t->memoryUsage().atoms_modelled == 0);
}
