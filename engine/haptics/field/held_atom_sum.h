// The sum of a held body's atoms: each atom's energy after bounding walls, its force at its arm about the body's
// middle, and the bounds of the curvature. Haptic thread. Units: angstrom, kcal/mol, radian.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/haptics/field/pair_sum.h"

namespace moltact {

class HeldAtomSum {
 public:
  explicit HeldAtomSum(const FeltFunction& felt) noexcept : felt_(felt) {}

  /// Adds an atom at `arm` from the body's middle. Its curvature may come from a nearby pose. Returns the
  /// derivative of the felt energy by the atom's: 1 below zero without a gain.
  double add(const PairTerms& terms, const std::array<double, 6>& c, const Vec3& arm) noexcept {
    // Nothing is within the cut-off.
    if (terms.energy.total_kcal_mol() == 0.0 && terms.gradient == Vec3(0.0) && c == std::array<double, 6>{})
      return felt_.at(0.0).slope;
    sum_.energy.parts += terms.energy;
    const auto [felt, first, second] = felt_.at(terms.energy.total_kcal_mol());
    sum_.energy.felt_kcal_mol += felt;
    const Vec3 gradient = first * terms.gradient;
    sum_.force_kcal_mol_A -= gradient;
    sum_.torque_kcal_mol -= glm::cross(arm, gradient);
    const glm::dmat3 curvature = first * glm::dmat3(c[0], c[3], c[4], c[3], c[1], c[5], c[4], c[5], c[2]) +
                                 second * glm::outerProduct(terms.gradient, terms.gradient);
    translational_ += curvature;
    // E(exp(w)): second order in w of arm + w x arm + w x (w x arm) / 2.
    rotational_ += atArm(curvature, arm) + 0.5 * (glm::outerProduct(gradient, arm) + glm::outerProduct(arm, gradient)) -
                   glm::dmat3(glm::dot(gradient, arm));
    return first;
  }

  PairEnergy energy() const noexcept {
    PairEnergy out = sum_;
    out.stiffness_kcal_mol_A2 = bound(translational_);
    out.rotational_stiffness_kcal_mol = bound(rotational_);
    return out;
  }

 private:
  // X c X^T for a symmetric c, where X v is the cross product of the arm and v.
  static glm::dmat3 atArm(const glm::dmat3& c, const Vec3& arm) noexcept {
    const glm::dmat3 half(glm::cross(arm, c[0]), glm::cross(arm, c[1]), glm::cross(arm, c[2]));
    const glm::dmat3 rows = glm::transpose(half);
    return {glm::cross(arm, rows[0]), glm::cross(arm, rows[1]), glm::cross(arm, rows[2])};
  }

  // The largest eigenvalue of a symmetric matrix is at most that of its trace and of the norm of its rest.
  static double bound(const glm::dmat3& m) noexcept {
    const double mean = (m[0][0] + m[1][1] + m[2][2]) / 3.0;
    double rest = 0.0;
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l) rest += std::pow(m[k][l] - (k == l ? mean : 0.0), 2.0);
    // A traceless symmetric matrix has no eigenvalue above sqrt(2 / 3) of its norm.
    return std::max(0.0, mean + std::sqrt(rest * 2.0 / 3.0));
  }

  FeltFunction felt_;
  PairEnergy sum_;
  glm::dmat3 translational_{0.0}, rotational_{0.0};
};

}  // namespace moltact
