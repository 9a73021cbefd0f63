#include "engine/haptics/field/minimise_pose.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

using Six = std::array<double, 6>;

double dot(const Six& a, const Six& b) noexcept {
  double out = 0.0;
  for (std::size_t k = 0; k < 6; ++k) out += a[k] * b[k];
  return out;
}

double largest(const Six& way) noexcept {
  return std::max(std::hypot(way[0], way[1], way[2]), std::hypot(way[3], way[4], way[5]));
}

}  // namespace

double radiusOfGyration_A(std::span<const PairAtom> body) noexcept {
  double sum = 0.0;
  for (const PairAtom& atom : body) sum += glm::dot(atom.centre_A, atom.centre_A);
  return body.empty() ? 1.0 : std::max(1.0, std::sqrt(sum / double(body.size())));
}

PoseMinimiser::PoseMinimiser(PairSum& sum, double gyration_A) noexcept : sum_(sum), gyration_A_(gyration_A) {}

Six PoseMinimiser::gradient(const PairEnergy& energy) const noexcept {
  const Vec3 f = -energy.force_kcal_mol_A, t = -energy.torque_kcal_mol / gyration_A_;
  return {f.x, f.y, f.z, t.x, t.y, t.z};
}

PoseA PoseMinimiser::moved(const Six& way, double length) const noexcept {
  const Vec3 shift = length * Vec3(way[0], way[1], way[2]);
  const Vec3 turn = length / gyration_A_ * Vec3(way[3], way[4], way[5]);
  const double angle = glm::length(turn);
  const Quat rotation = angle > 0.0 ? glm::angleAxis(angle, turn / angle) : kNoRotation;
  return {{pose_.place.A + shift}, glm::normalize(rotation * pose_.orientation)};
}

// The inverse curvature before anything is known of it: the largest step down the gradient.
void PoseMinimiser::forget() noexcept {
  const double steepest = std::max(largest(gradient_), 1e-12);
  inverse_ = {};
  for (std::size_t k = 0; k < 6; ++k) inverse_[k][k] = 0.5 * kMaxStep_A / steepest;
  fresh_ = true;
}

void PoseMinimiser::choose() noexcept {
  for (std::size_t k = 0; k < 6; ++k) way_[k] = -dot(inverse_[k], gradient_);
  if (!(dot(way_, gradient_) < 0.0)) {
    forget();
    for (std::size_t k = 0; k < 6; ++k) way_[k] = -inverse_[k][k] * gradient_[k];
  }
  length_ = std::min(1.0, kMaxStep_A / std::max(largest(way_), 1e-300));
}

void PoseMinimiser::start(const PoseA& pose) noexcept {
  pose_ = pose;
  energy_ = sum_.at(pose);
  gradient_ = gradient(energy_);
  steps_ = 0;
  converged_ = !std::isfinite(energy_.energy.felt_kcal_mol) || largest(gradient_) < kForceDone_kcal_mol_A;
  forget();
  choose();
}

// H <- (1 - s y'/y's) H (1 - y s'/y's) + s s'/y's.
void PoseMinimiser::learn(const Six& way, const Six& change) noexcept {
  const double along = dot(way, change);
  if (!(along > 1e-12)) return;  // no curvature upwards: a wall's bound or a saddle
  Six turned;
  for (std::size_t k = 0; k < 6; ++k) turned[k] = dot(inverse_[k], change);
  const double factor = (1.0 + dot(change, turned) / along) / along;
  for (std::size_t k = 0; k < 6; ++k)
    for (std::size_t l = 0; l < 6; ++l)
      inverse_[k][l] += factor * way[k] * way[l] - (way[k] * turned[l] + turned[k] * way[l]) / along;
  fresh_ = false;
}

bool PoseMinimiser::step() noexcept {
  if (converged_) return false;
  ++steps_;
  const PoseA trial = moved(way_, length_);
  const PairEnergy found = sum_.at(trial);
  constexpr double kEnough = 1e-4;  // share of the fall that the slope promises (Armijo)
  const double promised = length_ * dot(way_, gradient_);
  if (found.energy.felt_kcal_mol <= energy_.energy.felt_kcal_mol + kEnough * promised) {
    Six done, change;
    const Six next = gradient(found);
    for (std::size_t k = 0; k < 6; ++k) done[k] = length_ * way_[k], change[k] = next[k] - gradient_[k];
    pose_ = trial, energy_ = found, gradient_ = next;
    converged_ = largest(gradient_) < kForceDone_kcal_mol_A;
    learn(done, change);
    choose();
  } else if (length_ * largest(way_) > kStepDone_A) {
    length_ *= 0.3;
  } else if (!fresh_) {
    forget();
    choose();
  } else {
    converged_ = true;
  }
  return !converged_;
}

}  // namespace moltact
