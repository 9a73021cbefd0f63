#include "engine/dynamics/normal_modes.h"

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/dynamics/network_matrix.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

// Added to the diagonal, so that the Hessian has an inverse; relative to its mean diagonal element. The rigid motions,
// which alone feel it, are removed.
constexpr double kShift = 1e-9;
// A mode below this fraction of the mean diagonal element has no stiffness of its own.
constexpr double kMinEigenvalue = 1e-7;

// The inverse of the Hessian in the space of deformations.
class InverseHessian {
 public:
  using Scalar = double;

  explicit InverseHessian(const ElasticNetwork& network) : rigid_(rigidMotions(network)) {
    mean_diagonal_ = 2.0 * double(network.springs().size()) / (3.0 * double(network.nodes().size()));
    factor_.compute(networkMatrix(network, 1.0, kShift * mean_diagonal_));
  }

  double meanDiagonal() const { return mean_diagonal_; }
  Eigen::VectorXd apply(Eigen::VectorXd x) const {
    removeRigid(rigid_, x);
    Eigen::VectorXd y = factor_.solve(x);
    removeRigid(rigid_, y);
    return y;
  }

  // The interface of Spectra's operators.
  Eigen::Index rows() const { return rigid_.rows(); }
  Eigen::Index cols() const { return rigid_.rows(); }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd>(out, rows()) = apply(Eigen::Map<const Eigen::VectorXd>(in, rows()));
  }

 private:
  Eigen::MatrixXd rigid_;
  double mean_diagonal_ = 0.0;
  Eigen::SimplicialLDLT<SparseMatrix> factor_;
};

}  // namespace

SparseMatrix networkMatrix(const ElasticNetwork& network, double scale, double diagonal) {
  const std::size_t count = network.nodes().size();
  std::vector<glm::dmat3> blocks(count, glm::dmat3(0.0));
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(18 * network.springs().size() + 9 * count);
  const auto add = [&](std::uint32_t row, std::uint32_t column, const glm::dmat3& block) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        entries.emplace_back(int(3 * row) + r, int(3 * column) + c,
                             scale * block[c][r] + (row == column && r == c ? diagonal : 0.0));
  };
  for (const auto& [a, b] : network.springs()) {
    const Vec3 along = glm::normalize(network.place_A(b) - network.place_A(a));
    const glm::dmat3 block = glm::outerProduct(along, along);
    blocks[a] += block;
    blocks[b] += block;
    add(a, b, -block);
    add(b, a, -block);
  }
  for (std::uint32_t i = 0; i < count; ++i) add(i, i, blocks[i]);
  SparseMatrix out(Eigen::Index(3 * count), Eigen::Index(3 * count));
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

Eigen::MatrixXd rigidMotions(const ElasticNetwork& network) {
  const std::size_t count = network.nodes().size();
  Vec3 centre(0.0);
  for (std::size_t i = 0; i < count; ++i) centre += network.place_A(i) / double(count);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(Eigen::Index(3 * count), 6);
  for (std::size_t i = 0; i < count; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 unit(0.0);
      unit[axis] = 1.0;
      const Vec3 turned = glm::cross(unit, network.place_A(i) - centre);
      out(Eigen::Index(3 * i) + axis, axis) = 1.0;
      for (int c = 0; c < 3; ++c) out(Eigen::Index(3 * i) + c, 3 + axis) = turned[c];
    }
  return Eigen::HouseholderQR<Eigen::MatrixXd>(out).householderQ() * Eigen::MatrixXd::Identity(out.rows(), 6);
}

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
    const double eigenvalue = 1.0 / inverses[k] - kShift * inverse.meanDiagonal();
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

std::vector<double> nodeCompliances(const ElasticNetwork& network, const std::function<bool(double)>& progress) {
  const InverseHessian inverse(network);
  std::vector<double> out(network.nodes().size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (progress && !progress(double(i) / double(out.size()))) return {};
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Index at = Eigen::Index(3 * i) + axis;
      out[i] += inverse.apply(Eigen::VectorXd::Unit(inverse.rows(), at))[at];
    }
  }
  return out;
}

double springFromDisplacementFactors(const ElasticNetwork& network, const Molecule& molecule,
                                     std::span<const double> compliances) {
  double compliance = 0.0, factor_A2 = 0.0;
  for (std::size_t i = 0; i < compliances.size(); ++i) {
    const double b = molecule.atoms[network.nodes()[i]].b_factor_A2;
    if (!(b > 0.0)) return 0.0;
    compliance += compliances[i];
    factor_A2 += b;
  }
  constexpr double kPi2 = std::numbers::pi * std::numbers::pi;
  return factor_A2 > 0.0 ? 8.0 * kPi2 / 3.0 * kThermalEnergy_kcal_mol * compliance / factor_A2 : 0.0;
}

double correlationWithDisplacementFactors(const ElasticNetwork& network, const Molecule& molecule,
                                          std::span<const double> compliances) {
  const double count = double(compliances.size());
  double mean_c = 0.0, mean_b = 0.0, cc = 0.0, bb = 0.0, cb = 0.0;
  const auto factor = [&](std::size_t i) { return double(molecule.atoms[network.nodes()[i]].b_factor_A2); };
  for (std::size_t i = 0; i < compliances.size(); ++i) {
    mean_c += compliances[i] / count;
    mean_b += factor(i) / count;
  }
  for (std::size_t i = 0; i < compliances.size(); ++i) {
    const double c = compliances[i] - mean_c, b = factor(i) - mean_b;
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
