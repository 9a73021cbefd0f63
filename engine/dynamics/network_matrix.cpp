#include "engine/dynamics/network_matrix.h"

#include <utility>
#include <vector>

namespace moltact {
namespace {

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

}  // namespace

SparseMatrix networkMatrix(const ElasticNetwork& network, double diagonal) {
  const std::size_t count = network.nodes().size();
  std::vector<glm::dmat3> blocks(count, glm::dmat3(diagonal));
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(18 * network.springs().size() + 9 * count);
  const auto add = [&](std::uint32_t row, std::uint32_t column, const glm::dmat3& block) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) entries.emplace_back(int(3 * row) + r, int(3 * column) + c, block[c][r]);
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

InverseHessian::InverseHessian(const ElasticNetwork& network) : rigid_(rigidMotions(network)) {
  // The trace of the Hessian is two for each spring.
  mean_diagonal_ = 2.0 * double(network.springs().size()) / (3.0 * double(network.nodes().size()));
  factor_.compute(networkMatrix(network, shift()));
}

Eigen::VectorXd InverseHessian::apply(Eigen::VectorXd x) const {
  removeRigid(x);
  Eigen::VectorXd out = factor_.solve(x);
  removeRigid(out);
  return out;
}

}  // namespace moltact
