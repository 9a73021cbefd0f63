#include "engine/molecule/side_by_side.h"

#include <algorithm>
#include <gemmi/qcp.hpp>
#include <map>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct Box {
  Vec3 low{1e300}, high{-1e300};
  Vec3 middle() const { return 0.5 * (low + high); }
};

Box boxOf(const Molecule& molecule) {
  Box box;
  for (const Sphere& a : molecule.spheres) {
    box.low = glm::min(box.low, a.centre_A - a.radius_A);
    box.high = glm::max(box.high, a.centre_A + a.radius_A);
  }
  return box;
}

using ResidueName = std::tuple<std::string_view, int, char>;  // chain, number, insertion code

// The representative atom of each residue.
std::map<ResidueName, std::pair<std::string_view, Vec3>> leadingAtoms(const Molecule& m) {
  std::map<ResidueName, std::pair<std::string_view, Vec3>> out;
  for (const Residue& r : m.residues)
    for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i)
      if (const std::string_view name = m.atoms[i].nameText();
          (r.kind == ResidueKind::AminoAcid && name == "CA") || (r.kind == ResidueKind::Nucleotide && name == "P"))
        out.emplace(ResidueName{m.chains[r.chain].name, r.number, r.insertion},
                    std::pair{std::string_view(r.name), m.spheres[i].centre_A});
  return out;
}

// Rotates the second molecule to the orientation of the first if they are mostly the same molecule.
void turnAlike(const Molecule& first, Molecule& second) {
  std::vector<gemmi::Position> here, there;
  std::size_t common = 0;
  const auto of_second = leadingAtoms(second);
  for (const auto& [name, atom] : leadingAtoms(first)) {
    const auto same = of_second.find(name);
    if (same == of_second.end()) continue;
    ++common;
    if (same->second.first != atom.first) continue;
    here.emplace_back(atom.second.x, atom.second.y, atom.second.z);
    there.emplace_back(same->second.second.x, same->second.second.y, same->second.second.z);
  }
  if (here.size() < 3 || 2 * here.size() < common) return;
  const gemmi::SupResult fit = gemmi::superpose_positions(here.data(), there.data(), here.size(), nullptr);
  std::vector<Sphere> turned = second.spheres.copy();
  for (Sphere& b : turned) {
    const gemmi::Vec3 to = fit.transform.apply(gemmi::Vec3(b.centre_A.x, b.centre_A.y, b.centre_A.z));
    if (const Vec3 place(to.x, to.y, to.z); finite(place)) b.centre_A = place;
  }
  second.spheres = std::move(turned);
}

// The first array, then the second with each element mapped.
template <class T, class Map>
std::vector<T> joined(const SharedArray<T>& first, const SharedArray<T>& second, Map&& mapped) {
  std::vector<T> out;
  out.reserve(first.size() + second.size());
  out.insert(out.end(), first.begin(), first.end());
  for (const T& item : second) out.push_back(mapped(item));
  return out;
}

}  // namespace

Molecule sideBySide(Molecule first, Molecule second) {
  turnAlike(first, second);
  const Box left = boxOf(first), right = boxOf(second);
  Vec3 shift = left.middle() - right.middle();
  shift.x = left.high.x + kBesideGap_A - right.low.x;
  Molecule out = first;
  const auto atoms = std::uint32_t(first.atoms.size()), residues = std::uint32_t(first.residues.size()),
             chains = std::uint32_t(first.chains.size());
  out.beside_from = atoms;
  out.beside_id = second.id;
  out.numbers_in_file = {};
  out.atoms_in_file = 0;
  out.atoms = joined(first.atoms, second.atoms, [&](Atom a) {
    if (a.residue != kNoResidue) a.residue += residues;
    return a;
  });
  out.spheres = joined(first.spheres, second.spheres, [&](Sphere b) {
    b.centre_A += shift;
    return b;
  });
  // A charge of 0 replaces the missing charges of a file without charges.
  if (!first.charges_e.empty() || !second.charges_e.empty()) {
    const auto chargesOf = [](const Molecule& m) {
      return m.charges_e.empty() ? SharedArray<float>(std::vector<float>(m.atoms.size())) : m.charges_e;
    };
    out.charges_e = joined(chargesOf(first), chargesOf(second), [](float c) { return c; });
  }
  if (!first.formal_charges_e.empty() || !second.formal_charges_e.empty()) {
    const auto formalOf = [](const Molecule& m) {
      return m.formal_charges_e.empty() ? SharedArray<std::int8_t>(std::vector<std::int8_t>(m.atoms.size()))
                                        : m.formal_charges_e;
    };
    out.formal_charges_e = joined(formalOf(first), formalOf(second), [](std::int8_t c) { return c; });
  }
  out.residues = joined(first.residues, second.residues, [&](Residue r) {
    r.chain += chains;
    r.first_atom += atoms;
    return r;
  });
  out.chains = joined(first.chains, second.chains, [&](Chain c) {
    c.name = std::string(c.name) + kBesideEnding;
    c.first_residue += residues;
    return c;
  });
  // Bonds and helices that only one of the two files lists are computed for both.
  if (first.listed_bonds.empty() || second.listed_bonds.empty())
    out.listed_bonds = {};
  else
    out.listed_bonds = joined(first.listed_bonds, second.listed_bonds, [&](Bond b) {
      return Bond{b.first + atoms, b.second + atoms, b.order};
    });
  out.has_recorded_structure = out.has_recorded_structure && second.has_recorded_structure;
  out.warnings = joined(first.warnings, second.warnings, [](const std::string& w) { return w; });
  out.waters_left_out += second.waters_left_out;
  out.alternates_left_out += second.alternates_left_out;
  return out;
}

ReadOptions besideReading(ReadOptions first) {
  const ReadOptions usual;
  first.model = usual.model;
  first.assembly = usual.assembly;
  first.beside = usual.beside;
  return first;
}

Expected<Molecule> readSideBySide(const fs::path& file, const ReadOptions& reading) {
  ReadOptions alone = reading;
  alone.beside.clear();
  Expected<Molecule> first = readMolecule(file, alone);
  if (!first) return first;
  std::error_code error;
  fs::path other = file.parent_path() / reading.beside;
  if (!fs::is_regular_file(other, error)) {
    MoleculeFolders folders = MoleculeFolders::ofThisComputer();
    folders.beside = file.has_parent_path() ? file.parent_path() : fs::path(".");
    Expected<fs::path> found = findMolecule(reading.beside, folders);
    if (!found) return found.problem();
    other = *std::move(found);
  }
  Expected<Molecule> second = readMolecule(other, besideReading(reading));
  if (!second) return second;
  return sideBySide(*std::move(first), *std::move(second));
}

}  // namespace moltact
