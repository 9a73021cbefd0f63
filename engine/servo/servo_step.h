// One tick of the servo loop as a function of its inputs, for the haptic thread and for tests with a virtual clock. No
// lock, allocation, exception, log or system call.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/units.h"
#include "engine/device/device.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/haptics/touch_setup.h"
#include "engine/servo/clutch.h"
#include "engine/servo/safety_stage.h"

namespace moltact {

/// The program's requests to the servo loop, handed over as a whole. Values out of range are clamped, non-finite ones
/// ignored.
struct ServoSettings {
  Workspace workspace;
  /// The requested stiffness of the spring between HIP and SCP, in the device's space (0 to 5). The loop uses less
  /// where it would become unstable.
  double stiffness_N_per_mm = 0.5;
  double max_force_N = 3.3;           ///< limit on the norm of the force
  double probe_A = kWaterProbe_A;     ///< approached at kProbeSlew_A_per_s
  SurfaceProperties surface;          ///< approached by surfaceTowards()
  bool force_on = true;               ///< false: contacts are computed, but no force is given
  ClutchSettings clutch;              ///< clutch and drift
  bool panic = false;                 ///< true: no force from the next tick on, in any case
  std::uint32_t discontinuities = 0;  ///< incremented: discard the contact and restart at the HIP

  /// Copies the properties of a setup that the loop itself applies; the interaction contains the others.
  void take(const TouchSetup& touch) noexcept {
    probe_A = touch.probe_A;
    stiffness_N_per_mm = touch.stiffness_N_per_mm;
    force_on = touch.force_on;
    surface.friction = {touch.friction, touch.stick_slip};
  }
  /// Copies these properties back to a setup.
  void giveTo(TouchSetup& touch) const noexcept {
    touch.probe_A = probe_A;
    touch.stiffness_N_per_mm = stiffness_N_per_mm;
    touch.force_on = force_on;
    touch.friction = surface.friction.coefficient;
    touch.stick_slip = surface.friction.stick_slip;
  }
};

/// The progress of a scene's motion.
struct MotionPhase {
  const SphereMotion* motion = nullptr;  ///< null: the spheres are at rest as the interaction was created
  double fraction = 0.0;                 ///< of the motion, 0 to 1
};

inline constexpr double kProbeSlew_A_per_s = 8.0;  ///< largest rate of growth of the probe during contact

/// Threshold of a field's force that counts as felt; the hand perceives forces of some hundredths of a newton.
inline constexpr double kMinFelt_N = 0.02;

/// The result of one tick, for display, lessons and logs.
struct ServoSample {
  std::uint64_t tick = 0;
  double time_s = 0;               ///< since the loop began
  PointMm hand;                    ///< position of the device, shifted by the clutch
  PointA hip;                      ///< that position in the molecule's space
  Quat orientation = kNoRotation;  ///< of the hand, in the molecule's space
  Contact contact;
  Vec3 torque_A2{0.0};                                             ///< of the springs, as in Response
  double stiffness_factor = 1.0;                                   ///< as in Response
  double spring_N_per_A = 0.0;                                     ///< stiffness used for each spring
  double field_share = 1.0;                                        ///< fraction used of the field
  std::optional<FeltForce> field = std::nullopt;                   ///< as returned by the interaction
  std::optional<PoseA> body_pose = std::nullopt;                   ///< as in Response
  bool at_rest = true;                                             ///< as in Response
  std::optional<MolecularEnergy> molecular_energy = std::nullopt;  ///< as in Response
  ForceN force;                                                    ///< as given to the device, after all limits
  Vec3 torque_N_mm{0.0};                                           ///< the same; zero for a device without torque
  LimitFlags limits;                                               ///< those that changed the force of this tick
  double probe_A = 0;                                              ///< used in this tick
  SurfaceProperties surface;                                       ///< used in this tick
  MemoryUsage memory_usage;                                        ///< of the interaction
  std::uint32_t buttons = 0;
  float work_us = 0;  ///< duration of the tick (0 on a virtual clock)
  float late_us = 0;  ///< delay of its start after the due time (0 on a virtual clock)
  /// The stiffness bound for the device and the recently measured delay.
  double stiffness_bound_N_per_mm = 0;
  bool has_interaction = false;
  bool holds_body = false;            ///< Interaction::hasOrientation
  std::uint64_t motion = 0;           ///< SphereMotion::serial() of the present motion; 0: the spheres are at rest
  double fraction = 0.0;              ///< of that motion
  std::uint32_t scene = 0;            ///< number with which the interaction was handed over (0 from tick() itself)
  std::uint32_t discontinuities = 0;  ///< of the settings used in this tick
  /// True if the contact was discarded before this tick: hand or scene were placed elsewhere, or the hand was lost.
  bool contact_reset = false;

  /// The pose in which the held body is drawn.
  PoseA shownBody() const {
    return Response{.contact = contact, .body_pose = body_pose, .molecular_energy = molecular_energy}.shownBody(
        {hip, orientation});
  }
  /// The force of contact and field before all limits except those on the stiffness, in the molecule's space.
  FeltForce wanted() const {
    return Response{.contact = contact, .torque_A2 = torque_A2, .stiffness_factor = stiffness_factor, .field = field}
        .total(spring_N_per_A, field_share);
  }
  /// The torque to show beside `force`: that of wanted(), reduced by limits as the force is (unit: N A, in the molecule's
  /// axes). Where no force but a torque is wanted, it counts as given in whole.
  Vec3 shownTorque_N_A() const {
    const FeltForce all = wanted();
    const double size = glm::length(all.force_N);
    return all.torque_N_A * (size > 1e-9 ? std::min(1.0, glm::length(force.N) / size) : 1.0);
  }
  /// The direction of the force in the molecule's space, of arbitrary length. Zero without a force.
  Vec3 forceDirection() const { return field ? wanted().force_N : contact.displacement_A; }
  /// The point at which the force is drawn.
  PointA forcePlace() const { return contact.touching() || molecular_energy ? contact.scp : hip; }
  /// True if forces act beyond contact: a field, or those between atoms.
  bool inField() const { return field || molecular_energy; }
  /// True if there is a noticeable force, from a contact or a field. `contact.touching()` tests for a contact only.
  bool felt() const { return contact.touching() || (inField() && glm::length(force.N) >= kMinFelt_N); }
};

/// The reactions on the scene's atoms in one tick (unit: newton at the hand, in the molecule's axes). Their sum is the
/// opposite of the force of ServoSample::wanted. Empty in a tick without force.
struct Reactions {
  std::uint64_t tick = 0;
  std::size_t count = 0;
  std::vector<AtomForce> room;  ///< allocated in advance for the interaction's largest number of reactions
  std::span<const AtomForce> forces() const { return std::span(room).first(count); }
};

class ServoStep {
 public:
  explicit ServoStep(const DeviceSpecs& device = shownForceFigures()) : ServoStep(device, true) {}

  /// Switches to another device: its figures apply, the contact is discarded, and the force starts softly.
  void setDevice(const DeviceSpecs& device) noexcept {
    safety_.setDevice(device);
    clutch_.forget();
    workspace_mm_ = device.workspace_mm;
    other_device_ = true;
  }

  /// Performs one tick. `interaction` may be null: no molecule, no force. It may change between ticks; a new one is not
  /// reset, and the force starts softly. With the same interaction one motion of its spheres may follow another without
  /// a soft start. Energy that moving spheres store in the springs does not count as generated by the loop.
  /// `reactions`, if given, is filled; its room must hold Interaction::maxReactionCount() entries.
  ServoSample tick(const ServoSettings& settings, Interaction* interaction, const DevicePose& pose,
                   const TickTime& time = {}, const MotionPhase& phase = {}, Reactions* reactions = nullptr) noexcept;

  /// Forgets the last interaction: the next one counts as new.
  void forgetInteraction() noexcept { last_interaction_ = nullptr; }

  const SafetyStage& safety() const { return safety_; }

 protected:
  /// With `guarded` false the safety stage is bypassed, except for the limit on the force, so that a derived class can
  /// measure a method alone. No program with a real device has such a class.
  ServoStep(const DeviceSpecs& device, bool guarded) noexcept
      : guarded_(guarded), workspace_mm_(device.workspace_mm), safety_(device) {}

 private:
  friend struct StepState;  // step_state.cpp, which saves the state
  bool moveSurface(const ServoSettings& settings, Interaction& interaction, const MotionPhase& phase,
                   bool changed) noexcept;
  static void setSurface(const SurfaceProperties& goal, Interaction& interaction, bool changed) noexcept;
  void respondBefore(const Workspace& workspace, Interaction& interaction, Stored& before) noexcept;
  void feel(const ServoSettings& settings, const Response& response, WantedWrench& wanted) noexcept;

  std::uint64_t tick_ = 0;
  const Interaction* last_interaction_ = nullptr;
  // The last pose, and the phase of the motion. The first tick with a new interaction depends on neither.
  PoseA last_at_;
  std::uint64_t last_motion_ = 0;  // its serial; 0: none
  double last_fraction_ = 0.0;
  std::uint32_t discontinuities_ = 0, hand_discontinuities_ = 0;
  bool other_device_ = false, guarded_ = true;
  double A_per_mm_ = 0;
  Vec3 workspace_mm_;
  Vec3 push_{0.0};  // direction of the surface's force in the last tick
  Clutch clutch_;
  SafetyStage safety_;
};

}  // namespace moltact
