// The interface of everything that can be felt: the hand's position and orientation go in; a force, a torque, the
// potential energy and the stiffness come out. A scene chooses one (interactions.h); the servo step and the safety
// stage do not know which.
// `respond` runs on the haptic thread: no lock, allocation, exception, log or call of the system. Units: angstrom, in
// the molecule's space; forces in newtons of the hand (felt_force.h).
#pragma once

#include <optional>
#include <span>

#include "engine/core/units.h"
#include "engine/haptics/contact.h"
#include "engine/haptics/felt_force.h"

namespace moltact {

class SphereMotion;

/// The memory that a method keeps for the places it has been: "model no more than a scene needs", in numbers.
struct MemoryUsage {
  std::size_t atoms_modelled = 0;  ///< atoms for which anything beyond centre and radius is held now
  std::size_t bytes = 0;           ///< all memory of the method beyond the list of spheres itself (unit: byte)
};

/// The answer to a pose. It has two sources. The contact's springs are given over their stiffness, which the slider
/// "Stiffness" and the safety stage choose. A field (attraction, charge, a well of energy) gives newtons, which no
/// slider for the springs changes.
struct Response {
  Contact contact;  ///< its `displacement_A` is the springs' force, its `energy_A2` all that they store; the rest is
                    ///< what there is to show of a contact, and may be empty
  Vec3 torque_A2{0.0};  ///< of the springs, round the pose's place, in the molecule's axes; zero for a point
  /// How many times as stiff as one spring the springs are together, along the stiffest direction (1 or more): several
  /// spheres that push at once, several places where a body is held. The loop's stability depends on all of them.
  double springs = 1.0;
  double rotational_A2 = 0.0;  ///< the same round the stiffest axis: no small rotation is opposed by more
  std::optional<FeltForce> field = std::nullopt;  ///< what acts besides the contact; none where nothing does
  /// Where the held body rests: the place of its middle and its orientation. Empty: where the springs' mean has shifted
  /// it, at the contact's SCP, with the hand's orientation.
  std::optional<PoseA> body_pose = std::nullopt;
  bool at_rest = true;  ///< false: the search for the body's rest ended before it was found, and the next tick goes on

  /// Where the held body is shown for this hand.
  PoseA shownBody(const PoseA& hand) const {
    return body_pose ? *body_pose : PoseA{contact.touching() ? contact.scp : hand.place, hand.orientation};
  }

  bool springsPull() const {
    return contact.touching() || contact.displacement_A != Vec3(0.0) || torque_A2 != Vec3(0.0);
  }
  /// Springs or a field pull, however weakly.
  bool acts() const { return springsPull() || field; }

  /// Both sources together, with springs of that stiffness and the field scaled by a share. The stiffness is the sum
  /// of both bounds.
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
      out.stiffness_N_per_A += springs * spring_N_per_A;
      out.rotational_stiffness_N_A += rotational_A2 * spring_N_per_A;
    }
    return out;
  }
};

class Interaction {
 public:
  virtual ~Interaction() = default;

  /// The answer to a pose. Calls are not ticks: ServoStep::tick asks once a tick, but while the surface itself moves
  /// twice, first with the pose of the tick before, so as to tell the surface's work from the hand's; before a new
  /// interaction is handed over, it may be led to the contact by some poses in a row.
  /// No time goes with a call. What an interaction remembers (where it sticks, how far it has slid) may depend on the
  /// paths between the poses and never on how often it is asked. A pose that is no number gives Fault::NotFinite.
  virtual Response respond(const PoseA& pose) noexcept = 0;

  /// Forgets the contact, as at the start: what begins inside gives no force until it has been outside once.
  virtual void reset() noexcept = 0;

  /// Inflates every sphere by `probe_A` (0 to kLargestProbe_A, clamped; non-finite is ignored), also while touching. What
  /// has no probe passes it over.
  virtual void setProbe(double probe_A) noexcept = 0;

  /// 0 for what has none.
  virtual double probe_A() const noexcept = 0;

  /// The reactions on the scene's atoms to the last response: their sum is the opposite of the force of
  /// `last.total(spring_N_per_A, field_share)`. An atom may come more than once.
  /// `out` has room for greatestReactionCount(); the number of those written is returned. Haptic thread, as `respond`.
  /// Without an override the force of the contact is shared among the atoms that hold the SCP.
  virtual std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                                std::span<AtomForce> out) const noexcept;
  /// The same for every state of the interaction, so that the room is made beforehand.
  virtual std::size_t greatestReactionCount() const noexcept { return 3; }

  /// Spheres that move: from now on they are the motion's, at its beginning; null: those that it was made with. The
  /// motion has as many and stays until another is set; the one in force changes nothing. False, with nothing changed,
  /// where what is felt cannot follow.
  virtual bool setMotion(const SphereMotion*) noexcept { return false; }
  /// The spheres go evenly to where they are at this fraction (0 to 1) of the motion; what touches them goes with them.
  virtual void advanceTo(double /*fraction*/) noexcept {}

  virtual MemoryUsage memoryUsage() const noexcept = 0;

  /// It is felt how the hand is oriented: a body, not a point. Mouse, keys and devices that rotate the view then rotate
  /// it.
  virtual bool hasOrientation() const noexcept { return false; }
};

/// The force of a contact's springs, shared among the atoms that hold the SCP by pushes along their normals; what no
/// such push explains (friction, shading) is shared in the same proportion. At most three are written.
std::size_t contactReactions(const Contact& contact, double spring_N_per_A, std::span<AtomForce> out) noexcept;

}  // namespace moltact
