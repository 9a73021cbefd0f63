// The one interface of every haptic method: the HIP goes in, the surface contact point comes out.
// `step` runs on the haptic thread: it neither allocates nor locks, throws, logs or calls the system.
// Units: angstrom. Words as in Stocks & Laycock 2008: HIP, the haptic interface point, is where the hand is;
// SCP, the surface contact point, is the HIP's proxy, which stays outside every ball.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/core/units.h"

namespace moltact {

/// What the SCP lies on (the paper's Figure 4: case 1 sphere, case 2 circle, case 3 point).
enum class Feature : std::uint8_t { Free, Sphere, Circle, Point };

/// Why a tick gives no force although the HIP may be inside the molecule.
enum class Fault : std::uint8_t {
  None,
  NotFinite,  ///< the HIP was NaN, infinite or farther than kFarthest_A from the origin; the tracker keeps its state
  StartedInside,  ///< the HIP has been inside ever since the start; there is no force until it has been outside once
};

/// HIP coordinates beyond this are refused as Fault::NotFinite (unit: angstrom).
inline constexpr double kFarthest_A = 1e9;

struct Contact {
  PointA scp;  ///< equals the HIP when free, but where a tick was cut short and lags; and when faulty, where the HIP is
               ///< finite
  std::array<std::int32_t, 3> atoms{-1, -1, -1};  ///< the atoms that hold the SCP, in ascending order; -1 where none
  Feature feature = Feature::Free;
  Fault fault = Fault::None;
  Vec3 normal{0.0};  ///< unit: the force's direction where a method shades it; zero: along SCP - HIP

  bool touching() const { return feature != Feature::Free; }
};

/// Where the spring pulls the HIP to: the SCP, or as far from the HIP along `normal` where a method shades the force.
inline PointA springEnd(const Contact& contact, PointA hip) {
  if (contact.normal == Vec3(0.0)) return contact.scp;
  return {hip.A + contact.normal * glm::distance(contact.scp.A, hip.A)};
}

/// What a method keeps for the places it has been: "model no more than a scene needs", in numbers.
struct MemoryUsage {
  std::size_t atoms_modelled = 0;  ///< atoms for which anything beyond centre and radius is held now
  std::size_t bytes = 0;           ///< all memory of the method beyond the list of balls itself (unit: byte)
};

class SphereFrame;

class Tracker {
 public:
  virtual ~Tracker() = default;

  /// One tick: moves the SCP for the new HIP (unit: angstrom). Non-finite input gives Fault::NotFinite.
  virtual Contact step(PointA hip) noexcept = 0;

  /// Forgets the contact, as at the start: the next HIP, if inside, is StartedInside until it has been outside.
  virtual void reset() noexcept = 0;

  /// Inflates every ball by `probe_A` (0 to kLargestProbe_A, clamped; non-finite is ignored). Allowed while
  /// touching: the SCP is carried along with the moving surface.
  virtual void setProbe(double probe_A) noexcept = 0;

  /// Spheres that move: from now on they are the frame's, at its beginning; null: those that the tracker was made with.
  /// The frame has as many and stays until another is set. False, with nothing changed, where the method cannot follow.
  virtual bool setFrame(const SphereFrame*) noexcept { return false; }
  /// The spheres go evenly to where they are at this share (0 to 1) of the frame, and the SCP with the surface.
  virtual void moveTo(double /*share*/) noexcept {}

  virtual double probe_A() const noexcept = 0;
  virtual MemoryUsage memoryUsage() const noexcept = 0;
};

/// The largest probe radius a tracker accepts (unit: angstrom).
inline constexpr double kLargestProbe_A = 20.0;

/// The radius of a water molecule as a probe (unit: angstrom), the default everywhere.
inline constexpr double kWaterProbe_A = 1.4;

}  // namespace moltact
