// The exact tracker where surfaces meet in places that rounding can hardly tell, against the oracle in long double.
// MOLTACT_DEGENERATE_SCENES=10000 tries as many scenes (300 otherwise), MOLTACT_DEGENERATE_FROM another first seed.
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

struct Tally {
  int scenes = 0, ticks = 0, agree = 0, grazing = 0, two_right = 0, wrong = 0, inside = 0, moving = 0, cut = 0, unfinished = 0;
  double deepest_A = -1e300;
  void add(const Tally& o) {
    scenes += o.scenes, ticks += o.ticks, agree += o.agree, grazing += o.grazing, two_right += o.two_right, wrong += o.wrong;
    inside += o.inside, moving += o.moving, cut += o.cut, unfinished += o.unfinished;
    deepest_A = std::max(deepest_A, o.deepest_A);
  }
};

// How far from rounding a question must be decided to have one right answer: a few times what the tracker calls touching.
double decidedFrom_A(const scenes::Scene& scene) {
  double largest = scene.probe_A, spread = 0;
  for (const Ball& b : scene.balls) {
    largest = std::max(largest, b.radius_A + scene.probe_A);
    spread = std::max(spread, glm::distance(b.centre_A, scene.balls[0].centre_A));
  }
  const bool far_off = glm::length(scene.balls[0].centre_A) > 512;  // the tracker counts from a multiple of 1024 A
  return 0x1p-40 * (spread + largest + (far_off ? 1024 : glm::length(scene.balls[0].centre_A)));
}

// The oracle, and the same with balls larger or smaller by a hair: where they differ, two answers are right.
class Oracles {
 public:
  explicit Oracles(const scenes::Scene& s) : balls_(s.balls), probe_A_(s.probe_A) {
    hair_ = decidedFrom_A(s);
    each_.emplace_back(s.balls, s.probe_A);
    for (const double even : {hair_, -hair_})
      for (const double odd : {hair_, -hair_}) each_.emplace_back(resized(s.balls, even, odd), s.probe_A, false);
  }
  // True where there is one right answer, to within `accuracy_A`.
  bool step(const Vec3& hip, oracle::Oracle::Answer& right, double& accuracy_A) {
    right = each_[0].step(hip);
    bool decided = right.decided && (!right.contact || oracle::atRest(balls_, probe_A_, right.scp_A, hip, 1e-8));
    accuracy_A = 1e-7 + right.accuracy_A;
    for (std::size_t k = 1; k < each_.size(); ++k) {
      const auto other = each_[k].step(hip);
      const double off = glm::distance(other.scp_A, right.scp_A);
      decided = decided && other.decided && other.contact == right.contact && other.started_inside == right.started_inside && off < 1e-6;
      accuracy_A += off;
    }
    return decided;
  }
  void place(const Vec3& scp) {
    for (auto& o : each_) o.place(scp);
  }

 private:
  static std::vector<Ball> resized(std::vector<Ball> balls, double even, double odd) {
    for (std::size_t k = 0; k < balls.size(); ++k) balls[k].radius_A += k % 2 ? odd : even;
    return balls;
  }
  std::vector<Ball> balls_;
  double probe_A_, hair_ = 0;
  std::vector<oracle::Oracle> each_;
};

Tally compare(std::uint64_t seed, int ticks) {
  const test::DegenerateScene s = test::degenerateScene(seed);
  const auto path = test::degeneratePath(s, ticks, seed);
  ExactTracker tracker(test::makeScene(s.scene.balls), s.scene.probe_A);
  Oracles oracles(s.scene);
  Tally tally{.scenes = 1};
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
      if (oracle::deepest(s.scene.balls, s.scene.probe_A, c.scp.A) > 1e-9) ++tally.inside;
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
    const double depth = oracle::deepest(s.scene.balls, s.scene.probe_A, c.scp.A);
    tally.deepest_A = std::max(tally.deepest_A, depth);
    if (depth > 1e-9) ++tally.inside, fault("SCP inside by", tally.ticks, depth);
    const double off = glm::distance(c.scp.A, right.scp_A);
    const bool touches_here = glm::distance(c.scp.A, hip) <= 1e-9 && glm::distance(right.scp_A, hip) <= 1e-9;  // free or not: rounding
    const bool agrees = (c.touching() == right.contact || touches_here) && off <= accuracy_A;
    if (agrees) ++tally.agree;
    if (!decided) oracles.place(c.scp.A);
    if (agrees) continue;
    // Where surfaces graze each other, rounding in height is its root along them.
    if (c.touching() == right.contact && off <= accuracy_A + grazing_A) {
      ++tally.grazing;
      continue;
    }
    const bool rests = !c.touching() || oracle::atRest(s.scene.balls, s.scene.probe_A, c.scp.A, hip, 1e-6);
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

TEST_CASE("degenerate scenes: no SCP deeper than 1e-9 A, none not at rest, none wrong where one answer is right, each flow finished") {
  const int scenes = numberFrom("MOLTACT_DEGENERATE_SCENES", 300), from = numberFrom("MOLTACT_DEGENERATE_FROM", 1);
  std::map<std::string, Tally> families;
  Tally sum;
  for (int k = 0; k < scenes; ++k) {
    const Tally one = compare(std::uint64_t(from + k), 100);
    families[test::degenerateScene(std::uint64_t(from + k)).family].add(one);
    sum.add(one);
  }
  for (const auto& [family, t] : families)
    MESSAGE(family, ": ", t.scenes, " scenes, ", t.ticks, " ticks, ", t.agree, " agree to 1e-7 A, ", t.grazing, " graze, ", t.two_right, " two right, ", t.wrong,
            " wrong, ", t.inside, " inside, ", t.moving, " not at rest, ", t.cut, " cut, deepest ", t.deepest_A, " A");
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
    ExactTracker tracker(test::makeScene(s.scene.balls), s.scene.probe_A);
    scenes::Random random(seed);
    for (const Vec3& hip : test::degeneratePath(s, 100, seed)) {
      const double probe = std::max(0.0, s.scene.probe_A + (random.uniform(0, 1) < 0.3 ? 0.0 : random.uniform(-0.1, 0.1)));
      tracker.setProbe(probe);
      const Contact c = tracker.step({hip});
      ++ticks;
      if (c.fault != Fault::None || !c.touching()) continue;
      ++touched;
      const double depth = oracle::deepest(s.scene.balls, probe, c.scp.A);
      if (depth > 1e-9) {
        ++inside;
        MESSAGE(s.scene.name, ", tick ", ticks, ": inside by ", depth);
      }
      if (!oracle::atRest(s.scene.balls, probe, c.scp.A, hip, 1e-6)) {
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
