#include "engine/dynamics/elastic_motion.h"

#include <algorithm>
#include <utility>

#include "engine/dynamics/network_matrix.h"

namespace moltact {

double relaxationFor(double hand_kcal_mol_A2, double compliance_A2_mol_kcal, double step_s) {
  return std::max(0.0, step_s * (4.0 * hand_kcal_mol_A2 * compliance_A2_mol_kcal - 1.0));
}

struct ElasticMotion::Vectors {
  SparseMatrix hessian;
  InverseHessian inverse;
  Eigen::MatrixXd modes;    // a column per mode
  Eigen::VectorXd x, rest;  // displacements, and those at which the springs are at rest
};

ElasticMotion::ElasticMotion(std::shared_ptr<const ElasticNetwork> network, std::shared_ptr<const NormalModes> modes,
                             double spring_kcal_mol_A2, double step_s)
    : modes_(std::move(modes)),
      spring_(spring_kcal_mol_A2),
      step_s_(step_s),
      in_(new Vectors{networkMatrix(*network), InverseHessian(*network), {}, {}, {}}),
      shown_(network->nodes().size(), Vec3(0.0)) {
  in_->modes.resize(in_->hessian.rows(), Eigen::Index(modes_->count()));
  for (std::size_t k = 0; k < modes_->count(); ++k)
    for (std::size_t i = 0; i < modes_->nodes; ++i)
      for (int c = 0; c < 3; ++c) in_->modes(Eigen::Index(3 * i) + c, Eigen::Index(k)) = modes_->mode(k)[i][c];
  in_->x = in_->rest = Eigen::VectorXd::Zero(in_->hessian.rows());
}

ElasticMotion::~ElasticMotion() = default;
ElasticMotion::ElasticMotion(ElasticMotion&&) noexcept = default;

void ElasticMotion::restrictTo(std::vector<std::size_t> modes) {
  all_ = false;
  allowed_ = std::move(modes);
}

void ElasticMotion::setRest(std::span<const double> amplitudes_A) {
  in_->rest.setZero();
  for (std::size_t k = 0; k < std::min(amplitudes_A.size(), modes_->count()); ++k)
    in_->rest += in_->modes.col(Eigen::Index(k)) * amplitudes_A[k];
}

void ElasticMotion::step(std::span<const NodeForce> forces) {
  // Where the network would come to rest under these forces.
  Eigen::VectorXd goal = in_->rest;
  if (!forces.empty()) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(goal.size());
    for (const NodeForce& n : forces)
      for (int c = 0; c < 3; ++c) f[Eigen::Index(3 * n.node) + c] += n.force_kcal_mol_A[c] / spring_;
    if (all_)
      goal += in_->inverse.apply(std::move(f));
    else
      for (const std::size_t k : allowed_) {
        const auto mode = in_->modes.col(Eigen::Index(k));
        goal += mode * (mode.dot(f) / modes_->eigenvalues[k]);
      }
  }
  in_->x += (goal - in_->x) / (1.0 + relaxation_s_ / step_s_);
  update();
}

void ElasticMotion::place(std::span<const Vec3> displacements_A) {
  for (std::size_t i = 0; i < std::min(displacements_A.size(), shown_.size()); ++i)
    for (int c = 0; c < 3; ++c) in_->x[Eigen::Index(3 * i) + c] = displacements_A[i][c];
  in_->inverse.removeRigid(in_->x);
  update();
}

double ElasticMotion::energy_kcal_mol() const {
  const Eigen::VectorXd stretched = in_->x - in_->rest;
  return 0.5 * spring_ * stretched.dot(in_->hessian * stretched);
}

double ElasticMotion::maxDisplacement_A() const {
  double out = 0.0;
  for (const Vec3& v : shown_) out = std::max(out, glm::length(v));
  return out;
}

void ElasticMotion::update() {
  const Eigen::VectorXd& x = in_->x;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const Eigen::Index at = Eigen::Index(3 * i);
    shown_[i] = {x[at], x[at + 1], x[at + 2]};
  }
}

}  // namespace moltact
