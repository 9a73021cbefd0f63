// The motion of an elastic network under forces. Each spring has a dashpot beside it (Kelvin-Voigt), so that all modes
// relax in the same time tau: tau gamma H dx/dt = F - gamma H (x - x0). The steps are implicit (Euler); they are stable
// at every size and never gain energy: E(next) - E(now) <= F . (x(next) - x(now)). Rigid motions are left out, as if
// the molecule were held in place. One thread at a time. Units: angstrom, kcal/mol, second.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/dynamics/elastic_network.h"
#include "engine/dynamics/normal_modes.h"

namespace moltact {

struct NodeForce {
  std::uint32_t node = 0;
  Vec3 force_kcal_mol_A{0.0};
};

/// The relaxation time at which a spring in the hand, whose force arrives up to three steps late, cannot make the
/// molecule oscillate. In one step the spring moves a node by at most a quarter of the spring's stretch.
/// `compliance_A2_mol_kcal` is that of the pushed node along its softest direction.
double relaxationFor(double hand_kcal_mol_A2, double compliance_A2_mol_kcal, double step_s);

class ElasticMotion {
 public:
  /// `spring_kcal_mol_A2` (gamma) is the stiffness of each spring, `step_s` the duration of a step, both greater than
  /// zero. Factorises a sparse matrix: 10 ms for 214 nodes.
  ElasticMotion(std::shared_ptr<const ElasticNetwork> network, std::shared_ptr<const NormalModes> modes,
                double spring_kcal_mol_A2, double step_s);
  ~ElasticMotion();
  ElasticMotion(ElasticMotion&&) noexcept;

  /// tau, not negative.
  void setRelaxation(double s) { relaxation_s_ = s; }
  double relaxation_s() const { return relaxation_s_; }
  double step_s() const { return step_s_; }

  /// Lets forces excite only these modes (indices).
  void restrictTo(std::vector<std::size_t> modes);
  /// Ends the restriction.
  void useAll() { all_ = true; }
  /// The displacement at which the springs are at rest (x0), as an amplitude of each mode; empty: the structure of the
  /// file.
  void setRest(std::span<const double> amplitudes_A);

  /// One step under these forces; several may act on one node.
  void step(std::span<const NodeForce> forces);
  /// Sets the displacements, an element per node; their rigid part is removed.
  void place(std::span<const Vec3> displacements_A);

  std::span<const Vec3> displacements_A() const { return shown_; }
  /// The energy of the springs.
  double energy_kcal_mol() const;
  /// The greatest displacement of a node.
  double maxDisplacement_A() const;

 private:
  struct Vectors;
  void update();

  std::shared_ptr<const NormalModes> modes_;
  double spring_, step_s_, relaxation_s_ = 0.0;
  std::unique_ptr<Vectors> in_;
  bool all_ = true;
  std::vector<std::size_t> allowed_;
  std::vector<Vec3> shown_;
};

}  // namespace moltact
