// The interface of everything that can be felt. Input is the pose of the hand; output is force, torque, potential
// energy and stiffness. A scene selects one implementation (interactions.h); servo step and safety stage use only this
// interface. `respond` runs on the haptic thread: no lock, allocation, exception, log or system call. Units: angstrom
// in the molecule's space; forces in newtons at the hand (felt_force.h). Quat is constructed as (w, x, y, z).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "engine/core/units.h"
#include "engine/haptics/contact.h"
#include "engine/haptics/felt_force.h"
#include "engine/haptics/surface_properties.h"

namespace moltact {

class SphereMotion;

/// The memory that a method uses for the regions visited so far.
struct MemoryUsage {
  std::size_t atoms_modelled = 0;  ///< atoms with stored data beyond centre and radius
  std::size_t bytes = 0;           ///< memory of the method beyond the list of spheres (unit: byte)
};

/// The result for one pose, with two sources of force. The contact's springs are divided by their stiffness, which the
/// slider "Stiffness" and the safety stage choose. A field (attraction, charge, an energy well) is in newtons and
/// independent of that slider.
struct Response {
  /// `displacement_A` is the springs' force and `energy_A2` their stored energy; the other members describe the contact
  /// and may be empty.
  Contact contact;
  Vec3 torque_A2{0.0};  ///< of the springs, about the pose's position, in the molecule's axes; zero for a point
  /// Combined stiffness of the springs along the stiffest direction, as a multiple of one spring (1 or more). It
  /// exceeds 1 where several spheres push at once or a body is held at several points. The loop's stability depends on
  /// it.
  double stiffness_factor = 1.0;
  /// Rotational stiffness about the stiffest axis, divided by the stiffness of one spring.
  double rotational_A2 = 0.0;
  std::optional<FeltForce> field = std::nullopt;  ///< force besides the contact; empty: none
  /// The rest pose of the held body: position of its middle, and orientation. Empty: the body is at the contact's SCP,
  /// shifted by the mean of the springs, with the hand's orientation.
  std::optional<PoseA> body_pose = std::nullopt;
  bool at_rest = true;  ///< false: the search for the rest pose was cut short and continues in the next tick
  /// The energy at the shown pose; empty where no forces between atoms act.
  std::optional<MolecularEnergy> molecular_energy = std::nullopt;

  /// True if Contact::scp is where the probe or body is: in contact, and on the virtual coupling of a field of atoms.
  bool leavesHand() const { return contact.touching() || molecular_energy; }
  /// The pose in which the held body is drawn for this hand.
  PoseA shownBody(const PoseA& hand) const {
    return body_pose ? *body_pose : PoseA{leavesHand() ? contact.scp : hand.place, hand.orientation};
  }

  bool springsPull() const {
    return contact.touching() || contact.displacement_A != Vec3(0.0) || torque_A2 != Vec3(0.0);
  }
  /// True if springs or a field exert any force.
  bool acts() const { return springsPull() || field; }

  /// The sum of both sources, with the given spring stiffness and the field scaled by `field_share`. The stiffness is
  /// the sum of both bounds.
  FeltForce total(double spring_N_per_A, double field_share = 1.0) const {
    FeltForce out{contact.displacement_A * spring_N_per_A, torque_A2 * spring_N_per_A,
                  contact.energy_A2 * spring_N_per_A};
    if (field) {
      out.force_N += field_share * field->force_N;
      out.torque_N_A += field_share * field->torque_N_A;
      out.energy_N_A += field_share * field->energy_N_A;
      out.stiffness_N_per_A = field_share * field->stiffness_N_per_A;
      out.rotational_stiffness_N_A = field_share * field->rotational_stiffness_N_A;
    }
    if (springsPull()) {
      out.stiffness_N_per_A += stiffness_factor * spring_N_per_A;
      out.rotational_stiffness_N_A += rotational_A2 * spring_N_per_A;
    }
    return out;
  }
};

class Interaction {
 public:
  virtual ~Interaction() = default;

  /// Returns the response to a pose. A call is not a tick. ServoStep::tick calls once per tick. While the surface moves
  /// it calls twice, first with the previous pose, to separate the work of the surface from that of the hand. Before a
  /// new interaction is handed over, a series of poses may lead it to the contact. A call has no duration. The state of
  /// an interaction (where it sticks, how far it has slid) may depend on the path between the poses but not on the
  /// number of calls. A pose that is not finite gives Fault::NotFinite.
  virtual Response respond(const PoseA& pose) noexcept = 0;

  /// Discards the contact, as at the start: a hand inside the molecule gets no force until it has been outside once.
  virtual void reset() noexcept = 0;

  /// Inflates every sphere by `probe_A`, also while touching (0 to kMaxProbe_A, clamped; non-finite values are
  /// ignored). Interactions without a probe ignore the call.
  virtual void setProbe(double probe_A) noexcept = 0;

  /// The probe radius; 0 for an interaction without a probe.
  virtual double probe_A() const noexcept = 0;

  /// Sets the surface's properties, also while touching. Out-of-range values are clamped, non-finite ones ignored.
  /// Properties whose layer the interaction lacks are ignored, and surface() returns their defaults.
  virtual void setSurface(const SurfaceProperties&) noexcept {}
  virtual SurfaceProperties surface() const noexcept { return {}; }

  /// Writes the reactions on the scene's atoms to the last response and returns their number. Their sum is the opposite
  /// of the force of `last.total(spring_N_per_A, field_share)`. An atom may occur more than once. `out` has room for
  /// maxReactionCount() entries. Haptic thread, like `respond`. The default shares the contact's force among the
  /// atoms that block the SCP.
  virtual std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                                std::span<AtomForce> out) const noexcept;
  /// Upper bound of the number of reactions in every state, for allocating `out` in advance.
  virtual std::size_t maxReactionCount() const noexcept { return 3; }

  /// Switches to the spheres of a motion, at its beginning; null: to the spheres given at construction. The motion has
  /// the same number of spheres and stays in use until another is set. Setting the motion in use changes nothing.
  /// Returns false, without any change, if the interaction cannot follow moving spheres.
  virtual bool setMotion(const SphereMotion*) noexcept { return false; }
  /// Moves the spheres to this fraction (0 to 1) of the motion; an SCP in contact is carried along.
  virtual void advanceTo(double /*fraction*/) noexcept {}

  virtual MemoryUsage memoryUsage() const noexcept = 0;

  /// True if the force depends on the hand's orientation: a body and not a point. Mouse, keys and devices that rotate
  /// the view then rotate the body.
  virtual bool hasOrientation() const noexcept { return false; }
};

/// A force as pushes along a contact's normals, and what they leave over.
struct Pushes {
  std::array<double, 3> along{};  ///< along each of Contact::normals, at least 0
  Vec3 rest{0.0};
  double sum() const { return along[0] + along[1] + along[2]; }
};

/// The pushes along the contact's normals that come nearest to a force (of any unit).
Pushes pushesAlong(const Contact& contact, const Vec3& force) noexcept;

/// Shares the force of a contact's springs among the atoms that block the SCP, as pushes along their normals. A
/// remainder that no such push explains (friction, shading) is shared in the same proportion. Writes at most three
/// entries and returns their number.
std::size_t contactReactions(const Contact& contact, double spring_N_per_A, std::span<AtomForce> out) noexcept;

}  // namespace moltact
