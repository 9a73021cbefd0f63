// A molecule that a simulation moves: drawn, pushed, recorded, played back, stopped. Oracle: the spring that holds the
// centre of mass, whose stretch is the mean force of the hand. Where OpenMM is not installed the tests say that they did
// not run.
#include "app/ui/extensions/live_molecule.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/ui/extensions/extensions.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/platform/folders.h"
#include "tests/app/small_window.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

std::string liveLesson(const std::string& keys, const std::string& molecule = "alanine-dipeptide") {
  return "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: " + molecule +
         "\nauthor: A\nlicence: L\n---\n## One\n```scene\nmolecule: " + molecule + "\n" + keys +
         "```\n```touch\nreach: residue 2\nsay: Touch it.\n```\n\n> [!TIP]\n> Look.\n";
}

LiveMolecule& liveOf(ScriptedUser& user) { return user.app().extensions().movers.get<LiveMolecule>(); }

// False with a message where OpenMM is missing.
bool simulates(ScriptedUser& user) {
  if (liveOf(user).ready()) return true;
  if (!contains(liveOf(user).problem(), "cannot be loaded")) FAIL(liveOf(user).problem());
  MESSAGE("not run: ", liveOf(user).problem());
  return false;
}

double farthestFromRest_A(ScriptedUser& user) {
  return farthestFrom_A(user, user.app().scene.atoms().resting().spheres->spheres());
}

Vec3 massCentre_A(ScriptedUser& user) {
  const Molecule& molecule = *user.app().scene.atoms().seen();
  Vec3 sum(0.0);
  double mass = 0.0;
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    const int number = molecule.atoms[i].atomic_number;
    const double m = number == 1 ? 1.008 : number == 6 ? 12.011 : number == 7 ? 14.007 : 15.999;
    sum += m * molecule.spheres[i].centre_A;
    mass += m;
  }
  return sum / mass;
}

TEST_CASE(
    "a lesson's simulation moves the atoms, 1 ps in a second; paused they stand still, a step moves them by 0.02 ps, "
    "and "
    "switched off they are back at once; a playback puts the atoms where they were within 0.02 A") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "mine.md", liveLesson("simulation: alanine-dipeptide.xml\n"));
  fs::path file;
  {
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
    Application& app = user->app();
    LiveMolecule& live = liveOf(*user);
    REQUIRE(live.on());
    if (!simulates(*user)) return;
    const double began_ps = live.frame().time_ps;
    user->frames(180);
    CHECK(live.frame().time_ps - began_ps == doctest::Approx(3.0).epsilon(0.02));
    CHECK(live.frame().blow_ups == 0);
    CHECK(farthestFromRest_A(*user) > 0.1);
    CHECK(farthestFromRest_A(*user) < 6.0);
    user->point("view", 0.5, 0.5);
    user->press();
    user->frames(30);
    user->release();
    live.run(false);
    user->frames(60);
    const double still = farthestFromRest_A(*user), time_ps = live.frame().time_ps;
    user->frames(60);
    CHECK(farthestFromRest_A(*user) == doctest::Approx(still).epsilon(0.02));
    CHECK(live.frame().time_ps == time_ps);
    live.singleStep();
    user->frames(10);
    CHECK(live.frame().time_ps == doctest::Approx(time_ps + 0.02));
    user->frames(60);
    REQUIRE(app.extensions().recorder.flush());
    file = app.extensions().recorder.file();
    live.end();
    user->frames(5);
    CHECK(farthestFromRest_A(*user) == 0.0);
    CHECK_FALSE(live.live());
  }
  const Expected<Attempt> attempt = readAttempt(file);
  REQUIRE(bool(attempt));
  CHECK(attempt->problems.empty());
  const AtomsMoved* last = nullptr;
  double at_s = 0.0;
  // The first line of the motion says what computed it.
  std::vector<std::string> engines;
  for (const AttemptEvent& e : attempt->events)
    if (const auto* moved = std::get_if<AtomsMoved>(&e.what)) engines.push_back(moved->engine);
  REQUIRE(engines.size() > 2);
  CHECK(engines[0].starts_with("OpenMM "));
  CHECK(engines[0].ends_with(", steps of 4 fs, seed 1; alanine-dipeptide.xml"));
  CHECK(engines[1].empty());
  for (const AttemptEvent& e : attempt->events)
    if (const auto* moved = std::get_if<AtomsMoved>(&e.what); moved && moved->position > 1.0)
      last = moved, at_s = e.t_s;
  REQUIRE(last);
  CHECK(last->by == "simulation");
  // The first number of each atom is its displacement along x in hundredths of an angstrom.
  const double x_A = 0.01 * std::stod(last->detail);
  const auto user = startWith("alanine-dipeptide", smallWindow({}));
  user->app().open(file);
  user->app().finishLoading();
  Playback& playback = user->app().extensions().playback;
  playback.setRunning(false);
  playback.seek(at_s + 1e-3);
  user->app().finishLoading();
  user->frames(5);
  const AtomMotion& atoms = user->app().scene.atoms();
  CHECK(std::abs(atoms.seen()->spheres[0].centre_A.x - atoms.resting().molecule->spheres[0].centre_A.x - x_A) < 0.02);
}

TEST_CASE(
    "pushed for 20 s, the molecule's centre moves until the spring of 5 kcal/mol/A^2 that holds it balances the mean "
    "push, within 30 %; released, the push is 0") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "mine.md", liveLesson("simulation: alanine-dipeptide.xml\nstiffness: 1 N/mm\n"));
  const auto user = startWith((scratch.path / "mine.md").string(), smallWindow({}));
  if (!simulates(*user)) return;
  LiveMolecule& live = liveOf(*user);
  const Vec3 rest = massCentre_A(*user);
  user->point("view", 0.5, 0.5);
  user->press();
  for (int k = 0; k < 5; ++k) {
    user->wheel(1.0);
    user->frames(2);
  }
  user->frames(120);
  Vec3 moved(0.0);
  double push_pN = 0.0;
  constexpr int kFrames = 1200;
  for (int k = 0; k < kFrames; ++k) {
    user->frames(1);
    moved += (massCentre_A(*user) - rest) / double(kFrames);
    push_pN += live.push_pN() / kFrames;
  }
  MESSAGE("mean push ", push_pN, " pN, mean shift ", glm::length(moved), " A");
  CHECK(push_pN > 50.0);
  CHECK(live.frame().blow_ups == 0);
  CHECK(glm::length(moved) * LiveMolecule::kHold_kcal_mol_A2 * kForceUnit_pN == doctest::Approx(push_pN).epsilon(0.3));
  user->release();
  user->frames(60);
  CHECK(live.push_pN() == 0.0);
  CHECK(live.wanted().pushes.empty());
}

TEST_CASE(
    "a simulation that begins where a scene with an elastic molecule ends feels the press, and an elastic molecule "
    "that "
    "begins where a simulation ends yields to it") {
  const ScratchFolder scratch;
  const std::string elastic = "```scene\nmolecule: 1ubq\nelastic: on\n```\n",
                    live = "```scene\nmolecule: alanine-dipeptide\nsimulation: alanine-dipeptide.xml\n```\n";
  for (const bool simulation_last : {true, false}) {
    CAPTURE(simulation_last);
    writeFile(scratch.path / "mine.md",
              "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules:\n  - 1ubq\n  - alanine-dipeptide\nauthor: A\nlicence: "
              "L\n---\n## One\n" +
                  (simulation_last ? elastic : live) + "Text.\n\n## Two\n" + (simulation_last ? live : elastic) +
                  "Text.\n");
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow({}));
    user->frames(30);
    if (!simulation_last && !simulates(*user)) return;
    user->app().lesson.next();
    user->app().finishLoading();
    user->frames(30);
    if (simulation_last && !simulates(*user)) return;
    user->point("view", 0.5, 0.5);
    user->press();
    double pushed_pN = 0.0, moved_A = 0.0;
    for (int k = 0; k < 180; ++k) {
      user->frames(1);
      pushed_pN = std::max(pushed_pN, liveOf(*user).push_pN());
      moved_A = std::max(moved_A, farthestFromRest_A(*user));
    }
    CHECK(user->app().scene.log().latest().contact.touching());
    CHECK(moved_A > 0.1);
    if (simulation_last) CHECK(pushed_pN > 10.0);
  }
}

TEST_CASE(
    "a press that pulls holds the first atom that it touches: dragged for 10 s, the molecule's centre follows until "
    "the "
    "spring that holds it balances the mean pull, within 30 %; the end of the press lets go") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "mine.md", liveLesson("simulation: alanine-dipeptide.xml\nstiffness: 0.5 N/mm\n"));
  for (const auto hold : {LiveMolecule::Hold::Atom, LiveMolecule::Hold::Residue}) {
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow({}));
    if (!simulates(*user)) return;
    LiveMolecule& live = liveOf(*user);
    live.setHold(hold);
    const Vec3 rest = massCentre_A(*user);
    user->point("view", 0.5, 0.5);
    user->press();
    user->frames(60);
    const std::size_t held = user->app().scene.pull().atoms().size();
    CHECK((hold == LiveMolecule::Hold::Atom ? held == 1 : held == 6 || held == 10));
    CHECK_FALSE(live.heldText().empty());
    user->point("view", 0.98, 0.5);
    user->frames(120);
    Vec3 moved(0.0), force_pN(0.0);
    double shown_pN = 0.0, size_pN = 0.0;
    constexpr int kFrames = 600;
    for (int k = 0; k < kFrames; ++k) {
      user->frames(1);
      shown_pN += live.push_pN() / kFrames;
      moved += (massCentre_A(*user) - rest) / double(kFrames);
      const ServoSample& felt = user->app().scene.log().latest();
      force_pN -= felt.contact.displacement_A * (felt.spring_N_per_A * LiveMolecule::kScale_pN_per_N / kFrames);
      size_pN +=
          glm::length(felt.contact.displacement_A) * felt.spring_N_per_A * LiveMolecule::kScale_pN_per_N / kFrames;
    }
    const double pull_pN = glm::length(force_pN);
    MESSAGE(held, " atoms held: mean pull ", pull_pN, " pN, mean shift ", glm::length(moved), " A");
    CHECK(pull_pN > 50.0);
    CHECK(shown_pN == doctest::Approx(size_pN).epsilon(0.1));
    CHECK(live.pulledBy_A() > 0.3);
    CHECK(glm::dot(moved, user->app().scene.camera.right()) > 0.2);
    CHECK(glm::length(moved) * LiveMolecule::kHold_kcal_mol_A2 * kForceUnit_pN ==
          doctest::Approx(pull_pN).epsilon(0.3));
    CHECK(live.frame().blow_ups == 0);
    user->release();
    user->frames(60);
    CHECK(user->app().scene.pull().atoms().empty());
    CHECK(live.push_pN() == 0.0);
    CHECK(user->app().scene.log().shownForce_N() == 0.0);
  }
}

TEST_CASE(
    "pull: residue 1-3 holds all 22 atoms wherever the press touches; of three scenes that pull one residue each, one "
    "press holds its residue's 6 or 10 atoms and the other two push") {
  const ScratchFolder scratch;
  int held = 0, pushed = 0;
  for (const auto& [pull, atoms] : {std::pair("1-3", 22), std::pair("1", 6), std::pair("2", 10), std::pair("3", 6)}) {
    CAPTURE(std::string(pull));
    writeFile(scratch.path / "mine.md",
              liveLesson("simulation: alanine-dipeptide.xml\npull: residue " + std::string(pull) + "\n"));
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow({}));
    if (!simulates(*user)) return;
    CHECK(liveOf(*user).hold() == LiveMolecule::Hold::Selection);
    user->point("view", 0.5, 0.5);
    user->press();
    user->frames(60);
    const std::size_t holds = user->app().scene.pull().atoms().size();
    CHECK((holds == 0 || int(holds) == atoms));
    if (atoms == 22) {
      CHECK(holds == 22);
      continue;
    }
    holds ? ++held : ++pushed;
    if (!holds) CHECK(user->app().scene.log().latest().contact.touching());
  }
  CHECK(held == 1);
  CHECK(pushed == 2);
}

TEST_CASE(
    "a step of a hand that pulls is in the picture within two frames: of two windows with the same input, the one "
    "whose "
    "hand moves draws the held atom elsewhere by then, and until then both draw the same") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "mine.md", liveLesson("simulation: alanine-dipeptide.xml\npull: atom\nstiffness: 1 N/mm\n"));
  constexpr int kBefore = 30, kAfter = 30;
  struct Seen {
    std::vector<Vec3> hand, drawn, felt;  // the hand and the held atom, frame by frame
  };
  Seen still, moved;
  for (Seen* seen : {&still, &moved}) {
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow({}));
    if (!simulates(*user)) return;
    if (liveOf(*user).engine().platform != "Reference") {
      MESSAGE("not run: only the platform Reference repeats a run to the last bit");
      return;
    }
    user->point("view", 0.5, 0.5);
    user->press();
    user->frames(60);
    REQUIRE(user->app().scene.pull().atoms().size() == 1);
    const std::uint32_t held = user->app().scene.pull().atoms()[0];
    const auto note = [&] {
      seen->hand.push_back(user->app().scene.log().latest().hip.A);
      seen->drawn.push_back(user->app().scene.atoms().drawn()->spheres[held].centre_A);
      seen->felt.push_back(user->app().scene.atoms().seen()->spheres[held].centre_A);
    };
    for (int k = 0; k < kBefore; ++k) {
      user->frames(1);
      note();
    }
    user->point("view", seen == &moved ? 0.6 : 0.5, 0.5);  // runs the frame that sees the pointer there
    note();
    for (int k = 1; k < kAfter; ++k) {
      user->frames(1);
      note();
    }
  }
  REQUIRE(still.drawn.size() == moved.drawn.size());
  const auto first = [&](const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return int(std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin());
  };
  // The first frame whose ticks have the hand elsewhere.
  const int step = first(still.hand, moved.hand);
  REQUIRE(step >= kBefore);
  REQUIRE(step < kBefore + 5);
  const auto apart_A = [&](int frame) {
    return glm::distance(still.drawn[std::size_t(step + frame)], moved.drawn[std::size_t(step + frame)]);
  };
  const int picture = first(still.drawn, moved.drawn) - step, touch = first(still.felt, moved.felt) - step;
  MESSAGE("the picture differs ", picture, " frames after the hand's step, the felt atom ", touch,
          " frames"
          "; drawn apart after 2, 5, 10, 20 frames: ",
          apart_A(2), ", ", apart_A(5), ", ", apart_A(10), ", ", apart_A(20), " A");
  CHECK(picture >= 1);
  CHECK(picture <= 2);
  CHECK(touch >= picture);
  CHECK(touch <= 4);
  CHECK(apart_A(20) > 0.1);
}

TEST_CASE(
    "the buttons and sliders of a simulation: pause, a step of 0.02 ps, play, relax to a lower energy, start again at "
    "0 "
    "ps, the speed and the heat bath") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "mine.md", liveLesson("simulation: alanine-dipeptide.xml\npanels: motion\n"));
  ScriptedUser::Options options = smallWindow({});
  options.width = 1280;
  options.height = 1000;
  const auto user = startWith((scratch.path / "mine.md").string(), options);
  if (!simulates(*user)) return;
  LiveMolecule& live = liveOf(*user);
  user->frames(60);
  CHECK(user->text("simulation/play") == "Pause");
  REQUIRE(user->click("simulation/play"));
  user->frames(5);
  CHECK(user->text("simulation/play") == "Play");
  const double paused_ps = live.frame().time_ps;
  CHECK(paused_ps > 0.5);
  user->frames(60);
  CHECK(live.frame().time_ps == paused_ps);
  for (int k = 1; k <= 3; ++k) {
    REQUIRE(user->click("simulation/step"));
    user->frames(5);
    CHECK(live.frame().time_ps == doctest::Approx(paused_ps + 0.02 * k));
  }
  // A minimum has no energy of motion to it: 22 atoms at 300 K have 8 kcal/mol of potential energy above it.
  const double before = live.frame().energies.potential_kcal_mol;
  const std::uint32_t starts = live.frame().starts;
  REQUIRE(user->click("simulation/relax"));
  for (int k = 0; k < 120 && live.frame().starts == starts; ++k) user->frames(1);
  user->frames(5);
  CHECK(live.frame().starts == starts + 1);
  CHECK(live.frame().energies.potential_kcal_mol < before - 2.0);
  CHECK(live.frame().time_ps > paused_ps);
  const double relaxed_A = farthestFromRest_A(*user);
  user->frames(30);
  CHECK(farthestFromRest_A(*user) == doctest::Approx(relaxed_A).epsilon(1e-6));
  // The speed near its right end: ten picoseconds in a second.
  REQUIRE(user->point("simulation/speed", 0.99, 0.85));
  user->press();
  user->frames(2);
  user->release();
  CHECK(live.wanted().ps_per_s > 0.95 * LiveMolecule::kFastest_ps_per_s);
  REQUIRE(user->click("simulation/play"));
  user->frames(2);
  const double from_ps = live.frame().time_ps;
  user->frames(60);
  CHECK(live.frame().time_ps - from_ps == doctest::Approx(live.wanted().ps_per_s).epsilon(0.05));
  // The bath near its right end: 600 K, reached within 2 s at this speed.
  REQUIRE(user->point("simulation/bath", 0.99, 0.85));
  user->press();
  user->frames(2);
  user->release();
  CHECK(live.wanted().temperature_K > 0.95 * LiveMolecule::kHottest_K);
  user->frames(60);
  double kelvin = 0.0;
  constexpr int kFrames = 180;
  for (int k = 0; k < kFrames; ++k) {
    user->frames(1);
    kelvin += live.frame().energies.temperature_K / kFrames;
  }
  // 54 degrees of freedom in 30 ps: the error of the mean is about 3 % where half a picosecond decorrelates.
  CHECK(kelvin == doctest::Approx(live.wanted().temperature_K).epsilon(0.12));
  REQUIRE(user->click("simulation/restart"));
  user->frames(3);
  CHECK(live.frame().time_ps < 1.0);
  CHECK(live.frame().starts == starts + 2);
}

TEST_CASE("forces between atoms end the simulation with a message; a molecule without a system offers none") {
  {
    const auto user = startWith("alanine-dipeptide", smallWindow({}));
    LiveMolecule& live = liveOf(*user);
    CHECK(live.offered());
    live.start();
    user->frames(2);
    if (!simulates(*user)) return;
    user->frames(30);
    TouchSetup touch = user->app().scene.touch();
    touch.forces = "van-der-waals";
    user->app().scene.setTouch(touch);
    user->frames(5);
    CHECK_FALSE(live.on());
    CHECK(farthestFromRest_A(*user) == 0.0);
    CHECK(contains(user->app().messages.all().back().text, "Forces between atoms act in a molecule at rest."));
  }
  const auto other = startWith("benzene", smallWindow({}));
  CHECK_FALSE(liveOf(*other).offered());
}

TEST_CASE("a system of another molecule, and a file that is none, are said with file and remedy, and nothing moves") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "broken.xml", "<System");
  for (const auto& [system, says] : {std::pair("alanine-dipeptide.xml", "the system has 22 particles, not 12"),
                                     std::pair("broken.xml", "OpenMM cannot simulate this system")}) {
    fs::copy_file(moleculesFolder() / "alanine-dipeptide.xml", scratch.path / "alanine-dipeptide.xml",
                  fs::copy_options::overwrite_existing);
    writeFile(scratch.path / "mine.md", liveLesson("simulation: " + std::string(system) + "\n", "benzene"));
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow({}));
    const LiveMolecule& live = liveOf(*user);
    user->frames(30);
    CHECK_FALSE(live.ready());
    if (contains(live.problem(), "cannot be loaded")) {
      MESSAGE("not run: ", live.problem());
      return;
    }
    CHECK(contains(live.problem(), says));
    CHECK(contains(live.problem(), system));
    CHECK(contains(live.problem(), "moltact simulate prepare"));
    CHECK(farthestFromRest_A(*user) == 0.0);
  }
}

}  // namespace
}  // namespace moltact
