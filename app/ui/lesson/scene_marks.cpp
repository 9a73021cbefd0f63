#include "app/ui/lesson/scene_marks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/language/catalogue.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/render/molecule_model.h"
#include "engine/structure/bonds.h"
#include "engine/structure/colour_sight.h"
#include "engine/structure/hydrogen_bonds.h"
#include "engine/structure/measure.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxLabels = 5000;  // upper limit for a scene
// The colours of marks without a colour, in this order.
constexpr const char* kMarkColours[] = {"teal", "magenta", "olive", "sky", "rose", "mint", "violet", "brown"};

std::vector<std::uint32_t> atomsOf(const Selection& selection, const Molecule& molecule) {
  if (selection.given()) return selection.select(molecule);
  std::vector<std::uint32_t> all(molecule.atoms.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

struct Middle {
  PointA at;
  double reach_A = 0.0;  // distance of the outermost surface of the atoms
};

Middle middleOf(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
  Middle middle;
  for (const std::uint32_t i : atoms) middle.at.A += molecule.spheres[i].centre_A / double(atoms.size());
  for (const std::uint32_t i : atoms)
    middle.reach_A = std::max(middle.reach_A,
                              glm::distance(molecule.spheres[i].centre_A, middle.at.A) + molecule.spheres[i].radius_A);
  return middle;
}

// The anchor of a residue's name: its alpha carbon or the sugar's C1', else its centre.
std::uint32_t residueAnchor(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
  for (const std::uint32_t i : atoms)
    if (const std::string_view name = molecule.atoms[i].nameText(); name == "CA" || name == "C1'") return i;
  return atoms[atoms.size() / 2];
}

void addWordLabels(const MarkSpec& spec, const Molecule& molecule, std::vector<Annotations::Label>& labels) {
  const std::vector<std::uint32_t> atoms = atomsOf(spec.atoms, molecule);
  std::map<std::uint32_t, std::vector<std::uint32_t>> groups;  // the atoms of each residue or chain
  for (const std::uint32_t i : atoms) {
    if (labels.size() >= kMaxLabels) return;
    const PlacedAtom a = molecule.at(i);
    if (spec.word == "atom" || a.residue == kNoResidue)
      labels.push_back({.at = a.position, .clear_A = a.radius_A, .text = atomLabel(molecule, i)});
    else
      groups[spec.word == "chain" ? molecule.residues[a.residue].chain : a.residue].push_back(i);
  }
  for (const auto& [group, members] : groups) {
    if (labels.size() >= kMaxLabels) return;
    if (spec.word == "chain") {
      if (molecule.chains[group].name.string().empty()) continue;
      const Middle middle = middleOf(molecule, members);
      labels.push_back({.at = middle.at,
                        .clear_A = middle.reach_A,
                        .text = trf("chain {0}", molecule.chains[group].name.string()),
                        .always = true});
      continue;
    }
    const std::uint32_t anchor = residueAnchor(molecule, members);
    const AtomWords words = molecule.words(anchor);
    labels.push_back({.at = PointA{molecule.spheres[anchor].centre_A},
                      .clear_A = middleOf(molecule, members).reach_A,
                      .text = words.residue.empty() ? words.atom : words.residue});
  }
}

void addOwnLabel(const MarkSpec& spec, const Molecule& molecule, bool arrow, std::vector<Annotations::Label>& labels) {
  const std::vector<std::uint32_t> atoms = atomsOf(spec.atoms, molecule);
  if (atoms.empty()) return;
  const Middle middle = middleOf(molecule, atoms);
  labels.push_back({.at = middle.at, .clear_A = middle.reach_A, .text = spec.name, .arrow = arrow, .always = true});
}

// The caption below each of two molecules side by side, or its name.
void addCaptions(const SceneSpec& scene, const Molecule& molecule, std::vector<Annotations::Label>& labels) {
  if (molecule.beside_from == 0) return;
  const std::size_t ends[] = {0, molecule.beside_from, molecule.atoms.size()};
  Vec3 low[2], high[2];
  for (int k = 0; k < 2; ++k) {
    low[k] = Vec3(1e300);
    high[k] = Vec3(-1e300);
    for (std::size_t i = ends[k]; i < ends[k + 1]; ++i) {
      const Sphere& b = molecule.spheres[i];
      low[k] = glm::min(low[k], b.centre_A - b.radius_A);
      high[k] = glm::max(high[k], b.centre_A + b.radius_A);
    }
  }
  const double bottom = std::min(low[0].y, low[1].y);
  for (int k = 0; k < 2; ++k) {
    const std::string name = scene.captions.size() == 2 ? scene.captions[std::size_t(k)]
                             : k                        ? molecule.beside_id
                                                        : molecule.id;
    const Vec3 middle = 0.5 * (low[k] + high[k]);
    if (!name.empty())
      labels.push_back(
          {.at = {Vec3(middle.x, bottom, middle.z)}, .clear_A = high[k].z - low[k].z, .text = name, .always = true});
  }
}

Rgb8 colour8(const Colour& colour) {
  Rgb8 out;
  for (int k = 0; k < 3; ++k) out[std::size_t(k)] = static_cast<std::uint8_t>(std::lround(255.0f * colour[k]));
  return out;
}

// The colours of the drawn atoms without a mark. Empty for a gradient, or if so many chains have repeating colours that
// no shade differs from all of them.
std::vector<Rgb8> coloursBeside(const SceneSpec& scene, const Molecule& molecule, const std::vector<OwnColour>& marks) {
  constexpr std::size_t kMax = 24;
  if (scene.colour == "chain" && molecule.chains.size() > kChainColours) return {};
  if (scene.colour == "potential") return {};
  std::vector<bool> without(molecule.atoms.size(), true);
  for (const OwnColour& mark : marks)
    for (const std::uint32_t a : mark.atoms) without[a] = false;
  for (const std::uint32_t a : hiddenAtoms(scene, molecule)) without[a] = false;
  AtomPaint paint;
  paint.elements = shownColours(ElementColours::Customary, molecule.atoms.size());
  if (scene.colour == "chain") paint.by = ColourBy::Chain;
  paint.colouring = schemeColouring(molecule, scene.colour);
  const std::vector<std::uint32_t> packed = atomColours(molecule, paint);
  std::set<Rgb8> found;
  for (std::size_t a = 0; a < packed.size() && found.size() <= kMax; ++a)
    if (without[a])
      found.insert({std::uint8_t(packed[a]), std::uint8_t(packed[a] >> 8), std::uint8_t(packed[a] >> 16)});
  if (found.size() > kMax) return {};
  return {found.begin(), found.end()};
}

}  // namespace

std::string atomLabel(const Molecule& molecule, std::uint32_t atom) {
  const Atom& a = molecule.atoms[atom];
  if (a.residue != kNoResidue) return molecule.words(atom).atom;
  return a.nameText().empty() ? std::to_string(atom) : std::string(a.nameText());
}

Annotations::Measure measureBetween(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
  Annotations::Measure measure;
  for (const std::uint32_t i : atoms) measure.places.push_back(PointA{molecule.spheres[i].centre_A});
  measure.text = measureText(measure.places);
  return measure;
}

std::shared_ptr<const Annotations> annotationsOf(const SceneSpec& scene, const Molecule& molecule) {
  auto out = std::make_shared<Annotations>();
  addCaptions(scene, molecule, out->labels);
  for (const MarkSpec& spec : scene.labels)
    spec.name.empty() ? addWordLabels(spec, molecule, out->labels) : addOwnLabel(spec, molecule, false, out->labels);
  for (const MarkSpec& spec : scene.arrows) addOwnLabel(spec, molecule, true, out->labels);
  for (const PlacesSpec& spec : scene.measures) {
    Annotations::Measure measure;
    for (const Selection& place : spec.atoms) {
      const std::vector<std::uint32_t> atoms = place.select(molecule);
      if (!atoms.empty()) measure.places.push_back(middleOf(molecule, atoms).at);
    }
    if (measure.places.size() != spec.atoms.size()) continue;
    measure.text = measureText(measure.places);
    out->measures.push_back(std::move(measure));
  }
  if (scene.hydrogen_bonds.given()) {
    const std::vector<std::uint32_t> of = scene.hydrogen_bonds.select(molecule);
    const auto among = [&](std::uint32_t i) { return std::binary_search(of.begin(), of.end(), i); };
    const BondTable bonds(molecule.atoms.size(), findBonds(molecule));
    for (const HydrogenBond& b : findHydrogenBonds(molecule, bonds))
      if (among(b.donor) || among(b.acceptor))
        out->bonds.emplace_back(PointA{molecule.spheres[b.donor].centre_A},
                                PointA{molecule.spheres[b.acceptor].centre_A});
  }
  if (out->labels.empty() && out->measures.empty() && out->bonds.empty()) return nullptr;
  return out;
}

std::shared_ptr<const std::vector<OwnColour>> marksOf(const SceneSpec& scene, const Molecule& molecule) {
  if (scene.marks.empty()) return nullptr;
  auto out = std::make_shared<std::vector<OwnColour>>();
  std::size_t next = 0;
  const auto taken = [&](std::string_view colour) {
    return std::any_of(scene.marks.begin(), scene.marks.end(), [&](const MarkSpec& m) { return m.word == colour; });
  };
  std::vector<Rgb8> colours;
  for (const MarkSpec& spec : scene.marks) {
    std::string_view colour = spec.word;
    if (colour.empty()) {
      while (next + 1 < std::size(kMarkColours) && taken(kMarkColours[next])) ++next;
      colour = kMarkColours[next++ % std::size(kMarkColours)];
    }
    if (const Expected<Rgb8> rgb = parseColour(colour)) {
      out->push_back({.atoms = atomsOf(spec.atoms, molecule), .colour = *rgb, .name = spec.name});
      colours.push_back(*rgb);
    }
  }
  const Rgb8 targets[] = {colour8(darkTheme().target), colour8(lightTheme().target)};
  colours = shadesApart(colours, targets, coloursBeside(scene, molecule, *out));
  for (std::size_t k = 0; k < colours.size(); ++k) (*out)[k].colour = colours[k];
  return out;
}

}  // namespace moltact
