// The Hessian of an elastic network as a sparse matrix, and the space of its deformations. For sources of this room:
// Eigen's headers take seconds to compile.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "engine/dynamics/elastic_network.h"

namespace moltact {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// `scale` times the Hessian with springs of stiffness 1, plus `diagonal` on the diagonal. Both triangles are filled.
SparseMatrix networkMatrix(const ElasticNetwork& network, double scale, double diagonal);

/// An orthonormal basis of the six rigid motions, as columns.
Eigen::MatrixXd rigidMotions(const ElasticNetwork& network);

/// Removes the rigid motions of the basis from x.
inline void removeRigid(const Eigen::MatrixXd& rigid, Eigen::Ref<Eigen::VectorXd> x) {
  x -= rigid * (rigid.transpose() * x);
}

}  // namespace moltact
