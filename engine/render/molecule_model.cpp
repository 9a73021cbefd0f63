#include "engine/render/molecule_model.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr float kPaint = 0.55f;  // the share of the paint on an atom that was touched

glm::vec3 colourOf8(const Rgb8& c) { return glm::vec3(c[0], c[1], c[2]) / 255.0f; }

}  // namespace

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
  paint({});
  middle_A = 0.5 * (scene.low_A() + scene.high_A());
  for (const Ball& b : scene.balls()) reach_A = std::max(reach_A, glm::length(b.centre_A - middle_A) + b.radius_A);
}

void MoleculeModel::shade(std::shared_ptr<const std::vector<std::uint32_t>> hidden_atoms) {
  hidden = std::move(hidden_atoms);
  std::vector<Ball> seen;
  std::size_t next = 0;
  for (std::uint32_t i = 0; hidden && i < scene.size(); ++i)
    if (next < hidden->size() && (*hidden)[next] == i)
      ++next;
    else
      seen.push_back(scene[i]);
  occlusion = occlusionField(hidden ? std::span<const Ball>(seen) : scene.balls());
  wide.clear();
  if (occlusion.empty()) return;
  wide.reserve(scene.size());
  for (const Ball& b : scene.balls()) wide.push_back(occlusion.wideRound(b.centre_A, b.radius_A));
}

std::vector<std::uint32_t> atomColours(const Molecule& molecule, const AtomPaint& use) {
  const bool schemed = use.colouring && use.colouring->of_atom.size() == molecule.atoms.size();
  const auto colourOf = [&](std::size_t i) {
    if (schemed) return colourOf8(use.colouring->of_atom[i]);
    const Atom& a = molecule.atoms[i];
    const std::optional<std::uint32_t> chain = use.by == ColourBy::Chain ? colouredChain(molecule, a) : std::nullopt;
    return chain ? chainColour(*chain) : elementColour(a.atomic_number, use.elements);
  };
  std::vector<glm::vec3> now(molecule.atoms.size());
  for (std::size_t i = 0; i < now.size(); ++i) now[i] = colourOf(i);
  if (use.marks)
    for (const OwnColour& mark : *use.marks)
      for (const std::uint32_t i : mark.atoms)
        if (i < now.size()) now[i] = colourOf8(mark.colour);
  if (use.touched)
    for (const std::uint32_t i : *use.touched)
      if (i < now.size()) now[i] = glm::mix(now[i], use.touched_colour, kPaint);
  std::vector<std::uint32_t> out;
  out.reserve(now.size());
  for (const glm::vec3& c : now) out.push_back(packColour(c));
  return out;
}

void MoleculeModel::paint(AtomPaint with) {
  paint_used = std::move(with);
  ++painted;
  AtomPaint shown = paint_used;
  shown.elements = shownColours(shown.elements, molecule->atoms.size());
  colour = atomColours(*molecule, shown);
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

std::uint32_t paintedColour(std::uint32_t packed, const Colour& paint) {
  const glm::vec3 own = glm::vec3(packed & 255u, packed >> 8 & 255u, packed >> 16 & 255u) / 255.0f;
  return (packColour(glm::mix(own, paint, kPaint)) & 0x00FFFFFFu) | (packed & 0xFF000000u);
}

std::uint32_t packColour(const glm::vec3& colour, float alpha) {
  const auto byte = [](float v) { return std::uint32_t(std::lround(std::clamp(v, 0.0f, 1.0f) * 255)); };
  return byte(colour.x) | byte(colour.y) << 8 | byte(colour.z) << 16 | byte(alpha) << 24;
}

}  // namespace moltact
