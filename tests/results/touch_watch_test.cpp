// Oracle: closed forms of the hand's path.
#include "engine/results/touch_watch.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/results/attempt_lines.h"
#include "engine/results/timeline.h"
#include "tests/results/small_lesson.h"

namespace moltact {
namespace {

TEST_CASE("a slide of 2 A over atoms 3 and 4 in 1 s at 0.5 N is one touch with one crossing, 2 A of path and 0.5 N") {
  TouchWatch watch;
  for (int k = 0; k <= 1400; ++k) {
    const double t = k * 0.001;
    TouchSample s = touching(k < 700 ? 3 : 4, t, 0.5);
    if (k < 100 || k > 1100)
      s.contact = Contact(), s.force.N = Vec3(0.0);
    else
      s.contact.scp.A = {2.0 * (k - 100) / 1000.0, 0, 0};
    // A graze of 20 ms in the air does not end the touch.
    if (k >= 400 && k < 420) s.contact = Contact();
    watch.add(s, t, InputKind::Device);
  }
  std::vector<AttemptEvent> touches;
  for (AttemptEvent& e : watch.take(1.4))
    if (!std::holds_alternative<HipChunk>(e.what)) touches.push_back(std::move(e));
  REQUIRE(touches.size() == 2);
  CHECK(touches[0].t_s == doctest::Approx(0.1));
  CHECK(std::get<TouchBegan>(touches[0].what).atoms == std::vector<std::int32_t>{3});
  const auto& end = std::get<TouchEnded>(touches[1].what);
  CHECK(touches[1].t_s == doctest::Approx(1.1));
  CHECK(end.from_s == doctest::Approx(0.1));
  CHECK(end.atoms == std::vector<std::int32_t>{3, 4});
  CHECK(end.crossings == 1);
  CHECK(end.peak_N == doctest::Approx(0.5));
  CHECK(end.mean_N == doctest::Approx(0.5));
  CHECK(end.path_A == doctest::Approx(2.0));
  CHECK(end.by == InputKind::Device);
}

TEST_CASE(
    "a field of 0.4 N along y is kept with its force and direction through touch watch, line and timeline, in contact "
    "or "
    "without, for a probe and a body; without a field a line has neither key") {
  for (const bool body : {false, true}) {
    CAPTURE(body);
    TouchWatch watch;
    for (int k = 0; k <= 400; ++k) {
      const bool free = k < 200;
      TouchSample s = touching(3, k * 0.001, 0.5);
      s.hip.A = {0, 0, 0.01 * k};
      if (free) s.contact = Contact{.scp = s.hip};
      s.field = true;
      s.force.N = {0.4, 0, 0};  // the device's x is the molecule's y
      s.wanted_N = {0, free ? 0.4 : 0.6, 0};
      if (body) s.body = PoseA{s.hip, s.orientation};
      watch.add(s, s.time_s, InputKind::Mouse);
    }
    watch.breakOff();
    Attempt attempt;
    std::size_t kept = 0;
    for (const AttemptEvent& e : watch.take(0.4)) {
      if (!std::holds_alternative<HipChunk>(e.what)) continue;
      const std::string line = lineOf(e);
      CAPTURE(line);
      auto back = readEventLine(line);
      REQUIRE(bool(back));
      CHECK(lineOf(**back) == line);
      kept += std::get<HipChunk>((*back)->what).samples.size();
      attempt.events.push_back(**back);
    }
    CHECK(kept > 20);
    const Timeline played(attempt);
    for (const double t_s : {0.1, 0.15, 0.3}) {
      const auto hand = played.hand(t_s);
      REQUIRE(hand);
      REQUIRE(hand->wanted_N);
      CHECK((hand->feature == Feature::Free) == (t_s < 0.2));
      CHECK(glm::distance(*hand->wanted_N, Vec3(0, t_s < 0.2 ? 0.4 : 0.6, 0)) < 1e-3);
      CHECK(glm::distance(hand->force.N, Vec3(0.4, 0, 0)) < 1e-3);
      CHECK(hand->held.has_value() == body);
    }
  }
  TouchWatch plain;
  for (int k = 0; k <= 100; ++k) plain.add(touching(3, k * 0.001, 0.5), k * 0.001, InputKind::Mouse);
  plain.breakOff();
  for (const AttemptEvent& e : plain.take(0.1)) {
    CHECK(lineOf(e).find("wanted") == std::string::npos);
    CHECK(lineOf(e).find("free_force") == std::string::npos);
  }
}

TEST_CASE("a field that wants 1e12 N is kept with 100 N in its direction, and its line is read") {
  TouchWatch watch;
  TouchSample s;
  s.field = true;
  s.force.N = {0, 0, 3.3};
  s.wanted_N = {0, 0, 1e12};
  watch.add(s, 0.0, InputKind::Mouse);
  watch.breakOff();
  const std::vector<AttemptEvent> events = watch.take(0.0);
  REQUIRE(events.size() == 1);
  const auto back = readEventLine(lineOf(events[0]));
  REQUIRE(bool(back));
  CHECK(glm::distance(*std::get<HipChunk>((*back)->what).samples.at(0).wanted_N, Vec3(0, 0, 100)) < 1e-3);
}

TEST_CASE("a line of a field with too few forces, or with one beyond the range, is refused") {
  const std::string free = R"({"kind":"trace","t":1,"from":0,"ms":[0],"feature":".","hip":[1,2,3])";
  CHECK(readEventLine(free + R"(,"wanted":[0,0.4,0],"free_force":[0.4,0,0]})"));
  for (const char* forces :
       {R"(,"wanted":[0,0.4],"free_force":[0.4,0,0]})", R"(,"wanted":[0,0.4,0]})",
        R"(,"wanted":[0,0.4,0],"free_force":[0.4]})", R"(,"wanted":[0,1e9,0],"free_force":[0,0,0]})"}) {
    CAPTURE(forces);
    CHECK_FALSE(readEventLine(free + forces));
  }
}

TEST_CASE(
    "a body that is turned where it is gives samples, a body at rest none; with and without a body are two lines") {
  TouchWatch watch;
  const auto hold = [](double angle) {
    TouchSample s;
    s.orientation = glm::angleAxis(angle, Vec3(0, 0, 1));
    s.body = PoseA{s.hip, s.orientation};
    return s;
  };
  for (int k = 0; k <= 1000; ++k) watch.add(hold(0.5 * k * 0.001), k * 0.001, InputKind::Mouse);
  for (int k = 1001; k <= 2000; ++k) watch.add(hold(0.5), k * 0.001, InputKind::Mouse);
  for (int k = 2001; k <= 3000; ++k) watch.add(TouchSample(), k * 0.001, InputKind::Mouse);
  watch.breakOff();
  std::vector<HipChunk> chunks;
  for (AttemptEvent& e : watch.take(3.0))
    if (const auto* chunk = std::get_if<HipChunk>(&e.what)) chunks.push_back(*chunk);
  REQUIRE(chunks.size() == 2);
  CHECK(chunks[0].samples.size() >= 57);  // 60 a second while it turns, none while it rests
  CHECK(chunks[0].samples.size() <= 61);
  for (const HipSample& s : chunks[0].samples) {
    REQUIRE(s.held);
    CHECK(glm::length(rotationBetween(s.held->orientation, glm::angleAxis(0.5 * std::min(1.0, s.t_s), Vec3(0, 0, 1)))) <
          1e-9);
  }
  for (const HipSample& s : chunks[1].samples) CHECK_FALSE(s.held);
  // A pose that is none is passed over.
  TouchSample bad = hold(0.0);
  bad.body->orientation = Quat(0, 0, 0, 0);
  watch.add(bad, 4.0, InputKind::Mouse);
  watch.breakOff();
  CHECK(watch.take(4.0).empty());
}

TEST_CASE("the HIP samples of 10 s on a circle stay within 60 samples a second, 0.5 s a line and 0.5 A of the way") {
  TouchWatch watch;
  std::vector<HipSample> hips;
  double longest_s = 0.0;
  const auto way = [](double t) { return Vec3(5.0 * std::cos(t), 5.0 * std::sin(t), 0.0); };
  for (int k = 0; k <= 10'000; ++k) {
    TouchSample s;
    s.hip.A = s.contact.scp.A = way(k * 0.001);
    watch.add(s, k * 0.001, InputKind::Mouse);
    if (k % 16) continue;
    for (const AttemptEvent& e : watch.take(k * 0.001)) {
      const auto& samples = std::get<HipChunk>(e.what).samples;
      longest_s = std::max(longest_s, samples.back().t_s - samples.front().t_s);
      hips.insert(hips.end(), samples.begin(), samples.end());
    }
  }
  CHECK(longest_s <= TouchWatch::kHipChunk_s + 0.017);
  CHECK(hips.size() <= 600);
  CHECK(hips.size() >= 500);
  for (std::size_t k = 0; k < hips.size(); ++k) CHECK(glm::distance(hips[k].hip.A, way(hips[k].t_s)) < 1e-9);
}

TEST_CASE("a hand at rest for a minute gives 2 samples, one at each end of the rest") {
  TouchWatch watch;
  std::vector<HipSample> hips;
  for (int k = 0; k <= 60'100; ++k) {
    TouchSample s;
    s.hip.A = s.contact.scp.A = {k > 60'000 ? (k - 60'000) * 0.01 : 0.0, 0, 0};
    watch.add(s, k * 0.001, InputKind::Mouse);
    if (k % 16 == 0)
      for (const AttemptEvent& e : watch.take(k * 0.001))
        for (const HipSample& sample : std::get<HipChunk>(e.what).samples) hips.push_back(sample);
  }
  watch.breakOff();
  for (const AttemptEvent& e : watch.take(60.1))
    for (const HipSample& sample : std::get<HipChunk>(e.what).samples) hips.push_back(sample);
  REQUIRE(hips.size() >= 3);
  CHECK(hips.size() < 12);
  CHECK(hips[0].t_s == 0.0);
  CHECK(hips[1].t_s == doctest::Approx(60.0).epsilon(0.001));
  CHECK(hips[1].hip.A.x < 0.01);
}

TEST_CASE(
    "chatter between two features at 1 kHz gives at most 250 samples a second; numbers that are not finite give none") {
  TouchWatch watch;
  std::size_t samples = 0;
  for (int k = 0; k < 2000; ++k) {
    watch.add(touching(k % 2, k * 0.001), k * 0.001, InputKind::Mouse);
    TouchSample bad = touching(1, k * 0.001);
    bad.force.N.x = std::numeric_limits<double>::quiet_NaN();
    watch.add(bad, k * 0.001, InputKind::Mouse);
  }
  watch.breakOff();
  for (const AttemptEvent& e : watch.take(2.0)) {
    if (const auto* chunk = std::get_if<HipChunk>(&e.what)) samples += chunk->samples.size();
    if (const auto* end = std::get_if<TouchEnded>(&e.what)) CHECK(end->crossings == 1999);
  }
  CHECK(samples <= 501);
  CHECK(samples >= 300);
}

}  // namespace
}  // namespace moltact
