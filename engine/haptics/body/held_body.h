// The shape in the hand, for collision queries: the probe's sphere, or a rigid body made of atoms of the molecule.
// Built on the window's thread and immutable afterwards. Units: angstrom. Quat is constructed as (w, x, y, z).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/sweep.h"

namespace moltact {

/// heldBody() reduces the radius of each atom by this length unless another is given (unit: angstrom; to no less than
/// 0.2 A). The body may overlap the scene's atoms so far before it touches them. Hydrogen bonds bring atoms that close,
/// and a drug then fits into its binding site without contact. The value depends on the table of radii
/// (Molecule::body_overlap_A); this one is for those of Bondi.
inline constexpr double kBodyOverlap_A = 0.5;
/// The maximum number of atoms of a body.
inline constexpr std::size_t kMaxHeldAtoms = 5'000;

/// Atoms that move as one rigid body with the hand's pose.
struct HeldBody {
  std::vector<std::uint32_t> atoms;  ///< their indices in the molecule, ascending; empty for bodyOfSpheres()
  /// One per atom, relative to the middle, in the molecule's axes; radii reduced by overlap_A.
  std::vector<Sphere> spheres;
  PointA middle;           ///< mean of their centres, in the molecule; zero for bodyOfSpheres()
  double overlap_A = 0.0;  ///< by which radii were reduced; 0 for bodyOfSpheres()
  double reach_A = 0.0;    ///< radius of the sphere about the middle that contains the body
};

/// Builds the body from the given indices of a scene's spheres (ascending). Returns null if no index is valid or there
/// are more than kMaxHeldAtoms.
std::shared_ptr<const HeldBody> heldBody(std::span<const Sphere> scene, std::span<const std::uint32_t> atoms,
                                         double overlap_A = kBodyOverlap_A);

/// Builds a body from spheres that are not atoms of a molecule, given relative to its middle; their radii are felt
/// unchanged. Returns null if there are none or more than kMaxHeldAtoms.
std::shared_ptr<const HeldBody> bodyOfSpheres(std::vector<Sphere> spheres);

/// The least lever of the spring that turns a body to the hand's orientation (unit: angstrom).
inline constexpr double kMinLever_A = 0.5;

/// Root of the mean squared distance of the spheres' centres from the middle.
double radiusOfGyration_A(const HeldBody& body);

/// The shape that a sweep moves: the probe, or a body in its present orientation.
struct HandShape {
  double probe_A = 0.0;
  const HeldBody* body = nullptr;  ///< null: the probe
  Quat orientation = kNoRotation;  ///< of the body

  HandShape(double of_probe_A) : probe_A(of_probe_A) {}  // implicit: a radius denotes a probe
  HandShape(const HeldBody& held, const Quat& oriented) : body(&held), orientation(oriented) {}

  double reach_A() const { return body ? body->reach_A : probe_A; }
};

/// Returns the first contact of the shape with the scene while its middle moves from `from` to `to`. Without contact
/// Hit::sphere is -1 and Hit::t is 1. Any thread.
Hit sweep(const SphereGrid& scene, const HandShape& hand, const Vec3& from, const Vec3& to) noexcept;

}  // namespace moltact
