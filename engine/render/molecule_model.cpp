#include "engine/render/molecule_model.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr float kPaint = 0.55f;  // weight of the paint on a touched atom

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

std::shared_ptr<const Colouring> schemeColouring(const Molecule& molecule, std::string_view name,
                                                 const ColouringInput& input) {
  if (name == "element" || name == "chain") return nullptr;
  const auto scheme = findColouringScheme(name);
  return scheme ? std::make_shared<const Colouring>(colourMolecule(molecule, **scheme, input)) : nullptr;
}

MoleculeLight lightAmong(const SharedArray<Sphere>& spheres, const std::vector<std::uint8_t>& shown) {
  std::vector<Sphere> seen;
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (shown[i]) seen.push_back(spheres[i]);
  MoleculeLight out{occlusionField(shown.empty() ? std::span<const Sphere>(spheres) : seen), {}};
  if (out.field.empty()) return out;
  out.wide.reserve(spheres.size());
  for (const Sphere& b : spheres) out.wide.push_back(out.field.wideRound(b.centre_A, b.radius_A));
  return out;
}

MoleculeModel::MoleculeModel(std::shared_ptr<const Molecule> m, std::size_t max_count)
    : molecule(std::move(m)), max_single(max_count), found(std::make_shared<FoundStructure>()) {
  if (molecule->atoms.size() > max_single) {
    ResidueSpheres residues = residueSpheres(*molecule);
    first_atom = std::move(residues.first_atom);
    beyond_A = residues.beyond_A;
    spheres = std::move(residues.spheres);
  } else {
    spheres = molecule->spheres;
  }
  blocks = SphereBlocks(spheres);
  paint({});
  measure();
}

void MoleculeModel::measure() {
  Vec3 low(0.0), high(0.0);
  if (!spheres.empty()) low = high = spheres[0].centre_A;
  for (const Sphere& b : spheres) {
    low = glm::min(low, b.centre_A);
    high = glm::max(high, b.centre_A);
  }
  middle_A = 0.5 * (low + high);
  reach_A = 0.0;
  for (const Sphere& b : spheres) reach_A = std::max(reach_A, glm::distance(b.centre_A, middle_A) + b.radius_A);
  reach_A += beyond_A;
}

bool MoleculeModel::moveTo(const std::shared_ptr<const Molecule>& moved) {
  if (byResidue() || !moved || !moved->sameTopology(*molecule)) return false;
  molecule = moved;
  spheres = moved->spheres;
  blocks.refit(spheres);
  measure();
  return true;
}

std::uint32_t MoleculeModel::sphereOf(std::uint32_t atom) const {
  if (!byResidue()) return atom;
  return std::uint32_t(std::upper_bound(first_atom.begin(), first_atom.end(), atom) - first_atom.begin()) - 1;
}

std::vector<std::uint32_t> MoleculeModel::spheresOf(std::vector<std::uint32_t> of) const {
  if (!byResidue()) return of;
  std::erase_if(of, [&](std::uint32_t a) { return a >= atoms(); });
  for (std::uint32_t& a : of) a = sphereOf(a);
  of.erase(std::unique(of.begin(), of.end()), of.end());
  return of;
}

std::vector<std::uint8_t> MoleculeModel::shownSpheres(std::vector<std::uint8_t> shown) const {
  if (!byResidue()) return shown;
  std::vector<std::uint8_t> out(spheres.size());
  for (std::size_t sphere = 0; sphere < out.size(); ++sphere)
    out[sphere] = std::any_of(shown.begin() + first_atom[sphere], shown.begin() + first_atom[sphere + 1],
                              [](std::uint8_t s) { return s != 0; });
  return out;
}

std::vector<std::uint8_t> MoleculeModel::shownWithout(const AtomList& hidden_atoms) const {
  if (!hidden_atoms) return {};
  std::vector<std::uint8_t> shown(atoms(), 1);
  for (const std::uint32_t a : *hidden_atoms)
    if (a < shown.size()) shown[a] = 0;
  return shownSpheres(std::move(shown));
}

void MoleculeModel::lightBy(MoleculeLight found_light) {
  light = std::move(found_light);
  ++lit;
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
  if (!byResidue()) return;
  // A residue gets the mean of its atoms' colours.
  for (std::size_t sphere = 0; sphere < spheres.size(); ++sphere) {
    const std::uint32_t begin = first_atom[sphere], end = first_atom[sphere + 1];
    glm::vec3 sum(0.0f);
    for (std::uint32_t a = begin; a < end; ++a)
      sum += glm::vec3(colour[a] & 255u, colour[a] >> 8 & 255u, colour[a] >> 16 & 255u);
    colour[sphere] = packColour(sum / (255.0f * float(end - begin)));
  }
  colour.resize(spheres.size());
  colour.shrink_to_fit();
}

std::vector<std::uint32_t> nearestAtoms(const MoleculeModel& model, PointA place, double probe_A, double gap_A,
                                        std::size_t max_count) {
  std::vector<std::pair<double, std::uint32_t>> found;
  model.visitAtomsNear(place.A, probe_A + gap_A, [&](std::uint32_t i, const Sphere& b) {
    const double gap = glm::length(b.centre_A - place.A) - b.radius_A - probe_A;
    if (gap <= gap_A) found.emplace_back(gap, i);
  });
  std::sort(found.begin(), found.end());
  std::vector<std::uint32_t> atoms;
  for (std::size_t k = 0; k < std::min(max_count, found.size()); ++k) atoms.push_back(found[k].second);
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
