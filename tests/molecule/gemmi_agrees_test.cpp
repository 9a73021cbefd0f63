// Independent readings: gemmi reads every PDB file of the library and finds the same atoms as the readers. The readers
// find the same atoms in the mmCIF that gemmi writes of them.
#define GEMMI_WRITE_IMPLEMENTATION
#include <algorithm>
#include <cctype>
#include <cmath>
#include <gemmi/pdb.hpp>
#include <gemmi/polyheur.hpp>
#include <gemmi/to_cif.hpp>
#include <gemmi/to_mmcif.hpp>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

// clang-format off: gemmi undefines what doctest defines
#include <doctest/doctest.h>
// clang-format on

#include "tests/molecule/files.h"

namespace moltact {
namespace {

/// Chain, number, insertion code, residue and name: what names an atom in its file.
using AtomName = std::tuple<std::string, int, char, std::string, std::string>;

struct AtomSeen {
  Vec3 place_A{0.0};
  int atomic_number = 0;
  double b_factor_A2 = 0.0, occupancy = 0.0;
  int formal_e = 0;
};

using Atoms = std::map<AtomName, AtomSeen>;

// Of alternative locations the one with the largest occupancy, the first of equals. Waters are kept only if there is
// nothing else.
Atoms byGemmi(const gemmi::Structure& structure) {
  Atoms out;
  bool all_waters = true;
  for (const gemmi::Chain& chain : structure.models.at(0).chains)
    for (const gemmi::Residue& residue : chain.residues) all_waters = all_waters && residue.is_water();
  for (const gemmi::Chain& chain : structure.models.at(0).chains)
    for (const gemmi::Residue& residue : chain.residues) {
      if (residue.is_water() && !all_waters) continue;
      for (const gemmi::Atom& a : residue.atoms) {
        const AtomName name{chain.name, *residue.seqid.num, residue.seqid.icode, residue.name, a.name};
        const AtomSeen seen{{a.pos.x, a.pos.y, a.pos.z}, a.element.atomic_number(), a.b_iso, a.occ, a.charge};
        const auto [at, fresh] = out.emplace(name, seen);
        if (!fresh && a.occ > at->second.occupancy + 1e-6f) at->second = seen;
      }
    }
  return out;
}

Atoms byOurs(const Molecule& molecule) {
  Atoms out;
  for (const Chain& chain : molecule.chains)
    for (std::uint32_t r = chain.first_residue; r < chain.first_residue + chain.residue_count; ++r) {
      const Residue& residue = molecule.residues[r];
      for (std::uint32_t a = residue.first_atom; a < residue.first_atom + residue.atom_count; ++a) {
        const PlacedAtom atom = molecule.at(a);
        const AtomName name{std::string(std::string_view(chain.name)), residue.number, residue.insertion,
                            std::string(std::string_view(residue.name)), std::string(atom.nameText())};
        CHECK(out.emplace(name, AtomSeen{atom.position.A, atom.atomic_number, atom.b_factor_A2, 0.0,
                                         molecule.formal_charges_e.empty() ? 0 : molecule.formal_charges_e[a]})
                  .second);
      }
    }
  return out;
}

std::size_t differences(const Atoms& ours, const Atoms& theirs) {
  std::size_t out = ours.size() > theirs.size() ? ours.size() - theirs.size() : theirs.size() - ours.size();
  for (const auto& [name, seen] : theirs) {
    const auto at = ours.find(name);
    const bool same = at != ours.end() && glm::distance(at->second.place_A, seen.place_A) < 1e-9 &&
                      at->second.atomic_number == seen.atomic_number &&
                      std::abs(at->second.b_factor_A2 - seen.b_factor_A2) < 1e-3 &&
                      at->second.formal_e == seen.formal_e;
    if (same) continue;
    ++out;
    INFO(std::get<0>(name), " ", std::get<1>(name), " ", std::get<3>(name), " ", std::get<4>(name));
    CHECK_MESSAGE(same, "gemmi and the reader differ");
  }
  return out;
}

// gemmi refuses files of before 1996, whose columns 73 to 80 hold the entry's name and the number of the line.
gemmi::Structure readByGemmi(const std::filesystem::path& file) {
  std::istringstream lines(test::contentOf(file));
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 79 && std::isdigit(static_cast<unsigned char>(line[79])) &&
        std::isdigit(static_cast<unsigned char>(line[78])))
      line.resize(72);
    text += line + '\n';
  }
  return gemmi::read_pdb_string(text, file.string());
}

std::vector<std::filesystem::path> pdbFiles() {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(test::libraryFolder()))
    if (entry.path().extension() == ".pdb") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE(
    "of each PDB file of the library gemmi reads the same atoms: names, residues, chains, elements, places to 1e-9 A, "
    "B factors and formal charges") {
  REQUIRE(pdbFiles().size() >= 30);
  for (const auto& file : pdbFiles()) {
    CAPTURE(file.filename().string());
    const Expected<Molecule> ours = readMolecule(file);
    REQUIRE(ours);
    CHECK(differences(byOurs(*ours), byGemmi(readByGemmi(file))) == 0);
  }
}

TEST_CASE("what gemmi writes of each PDB file of the library as mmCIF is read as the same atoms") {
  for (const auto& file : pdbFiles()) {
    CAPTURE(file.filename().string());
    gemmi::Structure structure = readByGemmi(file);
    gemmi::setup_entities(structure);
    std::ostringstream text;
    gemmi::cif::write_cif_to_stream(text, gemmi::make_mmcif_document(structure), gemmi::cif::Style::Simple);
    const Expected<Molecule> ours = readMoleculeBytes(text.str(), "written.cif");
    REQUIRE(ours);
    CHECK(differences(byOurs(*ours), byGemmi(structure)) == 0);
  }
}

}  // namespace moltact
