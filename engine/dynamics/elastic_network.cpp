#include "engine/dynamics/elastic_network.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/structure/backbone.h"

namespace moltact {
namespace {

// The node of each residue by its atom; kNoAtom: none.
std::vector<std::uint32_t> nodesOfResidues(const Molecule& molecule) {
  std::vector<std::uint32_t> out(molecule.residues.size(), kNoAtom);
  for (const ProteinStretch& stretch : proteinBackbone(molecule))
    for (const AminoAcidAtoms& a : stretch) out[a.residue] = a.ca;
  for (const NucleicStretch& stretch : nucleicBackbone(molecule))
    for (const NucleotideAtoms& a : stretch) out[a.residue] = a.guide();
  for (std::size_t r = 0; r < out.size(); ++r) {
    const Residue& residue = molecule.residues[r];
    if (out[r] != kNoAtom || residue.kind == ResidueKind::Water || residue.atom_count == 0) continue;
    Vec3 centre(0.0);
    for (std::uint32_t i = 0; i < residue.atom_count; ++i)
      centre += molecule.spheres[residue.first_atom + i].centre_A / double(residue.atom_count);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = residue.first_atom; i < residue.first_atom + residue.atom_count; ++i) {
      const double away = glm::distance(molecule.spheres[i].centre_A, centre);
      if (molecule.atoms[i].atomic_number == 1 || away >= nearest) continue;
      nearest = away;
      out[r] = i;
    }
  }
  return out;
}

// The number of parts that the springs do not join.
std::size_t partCount(std::size_t nodes, std::span<const std::pair<std::uint32_t, std::uint32_t>> springs) {
  std::vector<std::uint32_t> parent(nodes);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::size_t parts = nodes;
  for (const auto& [a, b] : springs) {
    const std::uint32_t x = root(a), y = root(b);
    if (x == y) continue;
    parent[x] = y;
    --parts;
  }
  return parts;
}

}  // namespace

Expected<ElasticNetwork> ElasticNetwork::make(const Molecule& molecule, double cut_off_A,
                                              std::span<const std::uint32_t> left_out) {
  if (!(cut_off_A >= kMinCutOff_A && cut_off_A <= kMaxCutOff_A))
    return Problem{{},
                   0,
                   0,
                   trf("springs cannot be {0} long", quantityText(cut_off_A, Dimension::Length)),
                   trf("give a cut-off from {0} to {1}", quantityText(kMinCutOff_A, Dimension::Length),
                       quantityText(kMaxCutOff_A, Dimension::Length))};
  ElasticNetwork out;
  std::vector<std::uint32_t> of_residue = nodesOfResidues(molecule);
  for (const std::uint32_t i : left_out)
    if (const std::uint32_t residue = molecule.atoms[i].residue; residue != kNoResidue) of_residue[residue] = kNoAtom;
  std::vector<std::uint32_t> node_of_residue(of_residue.size(), kNoAtom);
  for (std::size_t r = 0; r < of_residue.size(); ++r) {
    if (of_residue[r] == kNoAtom) continue;
    node_of_residue[r] = std::uint32_t(out.nodes_.size());
    out.nodes_.push_back(of_residue[r]);
    out.places_.push_back(molecule.spheres[of_residue[r]].centre_A);
  }
  const std::size_t count = out.nodes_.size();
  if (count < kMinNodes)
    return Problem{{},
                   0,
                   0,
                   trf("{0} has too few residues for an elastic network: {1}", molecule.id, count),
                   trf("take a molecule of at least {0}", kMinNodes)};
  if (count > kMaxNodes)
    return Problem{{},
                   0,
                   0,
                   trf("{0} has too many residues for an elastic network: {1}", molecule.id, count),
                   trf("take a part of it with at most {0}, by 'remove' or --remove", kMaxNodes)};
  // Quadratic in the nodes: 2000 of them take 10 ms.
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a + 1; b < count; ++b) {
      const double apart = glm::distance(out.places_[a], out.places_[b]);
      if (apart <= cut_off_A && apart > 0.0) out.springs_.emplace_back(a, b);
    }
  if (const std::size_t parts = partCount(count, out.springs_); parts > 1)
    return Problem{
        {},
        0,
        0,
        trf("springs of {0} leave {1} in {2} parts", quantityText(cut_off_A, Dimension::Length), molecule.id, parts),
        tr("give a longer cut-off, or take one part alone")};
  out.node_of_.resize(molecule.atoms.size());
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    const std::uint32_t residue = molecule.atoms[i].residue;
    if (residue != kNoResidue && node_of_residue[residue] != kNoAtom) {
      out.node_of_[i] = node_of_residue[residue];
      continue;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t n = 0; n < count; ++n)
      if (const double away = glm::distance(out.places_[n], molecule.spheres[i].centre_A); away < nearest) {
        nearest = away;
        out.node_of_[i] = n;
      }
  }
  for (const std::uint32_t i : left_out) out.node_of_[i] = kNoNode;
  return out;
}

}  // namespace moltact
