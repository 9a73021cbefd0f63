#include "engine/structure/amber/pair_atoms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/haptics/sphere_grid.h"
#include "engine/structure/amber/amber.h"
#include "engine/structure/amber/element_types.h"
#include "engine/structure/amber/ligand_parameters.h"
#include "engine/structure/bonds.h"
#include "engine/structure/ligands.h"

namespace moltact {
namespace {

constexpr double kAcceptor_A = 3.5;  // a proton's partner lies within this distance of its carrier

double bondLength_A(std::string_view carrier_type) {
  return carrier_type.front() == 'S' ? 1.336 : carrier_type.front() == 'O' ? 0.96 : 1.01;
}

Vec3 anyNormal(const Vec3& v) {
  const Vec3 other = std::abs(v.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return glm::normalize(glm::cross(v, other));
}

class Assigner {
 public:
  explicit Assigner(const Molecule& m)
      : m_(m),
        all_bonds_(findBonds(m)),
        bonds_(m.atoms.size(), all_bonds_),
        grid_(m.spheres, SphereGrid::Duplicates::VisitEach),
        of_ligand_(m.atoms.size(), 0) {
    out_.atoms.resize(m.atoms.size());
    for (std::uint32_t i = 0; i < m.atoms.size(); ++i) {
      out_.atoms[i].centre_A = m.spheres[i].centre_A;
      out_.carrier.push_back(i);
    }
  }

  PairAtoms run() {
    for (std::uint32_t i = 0; i < m_.atoms.size(); ++i)
      if (m_.atoms[i].residue == kNoResidue) byElement(i);
    for (std::uint32_t r = 0; r < m_.residues.size(); ++r) residue(r);
    if (!ligands_.empty()) parametrizeLigands();
    out_.file_charges = !m_.charges_e.empty();
    if (out_.file_charges)
      for (std::uint32_t i = 0; i < m_.atoms.size(); ++i) out_.atoms[i].charge_e = m_.charges_e[i];
    for (const Proton& p : protons_) place(p);
    for (const PairAtom& a : out_.atoms) out_.net_charge_e += double(a.charge_e);
    noteFractionalCharges();
    noteUnknownElements();
    noteSamePlaces();
    return std::move(out_);
  }

 private:
  // A hydrogen to be placed: one of `count` on the carrier.
  struct Proton {
    std::uint32_t carrier = 0;
    std::vector<AmberAtom> hydrogens;
    std::string_view carrier_type;
  };

  static bool fractional(double charge_e) { return std::abs(charge_e - std::round(charge_e)) > kFractionalCharge_e; }

  // Which residues of the file have no whole charge, where the molecule has none.
  void noteFractionalCharges() {
    if (m_.charges_e.empty() || !fractional(out_.net_charge_e)) return;
    const std::size_t before = out_.notes.size();
    for (std::uint32_t k = 0; k < m_.residues.size(); ++k) {
      const Residue& r = m_.residues[k];
      double sum_e = 0.0;
      for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) sum_e += double(m_.charges_e[i]);
      if (!fractional(sum_e)) continue;
      note(PairAtoms::Note::Kind::FractionalCharge, k);
      out_.notes.back().residue_charge_e = sum_e;
    }
    if (out_.notes.size() > before) return;
    note(PairAtoms::Note::Kind::FractionalCharge, kNoResidue);
    out_.notes.back().residue_charge_e = out_.net_charge_e;
  }

  void noteUnknownElements() {
    for (std::uint32_t k = 0; k < m_.residues.size(); ++k) {
      const Residue& r = m_.residues[k];
      const auto first = m_.atoms.begin() + r.first_atom;
      if (std::any_of(first, first + r.atom_count, [](const Atom& a) { return a.atomic_number == 0; }))
        note(PairAtoms::Note::Kind::UnknownElement, k);
    }
  }

  void noteSamePlaces() {
    std::uint32_t noted = kNoResidue;
    bool any = false;
    for (std::uint32_t i = 0; i < m_.atoms.size(); ++i) {
      const std::uint32_t residue = m_.atoms[i].residue;
      if (any && residue == noted) continue;
      bool same = false;
      grid_.visitCentresNear(m_.spheres[i].centre_A, kSamePlace_A, [&](std::uint32_t k, const Sphere& s) {
        same = same || (k < i && glm::distance(s.centre_A, m_.spheres[i].centre_A) < kSamePlace_A);
      });
      if (!same) continue;
      note(PairAtoms::Note::Kind::SamePlace, residue);
      noted = residue, any = true;
    }
  }

  void byElement(std::uint32_t i) {
    const AmberType* noble = nobleGas(m_.atoms[i].atomic_number);
    set(i, noble ? noble : amberType(elementType(m_.atoms[i].atomic_number, bonds_.neighbours(i).size())), 0.0f);
  }

  void set(std::uint32_t i, const AmberType* type, float charge_e) {
    // An element without a type has the size of its van der Waals radius and carbon's depth. No atom's is larger than the
    // bound, beyond which the energy of overlapping atoms would overflow.
    constexpr double kMaxHalfMinimum_A = 20.0;
    out_.atoms[i].half_minimum_A =
        type ? type->half_minimum_A : float(std::min(m_.spheres[i].radius_A, kMaxHalfMinimum_A));
    out_.atoms[i].depth_kcal_mol = type ? type->depth_kcal_mol : 0.086f;
    out_.atoms[i].charge_e = charge_e;
  }

  void note(PairAtoms::Note::Kind kind, std::uint32_t residue, std::string_view name = {}) {
    out_.notes.push_back({kind, residue, std::string(name)});
  }

  // A state that decides a charge; the charges of a file need none.
  void noteState(PairAtoms::Note::Kind kind, std::uint32_t residue, std::string_view name, bool stated) {
    if (!m_.charges_e.empty()) return;
    note(kind, residue, name);
    out_.notes.back().stated = stated;
  }

  bool hasHydrogens(const Residue& r) const {
    const auto first = m_.atoms.begin() + r.first_atom;
    return std::any_of(first, first + r.atom_count, [](const Atom& a) { return a.atomic_number == 1; });
  }

  std::uint32_t find(const Residue& r, std::string_view name) const {
    for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i)
      if (formulaName(r.name, m_.atoms[i].nameText()) == name) return i;
    return std::uint32_t(m_.atoms.size());
  }
  bool has(const Residue& r, std::string_view name) const { return find(r, name) < m_.atoms.size(); }

  // The distance from an atom to the nearest oxygen of another residue, which a proton there would approach.
  double acceptor_A(std::uint32_t atom, std::uint32_t residue) const {
    double nearest = INFINITY;
    if (atom >= m_.atoms.size()) return nearest;
    const Vec3 at = m_.spheres[atom].centre_A;
    grid_.visitCentresNear(at, kAcceptor_A, [&](std::uint32_t i, const Sphere& s) {
      if (m_.atoms[i].residue != residue && m_.atoms[i].atomic_number == 8)
        nearest = std::min(nearest, glm::distance(at, s.centre_A));
    });
    return nearest;
  }

  bool bondedElsewhere(std::uint32_t atom, std::uint32_t residue) const {
    if (atom >= m_.atoms.size()) return false;
    const auto near = bonds_.neighbours(atom);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t i) { return m_.atoms[i].residue != residue; });
  }

  // HID, HIE or HIP.
  std::string histidine(std::uint32_t index) {
    const Residue& r = m_.residues[index];
    const bool d = has(r, "HD1"), e = has(r, "HE2");
    if (d || e) return d && e ? "HIP" : d ? "HID" : "HIE";
    const std::uint32_t nd = find(r, "ND1"), ne = find(r, "NE2");
    // The nitrogen on a metal has no proton; else the one nearer to an acceptor.
    const bool delta =
        bondedElsewhere(ne, index) || (!bondedElsewhere(nd, index) && acceptor_A(nd, index) < acceptor_A(ne, index));
    return delta ? "HID" : "HIE";
  }

  // A sulphur on a metal has given its proton away.
  std::string cysteine(std::uint32_t index) const {
    const std::uint32_t sulphur = find(m_.residues[index], "SG");
    if (!bondedElsewhere(sulphur, index)) return "CYS";
    const auto near = bonds_.neighbours(sulphur);
    const bool disulphide =
        std::any_of(near.begin(), near.end(), [&](std::uint32_t i) { return m_.atoms[i].atomic_number == 16; });
    return disulphide ? "CYX" : "CYM";
  }

  // ASP, GLU and LYS, or the state that the hydrogens of the file show.
  std::string chargedSideChain(const Residue& r) const {
    const std::string name(r.name);
    if (name == "ASP") return has(r, "HD2") ? "ASH" : name;
    if (name == "GLU") return has(r, "HE2") ? "GLH" : name;
    const int protons = has(r, "HZ1") + has(r, "HZ2") + has(r, "HZ3");
    return protons == 2 ? "LYN" : name;
  }

  std::string stateOf(std::uint32_t index) {
    using Kind = PairAtoms::Note::Kind;
    const Residue& r = m_.residues[index];
    std::string name(r.name);
    // Names that state the protons.
    if (name == "HID" || name == "HIE" || name == "HIP") noteState(Kind::Histidine, index, name, true);
    if (name == "ASH" || name == "GLH" || name == "LYN") noteState(Kind::SideChain, index, name, true);
    if (name == "CYX" || name == "CYM") noteState(Kind::Cysteine, index, name, true);
    if (name == "HIS") {
      name = histidine(index);
      noteState(Kind::Histidine, index, name, has(r, "HD1") || has(r, "HE2"));
    } else if (name == "CYS") {
      name = cysteine(index);
      if (name != "CYS") noteState(Kind::Cysteine, index, name, false);
    } else if (name == "ASP" || name == "GLU" || name == "LYS") {
      name = chargedSideChain(r);
      noteState(Kind::SideChain, index, name, hasHydrogens(r));
    } else if (r.kind == ResidueKind::Nucleotide && name.size() == 1 && !has(r, "O2'")) {
      return "D" + name;
    }
    return name;
  }

  // The name of the template with the ends of chains.
  std::string templateOf(std::uint32_t index) {
    const Residue& r = m_.residues[index];
    const std::string name = stateOf(index);
    const auto kindAt = [&](std::uint32_t k) {
      return k < m_.residues.size() && m_.residues[k].chain == r.chain && m_.residues[k].kind == r.kind;
    };
    const bool first = index == 0 || !kindAt(index - 1), last = !kindAt(index + 1);
    if ((!first && !last) || amberTemplate(name).empty()) return name;
    std::string end;
    if (first != last && r.kind == ResidueKind::Nucleotide)
      end = last ? name + '3' : has(r, "P") ? std::string() : name + '5';
    else if (first != last)
      end = first ? "N" + name : has(r, "OXT") ? "C" + name : std::string();
    const bool charged = !end.empty() && !amberTemplate(end).empty();
    noteState(charged ? PairAtoms::Note::Kind::Terminus : PairAtoms::Note::Kind::InnerEnd, index, charged ? end : name,
              false);
    return charged ? end : name;
  }

  void residue(std::uint32_t index) {
    const Residue& r = m_.residues[index];
    const std::string name =
        r.kind == ResidueKind::AminoAcid || r.kind == ResidueKind::Nucleotide ? templateOf(index) : std::string();
    const std::span<const AmberAtom> rows = amberTemplate(name);
    if (rows.empty()) {
      for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) byElement(i);
      if (water(r)) return;
      const bool ion = r.kind == ResidueKind::Ion && r.atom_count == 1;
      const int charge_e = ion ? ionCharge_e(m_.atoms[r.first_atom].atomic_number) : 0;
      if (charge_e) {
        out_.atoms[r.first_atom].charge_e = float(charge_e);
        noteState(PairAtoms::Note::Kind::Ion, index, {}, false);
      } else if (!ion && hasLigandCharges(r)) {
        for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) of_ligand_[i] = 1;
        ligands_.push_back(index);
      } else if (!allNoble(r)) {
        note(PairAtoms::Note::Kind::NoTemplate, index);
      }
      return;
    }
    std::vector<std::uint32_t> at(rows.size());
    std::vector<float> charge_e(rows.size());
    bool missing = false;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      at[k] = find(r, rows[k].name);
      charge_e[k] += rows[k].charge_e;
    }
    std::vector<Proton> placed;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (at[k] < m_.atoms.size()) continue;
      if (rows[k].parent < 0) {
        missing = true;
        continue;
      }
      const auto parent = std::size_t(rows[k].parent);
      if (at[parent] >= m_.atoms.size()) continue;
      if (!polarHydrogen(rows, rows[k])) {
        charge_e[parent] += rows[k].charge_e;
        continue;
      }
      if (placed.empty() || placed.back().carrier != at[parent]) placed.push_back({at[parent], {}, rows[parent].type});
      placed.back().hydrogens.push_back(rows[k]);
    }
    std::uint32_t found = 0;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (at[k] < m_.atoms.size()) {
        set(at[k], amberType(rows[k].type), charge_e[k]);
        ++found;
      }
    if (found < r.atom_count) {
      for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i)
        if (std::find(at.begin(), at.end(), i) == at.end()) byElement(i);
      note(PairAtoms::Note::Kind::OtherAtoms, index, name);
    }
    if (missing) note(PairAtoms::Note::Kind::MissingAtoms, index, name);
    // With the file's charges all of its atoms are there.
    if (m_.charges_e.empty()) protons_.insert(protons_.end(), placed.begin(), placed.end());
  }

  bool allNoble(const Residue& r) const {
    const auto first = m_.atoms.begin() + r.first_atom;
    return std::all_of(first, first + r.atom_count, [](const Atom& a) { return nobleGas(a.atomic_number) != nullptr; });
  }

  // A residue of an oxygen and two hydrogens, whatever its name is, and no bond leads out of it.
  bool isWater(const Residue& r) const {
    if (r.atom_count != 3) return false;
    std::uint32_t hydrogens = 0, oxygen = kNoResidue;
    for (std::uint32_t i = r.first_atom; i < r.first_atom + 3; ++i)
      if (m_.atoms[i].atomic_number == 1)
        ++hydrogens;
      else if (m_.atoms[i].atomic_number == 8)
        oxygen = i;
    if (hydrogens != 2 || oxygen == kNoResidue) return false;
    if (r.kind == ResidueKind::Water) return true;
    const auto near = bonds_.neighbours(oxygen);
    return near.size() == 2 && std::all_of(near.begin(), near.end(),
                                           [&](std::uint32_t i) { return i >= r.first_atom && i < r.first_atom + 3; });
  }

  // A water with both hydrogens has the charges of TIP3P (Jorgensen et al., J. Chem. Phys. 79, 926, 1983).
  bool water(const Residue& r) {
    if (!isWater(r)) return false;
    for (std::uint32_t i = r.first_atom; i < r.first_atom + 3; ++i) {
      const bool hydrogen = m_.atoms[i].atomic_number == 1;
      PairAtom& a = out_.atoms[i];
      a.half_minimum_A = hydrogen ? 0.0f : 1.7683f;
      a.depth_kcal_mol = hydrogen ? 0.0f : 0.1520f;
      a.charge_e = hydrogen ? 0.417f : -0.834f;
    }
    return true;
  }

  // A lone atom, such as an oxygen of water or argon, has no charge.
  bool hasLigandCharges(const Residue& r) const {
    if (r.kind == ResidueKind::Water || r.atom_count < 2) return false;
    for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i)
      if (m_.atoms[i].atomic_number != 1 && hasElectronegativity(m_.atoms[i].atomic_number)) return true;
    return false;
  }

  // The charge of a metal in a ligand: an ion's, and of a haem's iron and its substitutes 2.
  int metalCharge_e(std::uint32_t i) const {
    const int number = m_.atoms[i].atomic_number;
    if (!isMetal(number)) return 0;
    const int charge_e = ionCharge_e(number);
    return charge_e == 0 && ligandClass(m_.residues[m_.atoms[i].residue].name) == LigandClass::Heme ? 2 : charge_e;
  }

  void parametrizeLigands() {
    const std::vector<AtomValence> valences = atomValences(m_, all_bonds_, of_ligand_);
    const GasteigerCharges charges = gasteigerCharges(m_, all_bonds_, of_ligand_, valences);
    for (const std::uint32_t index : ligands_) {
      const Residue& r = m_.residues[index];
      double net_e = 0.0;
      bool whole = true;
      for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) {
        const auto near = bonds_.neighbours(i);
        const GaffType* type = gaffType(m_, valences, i, near,
                                        near.empty() ? std::span<const std::uint32_t>() : bonds_.neighbours(near[0]));
        PairAtom& a = out_.atoms[i];
        if (type) a.half_minimum_A = type->half_minimum_A, a.depth_kcal_mol = type->depth_kcal_mol;
        const bool known = hasElectronegativity(m_.atoms[i].atomic_number);
        a.charge_e = known ? charges.atoms_e[i] : float(metalCharge_e(i));
        whole = whole && (known || a.charge_e != 0.0f);
        net_e += double(a.charge_e) + double(charges.hydrogens_e[i]) * valences[i].hydrogens;
        addHydrogens(i, valences[i], charges.hydrogens_e[i]);
      }
      if (m_.charges_e.empty()) {
        note(PairAtoms::Note::Kind::Ligand, index);
        out_.notes.back().charge_e = int(std::lround(net_e));
      }
      if (!whole) note(PairAtoms::Note::Kind::NoTemplate, index);
    }
  }

  // Hydrogens that the file lacks: merged with carbon, else placed later.
  void addHydrogens(std::uint32_t i, const AtomValence& v, float charge_e) {
    if (v.hydrogens == 0) return;
    const int carrier = m_.atoms[i].atomic_number;
    if (carrier != 7 && carrier != 8 && carrier != 16) {
      out_.atoms[i].charge_e += charge_e * float(v.hydrogens);
      return;
    }
    if (!m_.charges_e.empty()) return;
    // AMBER's types, which have GAFF's parameters.
    const std::string_view type = carrier == 7 ? "H" : carrier == 8 ? "HO" : "HS";
    const std::string_view carrier_type = carrier == 8                           ? "OH"
                                          : carrier == 16                        ? "SH"
                                          : v.hybrid == AtomValence::Hybrid::Sp3 ? "N3"
                                                                                 : "N";
    protons_.push_back({i, std::vector<AmberAtom>(v.hydrogens, AmberAtom{{}, type, charge_e, -1}), carrier_type});
  }

  void put(const Proton& p, std::size_t k, const Vec3& direction) {
    const AmberAtom& h = p.hydrogens[k];
    const AmberType* type = amberType(h.type);
    out_.atoms.push_back({m_.spheres[p.carrier].centre_A + bondLength_A(p.carrier_type) * direction,
                          type->half_minimum_A, type->depth_kcal_mol, h.charge_e});
    out_.carrier.push_back(p.carrier);
    ++out_.placed_hydrogens;
  }

  // Energy of a unit charge with the heavy atoms nearby, up to a factor.
  double energyAt(const Vec3& place, std::uint32_t carrier) const {
    double sum = 0.0;
    grid_.visitCentresNear(place, 5.0, [&](std::uint32_t i, const Sphere& s) {
      if (i == carrier) return;
      const double r = std::max(0.5, glm::distance(s.centre_A, place));
      sum += double(out_.atoms[i].charge_e) / (r * r) + 0.5 * std::pow(2.0 / r, 12.0);
    });
    return sum;
  }

  void place(const Proton& p) {
    std::vector<Vec3> away;  // unit vectors to the heavy neighbours
    std::uint32_t neighbour = 0;
    for (const std::uint32_t i : bonds_.neighbours(p.carrier))
      if (m_.atoms[i].atomic_number != 1) {
        away.push_back(glm::normalize(m_.spheres[i].centre_A - m_.spheres[p.carrier].centre_A));
        neighbour = i;
      }
    const std::size_t count = p.hydrogens.size();
    if (away.size() >= 2 && count == 1) {
      Vec3 sum(0.0);
      for (const Vec3& a : away) sum += a;
      put(p, 0, glm::length(sum) > 1e-3 ? -glm::normalize(sum) : anyNormal(away[0]));
      return;
    }
    if (away.size() == 2 && count == 2) {  // a charged proline at the start of a chain
      const Vec3 back = -glm::normalize(away[0] + away[1]), side = glm::normalize(glm::cross(away[0], away[1]));
      const double half = 0.5 * 109.5 * std::numbers::pi / 180.0;
      put(p, 0, std::cos(half) * back + std::sin(half) * side);
      put(p, 1, std::cos(half) * back - std::sin(half) * side);
      return;
    }
    if (away.size() != 1) return;
    // Round the bond to the neighbour A: `u` is where the next atom beyond it lies.
    const Vec3 axis = -away[0];
    Vec3 u = anyNormal(axis);
    for (const std::uint32_t i : bonds_.neighbours(neighbour)) {
      if (i == p.carrier || m_.atoms[i].atomic_number == 1) continue;
      const Vec3 beyond = m_.spheres[i].centre_A - m_.spheres[neighbour].centre_A;
      const Vec3 across = beyond - axis * glm::dot(beyond, axis);
      if (glm::length(across) > 0.1) {
        u = glm::normalize(across);
        break;
      }
    }
    const Vec3 v = glm::cross(axis, u);
    const bool planar = count == 2 && p.carrier_type != "N3";
    const double bend = (planar ? 60.0 : 70.5) * std::numbers::pi / 180.0;
    const auto at = [&](double turn) {
      return std::cos(bend) * axis + std::sin(bend) * (std::cos(turn) * u + std::sin(turn) * v);
    };
    constexpr double kPi = std::numbers::pi;
    if (count == 1) {  // a hydroxyl or thiol turns to the place of lowest energy
      const bool ring = bonds_.neighbours(neighbour).size() >= 3 && p.carrier_type == "OH" && planarRing(neighbour);
      double best = INFINITY, turn = kPi;
      for (int k = 0; k < 12; ++k) {
        const double t = k * kPi / 6;
        if (ring && k % 6 != 0) continue;
        const double energy =
            energyAt(m_.spheres[p.carrier].centre_A + bondLength_A(p.carrier_type) * at(t), p.carrier);
        if (energy < best) best = energy, turn = t;
      }
      put(p, 0, at(turn));
      return;
    }
    for (std::size_t k = 0; k < count; ++k)
      put(p, k, at(planar ? (k == 0 ? 0.0 : kPi) : kPi + 2.0 * kPi / 3.0 * double(k)));
  }

  // A carbon whose three bonds lie in a plane.
  bool planarRing(std::uint32_t carbon) const {
    const auto near = bonds_.neighbours(carbon);
    if (near.size() != 3) return false;
    const Vec3 c = m_.spheres[carbon].centre_A;
    const auto to = [&](std::size_t k) { return glm::normalize(m_.spheres[near[k]].centre_A - c); };
    return std::abs(glm::dot(glm::cross(to(0), to(1)), to(2))) < 0.2;
  }

  const Molecule& m_;
  std::vector<Bond> all_bonds_;
  BondTable bonds_;
  SphereGrid grid_;
  std::vector<char> of_ligand_;         // per atom: in one of ligands_
  std::vector<std::uint32_t> ligands_;  // residues
  PairAtoms out_;
  std::vector<Proton> protons_;
};

}  // namespace

PairAtoms pairAtoms(const Molecule& molecule) { return Assigner(molecule).run(); }

}  // namespace moltact
