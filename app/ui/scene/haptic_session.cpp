#include "app/ui/scene/haptic_session.h"

#include <algorithm>
#include <iterator>

#include "engine/lesson/second_state.h"
#include "engine/servo/plain_trackers.h"
#include "engine/workspace/fit_workspace.h"

namespace moltact {
namespace {

constexpr double kLeftBehind_s = 0.4;  // contact without cause for so long is let go
constexpr double kProbeRoom = 2.0;     // so many radii of the probe are seen round the molecule,
constexpr double kBodyRoom = 0.5;      // or so much of a body's reach
constexpr double kTurned = 1e-9;       // a view that has turned or moved by less has not
constexpr double kSettle_s = 0.5;      // in which a device that was just chosen tells where its hand is
constexpr double kByHand_A = 3.5;      // the radius of what is magnified round the probe
constexpr double kAtLeast = 2.0;       // and at least so much more than the scene
constexpr double kTry_N_per_mm = 0.2;  // the spring of a force that is tried
constexpr double kStill_A = 2e-3;      // a hand slower than this in a frame is at rest

glm::dmat3 axes(const Camera& camera) { return {camera.right(), camera.up(), camera.back()}; }

bool sameView(const Camera& a, const Camera& b) {
  const glm::dmat3 of_a = axes(a), of_b = axes(b);
  double off = glm::distance(a.target.A, b.target.A);
  for (int k = 0; k < 3; ++k) off = std::max(off, glm::distance(of_a[k], of_b[k]));
  return off <= kTurned;
}

// Nothing that the hand holds, where it is, is inside a sphere.
bool inTheOpen(const TouchableModel& stage, const ServoSample& now, const SphereMotion* motion) {
  if (!stage.body) return clearanceAt(*stage.spheres, now, motion) > 0.0;
  const SphereGrid& spheres = motion ? motion->sweptSpheres() : *stage.spheres;
  return std::all_of(stage.body->spheres.begin(), stage.body->spheres.end(), [&](const Sphere& b) {
    return clearance(spheres, b.radius_A, now.hip.A + now.orientation * b.centre_A, motion, now.fraction) > 0.0;
  });
}

}  // namespace

HapticSession::HapticSession(ServoClock clock) : servo_(clock) {}

void HapticSession::show(TouchableModel next, const MoleculeKey& molecule, const Facing& facing) {
  stage_ = resting_model_ = std::move(next);
  seen_.reset();
  motion_.reset();
  seen_motion_ = 0;
  molecule_ = molecule;
  made_with_.interaction = wanted_interaction_;
  made_with_ = resolveInteraction(made_with_, stage_.body != nullptr);
  servo_settings.workspace = stage_.workspace;
  log_.clear();
  watch_.begin(stage_, touch());
  // Made before the workspace is handed over: until then the molecule before it is felt, where it was.
  std::unique_ptr<Interaction> felt = freshInteraction();
  resetView(facing);
  servo_.begin(effectiveSettings(false), std::move(felt));
}

std::unique_ptr<Interaction> HapticSession::freshInteraction() const {
  return played_ ? nullptr : interactionAt(stage_, touch(), Contact{}, PoseA{}, servo_.device());
}

void HapticSession::play(const std::optional<ServoSample>& sample) {
  const bool was = playing();
  played_ = sample;
  if (was == playing()) return;
  motion_.reset();  // of the scene that ends here
  log_.clear();
  ++servo_settings.discontinuities;
  servo_.begin(effectiveSettings(false), freshInteraction());
}

// What the servo loop is to do now: as the panels set it, but without force where nobody looks or a hand is played. A
// force that is tried does not depend on the scene.
ServoSettings HapticSession::effectiveSettings(bool trying) const {
  ServoSettings out = servo_settings;
  out.force_on = trying || (out.force_on && !resting_ && !played_);
  if (trying) {
    out.workspace = Workspace();
    out.stiffness_N_per_mm = kTry_N_per_mm;
    out.clutch = ClutchSettings();
  }
  return out;
}

void HapticSession::stopForce(bool stopped) {
  servo_settings.panic = stopped;
  if (stopped) endTry();
  servo_.setSettings(effectiveSettings(trying()));
}

bool HapticSession::tryForce(double force_N) {
  if (played_ || servo_settings.panic) return false;
  servo_.setSettings(effectiveSettings(true));
  servo_.tryInteraction(std::make_unique<ConstantForceTracker>(force_N / kTry_N_per_mm * Workspace().A_per_mm));
  return true;
}

void HapticSession::endTry() {
  if (!trying()) return;
  ++servo_settings.discontinuities;
  servo_.setSettings(effectiveSettings(false));
  servo_.setInteraction(freshInteraction());
}

void HapticSession::beginAgain(const Facing& facing) {
  log_.clear();
  resetView(facing);
  servo_.beginAgain(effectiveSettings(trying()));
}

void HapticSession::startSoftly() {
  log_.clear();
  ++servo_settings.discontinuities;
  servo_.beginAgain(effectiveSettings(trying()));
}

void HapticSession::beginAgainAt(PointA place) {
  beginAgain([&](Camera& turned, const Molecule&) { turned.face(place); });
  camera.target = place;
  layBeforeHand(place);
  handBegins(place);
}

bool HapticSession::touchesUnseen(const Contact& contact) const {
  if (!look.hidden) return false;
  return std::any_of(contact.atoms.begin(), contact.atoms.end(), [&](std::int32_t a) {
    return a >= 0 && std::binary_search(look.hidden->begin(), look.hidden->end(), std::uint32_t(a));
  });
}

Vec3 HapticSession::pushInView() const {
  const Vec3 way = log_.latest().forceDirection();
  if (!log_.felt() || log_.force_N() <= 0.0 || !(glm::length(way) > 1e-6)) return Vec3(0.0);
  return glm::conjugate(camera.orientation) * glm::normalize(way);
}

bool HapticSession::drawsNothing() const {
  return look.hidden && stage_ && look.hidden->size() == stage_.molecule->atoms.size();
}

Camera HapticSession::cameraFor(const Facing& facing, const std::optional<Region>& part) const {
  Camera out = camera;
  out.orientation = glm::dquat(1, 0, 0, 0);
  // Round the molecule there is room for the probe, which hovers before it and beside it.
  // What is neither seen nor felt needs none.
  std::vector<std::uint32_t> removed;
  if (look.hidden) {
    const std::vector<std::uint32_t> unfelt = stage_.spheres->untouchable();
    std::set_intersection(look.hidden->begin(), look.hidden->end(), unfelt.begin(), unfelt.end(),
                          std::back_inserter(removed));
  }
  const double room_A = stage_.body ? kBodyRoom * stage_.body->reach_A : kProbeRoom * servo_settings.probe_A;
  const auto fit = [&] { out.fit(*stage_.molecule, view_aspect_, 0.08, room_A, removed); };
  fit();
  facing(out, *stage_.molecule);
  // Another side of the molecule may be wider.
  fit();
  if (part) out.fit(part->centre, part->radius_A, view_aspect_);
  return out;
}

void HapticSession::resetView(const Facing& facing) {
  if (!stage_) return;
  const std::optional<Region>& part = zoomed_ ? zoomed_ : region_;
  camera = cameraFor(facing, part);
  by_hand_ = false;
  layBeforeHand(camera.target);
  handBegins(part ? part->centre : stage_.middle);
}

Workspace HapticSession::sceneWorkspace() const {
  return region_ ? magnified(stage_.workspace, *region_, servo_.device()) : stage_.workspace;
}

double HapticSession::byHand_A_per_mm() const {
  const Workspace whole = sceneWorkspace();
  return std::min(magnified(whole, {log_.latest().hip, kByHand_A}, servo_.device()).A_per_mm,
                  whole.A_per_mm / kAtLeast);
}

void HapticSession::magnify(bool on) {
  if (!stage_ || played_ || recorded_ || on == by_hand_) return;
  const ServoSample& now = log_.latest();
  const double wanted = on ? byHand_A_per_mm() : sceneWorkspace().A_per_mm;
  const double closer = servo_settings.workspace.A_per_mm / wanted;
  servo_settings.workspace = rescaled(servo_settings.workspace, wanted, now.hand, now.hip);
  // The probe stays where it is in the picture.
  camera.target.A = now.hip.A + (camera.target.A - now.hip.A) / closer;
  camera.distance_A /= closer;
  fitted_ = camera;
  by_hand_ = on;
  servo_.setSettings(effectiveSettings(trying()));
}

void HapticSession::fitRoomOfDevice() {
  if (!stage_) return;
  const PointA toward = by_hand_ ? log_.latest().hip : camera.target;
  layBeforeHand(toward);
  handBegins(toward);
}

void HapticSession::followView() {
  if (!stage_ || recorded_ || (device_leads_ == servo_.deviceLeads() && (!device_leads_ || sameView(camera, fitted_))))
    return;
  layBeforeHand(camera.target);
  ++servo_settings.discontinuities;
  // The mouse stays where it is in the molecule.
  if (!device_leads_) servo_.mouse().place(servo_settings.workspace.toDevice(controls.lead()));
  servo_.setSettings(effectiveSettings(trying()));
}

void HapticSession::layBeforeHand(PointA toward) {
  Workspace fitted = sceneWorkspace();
  if (by_hand_) {
    fitted.A_per_mm = byHand_A_per_mm();
    fitted.centre_A = toward.A;
  }
  device_leads_ = servo_.deviceLeads();
  if (device_leads_) {
    // As the hand is held now, along the axes of this view.
    const Quat held = glm::quat_cast(axes(camera)) * glm::conjugate(glm::quat_cast(servo_settings.workspace.rotation)) *
                      log_.latest().orientation;
    fitted = fitToDevice(fitted, *stage_.spheres, handShape(stage_, servo_settings.probe_A, held), toward, axes(camera),
                         servo_.device());
  }
  servo_settings.workspace = fitted;
  fitted_ = camera;
  fit_left_s_ = kSettle_s;
}

// Where the hand is shows only once its device has told it: a molecule that was put onto it goes back until it is free.
void HapticSession::drawBack(double dt_s) {
  const ServoSample& now = log_.latest();
  fit_left_s_ -= dt_s;
  if (!device_leads_ || recorded_ || fit_left_s_ <= 0.0 || now.discontinuities != servo_settings.discontinuities ||
      now.contact.fault != Fault::StartedInside)
    return;
  servo_settings.workspace =
      retracted(servo_settings.workspace, *stage_.spheres, handShape(stage_, now.probe_A, now.orientation), now.hand);
  ++servo_settings.discontinuities;
}

double HapticSession::magnification() const {
  return stage_ ? stage_.workspace.A_per_mm / servo_settings.workspace.A_per_mm : 1.0;
}

void HapticSession::handBegins(PointA before) {
  ++servo_settings.discontinuities;
  controls.begin(camera, before, servo_settings.workspace, std::min(stage_.reach_A, camera.distance_A), servo_.mouse());
  servo_.setSettings(effectiveSettings(trying()));
}

TouchSetup HapticSession::touch() const {
  TouchSetup out = made_with_;
  servo_settings.giveTo(out);
  return out;
}

void HapticSession::setTouch(const TouchSetup& wanted) {
  TouchSetup next = wanted;
  if (!findMethod(next.method)) next.method = made_with_.method;
  if (!findInteractionKind(next.interaction)) next.interaction = made_with_.interaction;
  wanted_interaction_ = next.interaction;
  next = resolveInteraction(std::move(next), stage_.body != nullptr);
  const bool alike = sameConstruction(next, made_with_);
  servo_settings.take(next);
  made_with_ = std::move(next);
  watch_.feelWith(touch());
  if (!alike) rebuildInteraction();
}

void HapticSession::useMethod(std::string_view name) {
  TouchSetup next = touch();
  next.method = name;
  setTouch(next);
}

void HapticSession::rebuildInteraction() {
  if (trying()) return endTry();
  // Each method goes on from the true contact, so that none inherits what another got wrong.
  const Contact& contact = watch_.exact().touching() ? watch_.exact() : log_.latest().contact;
  if (played_) return;
  const ServoSample& latest = log_.latest();
  const PoseA hand{latest.hip, latest.orientation};
  std::unique_ptr<Interaction> made = interactionAt(stage_, touch(), contact, hand, servo_.device());
  if (made && latest.body_pose && contact.touching()) {  // a body goes on from its rest pose, where it overlaps nothing
    made->reset();
    made->respond(*latest.body_pose);
    made->respond(hand);
  }
  servo_.setInteraction(std::move(made));
}

void HapticSession::leadBy(const ServoSettings* recorded) {
  // Whether the force is on stays the choice of who sits there.
  const auto take = [&](const ServoSettings& from) {
    TouchSetup led;
    from.giveTo(led);
    led.force_on = servo_settings.force_on;
    servo_settings.take(led);
  };
  if (recorded && !recorded_) before_recorded_ = servo_settings;
  const bool anew = !recorded || !recorded_ || recorded_->discontinuities != recorded->discontinuities;
  if (recorded) {
    // Seen as it was felt.
    if (anew || recorded_->workspace.rotation != recorded->workspace.rotation)
      camera.orientation = glm::normalize(glm::quat_cast(recorded->workspace.rotation));
    take(*recorded);
    servo_settings.workspace = recorded->workspace;
    servo_settings.clutch = recorded->clutch;
    recorded_ = *recorded;
  } else if (recorded_) {
    take(*before_recorded_);
    recorded_.reset();
    fitRoomOfDevice();
  }
  if (anew) ++servo_settings.discontinuities;
}

bool HapticSession::beginRecording() {
  if (!stage_ || played_ || trying() || recorded_) return false;
  ++servo_settings.discontinuities;
  servo_.setSettings(effectiveSettings(false));
  servo_.record(true);
  servo_.setInteraction(freshInteraction());
  return true;
}

bool HapticSession::moveAtoms(const std::vector<Sphere>& to, int ticks) {
  if (!stage_ || played_ || trying()) return false;
  auto next = motion_ ? SphereMotion::after(*motion_, to, ticks)
                      : SphereMotion::make(stage_.spheres->spheres(), to, ticks, stage_.spheres->untouchable());
  if (!next) return false;
  std::shared_ptr<const SphereMotion> motion = *std::move(next);
  if (!servo_.setMotion(motion)) return false;
  motion_ = std::move(motion);
  return true;
}

void HapticSession::placeAtoms(SharedArray<Sphere> at) {
  if (!stage_) return;
  seen_ = std::make_shared<const Molecule>(stage_.molecule->movedTo(at));
  stage_ = movedModel(resting_model_, std::move(at));
  motion_.reset();
  seen_motion_ = 0;
  log_.clear();
  watch_.begin(stage_, touch());
  std::unique_ptr<Interaction> felt = freshInteraction();
  layBeforeHand(camera.target);
  handBegins(camera.target);
  servo_.begin(effectiveSettings(false), std::move(felt));
}

// The picture goes with the newest tick, and costs at most half of the window's time: shapes that take long to make
// follow less often.
void HapticSession::followMotion(double dt_s) {
  if (since_seen_s_ == 0.0) frame_after_s_ = dt_s;
  since_seen_s_ += dt_s;
  const ServoSample& now = servo_.newest();
  const std::shared_ptr<const SphereMotion> motion = servo_.motionOf(now);
  if (!motion || (now.motion == seen_motion_ && now.fraction == seen_fraction_) || since_seen_s_ < 2.0 * frame_after_s_)
    return;
  seen_motion_ = now.motion;
  seen_fraction_ = now.fraction;
  since_seen_s_ = 0.0;
  const SharedArray<Sphere> places = motion->at(now.fraction);
  seen_ = std::make_shared<const Molecule>(stage_.molecule->movedTo(places));
  stage_ = movedModel(stage_, *motion, places);
}

FeltTicks HapticSession::advance(double dt_s, double now_s, bool timed) {
  const Method& m = *findMethod(made_with_.method);
  const PointA hand_before = log_.latest().hip;
  felt_.clear();
  const std::vector<ServoSample>& ticks = servo_.advance(dt_s);
  if (played_) {
    // What the hand does meanwhile counts for nothing.
    for (played_owed_s_ += std::min(dt_s, 0.5); played_owed_s_ >= kTick_s; played_owed_s_ -= kTick_s)
      log_.add(*played_);
    hand_moved_ = false;
  } else {
    for (const ServoSample& sample : ticks) {
      log_.add(sample);
      // A body has no SCP that a sphere's could be held against.
      felt_.push_back(
          {sample, servo_.hasOrientation() ? sample.contact : watch_.add(sample, m, servo_.motionOf(sample))});
    }
    followMotion(dt_s);
    log_.measure(now_s);
    servo_.timeTicks(timed);
    hand_moved_ = glm::distance(hand_before.A, log_.latest().hip.A) > kStill_A;
    watchLeftBehind(dt_s);
    drawBack(dt_s);
  }
  log_.figureForce(now_s);
  // Whatever is shown: the panic key is among the settings.
  servo_.setSettings(effectiveSettings(trying()));
  return {felt_, m};
}

void HapticSession::watchLeftBehind(double dt_s) {
  const ServoSample& now = log_.latest();
  const bool free = stage_ && log_.touching() && inTheOpen(stage_, now, servo_.motionOf(now).get());
  log_.countLeftBehind(free && !controls.pressing(), dt_s);
  if (log_.leftBehind_s() <= kLeftBehind_s) return;
  ++servo_settings.discontinuities;
  log_.countLeftBehind(false, dt_s);
}

}  // namespace moltact
