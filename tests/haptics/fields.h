// Fields for tests: energy wells around atoms, added to another interaction. Forces, energies and stiffness are closed
// forms. Units: angstrom, newton of the hand.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "engine/haptics/wrapped_interaction.h"
#include "tests/haptics/without_memory.h"

namespace moltact::test {

/// The energy of one pair of hand and atom as a function of the distance, with its first and second derivative.
struct PairEnergy {
  double energy_N_A, slope_N, curvature_N_per_A;
};

/// A spring without a surface: the energy k r^2 / 2.
struct HarmonicPair {
  double k_N_per_A = 1.0;
  PairEnergy at(double r) const { return {0.5 * k_N_per_A * r * r, k_N_per_A * r, k_N_per_A}; }
};

/// The Lennard-Jones potential with its minimum -depth at `rest_A`.
struct LennardJonesPair {
  double depth_N_A = 0.2, rest_A = 3.8;
  PairEnergy at(double r) const {
    const double q6 = std::pow(rest_A / r, 6), q12 = q6 * q6;
    return {depth_N_A * (q12 - 2.0 * q6), -12.0 * depth_N_A / r * (q12 - q6),
            12.0 * depth_N_A / (r * r) * (13.0 * q12 - 7.0 * q6)};
  }
};

/// A tracker without any contact.
class OpenSpace final : public WithoutMemory<Tracker> {
 public:
  Contact step(PointA hip) noexcept override { return {.scp = hip}; }
};

/// A field of pairs with some atoms of the scene, added to `inner`. It acts on a point at the hand, or on the sites of a
/// body.
template <class Pair>
class InField final : public WrappedInteraction {
 public:
  struct Atom {
    std::int32_t atom;
    Vec3 place_A;
  };
  double offset_N_A = 0.0;               ///< added to the energy everywhere
  std::vector<Vec3> sites_A{Vec3(0.0)};  ///< relative to the hand's position, in the body's axes
  double driving = 1.0;                  ///< factor of the force where it drives the hand; values above 1 create energy

  InField(std::unique_ptr<Interaction> inner, Pair pair, std::vector<Atom> atoms)
      : WrappedInteraction(std::move(inner)), pair_(pair), atoms_(std::move(atoms)), forces_(atoms_.size()) {}

  Response respond(const PoseA& pose) noexcept override {
    Response out = inner().respond(pose);
    if (!finite(pose.place.A)) return out;
    FeltForce& sum = out.field.emplace();
    sum.energy_N_A = offset_N_A;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      forces_[k] = Vec3(0.0);
      for (const Vec3& site : sites_A) {
        const Vec3 lever = pose.orientation * site, from = pose.place.A + lever - atoms_[k].place_A;
        const double r = glm::length(from), arm = glm::length(lever);
        const PairEnergy pair = pair_.at(r);
        const Vec3 force = r > 0.0 ? from * (-pair.slope_N / r) : Vec3(0.0);
        forces_[k] += force;
        sum.torque_N_A += glm::cross(lever, force);
        sum.energy_N_A += pair.energy_N_A;
        const double across = r > 0.0 ? pair.slope_N / r : pair.curvature_N_per_A;
        const double stiffness = std::max({0.0, pair.curvature_N_per_A, across});
        sum.stiffness_N_per_A += stiffness;
        sum.rotational_stiffness_N_A += arm * (stiffness * arm + glm::length(force));
      }
      sum.force_N += forces_[k];
    }
    if (pose.place.A != last_A_)
      drives_ = glm::dot(sum.force_N, pose.place.A - std::exchange(last_A_, pose.place.A)) > 0;
    if (drives_) sum.force_N *= driving;
    return out;
  }
  std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                        std::span<AtomForce> out) const noexcept override {
    std::size_t count = inner().reactions(last, spring_N_per_A, field_share, out);
    for (std::size_t k = 0; k < atoms_.size(); ++k) out[count++] = {atoms_[k].atom, -field_share * forces_[k]};
    return count;
  }
  std::size_t maxReactionCount() const noexcept override { return inner().maxReactionCount() + atoms_.size(); }

 private:
  Pair pair_;
  std::vector<Atom> atoms_;
  std::vector<Vec3> forces_;  // on the hand, by atom, at the last pose
  Vec3 last_A_{0.0};
  bool drives_ = false;
};

using LennardJones = InField<LennardJonesPair>;
using Harmonic = InField<HarmonicPair>;

}  // namespace moltact::test
