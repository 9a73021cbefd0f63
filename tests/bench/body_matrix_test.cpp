// The matrix of bodies: the exact body is sound in every scene, its rivals fail as the literature expects; and the oracle's
// rest and the report of bodies.
#include "engine/bench/bodies/body_matrix.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/bench/bodies/body_trade_off.h"
#include "engine/bench/bodies/path_watch.h"
#include "engine/bench/scenes.h"

using namespace moltact;
using namespace moltact::bench;

namespace {

const BodyScene& sceneNamed(const std::vector<BodyScene>& all, std::string_view start) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const BodyScene& s) { return s.name.starts_with(start); });
  REQUIRE(found != all.end());
  return *found;
}

bool fails(const BodyResult& r, char criterion) { return failuresOf(r).find(criterion) != std::string::npos; }

}  // namespace

TEST_CASE(
    "in the ten scenes, as defined and in one draw, the exact body overlaps by under 1e-9 A, makes under 1e-12 N A in "
    "a "
    "tick, and its force is that of the oracle's rest to 1e-8 N") {
  const BodyMethod& exact = *findBodyMethod("exact-body");
  CHECK(exact.reference);
  for (const std::size_t draw : {0u, 1u})
    for (const BodyScene& scene : drawnBodyScenes(1, draw)) {
      CAPTURE(scene.name);
      const BodyResult r = runBodyScene(scene, exact);
      CHECK(failuresOf(r).empty());
      CHECK(r.contact_ticks > 200);
      CHECK(r.judged > 150);
      CHECK(r.overlap_A < 1e-9);
      CHECK(r.energy_NA < 1e-12);
      CHECK(r.force_N < 1e-8);
      CHECK(r.torque_NA < 1e-8);
      CHECK(r.unrested == 0);
    }
}

TEST_CASE(
    "springs overlap in the corner, on the saddle and in the slot, and push 64 contacts with more than 10 N too much") {
  const auto all = bodyScenes(1);
  const BodyMethod& springs = *findBodyMethod("springs");
  for (const char* name : {"dumbbell", "stick", "key"}) {
    CAPTURE(name);
    const BodyResult r = runBodyScene(sceneNamed(all, name), springs);
    CHECK(fails(r, 'O'));
    CHECK(r.overlap_A > 0.5);
    CHECK(fails(r, 'F'));
    CHECK_FALSE(fails(r, 'E'));
  }
  CHECK(runBodyScene(sceneNamed(all, "64"), springs).force_N > 10.0);
}

TEST_CASE("points tunnel through a wall at 12 A a tick, and overlap a corner; a wall of one layer holds the springs") {
  const auto all = bodyScenes(1);
  const BodyScene& wall = sceneNamed(all, "passes");
  CHECK(fails(runBodyScene(wall, *findBodyMethod("point-penalty")), 'T'));
  CHECK_FALSE(fails(runBodyScene(wall, *findBodyMethod("springs")), 'T'));
  CHECK(fails(runBodyScene(sceneNamed(all, "dumbbell"), *findBodyMethod("point-penalty")), 'O'));
}

TEST_CASE(
    "PathWatch reports a step through a wall, a pose that no step reaches, and a step that begins elsewhere; it does "
    "not "
    "report a step in free space") {
  const auto all = bodyScenes(1);
  const BodyScene& wall = sceneNamed(all, "passes");
  PathWatch way(wall.spheres, wall.body, 0.05);
  const auto at = [](double z) { return PoseA{{{0, 0, z}}, kNoRotation}; };
  way.placed(at(18));
  way.moved(at(18), at(4), 0.0);
  CHECK_FALSE(way.tunnelled(at(4), nullptr));
  way.moved(at(4), at(-4), 0.0);
  CHECK(way.tunnelled(at(-4), nullptr));
  CHECK_FALSE(way.tunnelled(at(-4), nullptr));
  CHECK(way.tunnelled(at(-5), nullptr));
  way.moved(at(-5), at(-6), 0.0);
  CHECK(way.tunnelled(at(-6), nullptr));
  way.moved(at(-6), at(-7), 0.0);
  way.returned(at(-6));
  CHECK_FALSE(way.tunnelled(at(-6), nullptr));
}

TEST_CASE(
    "a body between two walls in ten draws: every tick at rest has the force of the oracle's rest to 1e-8 N, at most "
    "one "
    "of 1126 is not at rest, after 599 or 600 programmes and changes, and the next one is") {
  int unrested = 0;
  for (std::size_t draw = 0; draw < 10; ++draw) {
    CAPTURE(draw);
    const auto all = drawnBodyScenes(1, draw);
    const BodyScene& scene = sceneNamed(all, "squeezed");
    const auto grid = std::make_shared<const SphereGrid>(scene.spheres);
    ExactBody felt(grid, scene.body);
    RightBody right(grid, scene.body, scene.spheres);
    int here = 0;
    bool before = true;
    double off_N = 0;
    for (const PoseA& hand : scene.path) {
      const Response r = felt.respond(hand);
      const RightBody::Answer is = right.tick(hand, true);
      if (r.at_rest && is.known) off_N = std::max(off_N, glm::distance(r.contact.displacement_A, is.force_N));
      if (!r.at_rest) CHECK(felt.changes() >= ExactBody::kMaxChanges - 1);
      CHECK((r.at_rest || before));
      before = r.at_rest;
      here += !r.at_rest;
    }
    CHECK(scene.path.size() == 1126);
    CHECK(off_N < 1e-8);
    CHECK(here <= 1);
    unrested += here;
  }
  MESSAGE(unrested << " of 11 260 ticks not at rest");
}

TEST_CASE("a method that makes 1 N A in a tick, jitters, or gives no number is reported so") {
  BodyResult r;
  CHECK(failuresOf(r).empty());
  r.energy_NA = 1.0, r.jitter_N = 0.02, r.broken = 1;
  CHECK(failuresOf(r) == "EJN");
  r.overlap_A = 0.06, r.tunnelled = 2, r.unrested = 1, r.force_N = 0.06;
  CHECK(failuresOf(r) == "OTEUFJN");
}

TEST_CASE(
    "the oracle finds the rest of a dumbbell across a sphere from 1e-8 A beside it to 1e-14 A, and none 0.1 A beside "
    "it") {
  // Both ends touch; the hand is above the sphere's centre.
  const double R = 3.0, r = 1.2, l = 1.5, rest = std::sqrt((R + r) * (R + r) - l * l);
  const oracle::BodyOracle judge({{{0, 0, 0}, R}}, {{{l, 0, 0}, r}, {{-l, 0, 0}, r}}, l);
  const auto hand = oracle::BodyOracle::pose({{{0, 0, 3.0}}});
  const auto found = judge.rest(oracle::BodyOracle::pose({{{1e-8, 0, rest}}}), hand);
  REQUIRE(found);
  CHECK(std::abs(double(found->place[2]) - rest) < 1e-14);
  CHECK(std::abs(double(found->place[0])) < 1e-14);
  CHECK_FALSE(judge.rest(oracle::BodyOracle::pose({{{0, 0, rest - 0.1}}}), hand));
}

TEST_CASE("table, sentences and chart name every method and body of two made points; an error of zero has no mark") {
  std::vector<BodyTradeOff> points;
  for (const BodyMethod& m : bodyMethods())
    for (const std::size_t atoms : {std::size_t(1), std::size_t(10)}) {
      BodyTradeOff p{std::to_string(atoms), atoms, 100, &m, 2000, 9000, 1000, 1.0};
      p.position_A.rms = p.turn_rad.rms = p.force_N.rms = p.torque_NA.rms = 0.5;
      p.overlap_A.rms = p.overlap_A.max = m.reference ? 0.0 : 0.25;
      points.push_back(p);
    }
  const std::string table = toMarkdown(bodyTradeOffTable(points, {})), sentences = bodyTradeOffSentences(points),
                    chart = bodyTradeOffChart(points);
  for (const BodyMethod& m : bodyMethods()) {
    CHECK(table.find(std::string(m.name)) != std::string::npos);
    CHECK(sentences.find("`" + std::string(m.name) + "`: a tick takes 2 loops") != std::string::npos);
    CHECK(chart.find(std::string(m.name)) != std::string::npos);
  }
  CHECK(sentences.find("It overlaps nothing") != std::string::npos);
  CHECK(sentences.find("up to 0.250 A") != std::string::npos);
  std::size_t marks = 0;
  for (std::size_t at = 0; (at = chart.find("class=\"mark\"", at)) != std::string::npos; ++at) ++marks;
  CHECK(marks == 6 * 6 - 2 + 3);  // six panels of six points, less two without an overlap; three in the legend
}
