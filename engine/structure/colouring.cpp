#include "engine/structure/colouring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/elements.h"
#include "engine/structure/amino_acids.h"
#include "engine/structure/secondary_structure.h"
#include "engine/structure/surface_potential.h"

namespace moltact {
namespace {

constexpr Rgb8 kNothing{168, 168, 172};  // of atoms to which a scheme does not apply

// Distinguishable with every type of colour vision as far as possible: P. Tol's "bright" scheme of 2018, then others.
// None is orange, the colour of targets.
constexpr Rgb8 kChains[] = {{68, 119, 170},  {34, 136, 51},  {170, 51, 119},  {102, 204, 238},
                            {238, 102, 119}, {204, 187, 68}, {130, 90, 190},  {20, 110, 110},
                            {150, 220, 160}, {120, 60, 60},  {205, 160, 220}, {90, 90, 100}};
constexpr std::size_t kMaxInLegend = 24;

const Residue* residueOf(const Molecule& m, const Atom& a) {
  return a.residue < m.residues.size() ? &m.residues[a.residue] : nullptr;
}

/// Collects the entries of a legend without duplicates, in the order of their rank.
class LegendMaker {
 public:
  void met(std::size_t rank, std::string_view name, const Rgb8& colour) {
    entries_.emplace(rank, Legend::Entry{std::string(name), colour});
  }
  bool has(std::size_t rank) const { return entries_.contains(rank); }
  void write(Legend& to) const {
    for (const auto& [rank, entry] : entries_) {
      if (to.entries.size() == kMaxInLegend) {
        to.entries.push_back({"…", kNothing});
        return;
      }
      to.entries.push_back(entry);
    }
  }

 private:
  std::map<std::size_t, Legend::Entry> entries_;
};

/// A class of a scheme with few classes: every atom belongs to one, identified by its rank. Names are translated once
/// each.
struct Class {
  const char* name;  // untranslated (N_)
  Rgb8 colour;
};

template <class ClassOf>
void byClass(const Molecule& m, Colouring& out, std::span<const Class> classes, ClassOf&& classOf) {
  LegendMaker legend;
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    const std::size_t rank = classOf(m.atoms[i]);
    out.of_atom[i] = classes[rank].colour;
    if (!legend.has(rank)) legend.met(rank, tr(classes[rank].name), classes[rank].colour);
  }
  legend.write(out.legend);
}

Rgb8 mix(const Rgb8& a, const Rgb8& b, double share) {
  Rgb8 out{};
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = static_cast<std::uint8_t>(std::lround(a[k] + (b[k] - a[k]) * std::clamp(share, 0.0, 1.0)));
  return out;
}

/// The colour at a fraction (0 to 1) of a gradient through equidistant `stops`.
Rgb8 along(std::span<const Rgb8> stops, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * double(stops.size() - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mix(stops[before], stops[before + 1], place - double(before));
}

constexpr Rgb8 kRainbow[] = {{52, 82, 184}, {54, 170, 200}, {80, 176, 90}, {226, 214, 80}, {200, 50, 60}};
constexpr Rgb8 kHydropathy[] = {{70, 120, 190}, {238, 236, 230}, {176, 96, 40}};
constexpr Rgb8 kBFactor[] = {{44, 80, 180}, {236, 236, 236}, {196, 40, 50}};

void byElement(const Molecule& m, const ColouringInput&, Colouring& out) {
  LegendMaker legend;
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    const Element& e = element(m.atoms[i].atomic_number);
    out.of_atom[i] = e.colour;
    const std::size_t rank = m.atoms[i].atomic_number;
    if (!legend.has(rank)) legend.met(rank, tr(e.name), e.colour);
  }
  legend.write(out.legend);
}

void byChain(const Molecule& m, const ColouringInput&, Colouring& out) {
  LegendMaker legend;
  // Chains of equal name count as one, wherever their residues are in the file.
  std::map<std::string_view, std::size_t> known;
  std::vector<std::size_t> rank_of;
  for (const Chain& c : m.chains) rank_of.push_back(known.emplace(c.name, known.size()).first->second);
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    const Residue* r = residueOf(m, m.atoms[i]);
    out.of_atom[i] = r ? kChains[rank_of[r->chain] % std::size(kChains)] : kNothing;
    if (!r || legend.has(rank_of[r->chain])) continue;
    const Chain& c = m.chains[r->chain];
    legend.met(rank_of[r->chain], c.name.empty() ? tr("without a chain") : trf("chain {0}", c.name.string()),
               out.of_atom[i]);
  }
  if (known.size() <= std::size(kChains)) legend.write(out.legend);  // a repeated colour would be ambiguous
}

// R. J. Fletterick's Shapely models as in RasMol; colours that are too similar or orange are changed.
struct ResidueColour {
  std::string_view code;
  Rgb8 colour;
};
constexpr ResidueColour kResidues[] = {
    {"ALA", {200, 200, 200}}, {"ARG", {20, 90, 255}},   {"ASN", {0, 190, 190}}, {"ASP", {230, 10, 70}},
    {"CYS", {230, 230, 0}},   {"GLN", {120, 225, 215}}, {"GLU", {160, 10, 40}}, {"GLY", {240, 240, 240}},
    {"HIS", {130, 130, 210}}, {"ILE", {15, 130, 15}},   {"LEU", {70, 180, 70}}, {"LYS", {100, 150, 255}},
    {"MET", {170, 170, 50}},  {"PHE", {50, 50, 140}},   {"PRO", {120, 80, 60}}, {"SER", {245, 170, 190}},
    {"THR", {205, 110, 160}}, {"TRP", {150, 50, 180}},  {"TYR", {95, 95, 115}}, {"VAL", {150, 220, 130}},
    {"A", {160, 160, 255}},   {"C", {225, 200, 140}},   {"G", {255, 112, 112}}, {"T", {130, 235, 130}},
    {"U", {190, 130, 130}}};

std::size_t residueRank(const Residue& r) {
  std::string_view code = r.name;
  if (const AminoAcid* a = r.kind == ResidueKind::AminoAcid ? aminoAcid(code) : nullptr) code = a->code;
  if (r.kind == ResidueKind::Nucleotide && code.size() == 2 && code[0] == 'D') code.remove_prefix(1);
  std::size_t rank = 0;
  while (rank < std::size(kResidues) && kResidues[rank].code != code) ++rank;
  return rank;
}

void byResidue(const Molecule& m, const ColouringInput&, Colouring& out) {
  LegendMaker legend;
  for (const Residue& r : m.residues) {
    const std::size_t rank = residueRank(r);
    const bool known = rank < std::size(kResidues);
    for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i)
      out.of_atom[i] = known ? kResidues[rank].colour : kNothing;
    if (legend.has(rank)) continue;
    const AminoAcid* a = known ? aminoAcid(kResidues[rank].code) : nullptr;
    legend.met(rank,
               !known ? std::string(tr("other"))
               : a    ? std::string(tr(a->name))
                      : std::string(kResidues[rank].code),
               known ? kResidues[rank].colour : kNothing);
  }
  legend.write(out.legend);
}

constexpr Class kTypes[] = {{N_("hydrophobic"), {178, 146, 104}},
                            {N_("polar"), {120, 190, 130}},
                            {N_("acidic"), {204, 51, 63}},
                            {N_("basic"), {52, 92, 196}},
                            {N_("nucleic acid"), {136, 88, 190}},
                            {N_("water"), {150, 210, 235}},
                            {N_("ion"), {80, 80, 88}},
                            {N_("ligand"), {230, 214, 80}},
                            {N_("other"), kNothing}};

std::size_t typeOf(const Residue& r) {
  switch (r.kind) {
    case ResidueKind::AminoAcid: {
      const AminoAcid* a = aminoAcid(r.name);
      if (!a) return 8;
      if (a->side_chain == SideChain::Hydrophobic) return 0;
      return a->side_chain == SideChain::Polar ? 1 : a->charge_e < 0 ? 2 : 3;
    }
    case ResidueKind::Nucleotide:
      return 4;
    case ResidueKind::Water:
      return 5;
    case ResidueKind::Ion:
      return 6;
    case ResidueKind::Ligand:
      return 7;
    case ResidueKind::Other:
      break;
  }
  return 8;
}

/// Colours by a property of the residue, evaluated once per residue.
template <class ClassOf>
void byResidueClass(const Molecule& m, Colouring& out, std::span<const Class> classes, ClassOf&& classOf) {
  std::vector<std::size_t> rank(m.residues.size());
  for (std::size_t r = 0; r < rank.size(); ++r) rank[r] = classOf(r);
  byClass(m, out, classes,
          [&](const Atom& a) { return a.residue < rank.size() ? rank[a.residue] : classes.size() - 1; });
}

void byType(const Molecule& m, const ColouringInput&, Colouring& out) {
  byResidueClass(m, out, kTypes, [&](std::size_t r) { return typeOf(m.residues[r]); });
}

void byHydropathy(const Molecule& m, const ColouringInput&, Colouring& out) {
  constexpr double kMax = 4.5;  // of isoleucine; that of arginine is -4.5
  std::fill(out.of_atom.begin(), out.of_atom.end(), kNothing);
  for (const Residue& r : m.residues) {
    const AminoAcid* a = r.kind == ResidueKind::AminoAcid ? aminoAcid(r.name) : nullptr;
    if (!a) continue;
    const Rgb8 colour = along(kHydropathy, 0.5 + 0.5 * a->hydropathy / kMax);
    for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) out.of_atom[i] = colour;
  }
  out.legend.gradient = true;
  out.legend.entries = {{trf("{0} (likes water)", numberText(-kMax, decimals(1))), kHydropathy[0]},
                        {numberText(0.0, decimals(1)), kHydropathy[1]},
                        {trf("{0} (shuns water)", numberText(kMax, decimals(1))), kHydropathy[2]}};
}

constexpr Class kCharges[] = {{N_("negative (−1)"), {204, 51, 63}},
                              {N_("positive (+1)"), {52, 92, 196}},
                              {N_("uncharged"), {226, 226, 226}},
                              {N_("not known"), kNothing}};

// The charge belongs to the phosphate of a nucleotide and to the side chain of an amino acid; chain ends are ignored.
void byCharge(const Molecule& m, const ColouringInput&, Colouring& out) {
  byClass(m, out, kCharges, [&](const Atom& a) -> std::size_t {
    const Residue* r = residueOf(m, a);
    if (!r) return 3;
    const std::string_view name = a.nameText();
    if (r->kind == ResidueKind::AminoAcid) {
      const bool backbone = name == "N" || name == "CA" || name == "C" || name == "O";
      const int charge = backbone ? 0 : residueCharge_e(r->name);
      return charge < 0 ? 0 : charge > 0 ? 1 : 2;
    }
    if (r->kind == ResidueKind::Nucleotide)
      return name == "P" || name == "OP1" || name == "OP2" || name == "O1P" || name == "O2P" ? 0 : 2;
    if (r->kind == ResidueKind::Water) return 2;
    return 3;
  });
}

constexpr Class kStructures[] = {{N_("alpha helix"), {190, 60, 110}},  {N_("3-10 helix"), {130, 90, 190}},
                                 {N_("pi helix"), {90, 50, 110}},      {N_("other helix"), {238, 136, 150}},
                                 {N_("strand"), {226, 202, 70}},       {N_("coil"), {214, 214, 220}},
                                 {N_("nucleic acid"), {70, 130, 180}}, {N_("other"), {120, 120, 124}}};

void byStructure(const Molecule& m, const ColouringInput&, Colouring& out) {
  const MoleculeStructure s = secondaryStructure(m);
  std::vector<std::size_t> rank(m.residues.size());
  for (std::size_t r = 0; r < rank.size(); ++r)
    rank[r] = m.residues[r].kind == ResidueKind::AminoAcid ? 5 : m.residues[r].kind == ResidueKind::Nucleotide ? 6 : 7;
  for (const StructureElement& e : s.elements)
    for (std::uint32_t r = e.first_residue; r <= e.last_residue; ++r)
      rank[r] = e.kind == SecondaryStructure::Strand ? 4 : static_cast<std::size_t>(e.helix);
  byResidueClass(m, out, kStructures, [&](std::size_t r) { return rank[r]; });
}

void byBFactor(const Molecule& m, const ColouringInput&, Colouring& out) {
  float low = std::numeric_limits<float>::max(), high = 0.0f;
  for (const Atom& a : m.atoms) low = std::min(low, a.b_factor_A2), high = std::max(high, a.b_factor_A2);
  const double range = double(high) - double(low);
  for (std::size_t i = 0; i < m.atoms.size(); ++i)
    out.of_atom[i] = range > 0.0 ? along(kBFactor, (double(m.atoms[i].b_factor_A2) - double(low)) / range) : kNothing;
  if (!(range > 0.0)) {
    out.legend.entries = {{tr("the file has none"), kNothing}};
    return;
  }
  out.legend.gradient = true;
  const auto value = [](double b) { return numberText(b, decimals(0)) + "\u00A0Å²"; };
  out.legend.entries = {
      {value(low), kBFactor[0]}, {value(0.5 * (low + high)), kBFactor[1]}, {value(high), kBFactor[2]}};
}

// Water and ions, which may cross the whole cell, have no part in the range.
void byFluctuation(const Molecule& m, const ColouringInput& input, Colouring& out) {
  if (input.fluctuation_A.size() != m.atoms.size()) {
    out.legend.entries = {{tr("no trajectory has been read"), kNothing}};
    return;
  }
  float low = std::numeric_limits<float>::max(), high = 0.0f;
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    const Residue* r = residueOf(m, m.atoms[i]);
    if (r && (r->kind == ResidueKind::Water || r->kind == ResidueKind::Ion)) continue;
    low = std::min(low, input.fluctuation_A[i]), high = std::max(high, input.fluctuation_A[i]);
  }
  const double range = double(high) - double(low);
  for (std::size_t i = 0; i < m.atoms.size(); ++i)
    out.of_atom[i] =
        range > 0.0 ? along(kBFactor, (double(input.fluctuation_A[i]) - double(low)) / range) : kBFactor[0];
  const auto value = [](double distance) { return quantityText(distance, Dimension::Length, decimals(2)); };
  if (!(range > 0.0)) {
    out.legend.entries = {{value(m.atoms.empty() ? 0.0 : double(input.fluctuation_A[0])), kBFactor[0]}};
    return;
  }
  out.legend.gradient = true;
  out.legend.entries = {{value(double(low)), kBFactor[0]},
                        {value(0.5 * (double(low) + double(high))), kBFactor[1]},
                        {value(double(high)), kBFactor[2]}};
}

void byPlaceInChain(const Molecule& m, const ColouringInput&, Colouring& out) {
  std::fill(out.of_atom.begin(), out.of_atom.end(), kNothing);
  const auto polymer = [&](std::uint32_t r) {
    return m.residues[r].kind == ResidueKind::AminoAcid || m.residues[r].kind == ResidueKind::Nucleotide;
  };
  for (const Chain& c : m.chains) {
    std::uint32_t length = 0, place = 0;
    for (std::uint32_t r = c.first_residue; r < c.first_residue + c.residue_count; ++r) length += polymer(r);
    for (std::uint32_t r = c.first_residue; r < c.first_residue + c.residue_count; ++r) {
      if (!polymer(r)) continue;
      const Rgb8 colour = along(kRainbow, length > 1 ? double(place) / double(length - 1) : 0.0);
      ++place;
      const Residue& residue = m.residues[r];
      for (std::uint32_t i = residue.first_atom; i < residue.first_atom + residue.atom_count; ++i)
        out.of_atom[i] = colour;
    }
  }
  out.legend.gradient = true;
  for (const Rgb8& colour : kRainbow) out.legend.entries.push_back({{}, colour});
  out.legend.entries.front().name = tr("start (N-terminus or 5′)");
  out.legend.entries.back().name = tr("end (C-terminus or 3′)");
}

// Red to blue as in the literature; ColorBrewer's RdBu, which every type of colour vision can read.
constexpr Rgb8 kPotential[] = {{178, 24, 43}, {239, 138, 98}, {247, 247, 247}, {103, 169, 207}, {33, 102, 172}};

void paintPotential(std::span<const float> potential, Colouring& out) {
  const double top = potentialRange_kcal_mol_e(potential);
  std::fill(out.of_atom.begin(), out.of_atom.end(), kNothing);
  if (!(top > 0.0)) {
    out.legend.entries = {{tr("no charges are known"), kNothing}};
    return;
  }
  for (std::size_t i = 0; i < out.of_atom.size(); ++i)
    if (!std::isnan(potential[i])) out.of_atom[i] = along(kPotential, 0.5 + 0.5 * double(potential[i]) / top);
  out.legend.gradient = true;
  const auto value = [](double v) { return trf("{0} kcal/mol/e", numberText(v, plain(2))); };
  const double parts[] = {-1.0, -0.5, 0.0, 0.5, 1.0};
  for (std::size_t k = 0; k < std::size(parts); ++k)
    out.legend.entries.push_back({value(parts[k] * top), kPotential[k]});
}

void byPotential(const Molecule& m, const ColouringInput& input, Colouring& out) {
  if (!input.later)
    return paintPotential(surfacePotential_kcal_mol_e(m, dielectricChoice(input.dielectric), input.held), out);
  std::fill(out.of_atom.begin(), out.of_atom.end(), kNothing);
  out.pending = true;
  out.legend.entries = {{tr("being computed"), kNothing}};
}

// One row per scheme.
constexpr ColouringScheme kSchemes[] = {
    {"element", NC_("colours", "Element"), N_("the chemical element: carbon grey, oxygen red, nitrogen blue"),
     byElement},
    {"chain", NC_("colours", "Chain"), N_("the chain; twelve colours, then again from the first"), byChain},
    {"residue", NC_("colours", "Residue"), N_("the name of the residue: each amino acid and each base its own"),
     byResidue},
    {"residue-type", NC_("colours", "Residue type"),
     N_("the kind of residue: hydrophobic, polar, acidic or basic amino acids, nucleic acid, water, ions, ligands"),
     byType},
    {"hydrophobicity", NC_("colours", "Hydrophobicity"),
     N_("the hydropathy of the amino acid after Kyte and Doolittle, from blue (likes water) to brown (shuns it)"),
     byHydropathy},
    {"charge", NC_("colours", "Charge at pH 7"),
     N_("the charge at pH 7: side chains of Asp and Glu negative, of Lys and Arg positive; phosphates negative"),
     byCharge},
    {"potential", NC_("colours", "Electrostatic potential"),
     N_("the energy of a charge of +1 e on the surface, from red (negative) to blue (positive)"), byPotential},
    {"structure", NC_("colours", "Secondary structure"),
     N_("helix, strand or coil, as the file records them, else by the hydrogen bonds"), byStructure},
    {"b-factor", NC_("colours", "B factor"), N_("the B factor of the file, from its lowest to its highest"), byBFactor},
    {"fluctuation", NC_("colours", "Fluctuation"),
     N_("how far the atom moves about its mean position in a trajectory (root mean square), from blue to red"),
     byFluctuation},
    {"rainbow", NC_("colours", "Rainbow"), N_("the place along the chain, from blue at its start to red at its end"),
     byPlaceInChain},
};

}  // namespace

const char* ColouringScheme::shownLabel() const { return trc("colours", label); }

std::span<const ColouringScheme> colouringSchemes() { return kSchemes; }

Expected<const ColouringScheme*> findColouringScheme(std::string_view name) {
  std::string names;
  for (const ColouringScheme& s : kSchemes) {
    if (s.name == name) return &s;
    names += (names.empty() ? "" : ", ") + std::string(s.name);
  }
  return Problem{{}, 0, 0, trf("there is no colouring named '{0}'", name), trf("the names are {0}", names)};
}

Colouring colourMolecule(const Molecule& molecule, const ColouringScheme& scheme, const ColouringInput& input) {
  Colouring out;
  out.of_atom.assign(molecule.atoms.size(), kNothing);
  out.scheme = scheme.name;
  out.legend.title = scheme.shownLabel();
  scheme.colour(molecule, input, out);
  return out;
}

Colouring potentialColouring(std::span<const float> potential) {
  const ColouringScheme& scheme = **findColouringScheme("potential");
  Colouring out;
  out.of_atom.assign(potential.size(), kNothing);
  out.scheme = scheme.name;
  out.legend.title = scheme.shownLabel();
  paintPotential(potential, out);
  return out;
}

void colourParts(Colouring& colouring, std::span<const OwnColour> parts) {
  for (const OwnColour& part : parts) {
    for (const std::uint32_t i : part.atoms)
      if (i < colouring.of_atom.size()) colouring.of_atom[i] = part.colour;
    if (!part.name.empty()) colouring.legend.parts.push_back({part.name, part.colour});
  }
}

}  // namespace moltact
