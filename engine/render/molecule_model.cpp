#include "engine/render/molecule_model.h"

#include <algorithm>
#include <cmath>

namespace moltact {

std::optional<std::uint32_t> colouredChain(const Molecule& molecule, const Atom& atom) {
  if (atom.residue == kNoResidue) return std::nullopt;
  const Residue& r = molecule.residues[atom.residue];
  if (r.kind != ResidueKind::AminoAcid && r.kind != ResidueKind::Nucleotide) return std::nullopt;
  return r.chain;
}

ColourBy usualColourBy(const Molecule& molecule) {
  std::optional<std::uint32_t> first;
  for (const Residue& r : molecule.residues) {
    if (r.kind != ResidueKind::AminoAcid && r.kind != ResidueKind::Nucleotide) continue;
    if (first && *first != r.chain) return ColourBy::Chain;
    first = r.chain;
  }
  return ColourBy::Element;
}

std::shared_ptr<const Colouring> schemeColouring(const Molecule& molecule, std::string_view name) {
  if (name == "element" || name == "chain") return nullptr;
  const auto scheme = findColouringScheme(name);
  return scheme ? std::make_shared<const Colouring>(colourMolecule(molecule, **scheme)) : nullptr;
}

MoleculeModel::MoleculeModel(std::shared_ptr<const Molecule> m)
    : molecule(std::move(m)), scene(molecule->balls()), blocks(scene.balls()) {
  paint(elements, colour_by, nullptr);
  occlusion = occlusionField(scene.balls());
  if (!occlusion.empty()) {
    wide.reserve(scene.size());
    for (const Ball& b : scene.balls()) wide.push_back(occlusion.wideRound(b.centre_A, b.radius_A));
  }
  middle_A = 0.5 * (scene.low_A() + scene.high_A());
  for (const Ball& b : scene.balls()) reach_A = std::max(reach_A, glm::length(b.centre_A - middle_A) + b.radius_A);
}

void MoleculeModel::paint(ElementColours wanted, ColourBy by, std::shared_ptr<const Colouring> by_scheme) {
  elements = wanted;
  colour_by = by;
  colouring = std::move(by_scheme);
  ++painted;
  const ElementColours used = shownColours(wanted, molecule->atoms.size());
  colour.clear();
  colour.reserve(molecule->atoms.size());
  if (colouring && colouring->of_atom.size() == molecule->atoms.size()) {
    for (const Rgb8& c : colouring->of_atom) colour.push_back(packColour(glm::vec3(c[0], c[1], c[2]) / 255.0f));
    return;
  }
  for (const Atom& a : molecule->atoms) {
    const std::optional<std::uint32_t> chain = by == ColourBy::Chain ? colouredChain(*molecule, a) : std::nullopt;
    colour.push_back(packColour(chain ? chainColour(*chain) : elementColour(a.atomic_number, used)));
  }
}

std::vector<std::uint32_t> nearestAtoms(const BallScene& scene, PointA place, double probe_A, double gap_A,
                                        std::size_t most) {
  std::vector<std::pair<double, std::uint32_t>> found;
  scene.visitNear(place.A, probe_A + gap_A, [&](std::uint32_t i, const Ball& b) {
    const double gap = glm::length(b.centre_A - place.A) - b.radius_A - probe_A;
    if (gap <= gap_A) found.emplace_back(gap, i);
  });
  std::sort(found.begin(), found.end());
  std::vector<std::uint32_t> atoms;
  for (std::size_t k = 0; k < std::min(most, found.size()); ++k) atoms.push_back(found[k].second);
  return atoms;
}

std::uint32_t packColour(const glm::vec3& colour, float alpha) {
  const auto byte = [](float v) { return std::uint32_t(std::lround(std::clamp(v, 0.0f, 1.0f) * 255)); };
  return byte(colour.x) | byte(colour.y) << 8 | byte(colour.z) << 16 | byte(alpha) << 24;
}

}  // namespace moltact
