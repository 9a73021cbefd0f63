// The motions of LessonHand with a body in the hand: the states' slider, the body's orientation, and a press that leads
// the body to a pose along the line of sight. The pointer reaches only what the body meets straight from the eye, so the
// hand follows not the corners of a plan but its end: it searches a direction of view, an orientation and a line of
// sight that bring the body near that pose, and presses there.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/moving_states.h"
#include "app/ui/widgets/key_focus.h"
#include "engine/core/random.h"
#include "engine/haptics/sweep.h"
#include "engine/lesson/tasks/held_way.h"
#include "tests/app/lesson_hand.h"

namespace moltact {
namespace {

constexpr double kTurn_rad_per_px = 0.008, kTurn_rad_per_s = 1.4;
constexpr double kTurned_rad = 0.03;  // an orientation within this angle is reached
constexpr double kPush_A = 2.0;       // depth of the press
constexpr double kMaxTilt_rad = 0.5;  // of the orientations that are tried, off the wanted one
constexpr double kMaxAside_A = 1.5;   // of the lines of sight, off the wanted place
constexpr double kFar_A = 80.0;       // a distance outside every scene with a body
constexpr double kStart_A = 14.0;     // sideways: a press begins this far from its place
constexpr int kRoughTries = 6000, kFineTries = 4000;

Vec3 anyIn(std::uint64_t& random) {
  return Vec3(nextFraction(random), nextFraction(random), nextFraction(random)) * 2.0 - 1.0;
}

Quat tilted(const Quat& q, std::uint64_t& random) {
  return glm::normalize(glm::angleAxis(kMaxTilt_rad * nextFraction(random), glm::normalize(anyIn(random))) * q);
}

}  // namespace

void LessonHand::moveStates(double share) {
  MovingStates& states = d_.app().extensions().movers.get<MovingStates>();
  if (states.wanted() != share) {
    if (mouse()) {
      d_.point("view/states", std::clamp(share, 0.01, 0.99), 0.5);  // the ends of the track are within it
      d_.press();
      d_.frames(2);
      d_.release();
    } else {
      // The keyboard has a button for each end of the slider.
      const std::string end = share < 0.5 ? "view/state/0" : "view/state/1";
      for (int stops = 0; stops < 200 && controlOfKeys() != end; ++stops) {
        d_.tap("Tab");
        d_.frames(2);
      }
      d_.tap("Enter");
      d_.frames(2);
      d_.tap("Escape");  // the keys are the molecule's again
    }
  }
  for (int k = 0; k < 1200 && states.live(); ++k) d_.frames(1);
  d_.frames(5);
  if (std::abs(states.share() - share) > 0.01) failed_ += session().step().id + ", the states' slider\n";
}

void LessonHand::lookAtStates() {
  MovingStates& states = d_.app().extensions().movers.get<MovingStates>();
  structures_.clear();
  if (!states.ready()) return;
  for (const double share : {0.0, 1.0}) {
    moveStates(share);
    structures_.emplace_back(share, d_.app().scene.stage().spheres);
  }
  moveStates(0.0);
}

Quat LessonHand::bodyTurned() const { return d_.app().scene.log().latest().orientation; }

// Two axes are on the screen. About the third, the line of sight, the body is turned by a quarter turn sideways, up or
// down, and the quarter turn back.
void LessonHand::turnBodyTo(const Quat& wanted) {
  const auto turn = [&](double right_rad, double down_rad) {
    constexpr double kMaxDrag_px = 200.0;
    if (mouse()) {
      double x = right_rad / kTurn_rad_per_px, y = down_rad / kTurn_rad_per_px;
      const int drags = std::max(1, int(std::ceil(std::max(std::abs(x), std::abs(y)) / kMaxDrag_px)));
      d_.hold("Ctrl");
      for (int k = 0; k < drags; ++k) d_.drag("view", x / drags, y / drags, 1);
      d_.letGo("Ctrl");
    } else {
      const auto key = [&](double rad, const char* plus, const char* minus) {
        const int frames = int(std::lround(std::abs(rad) / kTurn_rad_per_s * 60.0));
        if (frames == 0) return;
        const char* keys = rad > 0.0 ? plus : minus;
        d_.hold(keys);
        d_.frames(frames - 1);  // holding takes one
        d_.letGo(keys);
      };
      key(right_rad, "Ctrl+Shift+Right", "Ctrl+Shift+Left");
      key(down_rad, "Ctrl+Shift+Down", "Ctrl+Shift+Up");
    }
    d_.frames(10);
  };
  for (int turns = 0; turns < 20; ++turns) {
    const Vec3 left = rotationBetween(bodyTurned(), wanted);
    if (glm::length(left) < kTurned_rad) return;
    const Camera& c = d_.app().scene.camera;
    const double roll = glm::dot(left, c.back());
    if (std::abs(roll) > kTurned_rad / 2.0) {
      constexpr double kQuarter_rad = std::numbers::pi / 2.0;
      turn(kQuarter_rad, 0.0);
      turn(0.0, roll);
      turn(-kQuarter_rad, 0.0);
    } else {
      turn(glm::dot(left, c.up()), glm::dot(left, c.right()));
    }
  }
}

LessonHand::Approach LessonHand::approachTo(const PoseA& end, std::uint64_t seed, const std::optional<Vec3>& from,
                                            const std::optional<Quat>& turned) const {
  const TouchableModel& stage = d_.app().scene.stage();
  const PoseGoal goal(stage.body, end);
  std::uint64_t random = seed * 7919 + 1;
  Approach best;
  const int tries = from ? kFineTries : kRoughTries;
  for (int n = 0; n < tries; ++n) {
    Approach a;
    a.turned = turned ? *turned : n == 0 ? end.orientation : tilted(end.orientation, random);
    a.aim = end.place.A + kMaxAside_A * anyIn(random);
    Vec3 eye(0.0);
    if (from) {
      eye = *from;
      a.toViewer = glm::normalize(eye - a.aim);
    } else {
      a.toViewer = glm::normalize(anyIn(random));
      eye = a.aim + kFar_A * a.toViewer;
    }
    const Vec3 behind = a.aim - 2.0 * stage.body->reach_A * a.toViewer;
    const Hit hit = sweep(*stage.spheres, HandShape(*stage.body, a.turned), eye, behind);
    if (hit.sphere < 0) continue;
    a.stop = eye + (behind - eye) * hit.t;
    a.off_A = goal.rmsd_A({{a.stop}, a.turned});
    if (a.off_A < best.off_A) best = a;
  }
  return best;
}

bool LessonHand::followWithBody(const HandPlan& plan, std::size_t task) {
  if (!d_.app().scene.stage().body) return false;
  PoseA end{{}, bodyTurned()};
  bool moves = false;
  double wait_s = 0.0;
  for (const HandAct& act : plan) {
    if (act.share) moveStates(*act.share);
    if (act.turned_to) end.orientation = *act.turned_to;
    if (act.to) end.place = *act.to, moves = true;
    wait_s = act.wait_s;
  }
  if (!moves) return false;
  ++approaches_;
  const Approach rough = approachTo(end, approaches_, {}, {});
  if (!rough.meets()) return true;
  face(rough.toViewer);
  const Vec3 eye = d_.app().scene.camera.eye().A;
  turnBodyTo(approachTo(end, approaches_, eye, {}).turned);
  const Approach fine = approachTo(end, approaches_, eye, bodyTurned());
  if (!fine.meets()) return true;
  // The press begins beside the place, where the body stops farthest out, and slides there.
  const Camera& c = d_.app().scene.camera;
  const TouchableModel& stage = d_.app().scene.stage();
  Vec3 start = fine.aim;
  double nearest = 1e300;  // to the eye, as a share of the line of sight
  for (int k = 0; k < 16; ++k) {
    const double angle = k * std::numbers::pi / 8.0;
    const Vec3 there = fine.aim + kStart_A * (c.right() * std::cos(angle) + c.up() * std::sin(angle));
    const Vec3 behind = there + (there - eye);
    const Hit hit = sweep(*stage.spheres, HandShape(*stage.body, fine.turned), eye, behind);
    if (hit.sphere < 0 || hit.t >= nearest) continue;
    nearest = hit.t;
    start = there;
  }
  pointAt(start);
  if (watch) watch();
  press();
  // Who watches sees the words from the press on, not only once there is a contact.
  for (int k = 0; watch && k < 10 && isCurrent(task); ++k) {
    d_.frames(1);
    watch();
  }
  lead(fine.aim, task);
  for (int k = 0; k < 120 && isCurrent(task) && !d_.app().scene.log().touching(); ++k) {
    d_.frames(1);
    if (watch) watch();
  }
  push(kPush_A * N_per_A());
  for (int n = 0; n < int((wait_s + 2.0) * 60.0) && isCurrent(task); ++n) {
    d_.frames(1);
    if (watch) watch();
  }
  lift();
  return true;
}

}  // namespace moltact
