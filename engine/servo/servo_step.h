// One tick of the servo loop as a function of its inputs: the same on the haptic thread and on a test's virtual clock.
// No lock, allocation, exception, log or call of the system.
#pragma once

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

/// The program's requests to the servo loop, handed over whole. Values out of range are clamped, non-finite ones
/// ignored.
struct ServoSettings {
  Workspace workspace;
  /// The stiffness of the spring between HIP and SCP, in the device's space (0 to 5); less is used where the loop would
  /// vibrate.
  double stiffness_N_per_mm = 0.5;
  double max_force_N = 3.3;           ///< the force's norm is clamped to this
  double probe_A = kWaterProbe_A;     ///< reached gradually, by kProbeSlew_A_per_s
  bool force_on = true;               ///< false: contact is followed, but no force is given
  ClutchSettings clutch;              ///< how the hand reaches farther than the device
  bool panic = false;                 ///< true: no force from the next tick on, whatever else holds
  std::uint32_t discontinuities = 0;  ///< raised by one: forget the contact and restart at the HIP

  /// Those properties of a setup that the loop itself uses; the others went into the interaction when it was made.
  void take(const TouchSetup& touch) noexcept {
    probe_A = touch.probe_A;
    stiffness_N_per_mm = touch.stiffness_N_per_mm;
    force_on = touch.force_on;
  }
  /// The same back.
  void giveTo(TouchSetup& touch) const noexcept {
    touch.probe_A = probe_A;
    touch.stiffness_N_per_mm = stiffness_N_per_mm;
    touch.force_on = force_on;
  }
};

/// The state of a scene whose spheres move.
struct MotionPhase {
  const SphereMotion* motion = nullptr;  ///< null: they are at rest where the interaction was made with them
  double fraction = 0.0;                 ///< of the motion, 0 to 1
};

inline constexpr double kProbeSlew_A_per_s = 8.0;  ///< how fast the surface may swell under the finger

/// The least force of a field that counts as felt; a hand notices forces of some hundredths of a newton.
inline constexpr double kMinFelt_N = 0.02;

/// The complete result of one tick, for the screen, the lesson and the log.
struct ServoSample {
  std::uint64_t tick = 0;
  double time_s = 0;               ///< since the loop began
  PointMm hand;                    ///< the device's position, shifted by the clutch
  PointA hip;                      ///< that position in the molecule's space
  Quat orientation = kNoRotation;  ///< of what is in the hand, in the molecule's space
  Contact contact;
  Vec3 torque_A2{0.0};                            ///< of the springs, as in Response
  double springs = 1.0;                           ///< as in Response
  double spring_N_per_A = 0.0;                    ///< the stiffness of each spring that is in force
  double field_share = 1.0;                       ///< of the field, that is in force
  std::optional<FeltForce> field = std::nullopt;  ///< as the interaction gave it
  std::optional<PoseA> body_pose = std::nullopt;  ///< as in Response
  bool at_rest = true;                            ///< as in Response
  ForceN force;                                   ///< as given to the device, after every limit
  Vec3 torque_N_mm{0.0};                          ///< the same; none for a device that drives none
  LimitFlags limits;                              ///< those that changed the force of this tick
  double probe_A = 0;                             ///< in force at this tick
  MemoryUsage memory_usage;                       ///< of the interaction
  std::uint32_t buttons = 0;
  float work_us = 0;  ///< how long the tick took (0 on a virtual clock)
  float late_us = 0;  ///< how long after its due time it began (0 on a virtual clock)
  /// The stiffest spring that is allowed, for the device and the recently measured delay.
  double stiffness_bound_N_per_mm = 0;
  bool has_interaction = false;
  bool holds_body = false;   ///< Interaction::hasOrientation
  std::uint64_t motion = 0;  ///< SphereMotion::serial() of the motion that the spheres are in; 0: they are at rest
  double fraction = 0.0;     ///< of that motion
  std::uint32_t scene = 0;   ///< the number that the interaction was handed over with (0 from tick() itself)
  std::uint32_t discontinuities = 0;  ///< of the settings in force at this tick
  /// The contact was forgotten before this tick: hand or scene were placed elsewhere, or the hand was lost.
  bool placed = false;

  /// Where the held body is shown.
  PoseA shownBody() const { return Response{.contact = contact, .body_pose = body_pose}.shownBody({hip, orientation}); }
  /// Contact and field together, before every limit but those on the stiffness, in the molecule's space.
  FeltForce wanted() const {
    return Response{.contact = contact, .torque_A2 = torque_A2, .springs = springs, .field = field}.total(
        spring_N_per_A, field_share);
  }
  /// Where the force leads, in the molecule's space; its length has no meaning. Zero without a force.
  Vec3 forceDirection() const { return field ? wanted().force_N : contact.displacement_A; }
  /// Where the force is shown to act.
  PointA forcePlace() const { return contact.touching() ? contact.scp : hip; }
  /// A force is there for the hand to notice, of a contact or of a field. `contact.touching()` says that a surface is
  /// touched.
  bool felt() const { return contact.touching() || (field && glm::length(force.N) >= kMinFelt_N); }
};

/// The reactions on the scene's atoms in one tick (unit: newton of the hand, in the molecule's axes): their sum is the
/// opposite of ServoSample::wanted's force. None in a tick in which the hand is to feel no force.
struct Reactions {
  std::uint64_t tick = 0;
  std::size_t count = 0;
  std::vector<AtomForce> room;  ///< made beforehand, for as many as the interaction ever gives
  std::span<const AtomForce> forces() const { return std::span(room).first(count); }
};

class ServoStep {
 public:
  explicit ServoStep(const DeviceSpecs& device = shownForceFigures()) : ServoStep(device, true) {}

  /// From now on another device is read: its figures apply, the contact is forgotten, and the force starts softly.
  void setDevice(const DeviceSpecs& device) noexcept {
    safety_.setDevice(device);
    clutch_.restart();
    workspace_mm_ = device.workspace_mm;
    other_device_ = true;
  }

  /// One tick. `interaction` may be null: no molecule, no force. It may change between ticks: a new one is not reset,
  /// and the force starts softly. One motion of its spheres may follow another under the same interaction, and the
  /// force goes on as it is: what the springs take up from moving spheres does not count as energy made by the loop.
  /// `reactions`, where it is given, is filled; its room must hold Interaction::greatestReactionCount().
  ServoSample tick(const ServoSettings& settings, Interaction* interaction, const DevicePose& pose,
                   const TickTime& time = {}, const MotionPhase& phase = {}, Reactions* reactions = nullptr) noexcept;

  /// Forgets the last interaction: the next one counts as new.
  void forgetInteraction() noexcept { last_interaction_ = nullptr; }

  const SafetyStage& safety() const { return safety_; }

 protected:
  /// Without the guard the safety stage is left out, except for the greatest force: a derived class may so judge a
  /// method alone. No program with a hand has such a class.
  ServoStep(const DeviceSpecs& device, bool guarded) noexcept
      : guarded_(guarded), workspace_mm_(device.workspace_mm), safety_(device) {}

 private:
  friend struct StepState;  // step_state.cpp, which keeps it
  bool moveSurface(const ServoSettings& settings, Interaction& interaction, const MotionPhase& phase,
                   bool changed) noexcept;
  void askBefore(const Workspace& workspace, Interaction& interaction, Stored& before) noexcept;
  void feel(const ServoSettings& settings, const Response& response, WantedWrench& wanted) noexcept;

  std::uint64_t tick_ = 0;
  const Interaction* last_interaction_ = nullptr;
  // The last pose asked for, and where the spheres were: the first tick with another interaction depends on neither.
  PoseA last_at_;
  std::uint64_t last_motion_ = 0;  // its serial; 0: none
  double last_fraction_ = 0.0;
  std::uint32_t discontinuities_ = 0, hand_discontinuities_ = 0;
  bool other_device_ = false, guarded_ = true;
  double A_per_mm_ = 0;
  Vec3 workspace_mm_;
  Vec3 push_{0.0};  // the direction in which the surface pushed in the last tick
  Clutch clutch_;
  SafetyStage safety_;
};

}  // namespace moltact
