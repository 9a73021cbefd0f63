// What the hand holds, for whoever asks where it meets a scene: the probe's sphere, or a rigid body, which is atoms that a
// scene hands to the student. Built on the window's thread, then never changed. Units: angstrom.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/sweep.h"

namespace moltact {

/// A body's atoms may come so much nearer to those of the scene than their radii say, for hydrogen bonds bring them as
/// near: a drug then lies in its own place without touching (amprenavir in 1HPV, whose atoms overlap by up to 0.46 A).
inline constexpr double kBodyOverlap_A = 0.5;
/// A body of more atoms is refused: each is a contact of its own in every tick.
inline constexpr std::size_t kMaxHeldAtoms = 200;

/// Atoms that move as one with the hand's pose.
struct HeldBody {
  std::vector<std::uint32_t> atoms;  ///< which of the molecule's they are, ascending; none for spheres of no molecule
  std::vector<Sphere> spheres;  ///< one for each, from the middle in the molecule's axes; their radii as they are felt
  PointA middle;                ///< of their centres, in the molecule
  double reach_A = 0.0;         ///< no surface of it lies farther from the middle
};

/// The body of these of a scene's spheres (ascending). Null where there are none of them, or more than kMaxHeldAtoms.
std::shared_ptr<const HeldBody> heldBody(std::span<const Sphere> scene, std::span<const std::uint32_t> atoms);

/// A body of these spheres, given from its middle, that are no atoms of a molecule; their radii are felt as they are.
/// Null where there are none of them, or more than kMaxHeldAtoms.
std::shared_ptr<const HeldBody> bodyOfSpheres(std::vector<Sphere> spheres);

/// The probe, or a body as it is oriented now.
struct HandShape {
  double probe_A = 0.0;
  const HeldBody* body = nullptr;  ///< null: the probe
  Quat orientation = kNoRotation;  ///< of a body

  HandShape(double of_probe_A) : probe_A(of_probe_A) {}  // a radius is a probe
  HandShape(const HeldBody& held, const Quat& oriented) : body(&held), orientation(oriented) {}

  double reach_A() const { return body ? body->reach_A : probe_A; }
};

/// Where what is in the hand first meets a sphere of the scene, when its middle goes from `from` to `to`.
Hit sweep(const SphereGrid& scene, const HandShape& hand, const Vec3& from, const Vec3& to) noexcept;

}  // namespace moltact
