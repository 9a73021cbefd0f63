// The exact tracker at almost degenerate intersections, against the oracle in long double.
// MOLTACT_DEGENERATE_SCENES=10000 sets the number of scenes (default 300), MOLTACT_DEGENERATE_FROM the first seed.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>

#include "engine/bench/oracle.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "tests/haptics/degenerate_scenes.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

int numberFrom(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text && std::atoi(text) > 0 ? std::atoi(text) : otherwise;
}

struct ExactDegenerateTally {
  int scenes = 0, ticks = 0, agree = 0, grazing = 0, two_right = 0, wrong = 0, inside = 0, moving = 0, cut = 0,
      unfinished = 0;
  double deepest_A = -1e300;
  void add(const ExactDegenerateTally& o) {
    scenes += o.scenes, ticks += o.ticks, agree += o.agree, grazing += o.grazing, two_right += o.two_right,
        wrong += o.wrong;
    inside += o.inside, moving += o.moving, cut += o.cut, unfinished += o.unfinished;
    deepest_A = std::max(deepest_A, o.deepest_A);
  }
};

// How far from rounding a question must be decided to have one right answer: a few times what the tracker calls
// touching.
double decidedFrom_A(const scenes::Scene& scene) {
  double largest = scene.probe_A, spread = 0;
  for (const Sphere& b : scene.spheres) {
    largest = std::max(largest, b.radius_A + scene.probe_A);
    spread = std::max(spread, glm::distance(b.centre_A, scene.spheres[0].centre_A));
  }
  const bool far_off = glm::length(scene.spheres[0].centre_A) > 512;  // the tracker counts from a multiple of 1024 A
  return 0x1p-40 * (spread + largest + (far_off ? 1024 : glm::length(scene.spheres[0].centre_A)));
}

// The oracle, and the same with spheres larger or smaller by a hair: where they differ, two answers are right.
class Oracles {
 public:
  explicit Oracles(const scenes::Scene& s) : spheres_(s.spheres), probe_A_(s.probe_A) {
    hair_ = decidedFrom_A(s);
    each_.emplace_back(s.spheres, s.probe_A);
    for (const double even : {hair_, -hair_})
      for (const double odd : {hair_, -hair_}) each_.emplace_back(resized(s.spheres, even, odd), s.probe_A, false);
  }
  // True where there is one right answer, to within `accuracy_A`.
  bool step(const Vec3& hip, oracle::Oracle::Answer& right, double& accuracy_A) {
    right = each_[0].step(hip);
    bool decided = right.decided && (!right.contact || oracle::atRest(spheres_, probe_A_, right.scp_A, hip, 1e-8));
    accuracy_A = 1e-7 + right.accuracy_A;
    for (std::size_t k = 1; k < each_.size(); ++k) {
      const auto other = each_[k].step(hip);
      const double off = glm::distance(other.scp_A, right.scp_A);
      decided = decided && other.decided && other.contact == right.contact &&
                other.started_inside == right.started_inside && off < 1e-6;
      accuracy_A += off;
    }
    return decided;
  }
  void place(const Vec3& scp) {
    for (auto& o : each_) o.place(scp);
  }

 private:
  static std::vector<Sphere> resized(std::vector<Sphere> spheres, double even, double odd) {
    for (std::size_t k = 0; k < spheres.size(); ++k) spheres[k].radius_A += k % 2 ? odd : even;
    return spheres;
  }
  std::vector<Sphere> spheres_;
  double probe_A_, hair_ = 0;
  std::vector<oracle::Oracle> each_;
};

ExactDegenerateTally exactDegenerateCompare(std::uint64_t seed, int ticks) {
  const test::DegenerateScene s = test::degenerateScene(seed);
  const auto path = test::degeneratePath(s, ticks, seed);
  ExactTracker tracker(test::makeScene(s.scene.spheres), s.scene.probe_A);
  Oracles oracles(s.scene);
  ExactDegenerateTally tally{.scenes = 1};
  const double grazing_A = 2.0 * std::sqrt(decidedFrom_A(s.scene) * (s.scene.probe_A + 2.0));
  const auto fault = [&](const std::string& what, int tick, double size) {
    MESSAGE(s.scene.name, ", tick ", tick, ": ", what, " ", size);
  };
  for (const Vec3& hip : path) {
    const std::uint64_t cut_before = tracker.cutShort();
    Contact c = tracker.step({hip});
    // A flow that is cut short is outside, and finishes in the following ticks.
    for (int more = 0; more < 100 && tracker.cutShort() != cut_before + std::uint64_t(more); ++more) {
      if (more == 0) ++tally.cut;
      if (oracle::deepest(s.scene.spheres, s.scene.probe_A, c.scp.A) > 1e-9) ++tally.inside;
      c = tracker.step({hip});
      if (more == 99) ++tally.unfinished, fault("does not finish", tally.ticks, 0);
    }
    oracle::Oracle::Answer right;
    double accuracy_A = 0;
    const bool decided = oracles.step(hip, right, accuracy_A);
    ++tally.ticks;
    if (c.fault != Fault::None || right.started_inside) {
      tally.wrong += decided && right.started_inside != (c.fault == Fault::StartedInside);
      if (c.fault == Fault::None) oracles.place(c.scp.A);
      continue;
    }
    const double depth = oracle::deepest(s.scene.spheres, s.scene.probe_A, c.scp.A);
    tally.deepest_A = std::max(tally.deepest_A, depth);
    if (depth > 1e-9) ++tally.inside, fault("SCP inside by", tally.ticks, depth);
    const double off = glm::distance(c.scp.A, right.scp_A);
    const bool touches_here =
        glm::distance(c.scp.A, hip) <= 1e-9 && glm::distance(right.scp_A, hip) <= 1e-9;  // free or not: rounding
    const bool agrees = (c.touching() == right.contact || touches_here) && off <= accuracy_A;
    if (agrees) ++tally.agree;
    if (!decided) oracles.place(c.scp.A);
    if (agrees) continue;
    // Where surfaces graze each other, rounding in height is its root along them.
    if (c.touching() == right.contact && off <= accuracy_A + grazing_A) {
      ++tally.grazing;
      continue;
    }
    const bool rests = !c.touching() || oracle::atRest(s.scene.spheres, s.scene.probe_A, c.scp.A, hip, 1e-6);
    if (!rests) ++tally.moving, fault("not at rest, off by", tally.ticks, off);
    if (decided)
      ++tally.wrong, fault("wrong by", tally.ticks, off);
    else
      ++tally.two_right;
    oracles.place(c.scp.A);
  }
  return tally;
}

}  // namespace

TEST_CASE(
    "degenerate scenes: no SCP deeper than 1e-9 A, none not at rest, none wrong where one answer is right, each flow "
    "finished") {
  const int scenes = numberFrom("MOLTACT_DEGENERATE_SCENES", 300), from = numberFrom("MOLTACT_DEGENERATE_FROM", 1);
  std::map<std::string, ExactDegenerateTally> families;
  ExactDegenerateTally sum;
  for (int k = 0; k < scenes; ++k) {
    const ExactDegenerateTally one = exactDegenerateCompare(std::uint64_t(from + k), 100);
    families[test::degenerateScene(std::uint64_t(from + k)).family].add(one);
    sum.add(one);
  }
  for (const auto& [family, t] : families)
    MESSAGE(family, ": ", t.scenes, " scenes, ", t.ticks, " ticks, ", t.agree, " agree to 1e-7 A, ", t.grazing,
            " graze, ", t.two_right, " two right, ", t.wrong, " wrong, ", t.inside, " inside, ", t.moving,
            " not at rest, ", t.cut, " cut, deepest ", t.deepest_A, " A");
  CAPTURE(from);
  CHECK(sum.wrong == 0);
  CHECK(sum.inside == 0);
  CHECK(sum.moving == 0);
  CHECK(sum.unfinished == 0);
  CHECK(sum.cut <= sum.ticks / 1000);
  CHECK(sum.ticks == scenes * 100);
}

TEST_CASE("degenerate scenes whose probe changes in every tick: no SCP deeper than 1e-9 A, none not at rest") {
  const int scenes = numberFrom("MOLTACT_DEGENERATE_SCENES", 300) / 3, from = numberFrom("MOLTACT_DEGENERATE_FROM", 1);
  int inside = 0, moving = 0, ticks = 0, touched = 0;
  for (int k = 0; k < scenes; ++k) {
    const auto seed = std::uint64_t(from + k);
    const test::DegenerateScene s = test::degenerateScene(seed);
    ExactTracker tracker(test::makeScene(s.scene.spheres), s.scene.probe_A);
    scenes::Random random(seed);
    for (const Vec3& hip : test::degeneratePath(s, 100, seed)) {
      const double probe =
          std::max(0.0, s.scene.probe_A + (random.uniform(0, 1) < 0.3 ? 0.0 : random.uniform(-0.1, 0.1)));
      tracker.setProbe(probe);
      std::uint64_t cut = tracker.cutShort();
      Contact c = tracker.step({hip});
      for (int more = 0; more < 100 && tracker.cutShort() != cut; ++more)
        cut = tracker.cutShort(), c = tracker.step({hip});
      ++ticks;
      if (c.fault != Fault::None || !c.touching()) continue;
      ++touched;
      const double depth = oracle::deepest(s.scene.spheres, probe, c.scp.A);
      if (depth > 1e-9) {
        ++inside;
        MESSAGE(s.scene.name, ", tick ", ticks, ": inside by ", depth);
      }
      if (!oracle::atRest(s.scene.spheres, probe, c.scp.A, hip, 1e-6)) {
        ++moving;
        MESSAGE(s.scene.name, ", tick ", ticks, ": not at rest");
      }
    }
  }
  CAPTURE(from);
  CHECK(inside == 0);
  CHECK(moving == 0);
  CHECK(touched > ticks / 10);
}

TEST_CASE(
    "five spheres of 3 A whose circle of 3 A closes the hole exactly: a HIP led through the middle leaves the SCP "
    "outside and at rest") {
  std::vector<Sphere> spheres;
  for (int k = 0; k < 5; ++k)
    spheres.push_back(
        {{3 * std::cos(0.4 * 3.14159265358979323846 * k), 3 * std::sin(0.4 * 3.14159265358979323846 * k), 0}, 1.6});
  spheres[0].centre_A = {3, 0, 0};
  spheres[1].centre_A = {0.92705098312484235, 2.8531695488854605, 0};
  ExactTracker tracker(test::makeScene(spheres), 1.4);
  for (const Vec3& hip : {Vec3(0, 0, 12), Vec3(0, 0, 0), Vec3(1, -0.5, 0), Vec3(1, -0.5, 0)}) {
    const Contact c = tracker.step({hip});
    CHECK(oracle::deepest(spheres, 1.4, c.scp.A) <= 1e-11);
    if (c.touching()) CHECK(oracle::atRest(spheres, 1.4, c.scp.A, hip, 1e-9));
  }
}

TEST_CASE(
    "rings of 3 to 12 spheres that close to within 1e-15 A: 4000 jumps through the middle, no SCP deeper than 1e-11 "
    "A") {
  const std::uint64_t seed = 7;
  CAPTURE(seed);
  scenes::Random random(seed);
  double deepest = -1;
  for (int k = 0; k < 4000; ++k) {
    const int n = 3 + k % 10;
    const double radius = 3.0 + random.uniform(-1e-15, 1e-15);
    std::vector<Sphere> spheres;
    for (int j = 0; j < n; ++j)
      spheres.push_back(
          {{radius * std::cos(6.283185307179586 * j / n), radius * std::sin(6.283185307179586 * j / n), 0}, 1.6});
    ExactTracker tracker(test::makeScene(spheres), 1.4);
    tracker.step({{0, 0, 12}});
    for (const Vec3& hip : {Vec3(0, 0, random.uniform(-1e-3, 1e-3)), random.direction(), random.direction() * 2.0})
      deepest = std::max(deepest, oracle::deepest(spheres, 1.4, tracker.step({hip}).scp.A));
  }
  CHECK(deepest <= 1e-11);
}

TEST_CASE(
    "a sphere of 2.4 A that touches one of 3.3 A from inside, to the last bit or nearly: the SCP follows the HIP on "
    "the "
    "larger") {
  for (const double x : {0.54, 0.5399999999999999, 0.5400000000000001}) {
    CAPTURE(x);
    const std::vector<Sphere> spheres{{{0, 0, 0}, 1.9}, {{x, 0, 0.72}, 1.0}};
    ExactTracker tracker(test::makeScene(spheres), 1.4);
    tracker.step({{4.8, 0, 6.4}});
    for (int k = 0; k <= 100; ++k) {
      const Vec3 hip = (0.95 - 0.008 * k) * Vec3(1.98, 0, 2.64) + Vec3(0, 0.01 * k, 0);
      const Contact c = tracker.step({hip});
      REQUIRE(c.touching());
      CHECK(glm::distance(c.scp.A, 3.3 * glm::normalize(hip)) <=
            2e-6);  // past the point of touch by the root of rounding
    }
  }
}

TEST_CASE(
    "every second of 60 spheres copied at 1e-9 to 1e-14 A: over 12 000 gliding ticks the SCP is never frozen, and "
    "outside to 1e-10 A") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  scenes::Random random(seed);
  int frozen = 0, touched = 0;
  double deepest = -1;
  for (const double offset : {1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14}) {
    scenes::Scene scene = scenes::cluster(60, seed);
    for (std::size_t k = 0; k < 60; k += 2)
      scene.spheres.push_back({scene.spheres[k].centre_A + random.direction() * offset, scene.spheres[k].radius_A});
    ExactTracker tracker(test::makeScene(scene.spheres), scene.probe_A);
    for (const Vec3& hip : scenes::walk(scene, 2000, seed)) {
      const Contact c = tracker.step({hip});
      if (!c.touching()) continue;
      ++touched;
      deepest = std::max(deepest, oracle::deepest(scene.spheres, scene.probe_A, c.scp.A));
      frozen += !oracle::atRest(scene.spheres, scene.probe_A, c.scp.A, hip, 1e-6);
    }
  }
  CHECK(touched > 6000);
  CHECK(frozen == 0);
  CHECK(deepest <= 1e-10);
}

TEST_CASE(
    "a HIP that arrives within 1e-3 to 1e-5 A of a centre or an axis: 20 000 arrivals, no flow cut short, all at "
    "rest") {
  const std::uint64_t seed = 13;
  CAPTURE(seed);
  scenes::Random random(seed);
  const scenes::Scene scene = scenes::cluster(50, seed);
  ExactTracker tracker(test::makeScene(scene.spheres), scene.probe_A);
  int moving = 0;
  for (int k = 0; k < 20'000; ++k) {
    if (k % 4 == 0) tracker.step({Vec3(4.0) + random.direction() * 25.0});
    const auto any = [&] { return scene.spheres[std::size_t(random.uniform(0, 49.99))].centre_A; };
    const Vec3 a = any(), b = any();
    const Vec3 hip = a + (b - a) * (k % 2 ? 0.0 : random.uniform(0, 1)) +
                     random.direction() * std::pow(10.0, random.uniform(-5, -3));
    const Contact c = tracker.step({hip});
    moving += c.touching() && !oracle::atRest(scene.spheres, scene.probe_A, c.scp.A, hip, 1e-6);
  }
  CHECK(tracker.cutShort() == 0);
  CHECK(moving == 0);
}

TEST_CASE(
    "100 000 spheres within 0.1 A, and 14 000 with a probe of 20 A: a tick looks at no more than 30 000 things, and "
    "the "
    "SCP is outside") {
  const std::uint64_t seed = 17;
  CAPTURE(seed);
  scenes::Random random(seed);
  scenes::Scene crowd{"crowd", {}, 1.4}, large = scenes::cluster(14'000, seed);
  large.probe_A = 20;
  for (int k = 0; k < 100'000; ++k)
    crowd.spheres.push_back({random.direction() * 0.1 * std::cbrt(random.uniform(0, 1)), random.uniform(1.4, 1.6)});
  for (const scenes::Scene& scene : {crowd, large}) {
    CAPTURE(scene.name);
    Vec3 low(1e300), high(-1e300);
    for (const Sphere& b : scene.spheres) low = glm::min(low, b.centre_A), high = glm::max(high, b.centre_A);
    const Vec3 middle = 0.5 * (low + high);
    const double half = 0.5 * glm::distance(low, high) + 2.0 + scene.probe_A;
    ExactTracker tracker(test::makeScene(scene.spheres), scene.probe_A);
    Vec3 hip = middle + Vec3(half, 0, 0);
    std::uint64_t most = 0;
    double deepest = -1;
    for (int k = 0; k < 3000; ++k) {
      const Contact c = tracker.step({hip});
      most = std::max(most, tracker.workCount());
      if (k % 100 == 0 && c.touching())
        deepest = std::max(deepest, oracle::deepest(scene.spheres, scene.probe_A, c.scp.A));
      hip += 0.05 * random.direction() + 0.02 * (middle + 0.7 * half * glm::normalize(hip - middle) - hip);
      if (k % 200 == 199) hip = middle + random.direction() * half * random.uniform(0, 1);
    }
    CHECK(most <= 30'000);
    CHECK(deepest <= 1e-10);
    MESSAGE(scene.name, ": ", most, " looked at in a tick, ", tracker.cutShort(), " of 3000 ticks cut short");
  }
}

TEST_CASE(
    "a probe that changes by up to 20 A at once: setProbe and the tick after it look at no more than 30 000 things "
    "each, and the SCP is outside") {
  const std::uint64_t seed = 19;
  CAPTURE(seed);
  scenes::Random random(seed);
  scenes::Scene crowd{"crowd", {}, 1.4}, large = scenes::cluster(14'000, seed), small = scenes::cluster(60, seed);
  for (int k = 0; k < 100'000; ++k)
    crowd.spheres.push_back({random.direction() * 0.1 * std::cbrt(random.uniform(0, 1)), random.uniform(1.4, 1.6)});
  for (const scenes::Scene& scene : {crowd, large, small}) {
    CAPTURE(scene.name);
    Vec3 low(1e300), high(-1e300);
    for (const Sphere& b : scene.spheres) low = glm::min(low, b.centre_A), high = glm::max(high, b.centre_A);
    const Vec3 middle = 0.5 * (low + high);
    const double half = 0.5 * glm::distance(low, high) + 2.0 + scene.probe_A;
    const auto spheres = test::makeScene(scene.spheres);
    constexpr int kTries = 12;
    std::uint64_t most_set = 0, most_tick = 0;
    double deepest = -1;
    int longest = 0, arrived = 0, closed = 0;
    for (int k = 0; k < kTries; ++k) {
      ExactTracker tracker(spheres, 0.0);
      const Vec3 way = random.direction(), hip = middle + way * random.uniform(0.5, 1.0) * half;
      const double goal = k % 2 ? 20.0 : random.uniform(0, 20);
      tracker.step({middle + half * way});
      tracker.step({hip});
      tracker.setProbe(goal);
      most_set = std::max(most_set, tracker.workCount());
      int ticks = 0;
      for (bool there = false; !there && ticks < 5000; ++ticks) {
        there = tracker.probe_A() == goal;
        const Contact c = tracker.step({hip + 0.01 * random.direction()});
        most_tick = std::max(most_tick, tracker.workCount());
        if (c.fault == Fault::None && (there || ticks % 50 == 0))
          deepest = std::max(deepest, oracle::deepest(scene.spheres, tracker.probe_A(), c.scp.A));
        if (there) closed += c.fault != Fault::None;
      }
      arrived += tracker.probe_A() == goal;
      longest = std::max(longest, ticks);
    }
    CHECK(arrived == kTries);
    CHECK(closed < kTries);
    CHECK(most_set <= 30'000);
    CHECK(most_tick <= 30'000);
    CHECK(deepest <= 1e-9);
    MESSAGE(scene.name, ": ", most_set, " looked at by setProbe, ", most_tick, " in a tick, at the goal after at most ",
            longest, " ticks, ", closed, " of ", kTries, " places closed");
  }
}

TEST_CASE(
    "two spheres of 3 A whose centres are 1e-4 to 1e-7 A apart, the HIP as near to both: the SCP goes round on their "
    "circle in one tick") {
  const std::uint64_t seed = 23;
  CAPTURE(seed);
  scenes::Random random(seed);
  int cut = 0, off_way = 0, inside = 0;
  for (int k = 0; k < 2000; ++k) {
    const double apart = std::pow(10.0, random.uniform(-7, -4)),
                 hip_off = apart * std::pow(10.0, random.uniform(-1, 1));
    const Vec3 at = random.direction() * (k % 2 ? 0.0 : 400.0), axis = random.direction();
    const std::vector<Sphere> spheres{{at, 1.6}, {at + axis * apart, 1.6}};
    const Vec3 between = spheres[1].centre_A - spheres[0].centre_A;  // as rounded
    Vec3 sideways = random.direction();
    sideways = glm::normalize(sideways - glm::normalize(between) * glm::dot(sideways, glm::normalize(between)));
    ExactTracker tracker(test::makeScene(spheres), 1.4);
    tracker.step({at + 9.0 * glm::normalize(random.direction() + sideways)});
    const Vec3 hip = at + 0.5 * between + hip_off * sideways;
    const Contact c = tracker.step({hip});
    cut += tracker.cutShort() > 0;
    // The HIP, rounded, in the plane between the centres: the SCP lies straight above it. At 400 A, rounding limits the
    // plane and the HIP's direction to about 1e-13 A.
    const Vec3 m = hip - (spheres[0].centre_A + 0.5 * between), u = glm::normalize(between),
               out = m - u * glm::dot(m, u);
    off_way += glm::distance(c.scp.A, at + 0.5 * between + 3.0 * glm::normalize(out)) >
               3.0 * 1e-12 / apart + 3.0 * 1e-12 / hip_off + 1e-5;
    inside += oracle::deepest(spheres, 1.4, c.scp.A) > 1e-9;
  }
  CHECK(cut == 0);
  CHECK(off_way == 0);
  CHECK(inside == 0);
}

TEST_CASE(
    "in the pit of four spheres, the HIP behind the centre of one: 1e-9 A to one side lets the SCP go round that "
    "sphere, "
    "to the other holds it") {
  const double r = 3.0;
  const Vec3 pit(400, -300, 200), n = Vec3(-1, 1, 1) / std::sqrt(3.0), aside = Vec3(1, -1, 2) / std::sqrt(6.0);
  std::vector<Sphere> spheres;  // all four through the pit, which opens along z
  for (const Vec3& way : {Vec3(-1, 1, 1), Vec3(-1, -1, 1), Vec3(1, 1, 1), Vec3(1, -1, 1)})
    spheres.push_back({pit - way * (r / std::sqrt(3.0)), 1.6});
  for (const double off : {1e-9, -1e-9}) {
    CAPTURE(off);
    ExactTracker tracker(test::makeScene(spheres), 1.4);
    test::walkTo(tracker, pit + Vec3(0, 0, 5), pit - Vec3(0, 0, 0.5), 0.1);
    const Vec3 hip = pit - n * (2 * r - 0.1) + aside * off;
    const Contact c = tracker.step({hip});
    const Vec3 right = off > 0 ? spheres[0].centre_A + r * glm::normalize(hip - spheres[0].centre_A) : pit;
    CHECK(glm::distance(c.scp.A, right) <= 1e-9);
  }
}

TEST_CASE(
    "degenerate scenes that were once wrong, not at rest or without end: seeds 21420, 21654, 21951, 22182, 23040, "
    "24192 and 51648") {
  ExactDegenerateTally sum;
  for (const std::uint64_t seed : {21420, 21654, 21951, 22182, 23040, 24192, 51648})
    sum.add(exactDegenerateCompare(seed, 100));
  CHECK(sum.wrong == 0);
  CHECK(sum.inside == 0);
  CHECK(sum.moving == 0);
  CHECK(sum.unfinished == 0);
}
