// A trajectory that moves the atoms of the scene: played, sought, recorded, played back, refused. Oracle: models in which
// all atoms of benzene are shifted by half an angstrom from frame to frame.
#include "app/ui/extensions/played_trajectory.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>

#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/elastic_molecule.h"
#include "app/ui/extensions/extensions.h"
#include "engine/haptics/methods.h"
#include "tests/app/small_window.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr double kShift_A = 0.5;

/// A molecule of the library, shifted along z from model to model by `steps` times kShift_A; or its last atom alone.
void writeModels(
    const fs::path& file, int frames, const char* molecule = "benzene.pdb",
    const std::function<double(int)>& steps = [](int f) { return double(f); }, bool last_alone = false) {
  std::ifstream in(fs::path(MOLTACT_SOURCE_DIR) / "molecules" / molecule);
  std::vector<std::string> atoms;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("ATOM") || line.starts_with("HETATM")) atoms.push_back(line);
  std::ofstream out(file);
  for (int f = 0; f < frames; ++f) {
    out << "MODEL\n";
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const double shift = !last_alone || i + 1 == atoms.size() ? kShift_A * steps(f) : 0.0;
      char z[20];
      std::snprintf(z, sizeof z, "%8.3f", std::stod(atoms[i].substr(46, 8)) + shift);
      out << std::string(atoms[i]).replace(46, 8, z) << '\n';
    }
    out << "ENDMDL\n";
  }
}

std::string playedTrajectoryLessonWith(const std::string& keys) {
  return "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: benzene\nauthor: A\nlicence: L\n---\n## One\n"
         "```scene\nmolecule: benzene\n" +
         keys + "```\n```touch\nreach: element C\nsay: Touch it.\n```\n\n> [!TIP]\n> Look.\n";
}

/// The common displacement of the drawn atoms from the file; fails if they differ by more than 1e-9 A.
double shift_A(ScriptedUser& user) {
  const AtomMotion& atoms = user.app().scene.atoms();
  const SharedArray<Sphere>&now = atoms.seen()->spheres, &rest = atoms.resting().molecule->spheres;
  const Vec3 first = now[0].centre_A - rest[0].centre_A;
  for (std::size_t i = 0; i < now.size(); ++i) REQUIRE(glm::distance(now[i].centre_A - rest[i].centre_A, first) < 1e-9);
  REQUIRE(std::abs(first.x) + std::abs(first.y) < 1e-9);
  return first.z;
}

TEST_CASE(
    "a lesson's trajectory plays at its speed, turns round at its last frame and stays between its frames; the atoms "
    "are on the line between two frames; a playback puts them where they were within 1e-9 A of the recorded frame") {
  const ScratchFolder scratch;
  writeModels(scratch.path / "shift.pdb", 12);
  writeFile(scratch.path / "mine.md",
            playedTrajectoryLessonWith("trajectory: shift.pdb, not superposed\nframes: 2-9\nspeed: 4\n"));
  fs::path file;
  {
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
    const PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
    REQUIRE(trajectory.ready());
    CHECK(trajectory.frames() == 12);
    CHECK(trajectory.format() == "PDB");
    user->point("view", 0.5, 0.5);
    user->press();
    double highest = 0.0, lowest = 99.0;
    for (int k = 0; k < 120; ++k) {
      user->frames(3);
      const double at = shift_A(*user) / kShift_A;
      highest = std::max(highest, at);
      lowest = std::min(lowest, at);
      // The atoms follow the requested place by at most two pieces of the motion.
      CHECK(std::abs(at - trajectory.at()) <= 4.0 * 2.0 * PlayedTrajectory::kPiece_ticks * kTick_s + 1e-9);
    }
    CHECK(lowest >= 1.0 - 1e-9);
    CHECK(highest <= 8.0 + 1e-9);
    // In six seconds, 24 frames: three times across the seven steps.
    CHECK(highest > 7.8);
    CHECK(lowest < 1.2);
    REQUIRE(user->app().extensions().recorder.flush());
    file = user->app().extensions().recorder.file();
  }
  const Expected<Attempt> attempt = readAttempt(file);
  REQUIRE(bool(attempt));
  CHECK(attempt->problems.empty());
  const AtomsMoved* last = nullptr;
  double at_s = 0.0;
  std::size_t count = 0;
  for (const AttemptEvent& e : attempt->events)
    if (const auto* moved = std::get_if<AtomsMoved>(&e.what)) {
      CHECK(moved->by == "trajectory");
      CHECK(moved->file == "shift.pdb");
      CHECK(moved->detail == "not superposed");
      if (std::abs(moved->position - 5.0) < 2.0) last = moved, at_s = e.t_s;
      ++count;
    }
  CHECK(count > 15);
  REQUIRE(last);
  const auto user = startWith("benzene", smallWindow({}));
  user->app().open(file);
  user->app().finishLoading();
  Playback& playback = user->app().extensions().playback;
  playback.setRunning(false);
  playback.seek(at_s + 1e-3);
  user->frames(4);
  CHECK(shift_A(*user) == doctest::Approx(kShift_A * (last->position - 1.0)).epsilon(1e-9));
}

TEST_CASE(
    "a hand recorded on a trajectory replays to the last bit, from where the atoms were when the recording began; "
    "played in the window, the atoms move as they did, late by at most two pieces of the motion") {
  const ScratchFolder scratch;
  writeModels(scratch.path / "shift.pdb", 12);
  writeFile(scratch.path / "mine.md",
            playedTrajectoryLessonWith("trajectory: shift.pdb, not superposed\nframes: 3-9\nspeed: 4\n"));
  const fs::path file = scratch.path / "hand.recording";
  std::vector<double> shifts;
  {
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
    REQUIRE(user->app().extensions().movers.get<PlayedTrajectory>().ready());
    user->app().extensions().device.choose("simulated");
    user->frames(60);
    user->app().extensions().hand_recorder.record(file);
    REQUIRE(user->app().extensions().hand_recorder.recording());
    for (int k = 0; k < 240; ++k) {
      user->frames(1);
      shifts.push_back(shift_A(*user));
    }
    user->app().extensions().hand_recorder.stop();
  }
  const Expected<ServoRecording> recorded = readServoRecording(file);
  REQUIRE(recorded);
  CHECK(recorded->torn.empty());
  CHECK(recorded->placed.size() == 12);
  CHECK(recorded->motions.size() > 100);
  int touching = 0;
  for (const RecordedTick& tick : recorded->ticks) touching += tick.motion > 0 && glm::length(tick.force.N) > 0.0;
  MESSAGE(recorded->ticks.size(), " ticks, ", touching, " with a force on atoms that move");
  CHECK(touching > 100);
  const RecordedScene scene = recordedScene(recorded->labels, SharedArray<Sphere>(recorded->placed));
  CHECK(recorded->labels.at("balls") == fingerprint(*scene.spheres));
  CHECK(recorded->labels.at("moved") == "trajectory");
  CHECK(recorded->labels.at("moved_by_file") == "shift.pdb");
  CHECK(recorded->labels.at("moved_how") == "not superposed");
  const double frame = std::stod(recorded->labels.at("moved_at"));
  CHECK(frame >= 3.0);
  CHECK(frame <= 9.0);
  const auto tracker = findMethod("exact")->make(scene.spheres, recorded->ticks.front().settings.probe_A);
  const ReplayResult result = replay(*recorded, tracker.get(), scene.spheres.get());
  CHECK(result.ticks == recorded->ticks.size());
  CHECK(result.motion_unknown == 0);
  CHECK_FALSE(result.first_difference);

  const auto user = startWith("benzene", smallWindow({}));
  user->app().open(file);
  user->app().finishLoading();
  const HandRecorder& player = user->app().extensions().hand_recorder;
  user->frames(2);
  REQUIRE(player.playing());
  int compared = 0;
  while (player.playing() && compared < 200) {
    user->frames(1);
    const auto at = std::size_t(player.at_s() * 60.0);
    if (at < 4 || at + 1 >= shifts.size()) continue;
    double off = 99.0;
    for (std::size_t k = at - 4; k <= at + 1; ++k) off = std::min(off, std::abs(shifts[k] - shift_A(*user)));
    CHECK(off < 4.0 * 2.0 * PlayedTrajectory::kPiece_ticks * kTick_s * kShift_A);
    ++compared;
  }
  CHECK(compared == 200);
}

TEST_CASE(
    "an opened trajectory waits at its first frame; a frame that the user chooses is reached at 8 A/s at most, also "
    "under a probe that touches; closed, the atoms return") {
  const ScratchFolder scratch;
  writeModels(scratch.path / "shift.pdb", 30);
  // A window opens a PDB file as a molecule.
  const auto user = startWith("benzene", smallWindow({}));
  PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
  REQUIRE(trajectory.open(FileKind::Trajectory, scratch.path / "shift.pdb"));
  user->frames(4);
  REQUIRE(trajectory.ready());
  CHECK(!trajectory.running());
  // Superposed: a shift of all atoms is no motion.
  CHECK(std::abs(shift_A(*user)) < 1e-6);
  trajectory.goTo(20.0);
  user->frames(60);
  CHECK(trajectory.at() == 20.0);
  CHECK(std::abs(shift_A(*user)) < 1e-6);
  trajectory.close();
  user->frames(2);
  CHECK(!trajectory.ready());
  CHECK(shift_A(*user) == 0.0);
}

TEST_CASE("an elastic molecule gives the atoms to a trajectory that is opened, and does not take them back") {
  const ScratchFolder scratch;
  writeModels(scratch.path / "shift.pdb", 12, "1ubq.pdb");
  const auto user = startWith("1ubq", smallWindow({}));
  ElasticMolecule& elastic = user->app().extensions().movers.get<ElasticMolecule>();
  elastic.start();
  for (int k = 0; k < 600 && !elastic.owns(); ++k) user->frames(1);
  REQUIRE(elastic.owns());
  PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
  REQUIRE(trajectory.open(FileKind::Trajectory, scratch.path / "shift.pdb"));
  CHECK_FALSE(elastic.on());
  for (int k = 0; k < 600 && !trajectory.owns(); ++k) user->frames(1);
  CHECK(trajectory.owns());
  trajectory.goTo(10.0);
  user->frames(180);
  CHECK(trajectory.at() == 10.0);
  CHECK(trajectory.owns());
}

TEST_CASE(
    "the bar and the panel of a trajectory: play and pause, a slider that leads to a frame, the speed, the smoothing "
    "and "
    "the three ends act on the atoms as they say") {
  const ScratchFolder scratch;
  writeModels(scratch.path / "shift.pdb", 9);
  writeFile(scratch.path / "mine.md",
            playedTrajectoryLessonWith("trajectory: shift.pdb, not superposed\nspeed: 0\npanels: motion\n"));
  ScriptedUser::Options options = smallWindow(scratch.path);
  options.width = 1280;
  options.height = 1000;
  const auto user = startWith((scratch.path / "mine.md").string(), options);
  PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
  REQUIRE(trajectory.ready());
  user->frames(10);
  const auto frame = [&] { return shift_A(*user) / kShift_A; };
  // It stands until it is played; then it moves at the slowest speed of 0.5 frames per second.
  CHECK(user->text("trajectory/play") == "Play");
  user->frames(60);
  CHECK(frame() == 0.0);
  REQUIRE(user->click("trajectory/play"));
  CHECK(user->text("trajectory/play") == "Pause");
  user->frames(120);
  CHECK(frame() == doctest::Approx(1.0).epsilon(0.15));
  // The slider of the speed: near its right end 60 frames per second, which turn round within 0.3 s.
  REQUIRE(user->point("trajectory/speed", 0.99, 0.85));
  user->press();
  user->frames(2);
  user->release();
  CHECK(trajectory.framesPerSecond() > 0.9 * PlayedTrajectory::kFastest_per_s);
  double low = 9.0, high = 0.0;
  for (int k = 0; k < 60; ++k) {
    user->frames(1);
    low = std::min(low, frame());
    high = std::max(high, frame());
  }
  CHECK(low < 1.5);
  CHECK(high > 6.5);
  REQUIRE(user->click("trajectory/play"));
  user->frames(10);
  const double paused = frame();
  user->frames(60);
  CHECK(frame() == doctest::Approx(paused).epsilon(1e-12));
  // The slider of the frames: its right end is the last frame, its middle the fifth.
  REQUIRE(user->point("trajectory/frames", 0.98, 0.5));
  user->press();
  user->frames(2);
  user->release();
  user->frames(90);
  CHECK(frame() == doctest::Approx(8.0).epsilon(1e-9));
  CHECK(user->text("trajectory/frame") == "9 of 9");
  // Stop: played from the end, it begins again at the first frame and stops at the last.
  trajectory.setFramesPerSecond(20.0);
  REQUIRE(user->click("trajectory/end/Stop"));
  CHECK(trajectory.at_end == PlayedTrajectory::AtEnd::Stop);
  REQUIRE(user->click("trajectory/play"));
  low = 9.0;
  for (int k = 0; k < 180; ++k) {
    user->frames(1);
    low = std::min(low, frame());
  }
  CHECK(low < 0.5);
  CHECK(frame() == doctest::Approx(8.0).epsilon(1e-9));
  CHECK_FALSE(trajectory.running());
  // Return: after the last frame the frames fall one by one. Repeat: they never fall slowly, but come back at once.
  const auto countsOf = [&](const char* end) {
    REQUIRE(user->click(end));
    trajectory.goTo(6.0);
    user->frames(90);
    if (!trajectory.running()) user->click("trajectory/play");
    int falling = 0, rising = 0, leaps = 0;
    double before = frame();
    for (int k = 0; k < 60; ++k) {
      user->frames(1);
      const double step = frame() - before;
      before = frame();
      if (step < -1.5)
        ++leaps;
      else if (step < 0.0)
        ++falling;
      else if (step > 0.0)
        ++rising;
    }
    user->click("trajectory/play");
    user->frames(10);
    return std::array{falling, rising, leaps};
  };
  const auto back = countsOf("trajectory/end/Return"), again = countsOf("trajectory/end/Repeat");
  CHECK(back[0] > 15);
  CHECK(back[2] == 0);
  CHECK(again[1] > 2 * again[0]);
  CHECK(again[2] > 0);
  CHECK(trajectory.smoothing() == 0);
  REQUIRE(user->point("trajectory/smoothing", 0.99, 0.85));
  user->press();
  user->frames(2);
  user->release();
  CHECK(trajectory.smoothing() == PlayedTrajectory::kMaxSmoothing);
}

TEST_CASE("smoothed by two frames, a zigzag of 0.5 A shows the mean of five frames, on the screen and under the hand") {
  const ScratchFolder scratch;
  writeModels(scratch.path / "shift.pdb", 9, "benzene.pdb", [](int f) { return f % 2 ? 1.0 : 0.0; });
  writeFile(scratch.path / "mine.md",
            playedTrajectoryLessonWith("trajectory: shift.pdb, not superposed\nspeed: 0\npanels: motion\n"));
  const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
  PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
  REQUIRE(trajectory.ready());
  trajectory.goTo(4.0);
  user->frames(60);
  CHECK(shift_A(*user) == doctest::Approx(0.0));
  trajectory.setSmoothing(2);
  user->frames(60);
  CHECK(shift_A(*user) == doctest::Approx(kShift_A * 2.0 / 5.0).epsilon(1e-3));
}

TEST_CASE(
    "coloured by fluctuation, the legend gives the range when the survey is done, and closed the colour is gone") {
  const ScratchFolder scratch;
  // Superposed: the ring is at rest but for one hydrogen, which swings by 0.5 A.
  writeModels(
      scratch.path / "shift.pdb", 8, "benzene.pdb", [](int f) { return f % 2 ? 1.0 : -1.0; }, true);
  const auto user = startWith("benzene", smallWindow({}));
  PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
  REQUIRE(trajectory.open(FileKind::Trajectory, scratch.path / "shift.pdb"));
  SceneLook& look = user->app().scene.look;
  look.atoms.colouring = look.colouring("fluctuation");
  for (int k = 0; k < 300 && look.fluctuation_A.empty(); ++k) user->frames(1);
  user->frames(2);
  REQUIRE(look.fluctuation_A.size() == 12);
  const auto most = std::max_element(look.fluctuation_A.begin(), look.fluctuation_A.end());
  CHECK(double(*most) == doctest::Approx(kShift_A).epsilon(0.15));
  // The swinging atom has a colour of its own, and the others nearly the same one.
  REQUIRE(look.atoms.colouring);
  const auto& colours = look.atoms.colouring->of_atom;
  REQUIRE(colours.size() == 12);
  const auto swings = std::size_t(most - look.fluctuation_A.begin());
  const auto apart = [](const Rgb8& a, const Rgb8& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
  };
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (i != swings) CHECK(apart(colours[i], colours[swings]) > 60);
  const Picture fluctuation = user->picture();
  look.atoms.colouring = look.colouring("element");
  user->frames(2);
  CHECK(fluctuation.rgb != user->picture().rgb);
  trajectory.close();
  user->frames(2);
  CHECK(look.fluctuation_A.empty());
}

// Two bonded carbons at rest, and an ion in a cell of 20 A.
std::string withIon(double x) {
  char text[400];
  std::snprintf(text, sizeof text,
                "HETATM    1  C1  LIG A   1    %8.3f%8.3f%8.3f  1.00  0.00           C\n"
                "HETATM    2  C2  LIG A   1    %8.3f%8.3f%8.3f  1.00  0.00           C\n"
                "HETATM    3 NA    NA A   2    %8.3f%8.3f%8.3f  1.00  0.00          NA\n",
                0.0, 0.0, 0.0, 1.5, 0.0, 0.0, x, 6.0, 0.0);
  return text;
}

struct IonFrame {
  double x_A = 0.0;
  bool has_cell = true;
};

void writeIonLesson(const fs::path& folder, const std::vector<IonFrame>& frames) {
  writeFile(folder / "box.pdb", withIon(0.0) + "END\n");
  std::string run;
  for (const IonFrame& f : frames)
    run += "MODEL\n" +
           std::string(f.has_cell ? "CRYST1   20.000   20.000   20.000  90.00  90.00  90.00 P 1           1\n" : "") +
           withIon(f.x_A) + "ENDMDL\n";
  writeFile(folder / "run.pdb", run);
  writeFile(folder / "mine.md",
            "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: box\nauthor: A\nlicence: L\n---\n## One\n```scene\n"
            "molecule: box\ntrajectory: run.pdb, not superposed\nspeed: 4\n```\nText.\n");
}

TEST_CASE(
    "an ion that moves by 16 A through frames of which only the first and the last two state a cell does not leap: it "
    "is "
    "drawn at its full size in each picture") {
  const ScratchFolder scratch;
  writeIonLesson(
      scratch.path,
      {{-8.0, true}, {-4.8, false}, {-1.6, false}, {1.6, false}, {4.8, false}, {8.0, false}, {8.0, true}, {8.2, true}});
  const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
  PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
  REQUIRE(trajectory.ready());
  trajectory.at_end = PlayedTrajectory::AtEnd::Stop;
  const auto ion = [&] { return user->app().scene.atoms().seen()->spheres[2]; };
  const double size_A = ion().radius_A;
  for (int k = 0; k < 150; ++k) {
    user->frames(1);
    CHECK(ion().radius_A == size_A);
  }
  CHECK_FALSE(trajectory.running());
  CHECK(ion().centre_A.x == doctest::Approx(8.2).epsilon(1e-6));
}

TEST_CASE(
    "an ion that leaves a cell of 20 A comes back on the other side: in no picture is it on the way through the cell, "
    "and "
    "it arrives at its full size") {
  const ScratchFolder scratch;
  // It moves on by 2.4 A from frame to frame, and leaps after frame 5.
  writeIonLesson(scratch.path, {{0.0}, {2.4}, {4.8}, {7.2}, {9.6}, {12.0}, {14.4}});
  const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
  PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
  REQUIRE(trajectory.ready());
  trajectory.at_end = PlayedTrajectory::AtEnd::Stop;
  const auto ion = [&] { return user->app().scene.atoms().seen()->spheres[2]; };
  const double size_A = ion().radius_A;
  REQUIRE(size_A > 0.5);
  int away = 0;
  for (int k = 0; k < 150; ++k) {
    user->frames(1);
    const Sphere now = ion();
    if (now.radius_A == 0.0) {
      ++away;
      continue;
    }
    CHECK((now.centre_A.x > -0.01 || now.centre_A.x < -5.59));
    CHECK(now.centre_A.x < 9.61);
  }
  CHECK(away > 0);
  CHECK_FALSE(trajectory.running());
  CHECK(ion().centre_A.x == doctest::Approx(14.4 - 20.0).epsilon(1e-6));
  CHECK(ion().radius_A == size_A);
  // The way to a frame that the user chose leaps too.
  trajectory.goTo(4.0);
  for (int k = 0; k < 120; ++k) {
    user->frames(1);
    if (ion().radius_A > 0.0) CHECK((ion().centre_A.x < -5.59 || ion().centre_A.x > 9.59));
  }
  CHECK(ion().centre_A.x == doctest::Approx(9.6).epsilon(1e-6));
  CHECK(ion().radius_A == size_A);
}

TEST_CASE(
    "a trajectory without a structure, with another number of atoms or with a damaged file is refused in a message, "
    "and "
    "the atoms rest") {
  const ScratchFolder scratch;
  writeModels(scratch.path / "shift.pdb", 3);
  {
    const auto user = startWith("", smallWindow({}));
    writeFile(scratch.path / "a.xtc", std::string(200, 'x'));
    user->app().open(scratch.path / "a.xtc");
    user->frames(2);
    CHECK(contains(user->app().messages.all().back().text, "Open the structure first"));
  }
  const auto user = startWith("1ubq", smallWindow({}));
  PlayedTrajectory& trajectory = user->app().extensions().movers.get<PlayedTrajectory>();
  user->app().open(scratch.path / "a.xtc");
  user->frames(2);
  CHECK(!trajectory.ready());
  CHECK(contains(user->app().messages.all().back().text, "a.xtc: this is no XTC file, or it is damaged"));
  CHECK(trajectory.open(FileKind::Trajectory, scratch.path / "shift.pdb"));
  user->frames(2);
  CHECK(!trajectory.ready());
  CHECK(!trajectory.position());
  CHECK(contains(user->app().messages.all().back().text,
                 "its frames have 12 atoms; the molecule has 602, and its file 660"));
}

}  // namespace
}  // namespace moltact
