#include "app/commands/molecule_argument.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/commands/command.h"
#include "engine/core/problem.h"

namespace moltact {
namespace {

// Stands in for engine/molecule/reader.h: ATOM and HETATM of a PDB file, or x y z r lines.
Expected<Molecule> readAtoms(const std::string& file) {
  std::ifstream in(file);
  if (!in) return Problem{.file = file, .message = "cannot be opened", .remedy = "give the path of a molecule file"};
  Molecule molecule;
  molecule.id = file;
  const bool xyzr = file.ends_with(".xyzr");
  std::string line;
  while (std::getline(in, line)) {
    Atom atom;
    if (xyzr) {
      std::istringstream fields(line);
      if (!(fields >> atom.position.A.x >> atom.position.A.y >> atom.position.A.z >> atom.radius_A)) continue;
      atom.atomic_number = atom.radius_A < 1.3 ? 1 : 6;
    } else {
      if (line.starts_with("ENDMDL")) break;
      if ((!line.starts_with("ATOM") && !line.starts_with("HETATM")) || line.size() < 54) continue;
      if (line.substr(17, 3) == "HOH") continue;
      for (int k = 0; k < 3; ++k) atom.position.A[k] = std::strtod(line.substr(std::size_t(30 + 8 * k), 8).c_str(), nullptr);
      const std::string element = line.size() >= 78 ? line.substr(76, 2) : line.substr(12, 2);
      struct Kind { const char* name; int number; double radius; };
      for (const Kind k : {Kind{" C", 6, 1.70}, {" N", 7, 1.55}, {" O", 8, 1.52}, {" S", 16, 1.80}, {" P", 15, 1.80}, {" H", 1, 1.20}, {"FE", 26, 2.44}})
        if (element == k.name) atom.atomic_number = std::uint8_t(k.number), atom.radius_A = k.radius;
      if (!atom.atomic_number) atom.radius_A = 1.7;
    }
    molecule.atoms.push_back(atom);
  }
  if (molecule.atoms.empty()) return Problem{.file = file, .message = "holds no atoms", .remedy = "give a PDB file"};
  return molecule;
}

}  // namespace

std::shared_ptr<const Molecule> moleculeArgument(const std::string& argument) {
  auto molecule = readAtoms(argument);
  if (!molecule) throw CommandError{molecule.problem().text()};
  return std::make_shared<const Molecule>(*std::move(molecule));
}

}  // namespace moltact
