// One tick of the servo loop as a function of its inputs: the same on the haptic thread and on a test's virtual clock.
// No lock, allocation, exception, log or call of the system.
#pragma once

#include <cstdint>

#include "engine/core/units.h"
#include "engine/device/device.h"
#include "engine/haptics/tracker.h"

namespace moltact {

inline constexpr double kTick_s = 0.001;  ///< the length of a tick: 1 kHz

/// What the program asks of the servo loop; handed over whole. Values out of range are clamped, non-finite ones ignored.
struct ServoSettings {
  Workspace workspace;
  double stiffness_N_per_mm = 0.5;  ///< of the spring between HIP and SCP, in the device's space (0 to 5)
  double max_force_N = 3.3;         ///< the force's norm is clamped to this
  double probe_A = kWaterProbe_A;   ///< reached gradually, kProbeSlew_A_per_s
  bool force_on = true;             ///< false: contact is followed, but no force is given
  std::uint32_t placements = 0;     ///< raised by one: forget the contact and begin anew where the HIP is
};

inline constexpr double kProbeSlew_A_per_s = 8.0;  ///< how fast the surface may swell under the finger
inline constexpr double kSoftStart_s = 0.25;       ///< the force grows from nothing for so long after a start or fault

/// What one tick found: whole, for the screen, the lesson and the log.
struct ServoSample {
  std::uint64_t tick = 0;
  double time_s = 0;       ///< since the loop began
  PointMm hand;            ///< the device's place
  PointA hip;              ///< the same in the molecule's space
  Contact contact;
  ForceN force;            ///< as given to the device: clamped, softly started
  double probe_A = 0;      ///< in force at this tick
  Footprint footprint;     ///< of the tracker
  std::uint32_t buttons = 0;
  float work_us = 0;       ///< how long the tick took (0 on a virtual clock)
  float late_us = 0;       ///< how long after its due time it began (0 on a virtual clock)
  bool has_tracker = false;
  std::uint32_t scene = 0;       ///< the number that the tracker was handed over with (0 from tick() itself)
  std::uint32_t placements = 0;  ///< of the settings in force at this tick
  bool placed = false;     ///< the contact was forgotten before this tick, for the hand or the scene was placed anew
};

class ServoStep {
 public:
  /// One tick. `tracker` may be null: no molecule, no force. Pass a changed tracker freely: it is not reset, and the force
  /// starts softly.
  ServoSample tick(const ServoSettings& settings, Tracker* tracker, const DevicePose& pose) noexcept;

 private:
  std::uint64_t tick_ = 0;
  const Tracker* last_tracker_ = nullptr;
  std::uint32_t placements_ = 0, hand_placements_ = 0;
  double ramp_ = 0.0;  // 0 to 1, the soft start
};

}  // namespace moltact
