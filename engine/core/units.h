// Spaces and units: the molecule's space in angstroms, the device's space in millimetres and newtons.
// The member's name is the unit, so a place in one space cannot be taken for a place in the other;
// `Workspace` is the one conversion between them. Plain data, usable on every thread.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace moltact {

using Vec3 = glm::dvec3;

/// True where none of the three numbers is infinite or NaN.
inline bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// A place in the molecule's space (unit: angstrom).
struct PointA {
  Vec3 A{0.0};
  friend bool operator==(const PointA&, const PointA&) = default;
};

/// A place in the device's space (unit: millimetre; +x right, +y up, +z toward the person).
struct PointMm {
  Vec3 mm{0.0};
};

/// A force in the device's space (unit: newton).
struct ForceN {
  Vec3 N{0.0};
};

/// How the device's space lies in the molecule's: a scale, a rotation and a centre.
/// Valid range: A_per_mm > 0; `rotation` a rotation matrix (orthonormal, determinant 1).
struct Workspace {
  double A_per_mm = 0.25;    ///< one millimetre of the hand is this many angstroms of the molecule (default 0.25)
  Vec3 centre_A{0.0};        ///< the place in the molecule where the device's origin lies (unit: angstrom)
  glm::dmat3 rotation{1.0};  ///< the device's axes in the molecule's space, as columns (default: the same axes)
  friend bool operator==(const Workspace&, const Workspace&) = default;

  PointA toMolecule(PointMm place) const { return {centre_A + rotation * (place.mm * A_per_mm)}; }
  PointMm toDevice(PointA place) const { return {glm::transpose(rotation) * (place.A - centre_A) / A_per_mm}; }

  /// The spring's force (paper, section 3.3): stiffness (N/mm, in the device's space) times the way from HIP to SCP.
  ForceN spring(PointA hip, PointA scp, double stiffness_N_per_mm) const {
    return {glm::transpose(rotation) * (scp.A - hip.A) * (stiffness_N_per_mm / A_per_mm)};
  }
};

}  // namespace moltact
