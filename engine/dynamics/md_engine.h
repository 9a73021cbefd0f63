// An engine that integrates the equations of motion of a molecule's atoms, one step after the other. An implementation
// may live in a module of its own (openmm_module.cpp), so the interface contains only functions that a derived class
// defines, and no text for people. One thread at a time, not the haptic one. Units: angstrom, kcal/mol, picosecond,
// kelvin, dalton.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.h"

namespace moltact {

/// A spring between the hand and one atom. With a direction it pushes the atom along it until the atom has reached the
/// plane through `to_A`, and never pulls: a contact. Without one it draws the atom to `to_A` from all sides: a grip. Its
/// end rests while the hand rests, so a late update gives no energy to the atom.
struct AtomPush {
  std::uint32_t atom = 0;
  Vec3 to_A{0.0}, direction{0.0};  ///< the direction is a unit vector, or zero for a grip
  double stiffness_kcal_mol_A2 = 0.0;

  /// The size of the force on the atom at this place (unit: kcal/mol/A).
  double force_kcal_mol_A(const Vec3& at_A) const {
    if (direction == Vec3(0.0)) return stiffness_kcal_mol_A2 * glm::distance(to_A, at_A);
    const double short_of_it = glm::dot(direction, to_A - at_A);
    return short_of_it > 0.0 ? stiffness_kcal_mol_A2 * short_of_it : 0.0;
  }
};

/// How fast a platform computes.
struct PlatformRate {
  std::string platform;
  double steps_per_s = 0.0;
};

/// What an engine starts from.
struct MdStart {
  std::string system;             ///< serialised, in the engine's own format
  std::vector<Vec3> positions_A;  ///< of every particle of the system
  double temperature_K = 300.0;   ///< of the bath and of the initial velocities
  double friction_per_ps = 2.0;   ///< of the Langevin bath; 0: no bath, the energy is conserved
  double hold_kcal_mol_A2 = 0.0;  ///< stiffness of a spring that holds the centre of mass in place; 0: free
  std::uint32_t seed = 1;         ///< of the bath's random forces and the initial velocities
  double step_ps = 0.0;           ///< 0: the engine's choice for this system (stepFor_ps)
  std::string platform;           ///< the engine's word for where it computes; empty: the fastest, measured
};

/// The longest stable step: 4 fs where every hydrogen has at least 3 u and a rigid bond, 2 fs where its bond is rigid,
/// else 0.5 fs. `lightest_u`: of all particles; `rigid`: every particle lighter than 5 u has a constraint.
constexpr double stepFor_ps(double lightest_u, bool rigid) {
  if (!rigid) return 0.0005;
  return lightest_u >= 3.0 ? 0.004 : 0.002;
}

struct MdEnergies {
  double potential_kcal_mol = 0.0;  ///< without that of pushes and of the spring on the centre of mass
  double kinetic_kcal_mol = 0.0;
  double temperature_K = 0.0;  ///< from the kinetic energy and the degrees of freedom
};

/// Functions that return text return why they failed, in the engine's words; empty: success. After a failure only
/// restart() and the destructor may be called.
class MdEngine {
 public:
  virtual ~MdEngine() = default;

  virtual std::size_t atomCount() const = 0;
  virtual std::span<const double> masses_u() const = 0;
  virtual double step_ps() const = 0;
  /// "Reference", "CPU", "OpenCL".
  virtual std::string_view platform() const = 0;
  /// The engine's name and version: "OpenMM 7.7".
  virtual std::string name() const = 0;
  /// Its steps per second when it was measured; 0: the platform was given.
  virtual double measured_steps_per_s() const = 0;
  /// All platforms that were measured for the choice, in the order of trial; empty: the platform was given.
  virtual std::span<const PlatformRate> measured() const = 0;

  /// Replaces all pushes.
  virtual std::string push(std::span<const AtomPush> pushes) = 0;
  virtual std::string setTemperature(double kelvin) = 0;
  /// Makes this number of steps.
  virtual std::string advance(int steps) = 0;
  /// Moves the atoms to the nearest minimum of the energy, at most this number of iterations, and draws new velocities.
  virtual std::string relax(int iterations) = 0;
  /// The initial positions, with new velocities.
  virtual std::string restart() = 0;

  /// The present positions, one for each particle. The reference is valid until the next call.
  virtual std::span<const Vec3> positions_A() = 0;
  virtual MdEnergies energies() = 0;
};

/// The function that a module exports under the name kMakeMdEngine. It returns null on failure, with the reason in `why`.
using MakeMdEngine = MdEngine* (*)(const MdStart& start, std::string& why);
inline constexpr const char* kMakeMdEngine = "moltactMakeMdEngine";

}  // namespace moltact
