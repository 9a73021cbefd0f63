// A haem of deoxyhaemoglobin with the four residues nearest to its iron, cut out of PDB entry 2HHB and rotated.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <sstream>
#include <stdexcept>

#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(' ');
  return from == std::string::npos ? std::string() : text.substr(from, text.find_last_not_of(' ') + 1 - from);
}

MadeAtom atomOf(const std::string& line) {
  MadeAtom a;
  a.name = trimmed(line.substr(12, 4));
  a.residue = line.substr(17, 3);
  // The entry has other data in the columns of the element, so it is taken from columns 13 and 14, right-aligned.
  a.element = trimmed(line.substr(12, 2));
  if (a.element.size() == 2 && a.element != "FE") a.element.resize(1);
  a.chain = line[21];
  a.number = std::atoi(line.substr(22, 4).c_str());
  a.position_A = {std::atof(line.substr(30, 8).c_str()), std::atof(line.substr(38, 8).c_str()),
                  std::atof(line.substr(46, 8).c_str())};
  a.hetero = line.starts_with("HETATM");
  return a;
}

Vec3 placeOf(const std::vector<MadeAtom>& atoms, const char* residue, const char* name, int number) {
  for (const MadeAtom& a : atoms)
    if (a.residue == residue && a.name == name && a.number == number) return a.position_A;
  throw std::runtime_error(std::string("no atom ") + name + " of " + residue);
}

}  // namespace

std::string makeHaemPocket(const std::string& entry, char chain) {
  const bool alpha = chain == 'A';
  const int proximal = alpha ? 87 : 92;
  const std::vector<int> kept = alpha ? std::vector<int>{43, 58, 62, 87} : std::vector<int>{42, 63, 67, 92};
  std::vector<MadeAtom> atoms;
  std::istringstream lines(entry);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("ATOM  ") && !line.starts_with("HETATM")) continue;
    const MadeAtom a = atomOf(line);
    const bool wanted =
        a.residue == "HEM" || (!a.hetero && std::find(kept.begin(), kept.end(), a.number) != kept.end());
    if (a.chain == chain && wanted) atoms.push_back(a);
  }

  // The haem's normal toward the distal histidine is at 30 degrees from y toward z. Its methine bridge opposite the
  // propionates points toward z.
  const Vec3 iron = placeOf(atoms, "HEM", "FE", 1);
  const auto haem = [&](const char* name) { return placeOf(atoms, "HEM", name, 1); };
  Vec3 up = glm::normalize(glm::cross(haem("N A") - haem("N C"), haem("N B") - haem("N D")));
  if (glm::dot(iron - placeOf(atoms, "HIS", "NE2", proximal), up) < 0) up = -up;
  Vec3 front = haem("CHC") - iron;
  front = glm::normalize(front - up * glm::dot(front, up));
  const Vec3 right = glm::cross(up, front);
  const double c = std::sqrt(0.75), s = 0.5;
  for (MadeAtom& a : atoms) {
    const Vec3 p = a.position_A - iron;
    const double y = glm::dot(p, up), z = glm::dot(p, front);
    a.position_A = {glm::dot(p, right), c * y - s * z, s * y + c * z};
  }
  return writePdb(
      std::string("A HAEM AND FOUR RESIDUES OF THE ") + (alpha ? "ALPHA" : "BETA") + " CHAIN OF DEOXYHAEMOGLOBIN",
      {std::string("FROM PDB ENTRY 2HHB (CC0), CHAIN ") + chain + ", TURNED: THE IRON AT THE ORIGIN",
       alpha ? "PHE 43 (CD1), HIS 58 (E7), VAL 62 (E11), HIS 87 (F8)"
             : "PHE 42 (CD1), HIS 63 (E7), VAL 67 (E11), HIS 92 (F8)",
       "MADE BY MOLTACT_GENERATE_MOLECULES"},
      atoms);
}

}  // namespace moltact::generator
