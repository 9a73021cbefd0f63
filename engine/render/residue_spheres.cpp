#include "engine/render/residue_spheres.h"

#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr std::uint32_t kMaxOfResidue = 32, kMaxOfNone = 8;
constexpr double kSplitBeyond_A = 12.0;

// A uniform sphere has a mean square radius of 3/5 of its radius squared.
Sphere sphereOf(const Molecule& molecule, std::uint32_t begin, std::uint32_t end) {
  const double each = 1.0 / double(end - begin);
  Sphere out;
  for (std::uint32_t a = begin; a < end; ++a) out.centre_A += molecule.spheres[a].centre_A * each;
  double square = 0.0;
  for (std::uint32_t a = begin; a < end; ++a) {
    const Vec3 off = molecule.spheres[a].centre_A - out.centre_A;
    square += each * (molecule.spheres[a].radius_A * molecule.spheres[a].radius_A + glm::dot(off, off) * 5.0 / 3.0);
  }
  out.radius_A = std::sqrt(square);
  return out;
}

}  // namespace

ResidueSpheres residueSpheres(const Molecule& molecule) {
  ResidueSpheres out;
  const auto atoms = std::uint32_t(molecule.atoms.size());
  out.spheres.reserve(molecule.residues.size());
  out.first_atom.reserve(molecule.residues.size() + 1);
  for (std::uint32_t begin = 0, end = 0; begin < atoms; begin = end) {
    const Atom& first = molecule.atoms[begin];
    const std::uint32_t limit = first.residue == kNoResidue ? kMaxOfNone : kMaxOfResidue;
    for (end = begin + 1; end < atoms && end - begin < limit && molecule.atoms[end].residue == first.residue; ++end)
      if (glm::distance(molecule.spheres[end].centre_A, molecule.spheres[begin].centre_A) > kSplitBeyond_A) break;
    const Sphere sphere = sphereOf(molecule, begin, end);
    for (std::uint32_t a = begin; a < end; ++a)
      out.beyond_A = std::max(out.beyond_A, glm::distance(molecule.spheres[a].centre_A, sphere.centre_A) +
                                                molecule.spheres[a].radius_A - sphere.radius_A);
    out.first_atom.push_back(begin);
    out.spheres.push_back(sphere);
  }
  out.first_atom.push_back(atoms);
  return out;
}

std::string residueSpheresNotice(std::size_t atoms, std::size_t max_single) {
  if (atoms <= max_single) return {};
  return trf(
      "Drawn as one sphere per residue in every style, because there are more than {1} atoms ({0}). Every atom is "
      "felt.",
      numberText(double(atoms), decimals(0)), numberText(double(max_single), decimals(0)));
}

}  // namespace moltact
