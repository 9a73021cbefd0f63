#include "engine/molecule/write_pose.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string_view>

#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"

namespace moltact {
namespace {

constexpr std::size_t kTitle = 70, kRemark = 69;  // columns after the record's name

std::string ascii(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c < ' ' || c > '~') c = '?';
  return out;
}

void addRecord(std::string& out, const char* record, std::string_view text, std::size_t columns) {
  do {
    std::size_t end = text.size();
    if (end > columns) {
      const std::size_t space = text.rfind(' ', columns);
      end = space == std::string_view::npos || space == 0 ? columns : space;
    }
    out.append(record).append(text.substr(0, end)) += '\n';
    text.remove_prefix(std::min(text.size(), end + (end < text.size() && text[end] == ' ')));
  } while (!text.empty());
}

}  // namespace

Expected<std::string> posedPdb(const Molecule& molecule, std::span<const std::uint32_t> atoms,
                               std::span<const Vec3> places_A, const std::string& title,
                               std::span<const std::string> remarks) {
  for (const Vec3& place : places_A)
    for (int axis = 0; axis < 3; ++axis)
      if (!(place[axis] > -999.9994 && place[axis] < 9999.9994))
        return Problem{"", 0, 0,
                       tr("an atom is too far from the origin for a PDB file, which holds -999.999 to 9999.999 Å"),
                       tr("move the molecule to the origin")};
  std::string out;
  addRecord(out, "TITLE     ", ascii(title).substr(0, kTitle), kTitle);
  for (const std::string& remark : remarks) addRecord(out, "REMARK   1 ", ascii(remark), kRemark);
  constexpr int kMaxSerial = 99'999, kMaxResidue = 9'999, kMinResidue = -999;
  for (std::size_t k = 0; k < std::min(atoms.size(), places_A.size()); ++k) {
    const Atom& atom = molecule.atoms[atoms[k]];
    std::string residue = "UNK", chain = "A";
    int number = 1;
    char insertion = ' ';
    bool polymer = false;
    if (atom.residue != kNoResidue) {
      const Residue& r = molecule.residues[atom.residue];
      residue = ascii(std::string(r.name)).substr(0, 3);
      number = std::clamp(r.number, kMinResidue, kMaxResidue);
      insertion = r.insertion;
      polymer = r.kind == ResidueKind::AminoAcid || r.kind == ResidueKind::Nucleotide;
      if (r.chain < molecule.chains.size()) chain = ascii(std::string(molecule.chains[r.chain].name));
    }
    std::string symbol(atom.atomic_number ? element(atom.atomic_number).symbol : std::string_view());
    for (char& c : symbol) c = char(std::toupper(static_cast<unsigned char>(c)));
    std::string name = ascii(atom.nameText()).substr(0, 4);
    if (name.empty()) name = symbol;
    // In the four columns of the name, one-letter elements begin in the second column.
    if (name.size() < 4 && symbol.size() < 2) name.insert(name.begin(), ' ');
    char line[128];
    std::snprintf(line, sizeof line, "%-6s%5d %-4s %3s %c%4d%c   %8.3f%8.3f%8.3f%6.2f%6.2f          %2s\n",
                  polymer ? "ATOM" : "HETATM", int(std::min(k + 1, std::size_t(kMaxSerial))), name.c_str(),
                  residue.c_str(), chain.empty() ? ' ' : chain[0], number, insertion, places_A[k].x, places_A[k].y,
                  places_A[k].z, 1.0, double(atom.b_factor_A2), symbol.c_str());
    out += line;
  }
  return out + "END\n";
}

}  // namespace moltact
