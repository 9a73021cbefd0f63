// A trajectory that moves the atoms of the scene: played, sought, recorded, played back, refused. Oracle: models in which
// all atoms of benzene are shifted by half an angstrom from frame to frame.
#include "app/ui/extensions/played_trajectory.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/elastic_molecule.h"
#include "app/ui/extensions/extensions.h"
#include "engine/haptics/methods.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr double kShift_A = 0.5;

ScriptedUser::Options small(const fs::path& folder) {
  ScriptedUser::Options options;
  options.width = 1000;
  options.height = 600;
  options.application.attempts_folder = folder;
  return options;
}

/// A molecule of the library, shifted along z from model to model.
void writeModels(const fs::path& file, int frames, const char* molecule = "benzene.pdb") {
  std::ifstream in(fs::path(MOLTACT_SOURCE_DIR) / "molecules" / molecule);
  std::vector<std::string> atoms;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("ATOM") || line.starts_with("HETATM")) atoms.push_back(line);
  std::ofstream out(file);
  for (int f = 0; f < frames; ++f) {
    out << "MODEL\n";
    for (std::string line : atoms) {
      char z[20];
      std::snprintf(z, sizeof z, "%8.3f", std::stod(line.substr(46, 8)) + kShift_A * f);
      out << line.replace(46, 8, z) << '\n';
    }
    out << "ENDMDL\n";
  }
}

std::string lessonWith(const std::string& keys) {
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
  writeFile(scratch.path / "mine.md", lessonWith("trajectory: shift.pdb, not superposed\nframes: 2-9\nspeed: 4\n"));
  fs::path file;
  {
    const auto user = startWith((scratch.path / "mine.md").string(), small(scratch.path));
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
  const auto user = startWith("benzene", small({}));
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
  writeFile(scratch.path / "mine.md", lessonWith("trajectory: shift.pdb, not superposed\nframes: 3-9\nspeed: 4\n"));
  const fs::path file = scratch.path / "hand.recording";
  std::vector<double> shifts;
  {
    const auto user = startWith((scratch.path / "mine.md").string(), small(scratch.path));
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

  const auto user = startWith("benzene", small({}));
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
  const auto user = startWith("benzene", small({}));
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
  const auto user = startWith("1ubq", small({}));
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
    "a trajectory without a structure, with another number of atoms or with a damaged file is refused in a message, "
    "and "
    "the atoms rest") {
  const ScratchFolder scratch;
  writeModels(scratch.path / "shift.pdb", 3);
  {
    const auto user = startWith("", small({}));
    writeFile(scratch.path / "a.xtc", std::string(200, 'x'));
    user->app().open(scratch.path / "a.xtc");
    user->frames(2);
    CHECK(contains(user->app().messages.all().back().text, "Open the structure first"));
  }
  const auto user = startWith("1ubq", small({}));
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
