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

/// Diagonalizes the leading `n` by `n` part of a symmetric matrix (both triangles set): Householder reflections to
/// tridiagonal form, then QR steps with Wilkinson's shift (Golub & Van Loan, Matrix Computations, 8.3). Returns the
/// eigenvalues; row j of `axes` is the unit eigenvector of value j.
inline Six eigenvalues(Matrix6 a, std::size_t n, Matrix6& axes) {
  axes = {};
  for (std::size_t i = 0; i < n; ++i) axes.row[i][i] = 1.0;
  for (std::size_t k = 0; k + 2 < n; ++k) {
    Six v;  // the normal of the mirror that takes column k to its first entry below the diagonal
    double below2 = 0.0;
    for (std::size_t i = k + 1; i < n; ++i) v[i] = a.row[i][k];
    for (std::size_t i = k + 2; i < n; ++i) below2 += v[i] * v[i];
    if (below2 == 0.0) continue;
    const double size = std::copysign(std::sqrt(v[k + 1] * v[k + 1] + below2), v[k + 1]);
    v[k + 1] += size;
    const double by = 2.0 / (v[k + 1] * v[k + 1] + below2);
    Six w;
    for (std::size_t i = k + 1; i < n; ++i) w[i] = by * dot(a.row[i], v);
    w.add(-0.5 * by * dot(v, w), v);
    Six turned;
    for (std::size_t i = k + 1; i < n; ++i) {
      a.row[i].add(-v[i], w);
      a.row[i].add(-w[i], v);
      turned.add(by * v[i], axes.row[i]);
    }
    for (std::size_t i = k + 1; i < n; ++i) axes.row[i].add(-v[i], turned);
    a.row[k + 1][k] = -size;
  }
  Six value, beside;  // the diagonal, and the entries beside it
  for (std::size_t i = 0; i < n; ++i) value[i] = a.row[i][i];
  for (std::size_t i = 0; i + 1 < n; ++i) beside[i] = a.row[i + 1][i];
  constexpr double kNone = 1e-16;
  constexpr int kMaxSteps = 60;
  std::size_t last = n > 0 ? n - 1 : 0;
  for (int step = 0; last > 0 && step < kMaxSteps;) {
    const auto none = [&](std::size_t i) {
      return std::abs(beside[i]) <= kNone * (std::abs(value[i]) + std::abs(value[i + 1]));
    };
    if (none(last - 1)) {
      --last;
      continue;
    }
    std::size_t first = last - 1;
    while (first > 0 && !none(first - 1)) --first;
    ++step;
    const double half = 0.5 * (value[last - 1] - value[last]), b = beside[last - 1];
    double x = value[first] - value[last] + b * b / (half + std::copysign(std::sqrt(half * half + b * b), half));
    double z = beside[first];
    for (std::size_t k = first; k < last; ++k) {
      const double r = std::sqrt(x * x + z * z);
      const double c = r > 0.0 ? x / r : 1.0, s = r > 0.0 ? z / r : 0.0;
      if (k > first) beside[k - 1] = r;
      const double p = value[k], q = beside[k], t = value[k + 1];
      value[k] = c * c * p + 2.0 * c * s * q + s * s * t;
      value[k + 1] = s * s * p - 2.0 * c * s * q + c * c * t;
      beside[k] = c * s * (t - p) + (c * c - s * s) * q;
      if (k + 1 < last) {
        x = beside[k];
        z = s * beside[k + 1];
        beside[k + 1] *= c;
      }
      Six one = axes.row[k];
      one.scale(c);
      one.add(s, axes.row[k + 1]);
      axes.row[k + 1].scale(c);
      axes.row[k + 1].add(-s, axes.row[k]);
      axes.row[k] = one;
    }
  }
  return value;
}

/// The smallest eigenvalue of the leading `n` by `n` part of a symmetric matrix, and its unit eigenvector.
inline double smallestEigenvalue(const Matrix6& a, std::size_t n, Six& vector) {
  Matrix6 axes;
  const Six values = eigenvalues(a, n, axes);
  std::size_t least = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (values[i] < values[least]) least = i;
  vector = axes.row[least];
  return values[least];
}

/// Factors the matrix of which `b` holds the lower triangle. If a pivot is at most `min_pivot`, the factor is that of
/// the matrix with other eigenvalues, so that a step of Newton's method leads away from a saddle. A negative eigenvalue
/// is replaced by half of its absolute value, and each is at least `min_modified`.
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
  for (std::size_t j = 0; j < 6; ++j)
    b.addOuter(std::max(min_modified, values[j] < 0.0 ? -0.5 * values[j] : values[j]), axes.row[j]);
  min_pivot = 0.0;
  run();
  return out;
}

}  // namespace moltact
