#include "app/ui/scene/workspace_fit.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "engine/workspace/fit_workspace.h"

namespace moltact {
namespace {

constexpr double kProbeRoom = 2.0;  // margin around the molecule in radii of the probe,
constexpr double kBodyRoom = 0.5;   // or as a fraction of a body's reach
constexpr double kTurned = 1e-9;    // smaller changes of the view are ignored
constexpr double kSettle_s = 0.5;   // time for a newly chosen device to report its position
constexpr double kByHand_A = 3.5;   // radius of the magnified region around the probe
constexpr double kAtLeast = 2.0;    // and minimum magnification relative to the scene

glm::dmat3 axes(const Camera& camera) { return {camera.right(), camera.up(), camera.back()}; }

bool sameView(const Camera& a, const Camera& b) {
  const glm::dmat3 of_a = axes(a), of_b = axes(b);
  double off = glm::distance(a.target.A, b.target.A);
  for (int k = 0; k < 3; ++k) off = std::max(off, glm::distance(of_a[k], of_b[k]));
  return off <= kTurned;
}

}  // namespace

Camera WorkspaceFit::cameraFor(const Camera& now, const Facing& facing, const std::optional<Region>& part,
                               const AtomList& hidden, double probe_A) const {
  Camera out = now;
  out.orientation = glm::dquat(1, 0, 0, 0);
  // Leaves a margin around the molecule for the probe. Atoms that are neither drawn nor felt need none.
  std::vector<std::uint32_t> removed;
  if (hidden) {
    const std::vector<std::uint32_t> unfelt = model_.spheres->untouchable();
    std::set_intersection(hidden->begin(), hidden->end(), unfelt.begin(), unfelt.end(), std::back_inserter(removed));
  }
  const double room_A = model_.body ? kBodyRoom * model_.body->reach_A : kProbeRoom * probe_A;
  const auto fit = [&] { out.fit(*model_.molecule, view_aspect, 0.08, room_A, removed); };
  fit();
  facing(out, *model_.molecule);
  // The molecule may be wider on another side.
  fit();
  if (part) out.fit(part->centre, part->radius_A, view_aspect);
  return out;
}

Workspace WorkspaceFit::ofScene() const {
  return region ? moltact::magnified(model_.workspace, *region, servo_.device()) : model_.workspace;
}

double WorkspaceFit::byHand_A_per_mm(const ServoSample& felt) const {
  const Workspace whole = ofScene();
  return std::min(moltact::magnified(whole, {felt.hip, kByHand_A}, servo_.device()).A_per_mm,
                  whole.A_per_mm / kAtLeast);
}

Workspace WorkspaceFit::magnified(const Workspace& now, Camera& camera, bool on, const ServoSample& felt) {
  const double wanted = on ? byHand_A_per_mm(felt) : ofScene().A_per_mm;
  const double closer = now.A_per_mm / wanted;
  // The probe keeps its position in the picture.
  camera.target.A = felt.hip.A + (camera.target.A - felt.hip.A) / closer;
  camera.distance_A /= closer;
  fitted_ = camera;
  by_hand = on;
  return rescaled(now, wanted, felt.hand, felt.hip);
}

bool WorkspaceFit::outdated(const Camera& camera) const {
  return device_leads_ != servo_.deviceLeads() || (device_leads_ && !sameView(camera, fitted_));
}

Workspace WorkspaceFit::fitted(const Workspace& now, const Camera& camera, PointA toward, double probe_A,
                               const ServoSample& felt) {
  Workspace out = ofScene();
  if (by_hand) {
    out.A_per_mm = byHand_A_per_mm(felt);
    out.centre_A = toward.A;
  }
  device_leads_ = servo_.deviceLeads();
  if (device_leads_) {
    // The present orientation of the hand, along the axes of this view.
    const Quat held = glm::quat_cast(axes(camera)) * glm::conjugate(glm::quat_cast(now.rotation)) * felt.orientation;
    out = fitToDevice(out, *model_.spheres, handShape(model_, probe_A, held), toward, axes(camera), servo_.device());
  }
  fitted_ = camera;
  fit_left_s_ = kSettle_s;
  return out;
}

// The hand's position is known only after its device has reported it. A molecule placed onto the hand is moved back
// until the hand is free.
std::optional<Workspace> WorkspaceFit::retracted(const ServoSettings& settings, const ServoSample& felt, double dt_s) {
  fit_left_s_ -= dt_s;
  if (!device_leads_ || fit_left_s_ <= 0.0 || felt.discontinuities != settings.discontinuities ||
      felt.contact.fault != Fault::StartedInside)
    return std::nullopt;
  return moltact::retracted(settings.workspace, *model_.spheres, handShape(model_, felt.probe_A, felt.orientation),
                            felt.hand);
}

double WorkspaceFit::magnification(const Workspace& now) const {
  return model_ ? model_.workspace.A_per_mm / now.A_per_mm : 1.0;
}

}  // namespace moltact
