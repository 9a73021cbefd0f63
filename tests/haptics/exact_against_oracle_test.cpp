// The exact tracker against the brute-force oracle in every scene where other methods fail: walks on the surface, jumps
// out and back, passes of 0.05 to 12 A per tick.
#include <doctest/doctest.h>

#include "engine/bench/oracle.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

struct Tally {
  int ticks = 0, judged = 0, wrong = 0;
  double worst_A = 0, deepest_A = -1;
};

// Where the oracle calls two outcomes right, the tracker's is checked to be one (outside, at rest), and both go on from
// it.
Tally compare(const scenes::Scene& scene, const scenes::Path& path) {
  ExactTracker tracker(test::makeScene(scene.spheres), scene.probe_A);
  oracle::Oracle oracle(scene.spheres, scene.probe_A);
  Tally tally;
  for (const Vec3& hip : path) {
    const Contact c = tracker.step({hip});
    const oracle::Oracle::Answer right = oracle.step(hip);
    ++tally.ticks;
    if (right.started_inside) {
      tally.wrong += c.fault != Fault::StartedInside;
      continue;
    }
    tally.deepest_A = std::max(tally.deepest_A, oracle::deepest(scene.spheres, scene.probe_A, c.scp.A));
    const double off = glm::distance(c.scp.A, right.scp_A);
    const bool agrees = c.touching() == right.contact && off <= 1e-7 + right.accuracy_A;
    if (right.decided) {
      ++tally.judged;
      tally.worst_A = std::max(tally.worst_A, agrees ? off : 0.0);
      if (!agrees) {
        ++tally.wrong;
        INFO(scene.name, ": tick ", tally.ticks, " off by ", off, " A, contact ", c.touching(), " for ", right.contact);
        CHECK(agrees);
      }
    }
    if (!agrees) {
      if (c.touching()) CHECK(oracle::atRest(scene.spheres, scene.probe_A, c.scp.A, hip, 1e-6));
      oracle.place(c.scp.A);
    }
  }
  CHECK(tracker.cutShort() == 0);
  return tally;
}

void checkAll(const std::string& what, scenes::Path (*path)(const scenes::Scene&, int, std::uint64_t), int ticks) {
  Tally sum;
  std::uint64_t seed = 100;
  for (const scenes::Scene& scene : scenes::all()) {
    CAPTURE(scene.name);
    CAPTURE(seed);
    const Tally one = compare(scene, path(scene, ticks, seed++));
    CHECK(one.wrong == 0);
    CHECK(one.deepest_A <= (glm::length(scene.spheres[0].centre_A) > 1e5 ? 1e-9 : 1e-11));
    sum.ticks += one.ticks, sum.judged += one.judged, sum.wrong += one.wrong;
    sum.worst_A = std::max(sum.worst_A, one.worst_A);
  }
  MESSAGE(what, ": ", sum.ticks, " ticks, ", sum.judged, " with one right answer, ", sum.wrong, " wrong, worst ",
          sum.worst_A, " A");
}

}  // namespace

TEST_CASE("walking over every scene, the exact tracker agrees with the oracle to 1e-7 A on every decided tick") {
  checkAll(
      "walks", [](const scenes::Scene& s, int n, std::uint64_t seed) { return scenes::walk(s, n, seed); }, 4000);
}

TEST_CASE("jumping out and back on every scene, it agrees with the oracle on every decided tick") {
  checkAll(
      "jumps", [](const scenes::Scene& s, int n, std::uint64_t seed) { return scenes::jumps(s, n, seed); }, 2000);
}

TEST_CASE("passing through every scene at 0.05 to 12 A a tick, it agrees with the oracle on every decided tick") {
  checkAll(
      "passes", [](const scenes::Scene& s, int n, std::uint64_t seed) { return scenes::passes(s, n, seed); }, 1500);
}
