// The data of one tick of the servo loop that a lesson evaluates. Plain data; any thread but the haptic one.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "engine/core/units.h"
#include "engine/haptics/tracker.h"

namespace moltact {

struct TouchSample {
  double time_s = 0.0;  ///< since the servo loop started; never goes back
  PointA hip;           ///< position of the hand in the molecule (unit: angstrom)
  Contact contact;      ///< as the interaction returned it for this HIP
  ForceN force;         ///< on the hand, in the device's space (unit: newton)
  bool field = false;   ///< a field exerts a noticeable force, with or without a contact
  Vec3 wanted_N{0.0};   ///< force of contact and field before limits, in the molecule's space; zero without a field
  /// Size of the field's share of the force, as far as the safety stage admits it (unit: newton). Empty without a field.
  /// The fields of scenes are guides.
  std::optional<double> field_N = {};
  double probe_A = 1.4;            ///< the probe's radius at that tick (unit: angstrom)
  std::string_view method = {};    ///< name of the haptic method in use; static, from the table of methods
  Contact exact;                   ///< that of the exact tracker for the same HIP; empty where nothing is compared
  Quat orientation = kNoRotation;  ///< of the hand, in the molecule's space
  std::optional<PoseA> body = {};  ///< the drawn pose of the held body: position of its middle, and orientation
                                   ///< relative to the molecule's file; empty: the hand holds the probe
  bool one_spring = false;         ///< the body is one rigid body on one spring, so its atoms are where they are drawn
  bool hovering = false;           ///< a hand of mouse or keys that does not press: it feels nothing on purpose
  bool contact_reset = false;      ///< the contact was discarded before this tick, so no path leads here
  Vec3 torque_N_mm{0.0};           ///< on the hand, in the device's space; zero for a device that drives none
  std::optional<MolecularEnergy> energy = {};  ///< of the drawn pose; empty where no forces between atoms act

  /// True if a force is felt, of a contact or a field. `contact.touching()` tests for a contact only.
  bool felt() const { return contact.touching() || field; }
  /// True if the hand touches, or is on purpose where the forces between atoms act: there they hold a probe off the
  /// surface.
  bool meets() const {
    constexpr double kNoticed_kcal_mol = 0.2;
    if (!energy) return contact.touching();
    return !hovering && (contact.touching() || std::abs(energy->total_kcal_mol()) >= kNoticed_kcal_mol);
  }
};

/// Converts a ServoSample. A template, so that tasks do not depend on the servo loop.
template <class ServoTick>
TouchSample touchSampleOf(const ServoTick& tick, std::string_view method = {}, const Contact& exact = {}) {
  return {.time_s = tick.time_s,
          .hip = tick.hip,
          .contact = tick.contact,
          .force = tick.force,
          .field = tick.inField() && tick.felt(),
          .wanted_N = tick.inField() ? tick.wanted().force_N : Vec3(0.0),
          .field_N = tick.field ? std::optional(tick.field_share * glm::length(tick.field->force_N)) : std::nullopt,
          .probe_A = tick.probe_A,
          .method = method,
          .exact = exact,
          .orientation = tick.orientation,
          .body = tick.holds_body ? std::optional(tick.shownBody()) : std::nullopt,
          .one_spring = tick.holds_body && tick.body_pose,
          .contact_reset = tick.contact_reset,
          .torque_N_mm = tick.torque_N_mm,
          .energy = tick.molecular_energy};
}

}  // namespace moltact
