// The Hessian of an elastic network as a sparse matrix, and its inverse in the space of deformations. Include
// it only from sources of this room, because Eigen's headers take seconds to compile.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "engine/dynamics/elastic_network.h"

namespace moltact {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The Hessian with springs of stiffness 1, plus `diagonal` on the diagonal. Both triangles are filled.
SparseMatrix networkMatrix(const ElasticNetwork& network, double diagonal = 0.0);

/// The pseudo-inverse of the Hessian: rigid motions are removed from what it is applied to and from the result. Accurate
/// to 1e-6. Also serves as a matrix operation for Spectra.
class InverseHessian {
 public:
  using Scalar = double;

  explicit InverseHessian(const ElasticNetwork& network);

  Eigen::VectorXd apply(Eigen::VectorXd x) const;
  /// Removes the rigid motions.
  void removeRigid(Eigen::VectorXd& x) const { x -= rigid_ * (rigid_.transpose() * x).eval(); }
  double meanDiagonal() const { return mean_diagonal_; }
  /// What is added to the diagonal before the inversion.
  double shift() const { return kShift * mean_diagonal_; }

  Eigen::Index rows() const { return rigid_.rows(); }
  Eigen::Index cols() const { return rigid_.rows(); }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd>(out, rows()) = apply(Eigen::Map<const Eigen::VectorXd>(in, rows()));
  }

 private:
  // Without it the matrix has no inverse. Relative to the mean diagonal element.
  static constexpr double kShift = 1e-9;

  Eigen::MatrixXd rigid_;  // an orthonormal basis of the six rigid motions, as columns
  double mean_diagonal_ = 0.0;
  Eigen::SimplicialLDLT<SparseMatrix> factor_;
};

}  // namespace moltact
