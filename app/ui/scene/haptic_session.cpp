#include "app/ui/scene/haptic_session.h"

#include <algorithm>
#include <utility>

namespace moltact {
namespace {

constexpr double kLeftBehind_s = 0.4;  // a contact without a sphere at the HIP is ended after this time
constexpr double kDrawn_A = 3.0;       // so far forces between atoms may draw a body off a hand in the open
constexpr double kStill_A = 2e-3;      // a hand slower than this in a frame is at rest

// Whether the probe or body at the hand's position is outside all spheres.
bool inTheOpen(const TouchableModel& stage, const ServoSample& now, const SphereMotion* motion) {
  if (!stage.body) return clearanceAt(*stage.spheres, now, motion) > 0.0;
  const SphereGrid& spheres = motion ? motion->sweptSpheres() : *stage.spheres;
  return std::all_of(stage.body->spheres.begin(), stage.body->spheres.end(), [&](const Sphere& b) {
    return clearance(spheres, b.radius_A, now.hip.A + now.orientation * b.centre_A, motion, now.fraction) > 0.0;
  });
}

}  // namespace

HapticSession::HapticSession(ServoClock clock) : felt_(clock, servo_settings, controls) {}

void HapticSession::show(TouchableModel next, const MoleculeKey& molecule, const Facing& facing) {
  felt_.letGo();
  felt_.atoms.begin(std::move(next));
  molecule_ = molecule;
  TouchSetup& built = felt_.built_setup;
  built.interaction = wanted_interaction_;
  built = resolveInteraction(built, stage().body != nullptr);
  servo_settings.workspace = stage().workspace;
  felt_.log.clear();
  watch_.begin(stage(), touch());
  // Constructed before the workspace is changed: until then the previous interaction is felt at its place.
  std::unique_ptr<Interaction> felt = felt_.freshInteraction();
  view_.reset(facing);
  felt_.servo.begin(felt_.settingsOfScene(), std::move(felt));
}

void HapticSession::setTouch(const TouchSetup& wanted) {
  TouchSetup& built = felt_.built_setup;
  TouchSetup next = wanted;
  const Method* method = findMethod(next.method);
  next.method = method ? method->name : built.method;
  if (!findInteractionKind(next.interaction)) next.interaction = built.interaction;
  wanted_interaction_ = next.interaction;
  next = resolveInteraction(std::move(next), stage().body != nullptr);
  const bool alike = sameConstruction(next, built), other_medium = next.dielectric != built.dielectric;
  servo_settings.take(next);
  built = std::move(next);
  watch_.feelWith(touch());
  if (!alike) {
    rebuildInteraction();
    felt_.log.forgetLowest();
  }
  std::shared_ptr<const Colouring>& colouring = look.atoms.colouring;
  if (other_medium && stage() && colouring && colouring->scheme == "potential")
    colouring = look.colouring(colouring->scheme);
}

void HapticSession::lead(const std::optional<TaskGuide>& guide) {
  if (!felt_.ownHand()) return;
  const ServoLink& servo = felt_.servo;
  const bool can = guide && stage() && !stage().body && felt_.pulled.empty() && !felt_.scanned &&
                   !felt_.recorded.on() && !servo.records() && servo.deviceLeads() && servo.device().gives_force;
  const std::optional<TaskGuide> next = can ? guide : std::nullopt;
  const double A_per_mm = servo_settings.workspace.A_per_mm;
  if (!next && !felt_.guide) return;
  if (next && felt_.guide && next->feelsLike(*felt_.guide) && A_per_mm == felt_.guide_A_per_mm) return;
  felt_.guide = next;
  felt_.guide_A_per_mm = A_per_mm;
  rebuildInteraction();
}

void HapticSession::rebuildInteraction() {
  if (force_.trying()) return force_.endTrial();
  const ServoSample& latest = log().latest();
  // Each method continues from the exact contact, so that it inherits no error of another.
  const Contact& contact = watch_.exact().touching() ? watch_.exact() : latest.contact;
  if (played_.on()) return;
  const PoseA hand{latest.hip, latest.orientation};
  std::unique_ptr<Interaction> made = felt_.interactionAt(contact, hand);
  // What hangs in a field goes on from its place, as does a body from its rest pose, where it overlaps nothing.
  if (made && (latest.molecular_energy || (latest.body_pose && contact.touching()))) leadFrom(*made, latest);
  felt_.servo.setInteraction(std::move(made));
}

bool HapticSession::moveAtoms(const MotionSource& source, const std::vector<Sphere>& to, int ticks) {
  return source.owns() && stage() && felt_.ownHand() && felt_.atoms.move(to, ticks);
}

bool HapticSession::placeAtoms(const MotionSource& source, SharedArray<Sphere> at) {
  if (!source.owns() || !stage()) return false;
  felt_.letGo();
  felt_.atoms.place(std::move(at));
  felt_.log.clear();
  watch_.begin(stage(), touch());
  std::unique_ptr<Interaction> felt = felt_.freshInteraction();
  view_.beginHere();
  felt_.servo.begin(felt_.settingsOfScene(), std::move(felt));
  return true;
}

FeltTicks HapticSession::advance(double dt_s, double now_s, bool timed) {
  TouchLog& log = felt_.log;
  ServoLink& servo = felt_.servo;
  const Method& m = *findMethod(felt_.built_setup.method);
  const PointA hand_before = log.latest().hip;
  ticks_.clear();
  const std::vector<ServoSample>& ticks = servo.advance(dt_s);
  if (played_.on()) {
    // The hand's motion meanwhile has no effect.
    played_.advance(dt_s);
    hand_moved_ = false;
  } else {
    for (const ServoSample& sample : ticks) {
      log.add(sample);
      // A body has no SCP that could be compared with that of a sphere.
      const bool judged = !servo.loop().hasOrientation() && felt_.pulled.empty() && !felt_.scanned;
      ticks_.push_back({sample, judged ? watch_.add(sample, m, servo.motionOf(sample)) : sample.contact});
    }
    felt_.atoms.follow(dt_s);
    log.measure(now_s);
    servo.timeTicks(timed);
    hand_moved_ = glm::distance(hand_before.A, log.latest().hip.A) > kStill_A;
    watchLeftBehind(dt_s);
    view_.advance(dt_s);
  }
  const bool wants_reactions = stage().body != nullptr && !played_.on();
  servo.loop().wantReactions(wants_reactions);
  const std::span<const AtomForce> reactions =
      wants_reactions ? servo.loop().reactions().forces() : std::span<const AtomForce>();
  body_contacts_ = moltact::bodyContacts(stage(), log.latest(), reactions, servo.motionOf(log.latest()).get());
  felt_.forces.follow(log.latest(), look.atoms.hidden);
  log.figureForce(now_s);
  // Independent of what is shown, because the settings contain the panic key.
  felt_.passSettings();
  return {ticks_, m};
}

void HapticSession::watchLeftBehind(double dt_s) {
  const ServoSample& now = log().latest();
  // Forces between atoms draw what is held off the hand, into contact; only farther away it is left behind.
  const bool drawn = now.molecular_energy && glm::length(now.contact.displacement_A) < kDrawn_A;
  const bool free = stage() && log().touching() && !drawn && !felt_.scanned &&
                    inTheOpen(stage(), now, felt_.servo.motionOf(now).get());
  felt_.log.countLeftBehind(free && !controls.pressing(), dt_s);
  if (log().leftBehind_s() <= kLeftBehind_s) return;
  ++servo_settings.discontinuities;
  felt_.log.countLeftBehind(false, dt_s);
}

void useMethod(HapticSession& scene, std::string_view name) {
  TouchSetup next = scene.touch();
  next.method = name;
  scene.setTouch(next);
}

Vec3 pushInView(const HapticSession& scene) {
  const TouchLog& log = scene.log();
  const Vec3 way = log.latest().forceDirection();
  if (!log.felt() || log.force_N() <= 0.0 || !(glm::length(way) > 1e-6)) return Vec3(0.0);
  return glm::conjugate(scene.camera.orientation) * glm::normalize(way);
}

}  // namespace moltact
