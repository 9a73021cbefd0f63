// A body in the hand, or a probe, while a trajectory moves the rest of the molecule. Oracles: the overlap over all pairs of
// spheres at each tick, and the same hand and motion in steps eight times as fine.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>

#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/hand_recorder.h"
#include "app/ui/extensions/played_trajectory.h"
#include "engine/bench/bodies/body_trade_off.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/methods.h"
#include "engine/servo/servo_recording.h"
#include "engine/servo/servo_step.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 12;
constexpr double kBreath = 0.03;  // of the distance from the middle

/// 1HPV, whose protein breathes about its middle; the atoms of the drug are shifted by 40 A from the second frame on.
void writeBreathing(const fs::path& file) {
  std::ifstream in(fs::path(MOLTACT_SOURCE_DIR) / "molecules/1hpv.pdb");
  std::vector<std::string> atoms;
  std::vector<Vec3> places;
  Vec3 middle(0.0);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("ATOM") && !line.starts_with("HETATM")) continue;
    atoms.push_back(line);
    places.emplace_back(std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)), std::stod(line.substr(46, 8)));
    middle += places.back();
  }
  middle /= double(places.size());
  std::ofstream out(file);
  for (int f = 0; f < kFrames; ++f) {
    const double swollen = 1.0 - kBreath * std::sin(kTwoPi * f / kFrames);
    out << "MODEL\n";
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const bool drug = atoms[i].substr(17, 3) == "478";
      const Vec3 to = middle + (places[i] - middle) * swollen + (drug && f > 0 ? Vec3(40, 0, 0) : Vec3(0.0));
      char text[40];
      std::snprintf(text, sizeof text, "%8.3f%8.3f%8.3f", to.x, to.y, to.z);
      out << std::string(atoms[i]).replace(30, 24, text) << '\n';
    }
    out << "ENDMDL\n";
  }
}

// `ligand`: the key that takes the drug, "in-hand" or "remove".
std::string lesson(const char* ligand) {
  return "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: 1hpv\nauthor: A\nlicence: L\n---\n## One\n```scene\n"
         "molecule: 1hpv\n" +
         std::string(ligand) + ": ligand\ntrajectory: breath.pdb, not superposed\nspeed: 6\n```\nText.\n";
}

// The hand of a simulated device on the breathing protein for 8 s, recorded in the window.
ServoRecording recordedHand(const char* ligand) {
  const ScratchFolder scratch;
  writeBreathing(scratch.path / "breath.pdb");
  writeFile(scratch.path / "mine.md", lesson(ligand));
  const fs::path file = scratch.path / "hand.recording";
  {
    const auto user = startWith((scratch.path / "mine.md").string());
    REQUIRE(user->app().extensions().movers.get<PlayedTrajectory>().ready());
    user->app().extensions().device.choose("simulated");
    user->frames(60);
    user->app().extensions().hand_recorder.record(file);
    REQUIRE(user->app().extensions().hand_recorder.recording());
    user->frames(480);
    user->app().extensions().hand_recorder.stop();
  }
  Expected<ServoRecording> recorded = readServoRecording(file);
  REQUIRE(recorded);
  REQUIRE(recorded->start);
  REQUIRE(recorded->motions.size() > 20);
  return *std::move(recorded);
}

struct Finer {
  int judged = 0,
      off = 0;  // ticks in contact with moving spheres; those in which the two differ by more than the bound
  double worst_A = 0.0, worst_N = 0.0;  // the greatest difference of the spring, and of its force
  double step_N = 0.0;                  // the greatest change of the spring's force in a tick
};

constexpr int kFiner = 8;

// Replays the recording, and beside it the same hand and motion in steps kFiner times as fine: `fine(hand, orientation)`
// is called for each of them, after setMotion and advanceTo of `moving`.
template <class Moving, class Fine>
Finer againstFiner(const ServoRecording& recorded, const SphereGrid& spheres, Interaction& coarse, Moving& moving,
                   double bound_A, const Fine& fine) {
  MotionReplay motions(recorded.motions, spheres);
  ServoStep step = *recorded.start;
  Finer out;
  std::optional<ServoSample> before;
  for (const RecordedTick& tick : recorded.ticks) {
    if (tick.other_device) step.setDevice(tick.device);
    const auto phase = motions.at(tick.motion, tick.motion_tick);
    REQUIRE(phase);
    const ServoSample now = step.tick(tick.settings, &coarse, tick.pose, tick.time, *phase);
    const bool other = moving.setMotion(phase->motion) && before && before->motion != now.motion;
    const double from = other || !before ? 0.0 : before->fraction;
    const ServoSample start = before.value_or(now);
    Contact f;
    for (int k = 1; k <= kFiner; ++k) {
      const double share = double(k) / kFiner;
      if (phase->motion) moving.advanceTo(from + (phase->fraction - from) * share);
      f = fine(start.hip.A + (now.hip.A - start.hip.A) * share, glm::slerp(start.orientation, now.orientation, share));
    }
    if (now.contact.touching() && f.touching() && before && now.motion > 0) {
      ++out.judged;
      const double apart_A = glm::distance(now.contact.displacement_A, f.displacement_A),
                   N_per_A = tick.settings.stiffness_N_per_mm / tick.settings.workspace.A_per_mm;
      out.worst_A = std::max(out.worst_A, apart_A);
      out.worst_N = std::max(out.worst_N, N_per_A * apart_A);
      out.off += apart_A > bound_A;
      if (before->contact.touching())
        out.step_N =
            std::max(out.step_N, N_per_A * glm::distance(now.contact.displacement_A, before->contact.displacement_A));
    }
    before = now;
  }
  MESSAGE(out.judged, " ticks judged, ", out.off, " apart by more than ", bound_A, " A, at most ", out.worst_A,
          " A and ", out.worst_N, " N; greatest step of the force ", out.step_N, " N");
  return out;
}

}  // namespace

TEST_CASE(
    "a drug in the hand follows a protein that breathes by 3 %, pressed by a mouse: in no frame does it overlap a "
    "sphere "
    "by over 1e-6 A, the force is at most 3.3 N, and the drug keeps its shape though the trajectory moves its atoms") {
  const ScratchFolder scratch;
  writeBreathing(scratch.path / "breath.pdb");
  writeFile(scratch.path / "mine.md", lesson("in-hand"));
  const auto user = startWith((scratch.path / "mine.md").string());
  HapticSession& scene = user->app().scene;
  REQUIRE(scene.stage().body);
  REQUIRE(user->app().extensions().movers.get<PlayedTrajectory>().ready());
  const std::vector<Sphere> shape = scene.stage().body->spheres;
  int touching = 0, moving = 0;
  double deepest_A = 0.0, greatest_N = 0.0, farthest_A = 0.0;
  for (int place = 0; place < 4; ++place) {
    user->point("view", 0.42 + 0.05 * place, 0.45);
    user->frames(10);
    user->press();
    for (int frame = 0; frame < 120; ++frame) {
      user->frames(1);
      const ServoSample& now = scene.log().latest();
      const auto motion = scene.servo().motionOf(now);
      greatest_N = std::max(greatest_N, glm::length(now.force.N));
      if (!now.contact.touching()) continue;
      ++touching;
      if (!motion) continue;
      ++moving;
      const std::vector<Sphere> at = motion->at(now.fraction);
      const SphereGrid grid(at, scene.stage().spheres->untouchable());
      deepest_A = std::max(deepest_A, bench::overlap_A(grid, *scene.stage().body, now.shownBody()));
      farthest_A =
          std::max(farthest_A, glm::distance(at[0].centre_A, scene.atoms().resting().spheres->spheres()[0].centre_A));
    }
    user->release();
    user->frames(5);
  }
  MESSAGE("touching in ", touching, " frames, ", moving, " with a motion, deepest ", deepest_A, " A, greatest force ",
          greatest_N, " N; the first atom moved by up to ", farthest_A, " A");
  CHECK(touching > 200);
  CHECK(moving > 200);
  CHECK(farthest_A > 0.3);
  CHECK(deepest_A <= 1e-6);
  CHECK(greatest_N <= 3.3);
  REQUIRE(scene.stage().body);
  CHECK(scene.stage().body->spheres.size() == shape.size());
  for (std::size_t i = 0; i < shape.size(); ++i)
    CHECK(glm::distance(scene.stage().body->spheres[i].centre_A, shape[i].centre_A) == 0.0);
}

TEST_CASE(
    "with a device's hand, recorded: in each tick of a breathing protein the exact body rests within 0.02 A of where "
    "the same motion in steps eight times as fine leaves it, so that no force jumps beyond the motion's own") {
  const ServoRecording recorded = recordedHand("in-hand");
  const RecordedScene scene = recordedScene(recorded.labels, SharedArray<Sphere>(recorded.placed));
  REQUIRE(scene.body);
  ExactBody coarse(scene.spheres, scene.body), fine(scene.spheres, scene.body);
  const Finer found =
      againstFiner(recorded, *scene.spheres, coarse, fine, 0.02, [&](const Vec3& hand, const Quat& orientation) {
        return fine.respond({{hand}, orientation}).contact;
      });
  CHECK(found.judged > 1000);
  CHECK(found.off == 0);
}

TEST_CASE(
    "with a device's probe, recorded: in each tick of a breathing protein the exact tracker's spring is within 0.02 A "
    "of "
    "that of the same hand and motion in steps eight times as fine, so that no force jumps beyond the motion's own") {
  const ServoRecording recorded = recordedHand("remove");
  const RecordedScene scene = recordedScene(recorded.labels, SharedArray<Sphere>(recorded.placed));
  REQUIRE_FALSE(scene.body);
  const double probe_A = recorded.ticks.front().settings.probe_A;
  const auto coarse = findMethod("exact")->make(scene.spheres, probe_A),
             fine = findMethod("exact")->make(scene.spheres, probe_A);
  const Finer found = againstFiner(recorded, *scene.spheres, *coarse, *fine, 0.02,
                                   [&](const Vec3& hand, const Quat&) { return fine->step({hand}); });
  CHECK(found.judged > 1000);
  CHECK(found.off == 0);
}

}  // namespace moltact
