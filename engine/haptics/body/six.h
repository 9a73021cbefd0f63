// Vectors and symmetric matrices of six components for the motion of a rigid body: three of translation, three of
// rotation. Plain data, every thread; nothing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/core/units.h"

namespace moltact {

struct Six {
  std::array<double, 6> v{};

  Six() = default;
  Six(const Vec3& translation, const Vec3& rotation)
      : v{translation.x, translation.y, translation.z, rotation.x, rotation.y, rotation.z} {}
  double& operator[](std::size_t i) { return v[i]; }
  double operator[](std::size_t i) const { return v[i]; }
  Vec3 translation() const { return {v[0], v[1], v[2]}; }
  Vec3 rotation() const { return {v[3], v[4], v[5]}; }

  /// Adds `factor` times another vector.
  void add(double factor, const Six& other) {
    for (std::size_t i = 0; i < 6; ++i) v[i] += factor * other.v[i];
  }
  void scale(double factor) {
    for (double& x : v) x *= factor;
  }
};

inline double dot(const Six& a, const Six& b) {
  return ((a.v[0] * b.v[0] + a.v[1] * b.v[1]) + (a.v[2] * b.v[2] + a.v[3] * b.v[3])) +
         (a.v[4] * b.v[4] + a.v[5] * b.v[5]);
}
inline double length(const Six& a) { return std::sqrt(dot(a, a)); }

/// A matrix; only its lower triangle is used where it is symmetric.
struct Matrix6 {
  std::array<Six, 6> row{};

  /// Adds `factor` times the outer product of a vector with itself to the lower triangle.
  void addOuter(double factor, const Six& a) {
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j <= i; ++j) row[i][j] += factor * a[i] * a[j];
  }
  void mirror() {
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < i; ++j) row[j][i] = row[i][j];
  }
};

/// The Cholesky factor C of a positive definite matrix B = C C^T.
struct Factor6 {
  Matrix6 lower;
  Six inverse;            ///< of the diagonal
  bool definite = false;  ///< false: the matrix was not positive definite and has been modified

  /// C^-1 a.
  Six forward(Six a) const {
    for (std::size_t i = 0; i < 6; ++i) {
      double sum = a[i];
      for (std::size_t j = 0; j < i; ++j) sum -= lower.row[i][j] * a[j];
      a[i] = sum * inverse[i];
    }
    return a;
  }
  /// C^-T a.
  Six backward(Six a) const {
    for (std::size_t i = 6; i-- > 0;) {
      a[i] *= inverse[i];
      for (std::size_t j = 0; j < i; ++j) a[j] -= lower.row[i][j] * a[i];
    }
    return a;
  }
};

/// Diagonalizes the leading `n` by `n` part of a symmetric matrix (both triangles set) by cyclic Jacobi rotations.
/// Returns the eigenvalues; column j of `axes` is the unit eigenvector of value j.
inline Six eigenvalues(Matrix6 a, std::size_t n, Matrix6& axes) {
  axes = {};
  for (std::size_t i = 0; i < n; ++i) axes.row[i][i] = 1.0;
  for (int sweep = 0; sweep < 12; ++sweep) {
    double off = 0.0, all = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      all += a.row[i][i] * a.row[i][i];
      for (std::size_t j = 0; j < i; ++j) off += a.row[i][j] * a.row[i][j];
    }
    if (off <= 1e-28 * all) break;
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) {
        if (a.row[p][q] == 0.0) continue;
        const double tau = (a.row[q][q] - a.row[p][p]) / (2.0 * a.row[p][q]);
        const double t = (tau >= 0.0 ? 1.0 : -1.0) / (std::abs(tau) + std::sqrt(1.0 + tau * tau));
        const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
        for (std::size_t k = 0; k < n; ++k) {
          const double kp = a.row[k][p], kq = a.row[k][q];
          a.row[k][p] = c * kp - s * kq;
          a.row[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double pk = a.row[p][k], qk = a.row[q][k];
          a.row[p][k] = c * pk - s * qk;
          a.row[q][k] = s * pk + c * qk;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double kp = axes.row[k][p], kq = axes.row[k][q];
          axes.row[k][p] = c * kp - s * kq;
          axes.row[k][q] = s * kp + c * kq;
        }
      }
  }
  Six out;
  for (std::size_t i = 0; i < n; ++i) out[i] = a.row[i][i];
  return out;
}

/// The smallest eigenvalue of the leading `n` by `n` part of a symmetric matrix, and its unit eigenvector.
inline double smallestEigenvalue(const Matrix6& a, std::size_t n, Six& vector) {
  Matrix6 axes;
  const Six values = eigenvalues(a, n, axes);
  std::size_t least = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (values[i] < values[least]) least = i;
  vector = {};
  for (std::size_t i = 0; i < n; ++i) vector[i] = axes.row[i][least];
  return values[least];
}

/// Factors the matrix of which `b` holds the lower triangle. If a pivot is at most `min_pivot`, the factor is that of
/// the matrix with other eigenvalues, so that a step of Newton's method leads away from a saddle: half of the absolute
/// value of a negative one, and each at least `min_modified`.
inline Factor6 factored(Matrix6 b, double min_pivot, double min_modified) {
  Factor6 out;
  const auto run = [&] {
    for (std::size_t j = 0; j < 6; ++j) {
      double pivot = b.row[j][j];
      for (std::size_t k = 0; k < j; ++k) pivot -= out.lower.row[j][k] * out.lower.row[j][k];
      if (!(pivot > min_pivot)) return false;
      const double size = std::sqrt(pivot);
      out.lower.row[j][j] = size;
      out.inverse[j] = 1.0 / size;
      for (std::size_t i = j + 1; i < 6; ++i) {
        double sum = b.row[i][j];
        for (std::size_t k = 0; k < j; ++k) sum -= out.lower.row[i][k] * out.lower.row[j][k];
        out.lower.row[i][j] = sum * out.inverse[j];
      }
    }
    return true;
  };
  out.definite = run();
  if (out.definite) return out;
  b.mirror();
  Matrix6 axes;
  const Six values = eigenvalues(b, 6, axes);
  b = {};
  for (std::size_t j = 0; j < 6; ++j) {
    Six axis;
    for (std::size_t i = 0; i < 6; ++i) axis[i] = axes.row[i][j];
    b.addOuter(std::max(min_modified, values[j] < 0.0 ? -0.5 * values[j] : values[j]), axis);
  }
  min_pivot = 0.0;
  run();
  return out;
}

}  // namespace moltact
