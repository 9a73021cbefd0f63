// The hand holds atoms of the scene by a spring between itself and their centre of mass: a simulated molecule follows. The
// spring has the stiffness of the felt spring and replaces the contact. The distance at the start counts as no stretch.
// Haptic thread but for the constructor. Units: angstrom, newton of the hand.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/haptics/sphere_motion.h"
#include "engine/haptics/wrapped_interaction.h"

namespace moltact {

class PullSpring final : public WrappedInteraction {
 public:
  /// `inner` is not felt meanwhile; it follows the motion and the probe's size. `atoms`: at least one, indices of
  /// `spheres`, which are those of the scene at this moment. `masses`: of these atoms, in any unit; empty: equal ones.
  PullSpring(std::unique_ptr<Interaction> inner, std::vector<std::uint32_t> atoms, std::span<const Sphere> spheres,
             std::span<const double> masses = {})
      : WrappedInteraction(std::move(inner)), atoms_(std::move(atoms)), shares_(sharesOf(masses, atoms_.size())) {
    for (std::size_t k = 0; k < atoms_.size(); ++k) at_rest_A_ += shares_[k] * spheres[atoms_[k]].centre_A;
    centre_A_ = at_rest_A_;
  }

  /// The share of each of `count` atoms in their mass; equal shares without masses, or where these have no positive sum.
  static std::vector<double> sharesOf(std::span<const double> masses, std::size_t count) {
    std::vector<double> out(count, 1.0 / double(std::max<std::size_t>(count, 1)));
    double sum = 0.0;
    for (const double mass : masses) sum += mass;
    if (masses.size() == count && sum > 0.0)
      for (std::size_t k = 0; k < count; ++k) out[k] = masses[k] / sum;
    return out;
  }

  Response respond(const PoseA& pose) noexcept override {
    Response out;
    if (!finite(pose.place.A)) {
      out.contact.scp = {centre_A_};
      out.contact.fault = Fault::NotFinite;
      return out;
    }
    if (std::exchange(begins_, false)) offset_A_ = pose.place.A - centre_A_;
    out.contact.scp = pose.place;
    out.contact.displacement_A = centre_A_ + offset_A_ - pose.place.A;
    out.contact.energy_A2 = 0.5 * glm::dot(out.contact.displacement_A, out.contact.displacement_A);
    return out;
  }
  void reset() noexcept override {
    inner().reset();
    begins_ = true;
  }
  bool setMotion(const SphereMotion* motion) noexcept override {
    inner().setMotion(motion);
    motion_ = motion;
    place(0.0);
    return true;
  }
  void advanceTo(double fraction) noexcept override {
    inner().advanceTo(fraction);
    place(fraction);
  }
  std::size_t maxReactionCount() const noexcept override { return atoms_.size(); }
  std::size_t reactions(const Response& last, double spring_N_per_A, double,
                        std::span<AtomForce> out) const noexcept override {
    const std::size_t count = std::min(out.size(), atoms_.size());
    const Vec3 whole = last.contact.displacement_A * -spring_N_per_A;
    for (std::size_t k = 0; k < count; ++k) out[k] = {std::int32_t(atoms_[k]), whole * shares_[k]};
    return count;
  }

 private:
  void place(double fraction) noexcept {
    if (!motion_) {
      centre_A_ = at_rest_A_;
      return;
    }
    centre_A_ = Vec3(0.0);
    for (std::size_t k = 0; k < atoms_.size(); ++k)
      if (atoms_[k] < motion_->size()) centre_A_ += shares_[k] * (*motion_)[atoms_[k]].at(fraction).centre_A;
  }

  std::vector<std::uint32_t> atoms_;
  std::vector<double> shares_;  // of each atom in the mass
  Vec3 at_rest_A_{0.0}, centre_A_{0.0}, offset_A_{0.0};
  const SphereMotion* motion_ = nullptr;
  bool begins_ = true;
};

}  // namespace moltact
