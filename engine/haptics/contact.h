// What a tick found where something is touched. Plain data, every thread. Units: angstrom. Words as in Stocks & Laycock
// 2008: HIP, the haptic interface point, is where the hand is; SCP, the surface contact point, is the HIP's proxy,
// which stays outside every sphere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/core/units.h"

namespace moltact {

/// What the SCP lies on (the paper's Figure 4: case 1 sphere, case 2 circle, case 3 point).
enum class Feature : std::uint8_t {
  Free,
  Sphere,
  Circle,  ///< a re-entrant edge of the accessible surface, where two spheres meet; students read "crease"
  Point,   ///< a re-entrant vertex, where three meet; students read "pit"
};

/// Why a tick gives no force although the HIP may be inside the molecule.
enum class Fault : std::uint8_t {
  None,
  NotFinite,  ///< the HIP was NaN, infinite or farther than kFarthest_A from the origin; the tracker keeps its state
  StartedInside,  ///< the HIP has been inside ever since the start; there is no force until it has been outside once
};

/// HIP coordinates beyond this are refused as Fault::NotFinite (unit: angstrom).
inline constexpr double kFarthest_A = 1e9;

/// All that is felt of a contact: whoever shows, writes, speaks, sounds or judges a force takes it from here.
struct Contact {
  PointA scp;  ///< equals the HIP when free, but where a tick was cut short and lags; and when faulty, where the HIP is
               ///< finite
  std::array<std::int32_t, 3> atoms{-1, -1, -1};  ///< the atoms that hold the SCP, in ascending order; -1 where none
  Feature feature = Feature::Free;
  Fault fault = Fault::None;
  Vec3 displacement_A{0.0};  ///< of the spring that is felt, from the HIP: the force over the stiffness. SCP - HIP, but
                             ///< where a method shades the force or several springs pull; zero without contact
  double energy_A2 =
      0.0;  ///< stored, over the stiffness: |displacement|^2 / 2 of a single spring; zero without contact
  std::array<Vec3, 3> normals{Vec3(0.0), Vec3(0.0), Vec3(0.0)};  ///< of the surfaces that hold the SCP, one for each of
                                                                 ///< `atoms`: unit, outward; zero where none

  bool touching() const { return feature != Feature::Free; }
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// Fills in the displacement and the energy of a single spring from the HIP to the SCP.
inline void stretchToScp(Contact& contact, PointA hip) {
  contact.displacement_A = contact.scp.A - hip.A;
  contact.energy_A2 = 0.5 * glm::dot(contact.displacement_A, contact.displacement_A);
}

/// The largest probe radius a tracker accepts (unit: angstrom).
inline constexpr double kLargestProbe_A = 20.0;

/// The radius of a water molecule as a probe (unit: angstrom), the default everywhere.
inline constexpr double kWaterProbe_A = 1.4;

}  // namespace moltact
