// Spaces and units: the molecule's space in angstroms, the device's space in millimetres and newtons. The name of a
// member is its unit, so the compiler distinguishes positions of the two spaces; `Workspace` is the only conversion
// between them. Plain data; any thread. Quat is constructed as (w, x, y, z).
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace moltact {

using Vec3 = glm::dvec3;
using Quat = glm::dquat;

/// A full turn (unit: radian).
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// The identity rotation.
inline constexpr Quat kNoRotation{1.0, 0.0, 0.0, 0.0};

/// True if all three components are finite.
inline bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// True for a rotation quaternion: of unit length within 0.1 %. False for NaN.
inline bool rotates(const Quat& q) { return std::abs(glm::dot(q, q) - 1.0) < 1e-3; }

/// The shortest rotation from one orientation to the other, as axis times angle (unit: radian).
inline Vec3 rotationBetween(const Quat& from, const Quat& to) {
  Quat q = to * glm::conjugate(from);
  if (q.w < 0.0) q = -q;
  const Vec3 v(q.x, q.y, q.z);
  const double sine = glm::length(v);
  return sine > 0.0 ? v * (2.0 * std::atan2(sine, q.w) / sine) : Vec3(0.0);
}

/// A position in the molecule's space (unit: angstrom).
struct PointA {
  Vec3 A{0.0};
  friend bool operator==(const PointA&, const PointA&) = default;
};

/// Position and orientation of the hand in the molecule's space. `orientation` rotates the molecule's axes into the
/// hand's axes.
struct PoseA {
  PointA place;
  Quat orientation = kNoRotation;
};

/// A position in the device's space (unit: millimetre; +x right, +y up, +z toward the user).
struct PointMm {
  Vec3 mm{0.0};
};

/// A force in the device's space (unit: newton).
struct ForceN {
  Vec3 N{0.0};
};

/// A force and a torque about the hand's position, in the device's space (unit: newton, newton millimetre).
struct Wrench {
  ForceN force;
  Vec3 torque_N_mm{0.0};
};

/// The mapping from the device's space to the molecule's: a scale, a rotation and a centre. Valid range: A_per_mm > 0;
/// `rotation` a rotation matrix (orthonormal, determinant 1).
struct Workspace {
  double A_per_mm = 0.25;    ///< scale: angstroms in the molecule per millimetre of the hand
  Vec3 centre_A{0.0};        ///< position of the device's origin in the molecule (unit: angstrom)
  glm::dmat3 rotation{1.0};  ///< its columns are the device's axes in the molecule's space
  friend bool operator==(const Workspace&, const Workspace&) = default;

  PointA toMolecule(PointMm place) const { return {centre_A + rotation * (place.mm * A_per_mm)}; }
  PoseA toMolecule(PointMm place, const Quat& orientation) const {
    return {toMolecule(place), glm::quat_cast(rotation) * orientation};
  }
  PointMm toDevice(PointA place) const { return {glm::transpose(rotation) * (place.A - centre_A) / A_per_mm}; }

  /// The force of the spring (paper, section 3.3): stiffness (N/mm, in the device's space) times displacement.
  ForceN spring(const Vec3& displacement_A, double stiffness_N_per_mm) const {
    return {glm::transpose(rotation) * displacement_A * (stiffness_N_per_mm / A_per_mm)};
  }
  /// The torque of such springs in N mm; `torque_A2` is the sum of lever cross displacement.
  Vec3 torque_N_mm(const Vec3& torque_A2, double stiffness_N_per_mm) const {
    return glm::transpose(rotation) * torque_A2 * (stiffness_N_per_mm / (A_per_mm * A_per_mm));
  }
};

}  // namespace moltact
