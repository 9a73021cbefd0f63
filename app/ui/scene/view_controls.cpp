#include "app/ui/scene/view_controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact {
namespace {
constexpr double kDragKeys_A_per_s = 4.0;
constexpr double kOrbit_rad_per_px = 0.008;
constexpr double kOrbitKeys_rad_per_s = 1.4;
constexpr double kHand_rad_per_px = kOrbit_rad_per_px, kHandKeys_rad_per_s = kOrbitKeys_rad_per_s;
constexpr double kGiveWay_rad_per_s = 1.0;  // largest speed at which a hand in a well follows the body that it holds
constexpr double kPanKeys_px_per_s = 320.0;
constexpr double kZoomNotch = 1.12;
constexpr double kZoomKeysPerS = 2.2;
constexpr double kHintFade_s = 0.6;
constexpr double kStill_px = 0.5;      // an aim that moves less than this per frame is at rest
constexpr double kHoverStep_A = 0.25;  // a hovering hand that moves farther than this per frame is repositioned
}  // namespace

ViewRays viewRays(const Camera& camera, glm::dvec2 size_px) {
  return {.eye_A = camera.eye().A,
          .forward = -camera.back(),
          .right = camera.right(),
          .up = camera.up(),
          .tan_half_fov = camera.tanHalfY(),
          .width_px = size_px.x,
          .height_px = size_px.y};
}

void ViewControls::update(const ViewInput& in, Camera& camera, const SphereGrid* spheres, const ServoSettings& settings,
                          const ServoSample& felt, MouseDevice& mouse, const HeldBody* body) {
  const Camera before = camera;
  const glm::dvec2 orbit = in.orbit_px * kOrbit_rad_per_px +
                           glm::dvec2(in.orbit_keys.x, -in.orbit_keys.y) * (kOrbitKeys_rad_per_s * in.dt_s);
  if (orbit != glm::dvec2(0.0)) camera.orbit(orbit.x, orbit.y);
  const glm::dvec2 pan = in.pan_px + glm::dvec2(in.pan_keys.x, -in.pan_keys.y) * (kPanKeys_px_per_s * in.dt_s);
  if (pan != glm::dvec2(0.0)) camera.pan(pan.x, pan.y, int(in.size_px.y));
  const double zoom = std::pow(kZoomNotch, in.zoom_notches) * std::pow(kZoomKeysPerS, in.zoom_keys * in.dt_s);
  if (zoom != 1.0) camera.zoom(zoom);
  camera_moved_ = !(camera == before);
  has_turned_ = has_turned_ || orbit != glm::dvec2(0.0);

  if (in.release) let_go_ = true;
  if (!in.press) let_go_ = false;
  pressing_ = in.press && !let_go_ && spheres;
  has_pressed_ = has_pressed_ || pressing_;
  has_pushed_ = has_pushed_ || (pressing_ && in.push_notches != 0.0);
  if (has_pressed_ && has_turned_) hint_left_s_ -= in.dt_s;
  if (!spheres) return;

  // Rotation about the screen's axes: to the right about the vertical one, downwards about the horizontal one,
  // clockwise about the viewing direction.
  const glm::dvec2 turn =
      in.hand_px * kHand_rad_per_px + glm::dvec2(in.hand_keys.x, -in.hand_keys.y) * (kHandKeys_rad_per_s * in.dt_s);
  const Vec3 seen = camera.up() * turn.x + camera.right() * turn.y - camera.back() * in.hand_roll_rad;
  if (const double angle_rad = glm::length(seen); angle_rad > 0.0) {
    const Vec3 axis = glm::transpose(settings.workspace.rotation) * seen;
    orientation_ = glm::normalize(glm::angleAxis(angle_rad, glm::normalize(axis)) * orientation_);
    mouse.turn(orientation_);
  }

  PointerInput pointer;
  pointer.rays = viewRays(camera, in.size_px);
  pointer.pointer_px = in.pointer_px;
  if (first_aim_ && !pointer.pointer_px) {
    const Vec3 px = camera.project(*first_aim_, std::max(1, int(in.size_px.x)), std::max(1, int(in.size_px.y)));
    pointer.pointer_px = glm::dvec2(px.x, px.y);
  }
  first_aim_.reset();
  pointer.over_control = in.over_control;
  pointer.keys = in.probe_keys;
  pointer.press = pressing_;
  pointer.touching = felt.contact.touching();
  pointer.hip = felt.hip;
  pointer.push_notches = in.push_notches;
  pointer.force_N = glm::length(felt.force.N);
  pointer.N_per_A = settings.force_on
                        ? in.expected_N_per_mm.value_or(settings.stiffness_N_per_mm) / settings.workspace.A_per_mm
                        : 0.0;
  // The springs of a body's atoms act in parallel; the mouse feels an equivalent single spring, whose displacement D
  // stores D^2 / 2.
  if (const Contact& c = felt.contact; body && c.energy_A2 > 0.0)
    pointer.N_per_A *= std::max(1.0, 0.5 * glm::dot(c.displacement_A, c.displacement_A) / c.energy_A2);
  if (felt.field && settings.force_on) {
    const FeltForce pull = felt.wanted();
    pointer.field = true;
    pointer.pull_N = pull.force_N;
    pointer.pull_N_per_A = pull.stiffness_N_per_A;
    pointer.well_N_A = felt.field->energy_N_A;
  }
  if (const auto& energy = felt.molecular_energy; energy && settings.force_on) {
    const FeltForce pull = felt.wanted();
    pointer.field = true;
    pointer.pull_N = pull.force_N;
    pointer.pull_N_per_A = pull.stiffness_N_per_A;
    // The minimum of coupling and field is a well of the hand.
    pointer.well_N_A = pull.energy_N_A + energy->felt_kcal_mol * felt.spring_N_per_A / energy->coupling_kcal_mol_A2;
  }
  pointer.dt_s = in.dt_s;
  if (drags_) return dragHand(pointer, settings, mouse);
  const PointA before_lead = lead_;
  const glm::dvec2 before_aim_px = hand_.aim_px();
  lead_ = hand_.lead(pointer, *spheres,
                     body ? HandShape(*body, settings.workspace.toMolecule({}, orientation_).orientation)
                          : HandShape(settings.probe_A));
  // In a well the hand yields in turning as well: it follows the body, which the field turns against its spring.
  if (body && hand_.inWell()) {
    const Quat wanted =
        glm::normalize(glm::conjugate(glm::quat_cast(settings.workspace.rotation)) * felt.shownBody().orientation);
    const Vec3 turn_by = rotationBetween(orientation_, wanted);
    if (const double angle_rad = glm::length(turn_by); angle_rad > 1e-6) {
      const double part =
          std::min(1.0 - std::exp(-in.dt_s / PointerHand::kSettle_s), kGiveWay_rad_per_s * in.dt_s / angle_rad);
      orientation_ = glm::normalize(glm::angleAxis(part * angle_rad, turn_by / angle_rad) * orientation_);
      mouse.turn(orientation_);
    }
  }
  press_rested_s_ =
      pressing_ && glm::distance(hand_.aim_px(), before_aim_px) < kStill_px ? press_rested_s_ + in.dt_s : 0.0;
  // A hovering hand moves over the molecule, not through what lies between two pointer positions.
  const bool hovering = !pressing_ && !pointer.touching;
  if (hand_.leapt() || (hovering && glm::distance(lead_.A, before_lead.A) > kHoverStep_A))
    mouse.place(settings.workspace.toDevice(lead_));
  else
    mouse.lead(settings.workspace.toDevice(lead_));
}

void ViewControls::dragHand(const PointerInput& in, const ServoSettings& settings, MouseDevice& mouse) {
  const ViewRays& rays = in.rays;
  lead_.A += (rays.right * in.keys.x + rays.up * in.keys.y) * (kDragKeys_A_per_s * in.dt_s) +
             rays.forward * (in.push_notches * PointerHand::kMaxNotch_A);
  if (in.pointer_px && !in.over_control) {
    const Vec3 along = rays.direction(*in.pointer_px);
    const double depth = glm::dot(lead_.A - rays.eye_A, rays.forward);
    if (depth > 0.0) lead_.A = rays.eye_A + along * (depth / glm::dot(along, rays.forward));
  }
  mouse.lead(settings.workspace.toDevice(lead_));
}

double ViewControls::hintStrength() const { return std::clamp(hint_left_s_ / kHintFade_s, 0.0, 1.0); }

bool ViewControls::live() const {
  return pressing_ || camera_moved_ || (hint_left_s_ > 0.0 && hint_left_s_ < kHintFade_s);
}

void ViewControls::begin(const Camera& camera, PointA before, const Workspace& workspace, double outside_A,
                         MouseDevice& mouse) {
  hand_.reset();
  first_aim_ = before;
  pressing_ = let_go_ = false;
  press_rested_s_ = 0.0;
  lead_ = start_at_.value_or(PointA{before.A + camera.back() * outside_A});
  if (start_at_) hand_.waitAt(*start_at_);
  orientation_ = start_ ? glm::normalize(glm::conjugate(glm::quat_cast(workspace.rotation)) * *start_) : kNoRotation;
  mouse.turn(orientation_);
  mouse.place(workspace.toDevice(lead_));
}

void ViewControls::beginAt(const PoseA& hand, const Camera& camera, const Workspace& workspace, MouseDevice& mouse) {
  const std::optional<Quat> start = std::exchange(start_, hand.orientation);
  const std::optional<PointA> start_at = std::exchange(start_at_, hand.place);
  begin(camera, hand.place, workspace, 0.0, mouse);
  start_ = start;
  start_at_ = start_at;
}

}  // namespace moltact
