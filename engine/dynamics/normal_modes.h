// The normal modes and the compliance of an elastic network. Computed on request, on a background thread: 0.2 s for 214
// nodes. Units: angstrom, kcal/mol, kelvin. Eigenvalues are those of the network's Hessian with springs of stiffness 1;
// times the spring's stiffness they are in kcal/mol/A^2. A mode has unit length over all nodes.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "engine/core/problem.h"
#include "engine/dynamics/elastic_network.h"

namespace moltact {

/// kT at 300 K.
inline constexpr double kThermalEnergy_kcal_mol = 0.5961612;

/// The number of modes that an elastic molecule has in the window.
inline constexpr std::size_t kElasticModes = 20;

struct NormalModes {
  std::size_t nodes = 0;
  std::vector<double> eigenvalues;  ///< ascending, without the six rigid motions
  std::vector<Vec3> vectors;        ///< mode after mode, a displacement per node

  std::size_t count() const { return eigenvalues.size(); }
  std::span<const Vec3> mode(std::size_t k) const { return std::span(vectors).subspan(k * nodes, nodes); }
};

/// Computes the `count` lowest modes of deformation (1 to 3 nodes - 6; fewer if the network has fewer). Lanczos
/// iteration on the inverse of the Hessian (Spectra, Eigen). Returns a Problem if the network has a further motion
/// without stiffness, such as a hinge.
Expected<NormalModes> lowestModes(const ElasticNetwork& network, std::size_t count);

/// The displacement of each node under unit forces on it, for springs of stiffness 1: its 3 x 3 block of the Hessian's
/// pseudo-inverse (all modes). `progress` is called with the finished fraction and returns false to cancel, which
/// returns an empty vector.
std::vector<glm::dmat3> nodeCompliances(const ElasticNetwork& network,
                                        const std::function<bool(double)>& progress = {});

/// The mean square displacement of a node in units of kT divided by the spring stiffness: the trace of its block.
inline double fluctuation(const glm::dmat3& compliance) {
  return compliance[0][0] + compliance[1][1] + compliance[2][2];
}

/// The compliance of a node along its softest direction.
double greatestCompliance(const glm::dmat3& compliance);

/// The stiffness of the springs (kcal/mol/A^2) for which the mean displacement factor at 300 K equals that of the file,
/// B = 8 pi^2/3 <u^2>; 0 if the file has none.
double springFromDisplacementFactors(const ElasticNetwork& network, const Molecule& molecule,
                                     std::span<const glm::dmat3> compliances);

/// The correlation coefficient of compliances and displacement factors; 0 if either is constant.
double correlationWithDisplacementFactors(const ElasticNetwork& network, const Molecule& molecule,
                                          std::span<const glm::dmat3> compliances);

/// The overlap of each mode with a change of structure (Marques & Sanejouand, Proteins 23, 557, 1995): the absolute
/// cosine of the angle between the two. `change_A` has an element per node; its rigid part must have been removed by superposition.
std::vector<double> modeOverlaps(const NormalModes& modes, std::span<const Vec3> change_A);

}  // namespace moltact
