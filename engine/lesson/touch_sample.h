// One tick of the servo loop as a lesson sees it. Plain data, written by the servo side, read on the screen's thread.
#pragma once

#include <optional>
#include <string_view>

#include "engine/core/units.h"
#include "engine/haptics/tracker.h"

namespace moltact {

struct TouchSample {
  double time_s = 0.0;  ///< since the servo loop started; never goes back
  PointA hip;           ///< where the hand is (unit: angstrom)
  Contact contact;      ///< what the tracker gave for it
  ForceN force;         ///< on the hand, in the device's space (unit: newton)
  bool field = false;   ///< a field's force is felt, in contact or without
  Vec3 wanted_N{0.0};   ///< force of contact and field before limits, in the molecule's space; zero where no field acts
  double probe_A = 1.4;  ///< the probe's radius at that tick (unit: angstrom)
  std::string_view method =
      {};         ///< name of the haptic method in use; from the table of methods, so it outlives the sample
  Contact exact;  ///< what the exact tracker gives for the same hand, where the method in use is compared with it
  Quat orientation = kNoRotation;  ///< of the hand, in the molecule's space
  std::optional<PoseA> body = {};  ///< where the held body is shown: the place of its middle and its orientation
                                   ///< relative to the molecule's file; empty: the hand holds the probe
  bool one_spring = false;  ///< the body rests as one rigid body on one spring, so its atoms are where it is shown
  bool placed = false;      ///< the hand was put down here, without a path from the tick before
  Vec3 torque_N_mm{0.0};    ///< on the hand, in the device's space; zero for a device that drives none

  /// A force is felt; `contact.touching()` says that a surface is touched.
  bool felt() const { return contact.touching() || field; }
};

/// The same from a tick of the servo loop (ServoSample of engine/servo, which stands above this room).
template <class ServoTick>
TouchSample touchSampleOf(const ServoTick& tick, std::string_view method = {}, const Contact& exact = {}) {
  return {.time_s = tick.time_s,
          .hip = tick.hip,
          .contact = tick.contact,
          .force = tick.force,
          .field = tick.field && tick.felt(),
          .wanted_N = tick.field ? tick.wanted().force_N : Vec3(0.0),
          .probe_A = tick.probe_A,
          .method = method,
          .exact = exact,
          .orientation = tick.orientation,
          .body = tick.holds_body ? std::optional(tick.shownBody()) : std::nullopt,
          .one_spring = tick.holds_body && tick.body_pose,
          .placed = tick.contact_reset,
          .torque_N_mm = tick.torque_N_mm};
}

}  // namespace moltact
