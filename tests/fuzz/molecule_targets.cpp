// Molecules by format. Accepted molecules must be finite and consistent.
#include <zlib.h>

#include <cmath>

#include "engine/haptics/field/pair_sum.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/molecule/reader.h"
#include "engine/molecule/summary.h"
#include "engine/structure/accessible_area.h"
#include "engine/structure/amber/pair_atoms.h"
#include "engine/structure/colouring.h"
#include "engine/structure/hydrogen_bonds.h"
#include "engine/structure/interaction_input.h"
#include "engine/structure/map_file.h"
#include "engine/structure/secondary_structure.h"
#include "engine/structure/superposition.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

void soundly(const Molecule& m) {
  mustBe(!m.atoms.empty() && m.atoms.size() <= kMaxMoleculeAtoms, "some atoms");
  for (const PlacedAtom& atom : m.placedAtoms()) {
    for (int k = 0; k < 3; ++k) mustBe(std::abs(atom.position.A[k]) <= kMaxCoordinate_A, "a place within 1e9 A");
    mustBe(atom.radius_A >= 0 && atom.radius_A <= kMaxCoordinate_A, "a radius");
    mustBe(atom.name.back() == 0, "a name with an end");
    mustBe(atom.residue == kNoResidue || atom.residue < m.residues.size(), "a residue that is there");
  }
  std::uint32_t next = 0, residue = 0;
  for (const Residue& r : m.residues) {
    mustBe(r.first_atom == next && r.atom_count > 0 && r.chain < m.chains.size(), "residues one after the other");
    next += r.atom_count;
  }
  mustBe(m.residues.empty() || next == m.atoms.size(), "every atom in a residue");
  for (const Chain& c : m.chains) {
    mustBe(c.first_residue == residue && c.residue_count > 0, "chains one after the other");
    residue += c.residue_count;
  }
  mustBe(residue == m.residues.size(), "every residue in a chain");
  for (const Bond& b : m.listed_bonds)
    mustBe(b.first < b.second && b.second < m.atoms.size(), "bonds between atoms that are there");
  mustBe(summarise(m).atoms == m.atoms.size(), "a summary of them all");
  for (std::size_t i = 0; i < m.atoms.size(); i += 1 + m.atoms.size() / 20)
    mustBe(!m.describe(i).empty(), "a name to be called by");
}

void read(std::string_view bytes, const char* name) {
  for (const bool plain : {true, false}) {
    ReadOptions options;
    if (!plain) options = {.model = 2, .waters = true, .assembly = "1"};
    const auto molecule = readMoleculeBytes(std::string(bytes), name, options);
    if (molecule)
      soundly(*molecule);
    else
      mustBe(!molecule.problem().message.empty(), "a message");
    for (const char* assembly : {"1", "cell"}) {
      if (!plain) break;
      options.assembly = assembly;
      if (const auto whole = readMoleculeBytes(std::string(bytes), name, options)) soundly(*whole);
    }
  }
}

void mustBeFinite(const PairEnergy& e) {
  mustBe(std::isfinite(e.energy.felt_kcal_mol) && std::isfinite(e.energy.total_kcal_mol()), "an energy");
  mustBe(finite(e.force_kcal_mol_A) && finite(e.torque_kcal_mol), "a force and a torque");
  mustBe(std::isfinite(e.stiffness_kcal_mol_A2) && e.stiffness_kcal_mol_A2 >= 0.0, "a curvature");
  mustBe(std::isfinite(e.rotational_stiffness_kcal_mol) && e.rotational_stiffness_kcal_mol >= 0.0,
         "a turn's curvature");
}

// Forces between the atoms that were read: finite for a probe and for the first residue in the hand, whatever their
// charges and places, at the places of atoms and between them.
void forces(std::string_view bytes, const char* name) {
  const auto molecule = readMoleculeBytes(std::string(bytes), name, {.waters = true});
  constexpr std::size_t kMost = 200;
  if (!molecule || molecule->atoms.size() > kMost) return;
  const Molecule& m = *molecule;
  const PairAtoms assigned = pairAtoms(m);
  mustBe(std::isfinite(assigned.net_charge_e) && assigned.atoms.size() == assigned.carrier.size(), "charges");
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < m.atoms.size() && m.atoms[i].residue == m.atoms[0].residue; ++i) first.push_back(i);
  std::vector<Vec3> places{Vec3(0.0)};
  for (std::size_t i = 0; i < m.spheres.size() && places.size() < 6; ++i) {
    places.push_back(m.spheres[i].centre_A);
    places.push_back(m.spheres[i].centre_A + Vec3(2.0, 0.1, 0.0));
  }
  for (const bool held : {false, true}) {
    const std::vector<std::uint32_t> untouchable = held ? first : std::vector<std::uint32_t>();
    const auto spheres = std::make_shared<const SphereGrid>(m.spheres, untouchable);
    const auto body = held ? heldBody(m, first) : nullptr;
    if (held && !body) return;
    TouchSetup touch;
    touch.forces = "all";
    touch.probe_charge_e = kMaxProbeCharge_e;
    touch.dielectric = m.atoms.size() % 2 ? "vacuum" : "water";
    touch.weak_gain = m.atoms.size() % 3 ? 1.0 : kMaxWeakGain;
    touch = resolveInteraction(touch, held);
    const InteractionInput input = interactionInput(touch, m, spheres, body);
    mustBe(input.pairs != nullptr, "atoms of forces");
    const PairField& f = *input.pairs;
    for (const double wall : {f.model.wall_kcal_mol, double(INFINITY)}) {
      PairModel model = f.model;
      model.wall_kcal_mol = wall;
      PairSum sum(f.places, f.atoms, f.held, model);
      for (const Vec3& at : places) mustBeFinite(sum.at({{at}, kNoRotation}));
    }
    const auto felt = makeInteraction(input);
    mustBe(felt != nullptr, "an interaction");
    for (const Vec3& at : places)
      for (int tick = 0; tick < 3; ++tick) {
        const Response r = felt->respond({{at}, kNoRotation});
        mustBe(finite(r.contact.displacement_A) && finite(r.torque_A2), "a force that is felt");
        mustBe(finite(r.contact.scp.A) && std::isfinite(r.contact.energy_A2), "a place where it rests");
        if (r.molecular_energy) mustBe(std::isfinite(r.molecular_energy->felt_kcal_mol), "an energy that is felt");
      }
  }
}

std::string packed(std::string_view bytes) {
  z_stream stream{};
  deflateInit2(&stream, 1, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, uLong(bytes.size())) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

}  // namespace

void pdb(std::string_view bytes) { read(bytes, "x.pdb"); }
void mmcif(std::string_view bytes) { read(bytes, "x.cif"); }
// The small-molecule dictionary is recognized by its first tags.
void smallCif(std::string_view bytes) {
  read(bytes, "x.cif");
  read("data_x\n_cell_length_a 5\n" + std::string(bytes), "x.cif");
}
void sdf(std::string_view bytes) { read(bytes, "x.sdf"); }
void mol2(std::string_view bytes) { read(bytes, "x.mol2"), forces(bytes, "x.mol2"); }
void pqr(std::string_view bytes) { read(bytes, "x.pqr"), forces(bytes, "x.pqr"); }
void pdbqt(std::string_view bytes) { read(bytes, "x.pdbqt"), forces(bytes, "x.pdbqt"); }
void gro(std::string_view bytes) { read(bytes, "x.gro"); }
void xyzr(std::string_view bytes) { read(bytes, "x.xyzr"); }

// What is worked out of a molecule, whatever its atoms.
void structure(std::string_view bytes) {
  const auto molecule = readMoleculeBytes(std::string(bytes), "x.pdb", {.waters = true});
  if (!molecule) return;
  const Molecule& m = *molecule;
  const auto bonds = findBonds(m);
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    mustBe(bonds[i].first < bonds[i].second && bonds[i].second < m.atoms.size(), "bonds between atoms that are there");
    mustBe(i == 0 || std::pair(bonds[i - 1].first, bonds[i - 1].second) < std::pair(bonds[i].first, bonds[i].second),
           "each bond once, in order");
  }
  for (const HydrogenBond& h : findHydrogenBonds(m, BondTable(m.atoms.size(), bonds)))
    mustBe(h.donor < m.atoms.size() && h.acceptor < m.atoms.size() && h.length_A <= 3.5, "hydrogen bonds");
  for (const MoleculeStructure& s : {secondaryStructure(m), structureByHydrogenBonds(m)}) {
    mustBe(s.of_residue.size() == m.residues.size(), "a structure of every residue");
    std::uint32_t next = 0;
    for (const StructureElement& e : s.elements) {
      mustBe(e.first_residue >= next && e.first_residue <= e.last_residue && e.last_residue < m.residues.size(),
             "elements one after the other");
      next = e.last_residue + 1;
    }
  }
  for (const double area : accessibleAreas_A2(m.spheres)) mustBe(std::isfinite(area) && area >= 0.0, "an area");
  for (const ColouringScheme& scheme : colouringSchemes())
    mustBe(colourMolecule(m, scheme).of_atom.size() == m.atoms.size(), "a colour of every atom");
  if (const auto states = twoStates(m, m))
    for (const Sphere& sphere : states->at(0.5)) mustBe(finite(sphere.centre_A), "a place between");
}

void gridMap(std::string_view bytes) {
  const auto map = readMap(bytes, "x.map");
  if (!map) return mustBe(!map.problem().message.empty(), "a message");
  mustBe(map->values.size() == map->box.count() && map->box.count() >= 64, "a value for each point");
  for (const float value : map->values) mustBe(std::isfinite(value), "energies that are numbers");
  // Interpolation at the middle of the box gives numbers.
  const auto cell = gridCell(map->box, 0.5 * (map->box.low_A() + map->box.high_A()));
  mustBe(cell.has_value(), "a middle");
  const GridSample sample = curvedGridSample(map->box, *cell, GridInterpolation::Tricubic, map->values.data());
  bool small = true;
  for (const float value : map->values) small = small && std::abs(value) < 1e10f;
  mustBe(!small || (std::isfinite(sample.value) && finite(sample.gradient)), "an energy between the points");
}

void anyMolecule(std::string_view bytes) { read(bytes, "x"); }

// Packed bytes as they are, and soundly packed ones of which some are then cut, changed or doubled.
void gzip(std::string_view bytes) {
  read(bytes, "x.pdb.gz");
  Choices choices(bytes);
  const std::size_t how = choices.pick(5), where = choices.pick(65536);
  std::string file = packed(choices.rest());
  switch (how) {
    case 1:
      file.resize(where % (file.size() + 1));
      break;
    case 2:
      file[where % file.size()] ^= char(1 + where % 255);
      break;
    case 3:
      file += file;
      break;
    case 4:
      file.append(where % 40, '\0');
      break;
    default:
      break;
  }
  read(file, "x.xyzr.gz");
}

}  // namespace moltact::fuzz
