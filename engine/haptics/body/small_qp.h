// Quadratic programs in six variables with many linear constraints: the dual active-set method of Goldfarb & Idnani
// (1983). At most six constraints are active. The orthonormal basis of the active normals comes from Gram-Schmidt
// orthogonalization, applied twice, because a Gram matrix would lose half of the digits for nearly parallel normals.
// Haptic thread; nothing allocates. Units: those of the caller.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/haptics/body/six.h"

namespace moltact {

/// The solution of a program.
struct QpSolution {
  bool feasible = false;
  Six step{};                      ///< the minimizer
  int count = 0;                   ///< active constraints
  std::array<int, 6> rows{};       ///< their indices
  std::array<double, 6> lambda{};  ///< their multipliers, >= 0
  int changes = 0;                 ///< additions and removals of active constraints
};

class SmallQp {
 public:
  static constexpr std::size_t kMaxRows = 512;  ///< the largest number of constraints
  static constexpr int kMaxChanges = 80;        ///< more changes end the search; the result is then not feasible

  /// Minimizes step^T B step / 2 - pull . step subject to rows[k] . step >= bounds[k]. `metric` is the factor of B;
  /// null: B is the identity. Violated constraints of `preferred` enter the active set first, which shortens the search
  /// if they are the active set of a similar program. Spans of equal length, at most kMaxRows. More than `max_changes`
  /// end the search as kMaxChanges do; QpSolution::changes is at most one more.
  QpSolution solve(const Factor6* metric, const Six& pull, std::span<const Six> rows, std::span<const double> bounds,
                   std::span<const int> preferred, int max_changes = kMaxChanges) noexcept;

 private:
  struct Entering {
    Six along;                         ///< the part of the new normal that is orthogonal to the active ones
    double along2 = 0.0;               ///< its squared length
    std::array<double, 6> in_basis{};  ///< coefficients of the rest in the basis
    std::array<double, 6> shares{};    ///< change of the active multipliers per unit of the new one
    bool independent = false;
  };
  Entering entering(const Six& normal) const noexcept;
  void append(const Entering& with, const Six& normal) noexcept;
  void remove(int at) noexcept;
  bool closed(QpSolution& out, const Factor6* metric) const noexcept;

  int count_ = 0;
  std::array<Six, 6> normals_;                     // of the active constraints, in the metric's coordinates
  std::array<Six, 6> basis_;                       // orthonormal
  std::array<std::array<double, 6>, 6> triangle_;  // upper triangle: normal j = sum over i <= j of basis i * [i][j]
  std::array<double, kMaxRows> slack_;
};

}  // namespace moltact
