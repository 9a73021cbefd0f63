// The interface of everything that can be felt: the hand's position and orientation go in; a force, a torque and the
// stored energy come out. A scene chooses one (interactions.h); the servo step and the safety stage do not know which.
// `respond` runs on the haptic thread: no lock, allocation, exception, log or call of the system. Units: angstrom, in
// the molecule's space.
#pragma once

#include "engine/core/units.h"
#include "engine/haptics/contact.h"

namespace moltact {

class SphereMotion;

/// The memory that a method keeps for the places it has been: "model no more than a scene needs", in numbers.
struct MemoryUsage {
  std::size_t atoms_modelled = 0;  ///< atoms for which anything beyond centre and radius is held now
  std::size_t bytes = 0;           ///< all memory of the method beyond the list of balls itself (unit: byte)
};

/// The answer to a pose, over the stiffness of the springs that give it.
struct Response {
  Contact contact;  ///< its `displacement_A` is the force, its `energy_A2` all that is stored; the rest is what there
                    ///< is to show of a contact, and may be empty
  Vec3 torque_A2{0.0};  ///< round the pose's place, in the molecule's axes; zero for what is felt as a point

  /// Something is felt, so that springs pull.
  bool felt() const { return contact.touching() || contact.displacement_A != Vec3(0.0) || torque_A2 != Vec3(0.0); }
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

  /// Inflates every ball by `probe_A` (0 to kLargestProbe_A, clamped; non-finite is ignored), also while touching. What
  /// has no probe passes it over.
  virtual void setProbe(double probe_A) noexcept = 0;

  /// 0 for what has none.
  virtual double probe_A() const noexcept = 0;

  /// How many times as stiff as one spring it is, along its stiffest direction, as it answered last (1 or more): the
  /// springs that pull together. The stiffness of each is bounded by it, for the loop's stability depends on all of
  /// them: several balls that push at once, several places where a body is held.
  virtual double parallelSprings() const noexcept { return 1.0; }

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

}  // namespace moltact
