// Independent readings: gemmi reads every PDB file of the library and finds the same atoms as the readers. The readers
// find the same atoms in the mmCIF that gemmi writes of them. Biological assemblies have the same atoms in the same places.
#define GEMMI_WRITE_IMPLEMENTATION
#include <algorithm>
#include <cctype>
#include <cmath>
#include <gemmi/assembly.hpp>
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
        const AtomSeen seen{{a.pos.x, a.pos.y, a.pos.z}, a.element.atomic_number(), a.b_iso, a.occ};
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
        CHECK(out.emplace(name, AtomSeen{atom.position.A, atom.atomic_number, atom.b_factor_A2, 0.0}).second);
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
                      std::abs(at->second.b_factor_A2 - seen.b_factor_A2) < 1e-3;
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
    "of each PDB file of the library gemmi reads the same atoms: names, residues, chains, elements, places to 1e-9 A "
    "and B factors") {
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

// Removes what the readers leave out: waters, and all but the likeliest of alternative atoms.
void dropLeftOut(gemmi::Structure& structure) {
  const Atoms kept = byGemmi(structure);
  for (gemmi::Chain& chain : structure.models.at(0).chains)
    for (gemmi::Residue& residue : chain.residues)
      std::erase_if(residue.atoms, [&](const gemmi::Atom& a) {
        const auto at = kept.find({chain.name, *residue.seqid.num, residue.seqid.icode, residue.name, a.name});
        return at == kept.end() || at->second.place_A != Vec3(a.pos.x, a.pos.y, a.pos.z);
      });
  gemmi::remove_empty_children(structure);
  structure.models.erase(structure.models.begin() + 1, structure.models.end());
}

// The number of atoms of `a` that have no atom of their own in `b` of the same element within 0.001 A.
std::size_t unmatched(const std::vector<PlacedAtom>& a, const std::vector<PlacedAtom>& b) {
  const auto cell = [](double x) { return std::int64_t(std::floor(x)); };
  std::multimap<std::array<std::int64_t, 3>, const PlacedAtom*> left;
  for (const PlacedAtom& atom : b)
    left.emplace(std::array{cell(atom.position.A.x), cell(atom.position.A.y), cell(atom.position.A.z)}, &atom);
  std::size_t out = 0;
  for (const PlacedAtom& atom : a) {
    bool found = false;
    for (int k = 0; k < 27 && !found; ++k) {
      const auto [from, to] =
          left.equal_range({cell(atom.position.A.x) + k % 3 - 1, cell(atom.position.A.y) + k / 3 % 3 - 1,
                            cell(atom.position.A.z) + k / 9 - 1});
      for (auto at = from; at != to && !found; ++at)
        if (at->second->atomic_number == atom.atomic_number &&
            glm::distance(at->second->position.A, atom.position.A) < 1e-3) {
          left.erase(at);
          found = true;
          break;
        }
    }
    out += !found;
  }
  return out;
}

TEST_CASE("each biological assembly of the library's PDB files has the same atoms in gemmi, in places within 0.001 A") {
  std::size_t assemblies = 0, copied = 0;
  for (const auto& file : pdbFiles()) {
    const gemmi::Structure structure = readByGemmi(file);
    for (const gemmi::Assembly& assembly : structure.assemblies) {
      CAPTURE(file.filename().string());
      CAPTURE(assembly.name);
      gemmi::Structure theirs = structure;
      dropLeftOut(theirs);
      gemmi::transform_to_assembly(theirs, assembly.name, gemmi::HowToNameCopiedChain::AddNumber, nullptr);
      std::vector<PlacedAtom> by_gemmi, by_ours;
      for (const gemmi::Chain& chain : theirs.models.at(0).chains)
        for (const gemmi::Residue& residue : chain.residues)
          for (const gemmi::Atom& a : residue.atoms) {
            PlacedAtom& atom = by_gemmi.emplace_back();
            atom.position.A = {a.pos.x, a.pos.y, a.pos.z};
            atom.atomic_number = std::uint8_t(a.element.atomic_number());
          }
      ReadOptions options;
      options.assembly = assembly.name;
      const Expected<Molecule> ours = readMolecule(file, options);
      REQUIRE(ours);
      for (std::size_t k = 0; k < ours->atoms.size(); ++k) by_ours.push_back(ours->at(k));
      CHECK(by_ours.size() == by_gemmi.size());
      CHECK(unmatched(by_ours, by_gemmi) == 0);
      ++assemblies;
      copied += by_ours.size();
    }
  }
  CHECK(assemblies >= 2);  // those of 1RB8, a virus, and of 2POR, a trimer
  CHECK(copied > 200'000);
}

}  // namespace moltact
