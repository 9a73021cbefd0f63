// Elastic networks for tests, and their dense Hessian, assembled independently of engine/dynamics.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "engine/dynamics/elastic_network.h"
#include "tests/structure/library.h"

namespace moltact::test {

/// A molecule of one CA per residue at these places.
inline Molecule beads(const std::vector<Vec3>& places_A) {
  std::string text;
  for (std::size_t i = 0; i < places_A.size(); ++i) {
    char line[1100];
    std::snprintf(line, sizeof line, "ATOM  %5zu  CA  ALA A%4zu    %8.3f%8.3f%8.3f  1.00 10.00           C\n", i + 1,
                  i + 1, places_A[i].x, places_A[i].y, places_A[i].z);
    text += line;
  }
  return moleculeOf(text + "END\n");
}

inline ElasticNetwork networkOf(const Molecule& molecule, double cut_off_A = ElasticNetwork::kCutOff_A) {
  auto out = ElasticNetwork::make(molecule, cut_off_A);
  if (!out) FAIL(out.problem().text());
  return *std::move(out);
}

/// By second differences of the energy in closed form: -d d^T / |d|^2 for each pair within the cut-off.
inline Eigen::MatrixXd denseHessian(const ElasticNetwork& network, double cut_off_A = ElasticNetwork::kCutOff_A) {
  const int n = int(network.nodes().size());
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      const Vec3 d = network.place_A(std::size_t(b)) - network.place_A(std::size_t(a));
      const double r2 = glm::dot(d, d);
      if (a == b || r2 > cut_off_A * cut_off_A) continue;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
          h(3 * a + r, 3 * b + c) -= d[r] * d[c] / r2;
          h(3 * a + r, 3 * a + c) += d[r] * d[c] / r2;
        }
    }
  return h;
}

/// The pseudo-inverse: the inverse over all eigenvectors but the six rigid motions.
inline Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& h) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all(h);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(h.rows(), h.cols());
  for (Eigen::Index k = 6; k < h.rows(); ++k)
    out += all.eigenvectors().col(k) * all.eigenvectors().col(k).transpose() / all.eigenvalues()[k];
  return out;
}

}  // namespace moltact::test
