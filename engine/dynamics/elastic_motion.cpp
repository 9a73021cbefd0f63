#include "engine/dynamics/elastic_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/dynamics/network_matrix.h"

namespace moltact {

struct ElasticMotion::Solver {
  SparseMatrix hessian;                      // gamma H
  Eigen::MatrixXd rigid;                     // basis of the rigid motions
  Eigen::MatrixXd modes;                     // a column per mode
  Eigen::SimplicialLDLT<SparseMatrix> step;  // of zeta/h + gamma H
  Eigen::VectorXd x, rest;
};

ElasticMotion::ElasticMotion(std::shared_ptr<const ElasticNetwork> network, std::shared_ptr<const NormalModes> modes,
                             double spring_kcal_mol_A2, double friction_kcal_s_mol_A2, double step_s)
    : network_(std::move(network)),
      modes_(std::move(modes)),
      spring_(spring_kcal_mol_A2),
      friction_(friction_kcal_s_mol_A2),
      step_(step_s),
      solver_(std::make_unique<Solver>()),
      shown_(network_->nodes().size(), Vec3(0.0)) {
  Solver& s = *solver_;
  s.hessian = networkMatrix(*network_, spring_, 0.0);
  s.rigid = rigidMotions(*network_);
  s.modes.resize(s.hessian.rows(), Eigen::Index(modes_->count()));
  for (std::size_t k = 0; k < modes_->count(); ++k)
    for (std::size_t i = 0; i < modes_->nodes; ++i)
      for (int c = 0; c < 3; ++c) s.modes(Eigen::Index(3 * i) + c, Eigen::Index(k)) = modes_->mode(k)[i][c];
  s.x = s.rest = Eigen::VectorXd::Zero(s.hessian.rows());
  setFriction(friction_kcal_s_mol_A2);
}

ElasticMotion::~ElasticMotion() = default;

void ElasticMotion::setFriction(double friction_kcal_s_mol_A2) {
  friction_ = friction_kcal_s_mol_A2;
  solver_->step.compute(networkMatrix(*network_, spring_, friction_ / step_));
}

void ElasticMotion::restrictTo(std::span<const std::size_t> modes) {
  all_ = false;
  allowed_.assign(modes.begin(), modes.end());
  Solver& s = *solver_;
  Eigen::VectorXd kept = Eigen::VectorXd::Zero(s.x.size());
  for (const std::size_t k : allowed_) {
    const auto mode = s.modes.col(Eigen::Index(k));
    kept += mode * mode.dot(s.x);
  }
  s.x = kept;
  update();
}

void ElasticMotion::useAll() { all_ = true; }

void ElasticMotion::setRest(std::span<const double> amplitudes_A) {
  Solver& s = *solver_;
  s.rest.setZero();
  for (std::size_t k = 0; k < std::min(amplitudes_A.size(), modes_->count()); ++k)
    s.rest += s.modes.col(Eigen::Index(k)) * amplitudes_A[k];
}

void ElasticMotion::step(std::span<const NodeForce> forces) {
  Solver& s = *solver_;
  Eigen::VectorXd f = s.hessian * s.rest;
  for (const NodeForce& n : forces)
    for (int c = 0; c < 3; ++c) f[Eigen::Index(3 * n.node) + c] += n.force_kcal_mol_A[c];
  const double drag = friction_ / step_;
  if (all_) {
    removeRigid(s.rigid, f);
    f += drag * s.x;  // evaluated beforehand: solve() writes into s.x while it reads its argument
    s.x = s.step.solve(f);
    removeRigid(s.rigid, s.x);
  } else {
    Eigen::VectorXd next = Eigen::VectorXd::Zero(s.x.size());
    for (const std::size_t k : allowed_) {
      const auto mode = s.modes.col(Eigen::Index(k));
      next += mode * ((mode.dot(f) + drag * mode.dot(s.x)) / (spring_ * modes_->eigenvalues[k] + drag));
    }
    s.x = next;
  }
  update();
}

void ElasticMotion::place(std::span<const Vec3> displacements_A) {
  Solver& s = *solver_;
  for (std::size_t i = 0; i < std::min(displacements_A.size(), shown_.size()); ++i)
    for (int c = 0; c < 3; ++c) s.x[Eigen::Index(3 * i) + c] = displacements_A[i][c];
  removeRigid(s.rigid, s.x);
  update();
}

double ElasticMotion::energy_kcal_mol() const {
  const Eigen::VectorXd stretched = solver_->x - solver_->rest;
  return 0.5 * stretched.dot(solver_->hessian * stretched);
}

double ElasticMotion::maxDisplacement_A() const {
  double out = 0.0;
  for (const Vec3& v : shown_) out = std::max(out, glm::length(v));
  return out;
}

void ElasticMotion::update() {
  const Eigen::VectorXd& x = solver_->x;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const Eigen::Index at = Eigen::Index(3 * i);
    shown_[i] = {x[at], x[at + 1], x[at + 2]};
  }
}

}  // namespace moltact
