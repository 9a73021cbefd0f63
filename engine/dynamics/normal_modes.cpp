#include "engine/dynamics/normal_modes.h"

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/dynamics/network_matrix.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

// A mode below this fraction of the mean diagonal element has no stiffness of its own.
constexpr double kMinEigenvalue = 1e-7;

}  // namespace

Expected<NormalModes> lowestModes(const ElasticNetwork& network, std::size_t count) {
  InverseHessian inverse(network);
  const Eigen::Index size = inverse.rows();
  const Eigen::Index wanted = std::clamp<Eigen::Index>(Eigen::Index(count), 1, size - 6);
  // A Krylov space of twice the number of modes converges in a few restarts.
  Spectra::SymEigsSolver<InverseHessian> solver(inverse, wanted,
                                                std::min(size, std::max<Eigen::Index>(2 * wanted, 20)));
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, 1000, 1e-12);
  NormalModes out;
  out.nodes = network.nodes().size();
  const Eigen::VectorXd inverses = solver.eigenvalues();
  const Eigen::MatrixXd vectors = solver.eigenvectors();
  for (Eigen::Index k = 0; k < inverses.size(); ++k) {
    const double eigenvalue = 1.0 / inverses[k] - inverse.shift();
    if (!(eigenvalue > kMinEigenvalue * inverse.meanDiagonal()))
      return Problem{
          {}, 0, 0, tr("a part of the network moves without stretching a spring"), tr("give a longer cut-off")};
    out.eigenvalues.push_back(eigenvalue);
    for (Eigen::Index i = 0; i < size; i += 3)
      out.vectors.emplace_back(vectors(i, k), vectors(i + 1, k), vectors(i + 2, k));
  }
  if (out.eigenvalues.empty())
    return Problem{{}, 0, 0, tr("the modes of the network cannot be computed"), tr("give another cut-off")};
  return out;
}

std::vector<glm::dmat3> nodeCompliances(const ElasticNetwork& network, const std::function<bool(double)>& progress) {
  const InverseHessian inverse(network);
  std::vector<glm::dmat3> out(network.nodes().size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (progress && !progress(double(i) / double(out.size()))) return {};
    const Eigen::Index at = Eigen::Index(3 * i);
    for (int c = 0; c < 3; ++c) {
      const Eigen::VectorXd column = inverse.apply(Eigen::VectorXd::Unit(inverse.rows(), at + c));
      for (int r = 0; r < 3; ++r) out[i][c][r] = column[at + r];
    }
  }
  return out;
}

double greatestCompliance(const glm::dmat3& compliance) {
  Eigen::Matrix3d block;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) block(r, c) = compliance[c][r];
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(block).eigenvalues()[2];
}

double springFromDisplacementFactors(const ElasticNetwork& network, const Molecule& molecule,
                                     std::span<const glm::dmat3> compliances) {
  double compliance = 0.0, factor_A2 = 0.0;
  for (std::size_t i = 0; i < compliances.size(); ++i) {
    const double b = molecule.atoms[network.nodes()[i]].b_factor_A2;
    if (!(b > 0.0)) return 0.0;
    compliance += fluctuation(compliances[i]);
    factor_A2 += b;
  }
  constexpr double kPi2 = std::numbers::pi * std::numbers::pi;
  return factor_A2 > 0.0 ? 8.0 * kPi2 / 3.0 * kThermalEnergy_kcal_mol * compliance / factor_A2 : 0.0;
}

double correlationWithDisplacementFactors(const ElasticNetwork& network, const Molecule& molecule,
                                          std::span<const glm::dmat3> compliances) {
  const double count = double(compliances.size());
  double mean_c = 0.0, mean_b = 0.0, cc = 0.0, bb = 0.0, cb = 0.0;
  const auto factor = [&](std::size_t i) { return double(molecule.atoms[network.nodes()[i]].b_factor_A2); };
  for (std::size_t i = 0; i < compliances.size(); ++i) {
    mean_c += fluctuation(compliances[i]) / count;
    mean_b += factor(i) / count;
  }
  for (std::size_t i = 0; i < compliances.size(); ++i) {
    const double c = fluctuation(compliances[i]) - mean_c, b = factor(i) - mean_b;
    cc += c * c;
    bb += b * b;
    cb += c * b;
  }
  return cc > 0.0 && bb > 0.0 ? cb / std::sqrt(cc * bb) : 0.0;
}

std::vector<double> modeOverlaps(const NormalModes& modes, std::span<const Vec3> change_A) {
  double length2 = 0.0;
  for (const Vec3& v : change_A) length2 += glm::dot(v, v);
  std::vector<double> out(modes.count());
  for (std::size_t k = 0; k < modes.count() && length2 > 0.0; ++k) {
    double along = 0.0;
    for (std::size_t i = 0; i < modes.nodes; ++i) along += glm::dot(modes.mode(k)[i], change_A[i]);
    out[k] = std::abs(along) / std::sqrt(length2);
  }
  return out;
}

}  // namespace moltact
