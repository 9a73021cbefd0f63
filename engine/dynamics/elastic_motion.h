// The motion of an elastic network under forces: overdamped, zeta dx/dt = F - gamma H (x - x0), by implicit Euler
// steps, which are stable at every step and never gain energy: E(next) - E(now) <= F . (x(next) - x(now)). Rigid motions
// are left out, as if the molecule were held in place. One thread at a time. Units: angstrom, kcal/mol, second.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/dynamics/elastic_network.h"
#include "engine/dynamics/normal_modes.h"

namespace moltact {

/// The friction of each node at which a spring of this stiffness in the hand, whose force arrives up to three steps late,
/// cannot make the molecule oscillate: in one step the spring moves a node by at most a fifth of its own stretch.
constexpr double frictionFor(double hand_kcal_mol_A2, double step_s) { return 5.0 * hand_kcal_mol_A2 * step_s; }

struct NodeForce {
  std::uint32_t node = 0;
  Vec3 force_kcal_mol_A{0.0};
};

class ElasticMotion {
 public:
  /// `spring_kcal_mol_A2` (gamma) is the stiffness of each spring, `friction_kcal_s_mol_A2` (zeta) the friction of each
  /// node (force over speed), `step_s` the duration of a step; all greater than zero. Factorises a sparse matrix: 10 ms
  /// for 214 nodes.
  ElasticMotion(std::shared_ptr<const ElasticNetwork> network, std::shared_ptr<const NormalModes> modes,
                double spring_kcal_mol_A2, double friction_kcal_s_mol_A2, double step_s);
  ~ElasticMotion();

  /// Sets another friction; factorises again.
  void setFriction(double friction_kcal_s_mol_A2);
  double friction_kcal_s_mol_A2() const { return friction_; }

  /// Restricts the motion to some modes, by index; the present displacement is projected on them. `all` ends the
  /// restriction.
  void restrictTo(std::span<const std::size_t> modes);
  void useAll();
  /// The displacement at which the springs are at rest (x0), as an amplitude of each mode; empty: that of the file.
  void setRest(std::span<const double> amplitudes_A);

  /// One step under these forces; several may act on one node.
  void step(std::span<const NodeForce> forces);
  /// Sets the displacements, an element per node, without their rigid part. Not with a restriction.
  void place(std::span<const Vec3> displacements_A);

  std::span<const Vec3> displacements_A() const { return shown_; }
  /// The energy of the springs, kcal/mol.
  double energy_kcal_mol() const;
  /// The greatest displacement of a node.
  double maxDisplacement_A() const;

 private:
  struct Solver;
  void update();

  std::shared_ptr<const ElasticNetwork> network_;
  std::shared_ptr<const NormalModes> modes_;
  double spring_, friction_, step_;
  std::unique_ptr<Solver> solver_;
  bool all_ = true;
  std::vector<std::size_t> allowed_;
  std::vector<Vec3> shown_;
};

}  // namespace moltact
