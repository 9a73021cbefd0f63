#include "app/ui/scene/haptic_session.h"

#include <algorithm>
#include <utility>

#include "engine/haptics/height_field/height_field_tracker.h"
#include "engine/haptics/pull_spring.h"
#include "engine/lesson/second_state.h"
#include "engine/render/molecule_model.h"
#include "engine/workspace/scale.h"

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

HapticSession::HapticSession(ServoClock clock) : servo_(clock) {}

void HapticSession::show(TouchableModel next, const MoleculeKey& molecule, const Facing& facing) {
  letGo();
  atoms_.begin(std::move(next));
  molecule_ = molecule;
  constructed_with_.interaction = wanted_interaction_;
  constructed_with_ = resolveInteraction(constructed_with_, stage().body != nullptr);
  servo_settings.workspace = stage().workspace;
  log_.clear();
  watch_.begin(stage(), touch());
  // Constructed before the workspace is changed: until then the previous interaction is felt at its place.
  std::unique_ptr<Interaction> felt = freshInteraction();
  resetView(facing);
  servo_.begin(effectiveSettings(false), std::move(felt));
}

std::unique_ptr<Interaction> HapticSession::interactionHere(const Contact& contact, const PoseA& hand) {
  std::shared_ptr<const PairField> pairs;
  std::unique_ptr<Interaction> made = interactionAt(stage(), touch(), contact, hand, servo_.device(), &pairs);
  forces_.begin(stage(), std::move(pairs));
  if (made && field_) return std::make_unique<HeightFieldTracker>(field_);
  if (made && !pulled_.empty())
    return std::make_unique<PullSpring>(std::move(made), pulled_, stage().spheres->spheres(), pulled_masses_);
  return made;
}

std::unique_ptr<Interaction> HapticSession::freshInteraction() {
  if (!played_) return interactionHere(Contact{}, PoseA{});
  forces_.begin(stage(), nullptr);
  return nullptr;
}

void HapticSession::showSample(const std::optional<ServoSample>& sample) {
  const bool was = playing();
  played_.show(sample);
  if (was == playing()) return;
  atoms_.stop();
  log_.clear();
  ++servo_settings.discontinuities;
  servo_.begin(effectiveSettings(false), freshInteraction());
}

// The settings for the servo loop: those of the panels, or during a force trial those of the trial. There is no force
// while the scene is not visible or a hand is played.
ServoSettings HapticSession::effectiveSettings(bool trying) const {
  if (trying) return ForceTrial::settings(servo_settings);
  ServoSettings out = servo_settings;
  out.force_on = out.force_on && !resting_ && !played_;
  return out;
}

void HapticSession::stopForce(bool stopped) {
  servo_settings.panic = stopped;
  if (stopped) endTry();
  servo_.loop().setSettings(effectiveSettings(trying()));
}

bool HapticSession::tryForce(double force_N) {
  if (played_ || servo_settings.panic) return false;
  trial_.begin(force_N, servo_settings);
  return true;
}

void HapticSession::endTry() {
  if (!trying()) return;
  ++servo_settings.discontinuities;
  servo_.loop().setSettings(effectiveSettings(false));
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
  fitRoom(place);
  handBegins(place);
}

void HapticSession::holdAt(const PoseA& body) {
  if (!stage().body || played_ || trying() || recorded_.on()) return;
  brought_.reset();
  if (servo_.deviceLeads())
    brought_ = body;
  else
    controls.beginAt(body, camera, servo_settings.workspace, servo_.mouse());
  log_.clear();
  ++servo_settings.discontinuities;
  servo_.beginAgain(effectiveSettings(false));
}

// A discontinuity ends the clutch's offset, and the workspace may have changed with it: where the hand is, and how it is
// turned, follows only from a tick after it. The screen's axes are the device's, so the view turns until the hand's
// orientation is that of the pose.
void HapticSession::bringToHand() {
  const ServoSample& now = servo_.newest();
  if (!brought_ || now.discontinuities != servo_settings.discontinuities) return;
  const PoseA pose = *std::exchange(brought_, std::nullopt);
  const Quat held = glm::conjugate(glm::quat_cast(servo_settings.workspace.rotation)) * now.orientation;
  camera.orientation = glm::normalize(pose.orientation * glm::conjugate(held));
  camera.target = pose.place;
  fitRoom(pose.place);
  servo_settings.workspace =
      rescaled(servo_settings.workspace, servo_settings.workspace.A_per_mm, now.hand, pose.place);
  log_.clear();
  ++servo_settings.discontinuities;
  servo_.beginAgain(effectiveSettings(false));
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

std::shared_ptr<const Colouring> HapticSession::colouring(std::string_view scheme) const {
  const TouchSetup now = touch();
  // Atoms in the hand are among the untouchable ones. Neither exerts a force.
  const std::vector<std::uint32_t> apart = stage().spheres->untouchable();
  return schemeColouring(*stage().molecule, scheme,
                         {.dielectric = now.dielectric, .held = apart, .fluctuation_A = fluctuation_A_, .later = true});
}

bool HapticSession::drawsNothing() const {
  return look.hidden && stage() && look.hidden->size() == stage().molecule->atoms.size();
}

Camera HapticSession::cameraFor(const Facing& facing, const std::optional<Region>& part) const {
  return fit_.cameraFor(camera, facing, part, look.hidden, servo_settings.probe_A);
}

void HapticSession::resetView(const Facing& facing) {
  if (!stage()) return;
  camera = cameraFor(facing, fit_.part());
  fit_.by_hand = false;
  fitRoom(camera.target);
  handBegins(fit_.part() ? fit_.part()->centre : stage().middle);
}

void HapticSession::magnify(bool on) {
  if (!stage() || played_ || recorded_.on() || on == fit_.by_hand) return;
  servo_settings.workspace = fit_.magnified(servo_settings.workspace, camera, on, log_.latest());
  servo_.loop().setSettings(effectiveSettings(trying()));
}

void HapticSession::fitRoomOfDevice() {
  if (!stage()) return;
  const PointA toward = fit_.by_hand ? log_.latest().hip : camera.target;
  fitRoom(toward);
  handBegins(toward);
}

void HapticSession::followView() {
  if (!stage() || recorded_.on() || !fit_.outdated(camera)) return;
  fitRoom(camera.target);
  ++servo_settings.discontinuities;
  // The mouse's hand keeps its position in the molecule.
  if (!fit_.deviceLeads()) servo_.mouse().place(servo_settings.workspace.toDevice(controls.lead()));
  servo_.loop().setSettings(effectiveSettings(trying()));
}

void HapticSession::fitRoom(PointA toward) {
  servo_settings.workspace =
      fit_.fitted(servo_settings.workspace, camera, toward, servo_settings.probe_A, log_.latest());
}

void HapticSession::retract(double dt_s) {
  const auto back = fit_.retracted(servo_settings, log_.latest(), dt_s);
  if (!back || recorded_.on()) return;
  servo_settings.workspace = *back;
  ++servo_settings.discontinuities;
}

void HapticSession::handBegins(PointA before) {
  brought_.reset();
  ++servo_settings.discontinuities;
  controls.begin(camera, before, servo_settings.workspace, std::min(stage().reach_A, camera.distance_A),
                 servo_.mouse());
  servo_.loop().setSettings(effectiveSettings(trying()));
}

TouchSetup HapticSession::touch() const {
  TouchSetup out = constructed_with_;
  servo_settings.giveTo(out);
  return out;
}

void HapticSession::setTouch(const TouchSetup& wanted) {
  TouchSetup next = wanted;
  const Method* method = findMethod(next.method);
  next.method = method ? method->name : constructed_with_.method;
  if (!findInteractionKind(next.interaction)) next.interaction = constructed_with_.interaction;
  wanted_interaction_ = next.interaction;
  next = resolveInteraction(std::move(next), stage().body != nullptr);
  const bool alike = sameConstruction(next, constructed_with_),
             other_medium = next.dielectric != constructed_with_.dielectric;
  servo_settings.take(next);
  constructed_with_ = std::move(next);
  watch_.feelWith(touch());
  if (!alike) {
    rebuildInteraction();
    log_.forgetLowest();
  }
  if (other_medium && stage() && look.colouring && look.colouring->scheme == "potential")
    look.colouring = colouring(look.colouring->scheme);
}

void HapticSession::useMethod(std::string_view name) {
  TouchSetup next = touch();
  next.method = name;
  setTouch(next);
}

void HapticSession::pull(std::vector<std::uint32_t> atoms, std::vector<double> masses) {
  const bool can = stage() && !stage().body && !played_ && !trying();
  if (!can || std::any_of(atoms.begin(), atoms.end(),
                          [&](std::uint32_t atom) { return atom >= stage().spheres->spheres().size(); }))
    atoms.clear();
  if (atoms == pulled_) return;
  pulled_masses_ = std::move(masses);
  pulled_ = std::move(atoms);
  controls.drag(!pulled_.empty());
  if (can) servo_.setInteraction(interactionHere(Contact{}, PoseA{}));
}

void HapticSession::touchField(std::shared_ptr<const HeightField> field, std::shared_ptr<const SphereGrid> like) {
  if (field == field_ || (field && (!stage() || stage().body || played_ || trying()))) return;
  letGo();
  field_ = std::move(field);
  field_like_ = field_ ? std::move(like) : nullptr;
  if (!stage() || played_) return;
  startSoftly();
  servo_.setInteraction(interactionHere(Contact{}, PoseA{}));
}

void HapticSession::letGo() {
  pulled_.clear();
  field_.reset();
  field_like_.reset();
  controls.drag(false);
}

void HapticSession::rebuildInteraction() {
  if (trying()) return endTry();
  // Each method continues from the exact contact, so that it inherits no error of another.
  const Contact& contact = watch_.exact().touching() ? watch_.exact() : log_.latest().contact;
  if (played_) return;
  const ServoSample& latest = log_.latest();
  const PoseA hand{latest.hip, latest.orientation};
  std::unique_ptr<Interaction> made = interactionHere(contact, hand);
  // What hangs in a field goes on from its place, as does a body from its rest pose, where it overlaps nothing.
  if (made && (latest.molecular_energy || (latest.body_pose && contact.touching()))) leadFrom(*made, latest);
  servo_.setInteraction(std::move(made));
}

void HapticSession::leadBy(const ServoSettings* recorded) {
  bool anew = true;
  if (recorded)
    anew = recorded_.lead(*recorded, servo_settings, camera);
  else if (recorded_.end(servo_settings))
    fitRoomOfDevice();
  if (anew) ++servo_settings.discontinuities;
}

bool HapticSession::beginRecording() {
  if (!stage() || played_ || trying() || recorded_.on()) return false;
  letGo();
  ++servo_settings.discontinuities;
  servo_.loop().setSettings(effectiveSettings(false));
  servo_.record(true);
  servo_.setInteraction(freshInteraction());
  return true;
}

bool HapticSession::moveAtoms(const MotionSource& source, const std::vector<Sphere>& to, int ticks) {
  return source.owns() && stage() && !played_ && !trying() && atoms_.move(to, ticks);
}

bool HapticSession::placeAtoms(const MotionSource& source, SharedArray<Sphere> at) {
  if (!source.owns() || !stage()) return false;
  letGo();
  atoms_.place(std::move(at));
  log_.clear();
  watch_.begin(stage(), touch());
  std::unique_ptr<Interaction> felt = freshInteraction();
  fitRoom(camera.target);
  handBegins(camera.target);
  servo_.begin(effectiveSettings(false), std::move(felt));
  return true;
}

FeltTicks HapticSession::advance(double dt_s, double now_s, bool timed) {
  const Method& m = *findMethod(constructed_with_.method);
  const PointA hand_before = log_.latest().hip;
  felt_.clear();
  const std::vector<ServoSample>& ticks = servo_.advance(dt_s);
  if (played_) {
    // The hand's motion meanwhile has no effect.
    played_.addTo(log_, dt_s);
    hand_moved_ = false;
  } else {
    for (const ServoSample& sample : ticks) {
      log_.add(sample);
      // A body has no SCP that could be compared with that of a sphere.
      felt_.push_back({sample, servo_.loop().hasOrientation() || !pulled_.empty() || field_
                                   ? sample.contact
                                   : watch_.add(sample, m, servo_.motionOf(sample))});
    }
    atoms_.follow(dt_s);
    log_.measure(now_s);
    servo_.timeTicks(timed);
    hand_moved_ = glm::distance(hand_before.A, log_.latest().hip.A) > kStill_A;
    watchLeftBehind(dt_s);
    if (brought_)
      bringToHand();
    else
      retract(dt_s);
  }
  servo_.loop().wantReactions(stage().body != nullptr && !played_);
  const std::span<const AtomForce> reactions =
      played_ || !stage().body ? std::span<const AtomForce>() : servo_.loop().reactions().forces();
  body_contacts_ = moltact::bodyContacts(stage(), log_.latest(), reactions, servo_.motionOf(log_.latest()).get());
  forces_.follow(log_.latest(), look.hidden);
  log_.figureForce(now_s);
  // Independent of what is shown, because the settings contain the panic key.
  servo_.loop().setSettings(effectiveSettings(trying()));
  return {felt_, m};
}

void HapticSession::watchLeftBehind(double dt_s) {
  const ServoSample& now = log_.latest();
  // Forces between atoms draw what is held off the hand, into contact; only farther away it is left behind.
  const bool drawn = now.molecular_energy && glm::length(now.contact.displacement_A) < kDrawn_A;
  const bool free =
      stage() && log_.touching() && !drawn && !field_ && inTheOpen(stage(), now, servo_.motionOf(now).get());
  log_.countLeftBehind(free && !controls.pressing(), dt_s);
  if (log_.leftBehind_s() <= kLeftBehind_s) return;
  ++servo_settings.discontinuities;
  log_.countLeftBehind(false, dt_s);
}

}  // namespace moltact
