// The result of a tick: the contact between the hand and the scene. Plain data, every thread. Units: angstrom. Terms of
// Stocks & Laycock 2008: the HIP (haptic interface point) is the hand's position; the SCP (surface contact point) is
// the HIP's proxy, which stays outside every sphere.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/core/units.h"

namespace moltact {

/// The feature of the surface on which the SCP lies (the paper's Figure 4: case 1 sphere, case 2 circle, case 3 point).
enum class Feature : std::uint8_t {
  Free,
  Sphere,
  Circle,  ///< a re-entrant edge of the accessible surface, where two spheres meet; students read "crease"
  Point,   ///< a re-entrant vertex, where three meet; students read "pit"
};

/// The reason for a tick without force although the HIP may be inside the molecule.
enum class Fault : std::uint8_t {
  None,
  NotFinite,  ///< the HIP is NaN, infinite or farther than kMaxPosition_A from the origin; the tracker keeps its state
  StartedInside,  ///< the HIP has been inside since the start; the force begins after it has been outside once
};

/// Largest absolute HIP coordinate; a larger one gives Fault::NotFinite (unit: angstrom).
inline constexpr double kMaxPosition_A = 1e9;

/// The complete description of a contact. Code that draws, records, describes, sonifies or judges a contact's force
/// reads it from here.
struct Contact {
  /// While free: the HIP. In a tick that was cut short the SCP lags behind the HIP, also while free. With a fault: the
  /// HIP if it is finite, else the last SCP.
  PointA scp;
  std::array<std::int32_t, 3> atoms{-1, -1, -1};  ///< the atoms that block the SCP, ascending; -1 where unused
  Feature feature = Feature::Free;
  Fault fault = Fault::None;
  /// Extension of the felt spring, from the HIP: the force divided by the stiffness. It is SCP - HIP unless a method
  /// shades the force or several springs pull. Zero without contact.
  Vec3 displacement_A{0.0};
  /// Energy stored in the springs, divided by the stiffness; |displacement|^2 / 2 for a single spring. Zero without
  /// contact.
  double energy_A2 = 0.0;
  /// Outward unit normals of the blocking surfaces, one for each of `atoms`; zero where unused.
  std::array<Vec3, 3> normals{Vec3(0.0), Vec3(0.0), Vec3(0.0)};

  bool touching() const { return feature != Feature::Free; }
  /// The outward unit normal at the SCP: of the surface if one alone blocks it, else the direction of the displacement,
  /// which then lies between the normals. Zero without a displacement.
  Vec3 outward() const {
    const bool one = normals[0] != Vec3(0.0) && normals[1] == Vec3(0.0);
    const double length = glm::length(displacement_A);
    return one ? normals[0] : length > 1e-9 ? displacement_A / length : Vec3(0.0);
  }
  /// How far the HIP lies below the surface. Friction displaces the spring along the surface, which does not count.
  double depth_A() const { return std::max(0.0, glm::dot(displacement_A, outward())); }
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// Sets displacement and energy to those of a single spring from the HIP to the SCP.
inline void stretchToScp(Contact& contact, PointA hip) {
  contact.displacement_A = contact.scp.A - hip.A;
  contact.energy_A2 = 0.5 * glm::dot(contact.displacement_A, contact.displacement_A);
}

/// The largest probe radius that a tracker accepts (unit: angstrom).
inline constexpr double kMaxProbe_A = 20.0;

/// Radius of a water molecule as a probe, the default everywhere (unit: angstrom).
inline constexpr double kWaterProbe_A = 1.4;

}  // namespace moltact
