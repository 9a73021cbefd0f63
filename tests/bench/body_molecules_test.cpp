// The exact rigid body in molecules against the oracle over all pairs. Longer runs, with bodies of 1069 and 5000 spheres:
// MOLTACT_BODY_TICKS=4000 build/release/test_bench -tc='*drug*'.
#include <doctest/doctest.h>

#include "engine/bench/bodies/body_tasks.h"
#include "engine/molecule/reader.h"
#include "tests/haptics/body_judge.h"

using namespace moltact;

TEST_CASE(
    "a drug in its protein and 200 atoms at its surface, pressed 6 A deep, dragged and twisted: no overlap, balance, "
    "no "
    "lower neighbour, no energy made, at rest in 999 of 1000 ticks, in at most 5 steps in the mean") {
  struct Judged {
    const char* task;
    int every, second_order_every;
    bool long_run;
  };
  for (const Judged& one : {Judged{"10", 40, 2, false}, Judged{"35", 40, 2, false}, Judged{"200", 100, 8, false},
                            Judged{"1069", 100, 40, true}, Judged{"5000", 200, 20, true}}) {
    if (one.long_run && !test::longRun()) continue;
    CAPTURE(one.task);
    const auto task = bench::bodyTask(one.task, [](const std::string& id) {
      return readMolecule(std::string(MOLTACT_SOURCE_DIR "/molecules/") + id + ".pdb");
    });
    REQUIRE(task);
    constexpr int kTicks = 4000;  // a faster path is another task
    const test::Verdict v =
        test::judge({task->scene->spheres().begin(), task->scene->spheres().begin() + task->scene->size()}, task->body,
                    bench::pathOf(*task, kTicks), one.second_order_every, one.every);
    test::check(v);
    MESSAGE(one.task << " atoms: " << v.judged << " ticks judged, " << v.unrested << " of " << v.ticks
                     << " not at rest, " << v.meanSteps() << " steps in the mean");
    CHECK(v.judged > kTicks / one.every * 9 / 10);
    CHECK(v.pressed > kTicks * 8 / 10);
    CHECK(v.unrested * 1000 <= v.ticks);
    CHECK(v.meanSteps() <= 5.0);
  }
}

TEST_CASE(
    "5000 spheres in 20 000, pressed 6 A deep, dragged and twisted: at rest in 999 of 1000 ticks, none of which "
    "examines more than 60 000 spheres, pairs and nodes, and the list that it begins last") {
  const auto task = bench::bodyTask("5000", [](const std::string&) -> Expected<Molecule> {
    return Problem{{}, 0, 0, "none", {}};
  });
  REQUIRE(task);
  REQUIRE(task->body->spheres.size() == 5000);
  ExactBody felt(task->scene, task->body);
  felt.respond({{task->home}});
  int unrested = 0, touching = 0;
  std::uint64_t most = 0;
  const std::vector<PoseA> path = bench::pathOf(*task, 4000);
  for (const PoseA& hand : path) {
    const Response r = felt.respond(hand);
    unrested += !r.at_rest;
    touching += r.contact.touching();
    most = std::max(most, felt.listWork());
  }
  MESSAGE(unrested << " of " << path.size() << " ticks not at rest; at most " << most << " examined in a tick");
  CHECK(unrested * 1000 <= int(path.size()));
  CHECK(touching > int(path.size()) * 9 / 10);
  CHECK(most > BodyPairs::kMaxWork);
  CHECK(most <= BodyPairs::kWorkPerSphere * 5000 + BodyPairs::kMaxFar);
}
