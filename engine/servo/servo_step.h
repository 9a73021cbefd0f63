// One tick of the servo loop as a function of its inputs: the same on the haptic thread and on a test's virtual clock.
// No lock, allocation, exception, log or call of the system.
#pragma once

#include <cstdint>

#include "engine/core/units.h"
#include "engine/device/device.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_frame.h"
#include "engine/haptics/touch_setup.h"
#include "engine/servo/clutch.h"
#include "engine/servo/safety_stage.h"

namespace moltact {

/// What the program asks of the servo loop; handed over whole. Values out of range are clamped, non-finite ones
/// ignored.
struct ServoSettings {
  Workspace workspace;
  double stiffness_N_per_mm =
      0.5;  ///< of the spring between HIP and SCP, in the device's space (0 to 5); less where it would buzz
  double max_force_N = 3.3;           ///< the force's norm is clamped to this
  double probe_A = kWaterProbe_A;     ///< reached gradually, kProbeSlew_A_per_s
  bool force_on = true;               ///< false: contact is followed, but no force is given
  ClutchSettings clutch;              ///< how the hand reaches farther than the device
  bool panic = false;                 ///< true: no force from the next tick on, whatever else holds
  std::uint32_t discontinuities = 0;  ///< raised by one: forget the contact and begin anew where the HIP is

  /// What the loop itself does of a setup; with the rest the interaction is made.
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

/// Where the spheres of a scene that moves are.
struct SceneMotion {
  const SphereFrame* frame = nullptr;  ///< null: they stand where the interaction was made with them
  double share = 0.0;                  ///< of the frame, 0 to 1
};

inline constexpr double kProbeSlew_A_per_s = 8.0;  ///< how fast the surface may swell under the finger

/// What one tick found: whole, for the screen, the lesson and the log.
struct ServoSample {
  std::uint64_t tick = 0;
  double time_s = 0;               ///< since the loop began
  PointMm hand;                    ///< the device's place, moved on by the clutch
  PointA hip;                      ///< the same in the molecule's space
  Quat orientation = kNoRotation;  ///< of what is in the hand, in the molecule's space
  Contact contact;
  ForceN force;              ///< as given to the device, after every limit
  Vec3 torque_N_mm{0.0};     ///< the same; none for a device that drives none
  LimitFlags limits;         ///< those that changed the force of this tick
  double probe_A = 0;        ///< in force at this tick
  MemoryUsage memory_usage;  ///< of the interaction
  std::uint32_t buttons = 0;
  float work_us = 0;  ///< how long the tick took (0 on a virtual clock)
  float late_us = 0;  ///< how long after its due time it began (0 on a virtual clock)
  double stiffness_bound_N_per_mm =
      0;  ///< the stiffest spring that is given, for the device and the delay as measured of late
  bool has_tracker = false;
  std::uint64_t frame = 0;            ///< SphereFrame::serial() of the spheres' frame; 0: they stand
  double share = 0.0;                 ///< of that frame
  std::uint32_t scene = 0;            ///< the number that the tracker was handed over with (0 from tick() itself)
  std::uint32_t discontinuities = 0;  ///< of the settings in force at this tick
  bool placed =
      false;  ///< the contact was forgotten before this tick: hand or scene were placed anew, or the hand was lost
};

class ServoStep {
 public:
  explicit ServoStep(const DeviceSpecs& device = {}) : ServoStep(device, true) {}

  /// Another device is read from now on: its figures hold, the contact is forgotten, and the force starts softly.
  void setDevice(const DeviceSpecs& device) noexcept {
    safety_.setDevice(device);
    clutch_.restart();
    workspace_mm_ = device.workspace_mm;
    other_device_ = true;
  }

  /// One tick. `felt` may be null: no molecule, no force. Pass a changed one freely: it is not reset, and the force
  /// starts softly. Frames follow one another without that: what the spheres' own motion does to the springs is no
  /// energy that the loop makes.
  ServoSample tick(const ServoSettings& settings, Interaction* felt, const DevicePose& pose, const TickTime& time = {},
                   const SceneMotion& motion = {}) noexcept;

  /// As if it had met no interaction yet: the next one counts as new.
  void forgetInteraction() noexcept { last_felt_ = nullptr; }

  const SafetyStage& safety() const { return safety_; }

 protected:
  /// Without the guard the safety stage is left out, but for the greatest force: for who judges a method alone, by a
  /// class of its own. No program with a hand has one.
  ServoStep(const DeviceSpecs& device, bool guarded) noexcept
      : guarded_(guarded), workspace_mm_(device.workspace_mm), safety_(device) {}

 private:
  friend struct StepState;  // step_state.cpp, which keeps it
  bool moveSurface(const ServoSettings& settings, Interaction& felt, const SceneMotion& motion, bool changed) noexcept;
  WantedWrench feel(const ServoSettings& settings, const Response& response, double parallel) noexcept;

  std::uint64_t tick_ = 0;
  const Interaction* last_felt_ = nullptr;
  // What it was last asked for, and where the spheres were: nothing that the first tick with another depends on.
  PoseA last_at_;
  std::uint64_t last_frame_ = 0;  // its serial; 0: none
  double last_share_ = 0.0;
  std::uint32_t discontinuities_ = 0, hand_discontinuities_ = 0;
  bool other_device_ = false, guarded_ = true;
  double A_per_mm_ = 0;
  Vec3 workspace_mm_;
  Vec3 push_{0.0};  // the way of the surface's push in the last tick
  Clutch clutch_;
  SafetyStage safety_;
};

}  // namespace moltact
