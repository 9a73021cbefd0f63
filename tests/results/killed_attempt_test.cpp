// The report of an attempt whose program was killed. Oracle: the clock that moved the hand.
#include <doctest/doctest.h>

#include "engine/results/attempt_file.h"
#include "engine/results/attempt_log.h"
#include "engine/results/class_summary.h"
#include "engine/results/touch_watch.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr double kFrame_s = 1.0 / 60.0;

// What the window does in a frame.
struct Window {
  AttemptLog log;
  TouchWatch touch;
  double now_s = 0.0;

  explicit Window(AttemptLog begun) : log(std::move(begun)) {}
  // 2 N at a place that moves at 1 Å/s; a frame has two ticks.
  void frame(bool touching) {
    now_s += kFrame_s;
    for (const double t_s : {now_s - 0.5 * kFrame_s, now_s}) {
      TouchSample s;
      s.hip.A = {t_s, 0, 0};
      s.contact.scp.A = {t_s, 1, 0};
      s.contact.feature = touching ? Feature::Sphere : Feature::Free;
      if (touching) s.contact.atoms = {3, -1, -1};
      s.force.N = {touching ? 2.0 : 0.0, 0, 0};
      touch.add(s, t_s, InputKind::Device);
    }
    for (AttemptEvent& e : touch.take(now_s)) log.add(std::move(e));
    log.heartbeat(now_s);
  }
};

PersonScore scoreOf(const fs::path& file) {
  Expected<Attempt> attempt = readAttempt(file, ReadDepth::NoHipSamples);
  REQUIRE(bool(attempt));
  CHECK(attempt->problems.empty());
  const ClassSummary summary = summarise({*std::move(attempt)});
  return summary.lessons.at(0).people.at(0);
}

TEST_CASE(
    "killed in any second of 5 s of reading, 25 s of pressing and 25 s of reading, the report is right to 1 s of the "
    "kill") {
  const ScratchFolder scratch;
  Window window(AttemptLog(scratch.path, sampleHeader()));
  window.log.add({0.0, StepEntered{"one"}});
  window.log.add({0.1, HintOpened{"one"}});
  std::uintmax_t before = 0;
  for (int frame = 1; frame <= 55 * 60; ++frame) {
    const double t_s = frame * kFrame_s;
    window.frame(t_s > 5.0 && t_s <= 30.0);
    if (frame % 47) continue;  // every 0.78 s
    REQUIRE(window.log.flush());
    const fs::path killed = scratch.path / "killed";
    fs::copy_file(window.log.file(), killed, fs::copy_options::overwrite_existing);
    const PersonScore score = scoreOf(killed);
    const double touched_s = std::clamp(t_s - 5.0, 0.0, 25.0);
    CAPTURE(t_s);
    CHECK(score.time_s <= t_s + 1e-3);
    CHECK(score.time_s >= t_s - 1.0);
    CHECK(score.step_s.at("one") == doctest::Approx(score.time_s));
    CHECK(score.touch_s <= touched_s + 0.03);
    CHECK(score.touch_s >= touched_s - 1.0);
    CHECK(score.path_A == doctest::Approx(score.touch_s).epsilon(0.02));
    if (touched_s > 1.0) {
      CHECK(score.touches == 1);
      CHECK(score.peak_N == 2.0);
      CHECK(score.mean_N == 2.0);
      CHECK(score.input() == InputKind::Device);
    }
    if (t_s > 32.0 && !before) before = fs::file_size(killed);
  }
  // Reading alone: 27 bytes each 0.9 s. (The hand's continuing motion is written in lines of its own.)
  std::size_t still = 0, touching = 0;
  const Attempt attempt = *readAttempt(window.log.file(), ReadDepth::NoHipSamples);
  for (const AttemptEvent& e : attempt.events) {
    still += std::holds_alternative<Heartbeat>(e.what);
    touching += std::holds_alternative<TouchSoFar>(e.what);
  }
  CHECK(touching <= 28);
  CHECK(touching >= 25);
  CHECK(still <= 34);
  CHECK(lineOf({1234.567, Heartbeat{}}).size() < 40);
}

TEST_CASE(
    "an attempt that is taken up after a kill counts the touch that was cut off once, and the next one from where it "
    "began") {
  const ScratchFolder scratch;
  fs::path file;
  {
    Window window(AttemptLog(scratch.path, sampleHeader()));
    window.log.add({0.0, StepEntered{"one"}});
    for (int frame = 0; frame < 600; ++frame) window.frame(true);
    REQUIRE(window.log.flush());
    file = window.log.file();
    fs::copy_file(file, scratch.path / "killed.jsonl");
  }
  const fs::path again = scratch.path / "killed.jsonl";
  const double end_s = readAttempt(again)->end_s();
  CHECK(end_s == doctest::Approx(10.0).epsilon(0.1));
  {
    Window window(AttemptLog(again, end_s, Resumed{"2026-11-21T11:05:00Z", "0.1.0", "Mouse", false}));
    for (int frame = 0; frame < 120; ++frame) window.frame(false);
    for (int frame = 0; frame < 300; ++frame) window.frame(true);
    for (int frame = 0; frame < 60; ++frame) window.frame(false);
    REQUIRE(window.log.flush());
  }
  const PersonScore score = scoreOf(again);
  CHECK(score.touches == 2);
  CHECK(score.touch_s == doctest::Approx(15.0).epsilon(0.07));
  CHECK(score.time_s == doctest::Approx(end_s + 8.0).epsilon(0.12));
  // The hand's way continues in time, too.
  const Attempt whole = *readAttempt(again);
  double last_s = 0.0;
  for (const AttemptEvent& e : whole.events)
    if (const auto* chunk = std::get_if<HipChunk>(&e.what)) {
      CHECK(chunk->samples.front().t_s >= last_s);
      last_s = chunk->samples.back().t_s;
    }
  CHECK(last_s == doctest::Approx(score.time_s).epsilon(0.05));
}

TEST_CASE(
    "an attempt of an older Moltact, whose touches after it was taken up count from there, is read with the times put "
    "right") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path / "old.jsonl";
  HipChunk chunk;
  for (int k = 0; k < 3; ++k) {
    HipSample s;
    s.t_s = 2.0 + 0.2 * k;
    chunk.samples.push_back(s);
  }
  std::string bytes = lineOf(sampleHeader());
  for (const AttemptEvent& e :
       std::vector<AttemptEvent>{{100.0, Resumed{"2026-11-21T11:05:00Z", "0.1.0", "Mouse", false}},
                                 {102.0, TouchBegan{{1}}},
                                 {102.4, chunk},
                                 {105.0, TouchEnded{2.0, {1}, 0, 1.0, 1.0, 1.0, InputKind::Mouse}},
                                 {250.0, TouchBegan{{1}}},
                                 {255.0, TouchEnded{150.0, {1}, 0, 1.0, 1.0, 1.0, InputKind::Mouse}}})
    bytes += lineOf(e);
  writeFile(file, bytes);
  CHECK(scoreOf(file).touch_s == doctest::Approx(8.0));
  const Attempt attempt = *readAttempt(file);
  CHECK(std::get<HipChunk>(attempt.events[2].what).samples[0].t_s == doctest::Approx(102.0));
}

}  // namespace
}  // namespace moltact
