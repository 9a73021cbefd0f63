// Oracle: the events of the timeline, and linear interpolation between samples.
#include "engine/results/timeline.h"

#include <doctest/doctest.h>

#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

Timeline sampleTimeline() {
  Attempt a;
  a.header = sampleHeader();
  a.events = sampleEvents();
  return Timeline(a);
}

TEST_CASE("the hand is where its samples are, and half way between two of them at half time") {
  const Timeline line = sampleTimeline();
  CHECK_FALSE(line.hand(2.9).has_value());
  const std::vector<HipSample> samples = std::get<HipChunk>(sampleEvents()[7].what).samples;
  for (const HipSample& s : samples) {
    const auto at = line.hand(s.t_s);
    REQUIRE(at.has_value());
    CHECK(glm::distance(at->hip.A, s.hip.A) < 1e-9);
    CHECK(glm::distance(at->scp.A, s.scp.A) < 1e-9);
    CHECK(at->feature == s.feature);
    CHECK(at->atoms == s.atoms);
  }
  const auto half = line.hand(0.5 * (samples[2].t_s + samples[3].t_s));
  CHECK(glm::distance(half->hip.A, 0.5 * (samples[2].hip.A + samples[3].hip.A)) < 1e-9);
  CHECK(half->force.N.z == doctest::Approx(0.25 * 2.5));
  // Between a free sample and a touch there is no force.
  const auto coming = line.hand(0.5 * (samples[1].t_s + samples[2].t_s));
  CHECK(coming->feature == Feature::Free);
  CHECK(coming->force.N == Vec3(0.0));
  CHECK(coming->scp.A == coming->hip.A);
  // After the last sample the hand rests.
  CHECK(line.hand(100.0)->hip.A == samples.back().hip.A);
}

TEST_CASE("between two samples a body turns evenly by the shorter arc, and is half way at half time") {
  Attempt a;
  a.header = sampleHeader();
  a.events = sampleEvents();
  HipChunk& chunk = std::get<HipChunk>(a.events[7].what);
  for (std::size_t k = 0; k < chunk.samples.size(); ++k) {
    const Quat q = glm::angleAxis(0.8 * double(k), Vec3(0, 0, 1));
    chunk.samples[k].held = {q, {{Vec3(0, double(k), 0)}, glm::angleAxis(0.4 * double(k), Vec3(1, 0, 0))}};
    if (k % 2) chunk.samples[k].held->orientation = -q;
  }
  const std::vector<HipSample> samples = chunk.samples;
  const Timeline line(a);
  const auto half = line.hand(0.5 * (samples[2].t_s + samples[3].t_s));
  REQUIRE(half->held);
  CHECK(glm::length(rotationBetween(half->held->orientation, glm::angleAxis(2.0, Vec3(0, 0, 1)))) < 1e-9);
  CHECK(glm::length(rotationBetween(half->held->body.orientation, glm::angleAxis(1.0, Vec3(1, 0, 0)))) < 1e-9);
  CHECK(glm::distance(half->held->body.place.A, Vec3(0, 2.5, 0)) < 1e-9);
}

TEST_CASE("9.5 s with 7 marks: steps, a task, answers and a hint, each with its words") {
  const Timeline line = sampleTimeline();
  CHECK(line.length_s() == 9.5);
  using Kind = TimelineMark::Kind;
  const std::vector<std::tuple<double, Kind, std::string>> wanted{{0.0, Kind::Step, "One"},
                                                                  {2.0, Kind::Hint, "Opened the hint"},
                                                                  {3.2, Kind::Task, "Done: Touch it."},
                                                                  {4.0, Kind::Wrong, "Answered: this"},
                                                                  {5.0, Kind::Right, "Answered rightly: that"},
                                                                  {8.0, Kind::Step, "Two"},
                                                                  {9.0, Kind::Right, "Answered rightly: 2.5 Å"}};
  REQUIRE(line.marks().size() == wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k)
    CHECK(std::tuple(line.marks()[k].t_s, line.marks()[k].kind, line.marks()[k].text) == wanted[k]);
  CHECK(line.step(7.9) == "One");
  CHECK(line.step(8.0) == "Two");
  REQUIRE(line.stage(0.0) != nullptr);
  CHECK(line.stage(5.0)->file == "1ubq.pdb");
  CHECK(line.view(0.4) == nullptr);
  CHECK(line.view(0.5)->distance_A == 60.5);
  CHECK(line.nextAfter(0.0) == 2.0);
  CHECK(line.nextAfter(2.0) == 3.0);
  CHECK(line.nextAfter(3.2) == 4.0);
  CHECK(line.nextAfter(9.2) == 9.5);
  CHECK(line.input(9.0) == InputKind::Mouse);
}

TEST_CASE("an attempt without HIP samples has no hand and no stage, and still its length") {
  Attempt a;
  a.header = sampleHeader();
  a.events = {{4.0, SessionClosed{"2026-11-21T10:59:00Z"}}};
  const Timeline line(a);
  CHECK(line.length_s() == 4.0);
  CHECK_FALSE(line.hand(1.0).has_value());
  CHECK(line.stage(1.0) == nullptr);
  CHECK(line.step(1.0).empty());
}

}  // namespace
}  // namespace moltact
