#include "engine/render/residue_balls.h"

#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr std::uint32_t kMostOfResidue = 32, kMostOfNone = 8;
constexpr double kSplitBeyond_A = 12.0;

// The balls have mean square radii of 3/5 of their radius squared.
Ball ballOf(const Molecule& molecule, std::uint32_t begin, std::uint32_t end) {
  const double each = 1.0 / double(end - begin);
  Ball out;
  for (std::uint32_t a = begin; a < end; ++a) out.centre_A += molecule.balls[a].centre_A * each;
  double square = 0.0;
  for (std::uint32_t a = begin; a < end; ++a) {
    const Vec3 off = molecule.balls[a].centre_A - out.centre_A;
    square += each * (molecule.balls[a].radius_A * molecule.balls[a].radius_A + glm::dot(off, off) * 5.0 / 3.0);
  }
  out.radius_A = std::sqrt(square);
  return out;
}

}  // namespace

ResidueBalls residueBalls(const Molecule& molecule) {
  ResidueBalls out;
  const auto atoms = std::uint32_t(molecule.atoms.size());
  out.balls.reserve(molecule.residues.size());
  out.first_atom.reserve(molecule.residues.size() + 1);
  for (std::uint32_t begin = 0, end = 0; begin < atoms; begin = end) {
    const Atom& first = molecule.atoms[begin];
    const std::uint32_t most = first.residue == kNoResidue ? kMostOfNone : kMostOfResidue;
    for (end = begin + 1; end < atoms && end - begin < most && molecule.atoms[end].residue == first.residue; ++end)
      if (glm::distance(molecule.balls[end].centre_A, molecule.balls[begin].centre_A) > kSplitBeyond_A) break;
    const Ball ball = ballOf(molecule, begin, end);
    for (std::uint32_t a = begin; a < end; ++a)
      out.beyond_A = std::max(out.beyond_A, glm::distance(molecule.balls[a].centre_A, ball.centre_A) +
                                                molecule.balls[a].radius_A - ball.radius_A);
    out.first_atom.push_back(begin);
    out.balls.push_back(ball);
  }
  out.first_atom.push_back(atoms);
  return out;
}

std::string residueBallsNotice(std::size_t atoms, std::size_t most_single) {
  if (atoms <= most_single) return {};
  return trf(
      "Drawn as one ball for each residue, in every style, since {0} atoms are more than {1}. Every atom is felt.",
      numberText(double(atoms), decimals(0)), numberText(double(most_single), decimals(0)));
}

}  // namespace moltact
