// A hand recorded and played in the window. Oracle: the file's own ticks, and a replay that is identical to the last
// bit.
#include <cmath>

#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/extensions.h"
#include "engine/haptics/methods.h"
#include "engine/molecule/reader.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

bool recordingReported(ScriptedUser& d, const std::string& part) {
  for (const Message& m : d.app().messages.all())
    if (contains(m.text, part)) return true;
  return false;
}

// The simulated stylus on ubiquitin for 6 s.
std::filesystem::path recordingRecorded(const Scratch& scratch) {
  const std::filesystem::path file = scratch.folder / "hand.recording";
  auto d = startWith("1ubq");
  d->app().extensions().device.choose("simulated");
  d->frames(10);
  d->app().extensions().hand_recorder.record(file);
  d->tap("Ctrl+D");
  d->frames(180);
  CHECK(contains(d->text("device/recording"), "s recorded in hand.recording"));
  d->frames(180);
  CHECK(d->click("device/record"));
  CHECK(recordingReported(*d, "of the hand are in"));
  return file;
}

}  // namespace

TEST_CASE("what the device page records replays to the last bit, and touches") {
  const Scratch scratch;
  const Expected<ServoRecording> trace = readServoRecording(recordingRecorded(scratch));
  REQUIRE(trace);
  CHECK(trace->labels.at("molecule") == "1ubq");
  CHECK(trace->labels.at("method") == "exact");
  CHECK(trace->labels.at("balls").starts_with("602 "));
  CHECK(trace->ticks.size() > 5900);
  double greatest = 0;
  for (const RecordedTick& tick : trace->ticks) greatest = std::max(greatest, glm::length(tick.force.N));
  CHECK(greatest > 0.5);
  const Expected<Molecule> molecule = readMolecule(MOLTACT_SOURCE_DIR "/molecules/1ubq.pdb");
  REQUIRE(molecule);
  const auto tracker = findMethod("exact")->make(std::make_shared<const SphereGrid>(molecule->spheres),
                                                 trace->ticks.front().settings.probe_A);
  const ReplayResult result = replay(*trace, tracker.get());
  CHECK(result.ticks == trace->ticks.size());
  CHECK_FALSE(result.first_difference);
}

TEST_CASE(
    "Record on the device page asks for a file and records into it; the words over the view lead back to the page, "
    "where it is stopped") {
  const Scratch scratch;
  ScriptedUser::Options options;
  options.height = 1300;  // the whole page
  options.application.picture_folder = scratch.folder;
  auto d = startWith("1ubq", options);
  d->tap("Ctrl+D");
  d->frames(3);
  REQUIRE(d->click("device/simulated"));
  d->frames(5);
  CHECK(d->click("device/record"));
  d->frames(5);
  CHECK(d->text("file/name") == "1ubq.recording");
  CHECK(d->click("file/choose"));
  d->frames(60);
  CHECK(d->app().extensions().hand_recorder.recording());
  std::string message;
  for (std::size_t k = 0; k < d->app().messages.all().size(); ++k)
    if (contains(d->app().messages.all()[k].text, "The hand is recorded in 1ubq.recording."))
      message = "message/" + std::to_string(k);
  CHECK(d->click(message + "/device"));
  d->frames(5);
  CHECK(d->click("device/record"));
  CHECK_FALSE(d->app().extensions().hand_recorder.recording());
  CHECK(readServoRecording(scratch.folder / "1ubq.recording")->ticks.size() > 900);
}

TEST_CASE(
    "a recording that is opened brings its molecule, leads the hand over it as it was led, with no device open, and "
    "gives back what led before") {
  const Scratch scratch;
  const std::filesystem::path file = recordingRecorded(scratch);
  const ServoRecording trace = *readServoRecording(file);
  auto d = startWith("1hel");
  d->app().extensions().device.choose("simulated");
  d->frames(10);
  const double stiffness = d->app().scene.servo_settings.stiffness_N_per_mm;
  d->app().open(file);
  d->frames(3);
  HandRecorder& player = d->app().extensions().hand_recorder;
  REQUIRE(player.playing());
  CHECK(d->app().scene.molecule().file.stem() == "1ubq");
  CHECK_FALSE(recordingReported(*d, "is not what the hand was recorded on"));
  CHECK(d->text("status/device") == "Recorded hand");
  CHECK_FALSE(d->app().scene.servo().device().gives_force);
  CHECK(player.length_s() == doctest::Approx(double(trace.ticks.size()) * kTick_s));
  int compared = 0, touching = 0;
  for (int k = 0; k < 300; ++k) {
    d->frames(1);
    const ServoSample& now = d->app().scene.log().latest();
    if (now.discontinuities != d->app().scene.servo_settings.discontinuities) continue;
    const std::size_t at = std::size_t(std::lround(player.at_s() / kTick_s)) - 1;
    REQUIRE(at < trace.ticks.size());
    const RecordedTick& tick = trace.ticks[at];
    CHECK(glm::distance(now.hip.A, tick.settings.workspace.toMolecule(tick.pose.position).A) < 1e-9);
    ++compared;
    touching += now.contact.touching();
  }
  CHECK(compared > 250);
  CHECK(touching > 60);
  d->tap("Ctrl+D");
  d->frames(3);
  CHECK(contains(d->text("device/recording"), "hand.recording. No force is given meanwhile."));
  d->frames(120);
  CHECK_FALSE(player.playing());
  CHECK(recordingReported(*d, "hand.recording has been played to its end"));
  CHECK(d->text("status/device") == "Simulated stylus");
  CHECK(d->app().scene.servo_settings.stiffness_N_per_mm == stiffness);
  CHECK(d->app().scene.servo_settings.clutch.at_edge);
}

TEST_CASE(
    "a recording of a hand that holds a body puts the body back into the hand wherever its molecule can be opened, "
    "leads "
    "it by its poses, and leaves the molecule whole at its end") {
  const Scratch scratch;
  const std::filesystem::path file = scratch.folder / "body.recording";
  std::vector<std::uint32_t> held;
  {
    auto d = startWith(scratch
                           .file("mine.md",
                                 "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: 1hpv\nauthor: A\nlicence: L\n---\n"
                                 "## One\n```scene\nmolecule: 1hpv\nin-hand: ligand\n```\nText.\n")
                           .string());
    held = d->app().scene.stage().body->atoms;
    d->app().extensions().device.choose("simulated");
    d->frames(10);
    d->app().extensions().hand_recorder.record(file);
    d->frames(180);
    d->app().extensions().hand_recorder.stop();
  }
  const Expected<ServoRecording> trace = readServoRecording(file);
  REQUIRE(trace);
  CHECK(trace->torn.empty());
  const RecordedScene scene =
      recordedScene(trace->labels, readMolecule(MOLTACT_SOURCE_DIR "/molecules/1hpv.pdb")->spheres);
  REQUIRE(scene.body);
  CHECK(scene.body->atoms == held);
  CHECK_FALSE(
      replay(*trace, makeInteraction({.spheres = scene.spheres, .touch = touchOf(*trace), .body = scene.body}).get())
          .first_difference);

  auto d = startWith("1hpv");
  d->frames(10);
  const Camera seen = d->app().scene.camera;
  d->app().open(file);
  d->frames(3);
  HandRecorder& player = d->app().extensions().hand_recorder;
  REQUIRE(player.playing());
  CHECK_FALSE(recordingReported(*d, "is not the one of this recording"));
  REQUIRE(d->app().scene.stage().body);
  CHECK(d->app().scene.stage().body->atoms == held);
  REQUIRE(d->app().scene.look.atoms.hidden);
  CHECK(*d->app().scene.look.atoms.hidden == held);
  int compared = 0;
  for (int k = 0; k < 100 && player.playing(); ++k) {
    d->frames(1);
    const ServoSample& now = d->app().scene.log().latest();
    if (!player.playing() || now.discontinuities != d->app().scene.servo_settings.discontinuities) continue;
    const RecordedTick& tick = trace->ticks[std::size_t(std::lround(player.at_s() / kTick_s)) - 1];
    const PoseA pose = tick.settings.workspace.toMolecule(tick.pose.position, tick.pose.orientation);
    CHECK(now.holds_body);
    CHECK(glm::distance(now.hip.A, pose.place.A) < 1e-9);
    CHECK(glm::length(rotationBetween(now.orientation, pose.orientation)) < 1e-9);
    ++compared;
  }
  CHECK(compared > 50);
  for (int k = 0; k < 300 && player.playing(); ++k) d->frames(1);
  d->frames(3);
  CHECK_FALSE(player.playing());
  CHECK_FALSE(d->app().scene.stage().body);
  CHECK_FALSE(d->app().scene.stage().spheres->hasUntouchable());
  CHECK_FALSE(d->app().scene.look.atoms.hidden);
  CHECK(d->app().scene.camera == seen);
}

TEST_CASE("a recorded hand that presses on a lesson's molecule does not do the lesson's task") {
  const Scratch scratch;
  const std::filesystem::path file = recordingRecorded(scratch);
  auto d = startWith("");
  d->app().open(scratch.file("press.md", R"(---
title: Press
minutes: 5
goals: Press.
molecules: 1ubq
author: A
licence: CC0
---

## Press

```scene
molecule: 1ubq
```

```touch
press: anywhere
until: 0.3 N
say: Press.
```

Press.
)"));
  d->app().finishLoading();
  d->frames(10);
  REQUIRE(d->app().lesson.session());
  d->app().open(file);
  d->frames(3);
  REQUIRE(d->app().extensions().hand_recorder.playing());
  double greatest_N = 0;
  while (d->app().extensions().hand_recorder.playing()) {
    d->frames(1);
    greatest_N = std::max(greatest_N, d->app().scene.log().force_N());
  }
  CHECK(greatest_N > 0.5);
  CHECK_FALSE(d->app().lesson.session()->task(0).done);
}

TEST_CASE("a recording whose molecule has changed since says so, and is played all the same") {
  const Scratch scratch;
  ServoRecording trace = *readServoRecording(recordingRecorded(scratch));
  trace.labels["balls"] = "601 0000000000000000";
  const std::filesystem::path other = scratch.folder / "other.recording";
  {
    auto writer = ServoRecordingWriter::create(other);
    REQUIRE(writer);
    REQUIRE_FALSE(writer->begin(trace.labels, *trace.start));
    for (const RecordedTick& tick : trace.ticks) REQUIRE_FALSE(writer->add(tick));
    REQUIRE_FALSE(writer->finish());
  }
  auto d = startWith("1ubq");
  d->app().open(other);
  d->frames(3);
  CHECK(recordingReported(*d, "is not the one of this recording"));
  CHECK(d->app().extensions().hand_recorder.playing());
}

TEST_CASE(
    "another device that is chosen while a recording plays ends it; a text is reported and changes "
    "nothing; another method ends a recording") {
  const Scratch scratch;
  const std::filesystem::path file = recordingRecorded(scratch);
  auto d = startWith("1ubq");
  d->app().open(file);
  d->frames(10);
  HandRecorder& recorder = d->app().extensions().hand_recorder;
  REQUIRE(recorder.playing());
  d->app().extensions().device.choose("simulated");
  d->frames(3);
  CHECK_FALSE(recorder.playing());
  CHECK(d->text("status/device") == "Simulated stylus");
  CHECK(d->app().scene.servo_settings.clutch.at_edge);
  d->app().open(scratch.file("text.recording", "no recording"));
  d->frames(3);
  CHECK(recordingReported(*d, "no recording of a device"));
  CHECK_FALSE(recorder.playing());
  CHECK(d->text("status/device") == "Simulated stylus");

  recorder.record(scratch.folder / "second.recording");
  d->frames(60);
  CHECK(recorder.recording());
  useMethod(d->app().scene, "penalty");
  d->frames(3);
  CHECK_FALSE(recorder.recording());
  CHECK(readServoRecording(scratch.folder / "second.recording")->ticks.size() > 900);
}

TEST_CASE(
    "another device that is clicked on the open device page while a recording plays: the hand that plays lives until "
    "the frame has been drawn, then the other device leads") {
  const Scratch scratch;
  const std::filesystem::path file = recordingRecorded(scratch);
  auto d = startWith("1ubq");
  HandRecorder& recorder = d->app().extensions().hand_recorder;
  const auto playOnPage = [&] {
    d->app().open(file);
    d->frames(10);
    REQUIRE(recorder.playing());
    d->tap("Ctrl+D");
    d->frames(3);
    REQUIRE_FALSE(d->text("device/recording").empty());  // the page draws it, in view or below
  };
  playOnPage();
  // Simulates a click within a frame: the page continues and draws the hand that plays.
  const Device* const plays = d->app().scene.servo().loop().device();
  d->app().extensions().device.choose("simulated");
  CHECK(d->app().scene.servo().loop().device() == plays);
  CHECK(recorder.playing());
  CHECK(recorder.length_s() > 0.0);
  d->frames(1);
  CHECK(d->app().scene.servo().loop().device() != plays);
  CHECK_FALSE(recorder.playing());
  CHECK(recorder.at_s() == 0.0);
  // The click itself.
  d->tap("Escape");
  playOnPage();
  REQUIRE(d->click("device/mouse"));
  d->frames(3);
  CHECK_FALSE(recorder.playing());
  CHECK(d->text("status/device") == "Mouse");
}

}  // namespace moltact
