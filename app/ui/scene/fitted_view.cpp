#include "app/ui/scene/fitted_view.h"

#include <algorithm>
#include <utility>

#include "engine/workspace/scale.h"

namespace moltact {

Camera FittedView::cameraFor(const Facing& facing, const std::optional<Region>& part) const {
  return fit.cameraFor(camera_, facing, part, look_.atoms.hidden, felt_.settings.probe_A);
}

void FittedView::reset(const Facing& facing) {
  if (!felt_.stage()) return;
  camera_ = cameraFor(facing, fit.part());
  fit.by_hand = false;
  fitRoom(camera_.target);
  handBegins(fit.part() ? fit.part()->centre : felt_.stage().middle);
}

void FittedView::beginAgain(const Facing& facing) {
  felt_.log.clear();
  reset(facing);
  felt_.servo.beginAgain(felt_.settingsNow());
}

void FittedView::beginAgainAt(PointA place) {
  beginAgain([&](Camera& turned, const Molecule&) { turned.face(place); });
  camera_.target = place;
  beginHere();
}

void FittedView::beginHere() {
  fitRoom(camera_.target);
  handBegins(camera_.target);
}

void FittedView::holdAt(const PoseA& body) {
  if (!felt_.stage().body || !felt_.ownHand() || felt_.recorded.on()) return;
  brought_.reset();
  if (felt_.servo.deviceLeads())
    brought_ = body;
  else
    felt_.controls.beginAt(body, camera_, felt_.settings.workspace, felt_.servo.mouse());
  force_.startSoftly();
}

// A discontinuity ends the clutch's offset, and the workspace may have changed with it: where the hand is, and how it is
// turned, follows only from a tick after it. The screen's axes are the device's, so the view turns until the hand's
// orientation is that of the pose.
void FittedView::bringToHand() {
  const ServoSample& now = felt_.servo.newest();
  if (now.discontinuities != felt_.settings.discontinuities) return;
  const PoseA pose = *std::exchange(brought_, std::nullopt);
  const Quat held = glm::conjugate(glm::quat_cast(felt_.settings.workspace.rotation)) * now.orientation;
  camera_.orientation = glm::normalize(pose.orientation * glm::conjugate(held));
  camera_.target = pose.place;
  fitRoom(pose.place);
  felt_.settings.workspace =
      rescaled(felt_.settings.workspace, felt_.settings.workspace.A_per_mm, now.hand, pose.place);
  felt_.log.clear();
  ++felt_.settings.discontinuities;
  felt_.servo.beginAgain(felt_.settingsOfScene());
}

void FittedView::magnify(bool on) {
  if (!felt_.stage() || felt_.played || felt_.recorded.on() || on == fit.by_hand) return;
  felt_.settings.workspace = fit.magnified(felt_.settings.workspace, camera_, on, felt_.log.latest());
  felt_.passSettings();
}

void FittedView::fitDevice() {
  if (!felt_.stage()) return;
  const PointA toward = fit.by_hand ? felt_.log.latest().hip : camera_.target;
  fitRoom(toward);
  handBegins(toward);
}

void FittedView::follow() {
  if (!felt_.stage() || felt_.recorded.on() || !fit.outdated(camera_)) return;
  fitRoom(camera_.target);
  ++felt_.settings.discontinuities;
  // The mouse's hand keeps its position in the molecule.
  if (!fit.deviceLeads()) felt_.servo.mouse().place(felt_.settings.workspace.toDevice(felt_.controls.lead()));
  felt_.passSettings();
}

void FittedView::advance(double dt_s) {
  if (brought_)
    bringToHand();
  else
    retract(dt_s);
}

void FittedView::fitRoom(PointA toward) {
  felt_.settings.workspace =
      fit.fitted(felt_.settings.workspace, camera_, toward, felt_.settings.probe_A, felt_.log.latest());
}

void FittedView::retract(double dt_s) {
  const auto back = fit.retracted(felt_.settings, felt_.log.latest(), dt_s);
  if (!back || felt_.recorded.on()) return;
  felt_.settings.workspace = *back;
  ++felt_.settings.discontinuities;
}

void FittedView::handBegins(PointA before) {
  brought_.reset();
  ++felt_.settings.discontinuities;
  felt_.controls.begin(camera_, before, felt_.settings.workspace, std::min(felt_.stage().reach_A, camera_.distance_A),
                       felt_.servo.mouse());
  felt_.passSettings();
}

}  // namespace moltact
