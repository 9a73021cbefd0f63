#include "engine/molecule/write_sdf.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"

namespace moltact {
namespace {

constexpr std::size_t kSdfLine = 80, kMaxItem = 200;

std::string sdfText(std::string_view text, std::size_t columns) {
  std::string out(text.substr(0, columns));
  for (char& c : out)
    if (c < ' ' || c > '~') c = '?';
  return out;
}

int sdfBondType(BondOrder order) {
  switch (order) {
    case BondOrder::Single:
      return 1;
    case BondOrder::Double:
      return 2;
    case BondOrder::Triple:
      return 3;
    case BondOrder::Aromatic:
      return 4;
    case BondOrder::Coordination:
      return 9;
    case BondOrder::Unknown:
      break;
  }
  return 8;
}

std::string sdfSymbol(const Atom& atom) {
  return atom.atomic_number ? std::string(element(atom.atomic_number).symbol) : std::string("*");
}

template <class... Values>
void addFormatted(std::string& out, const char* format, Values... values) {
  char line[160];
  std::snprintf(line, sizeof line, format, values...);
  out += line;
}

struct SdfMolecule {
  const Molecule& molecule;
  const SdfAtoms& what;
  std::vector<Bond> bonds;  // ends count from 0 in `what`

  int charge_e(std::size_t k) const { return k < what.formal_charges_e.size() ? what.formal_charges_e[k] : 0; }

  void addV2000(std::string& out) const {
    // Counts of atoms and bonds, no lists of atoms, not chiral, and the number 999 for the lines of properties.
    addFormatted(out, "%3d%3d  0  0  0  0  0  0  0  0999 V2000\n", int(what.atoms.size()), int(bonds.size()));
    for (std::size_t k = 0; k < what.atoms.size(); ++k) {
      const Vec3& p = what.places_A[k];
      addFormatted(out, "%10.4f%10.4f%10.4f %-3s 0  0  0  0  0  0  0  0  0  0  0  0\n", p.x, p.y, p.z,
                   sdfSymbol(molecule.atoms[what.atoms[k]]).c_str());
    }
    for (const Bond& b : bonds)
      addFormatted(out, "%3d%3d%3d  0  0  0  0\n", int(b.first + 1), int(b.second + 1), sdfBondType(b.order));
    std::vector<std::size_t> charged;
    for (std::size_t k = 0; k < what.atoms.size(); ++k)
      if (charge_e(k) != 0) charged.push_back(k);
    constexpr std::size_t kInLine = 8;
    for (std::size_t first = 0; first < charged.size(); first += kInLine) {
      const std::size_t end = std::min(first + kInLine, charged.size());
      addFormatted(out, "M  CHG%3d", int(end - first));
      for (std::size_t k = first; k < end; ++k)
        addFormatted(out, " %3d %3d", int(charged[k] + 1), charge_e(charged[k]));
      out += '\n';
    }
  }

  void addV3000(std::string& out) const {
    out += "  0  0  0  0  0  0  0  0  0  0999 V3000\nM  V30 BEGIN CTAB\n";
    addFormatted(out, "M  V30 COUNTS %zu %zu 0 0 0\nM  V30 BEGIN ATOM\n", what.atoms.size(), bonds.size());
    for (std::size_t k = 0; k < what.atoms.size(); ++k) {
      const Vec3& p = what.places_A[k];
      addFormatted(out, "M  V30 %zu %s %.4f %.4f %.4f 0", k + 1, sdfSymbol(molecule.atoms[what.atoms[k]]).c_str(), p.x,
                   p.y, p.z);
      if (charge_e(k) != 0) addFormatted(out, " CHG=%d", charge_e(k));
      out += '\n';
    }
    out += "M  V30 END ATOM\n";
    if (!bonds.empty()) {
      out += "M  V30 BEGIN BOND\n";
      for (std::size_t k = 0; k < bonds.size(); ++k)
        addFormatted(out, "M  V30 %zu %d %u %u\n", k + 1, sdfBondType(bonds[k].order), bonds[k].first + 1,
                     bonds[k].second + 1);
      out += "M  V30 END BOND\n";
    }
    out += "M  V30 END CTAB\n";
  }
};

}  // namespace

Expected<std::string> posedSdf(const Molecule& molecule, const SdfAtoms& what, std::span<const Bond> bonds,
                               const std::string& title, const std::string& comment, std::span<const SdfItem> items) {
  for (const Vec3& place : what.places_A)
    for (int axis = 0; axis < 3; ++axis)
      if (!(place[axis] > -9999.9999 && place[axis] < 99999.9999))
        return Problem{"", 0, 0,
                       tr("an atom is too far from the origin for an SD file, which holds -9999.9999 to 99999.9999 Å"),
                       tr("move the molecule to the origin")};
  SdfMolecule written{molecule, what, {}};
  std::unordered_map<std::uint32_t, std::uint32_t> number_of;
  for (std::size_t k = 0; k < what.atoms.size(); ++k) number_of.emplace(what.atoms[k], std::uint32_t(k));
  bool coordinates = false;
  for (const Bond& b : bonds) {
    const auto first = number_of.find(b.first), second = number_of.find(b.second);
    if (first == number_of.end() || second == number_of.end()) continue;
    written.bonds.push_back({first->second, second->second, b.order});
    coordinates = coordinates || b.order == BondOrder::Coordination;
  }
  // Program in columns 3-10, no date, "3D" in columns 21-22.
  std::string out = sdfText(title, kSdfLine) + "\n  Moltact           3D\n" + sdfText(comment, kSdfLine) + '\n';
  if (what.atoms.size() > kMaxV2000 || written.bonds.size() > kMaxV2000 || coordinates)
    written.addV3000(out);
  else
    written.addV2000(out);
  out += "M  END\n";
  for (const SdfItem& item : items) out += "> <" + item.name + ">\n" + sdfText(item.value, kMaxItem) + "\n\n";
  return out + "$$$$\n";
}

}  // namespace moltact
