// HIV-1 protease of PDB entry 1HPV with its flaps turned open: a model, no measured structure. Each flap, residues 40 to
// 61 of a chain, is turned as one stiff piece about the line through the alpha carbons at its two ends, away from the
// tunnel. Bond lengths stay; the angles at these two atoms give way.
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <map>
#include <numbers>
#include <sstream>

#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

constexpr int kFirst = 40, kLast = 61, kTip = 50, kFloor = 25;

struct Atom {
  std::string name;
  char chain = ' ';
  int residue = 0;
  glm::dvec3 place{0.0};
};

Atom atomOf(const std::string& line) {
  const std::string name = line.substr(12, 4);
  const std::size_t from = name.find_first_not_of(' ');
  return {name.substr(from, name.find_last_not_of(' ') - from + 1),
          line[21],
          std::stoi(line.substr(22, 4)),
          {std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)), std::stod(line.substr(46, 8))}};
}

// What is beyond either alpha carbon on the flap's side of the chain.
bool turns(const Atom& a) {
  if (a.residue == kFirst) return a.name == "C" || a.name == "O";
  if (a.residue == kLast) return a.name == "N";
  return a.residue > kFirst && a.residue < kLast;
}

glm::dvec3 turned(const glm::dvec3& place, const glm::dvec3& on_axis, const glm::dvec3& axis, double angle) {
  const glm::dvec3 v = place - on_axis;
  return on_axis + v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * (glm::dot(axis, v) * (1.0 - std::cos(angle)));
}

}  // namespace

std::string makeOpenProtease(const std::string& entry, double angle_deg) {
  std::map<std::pair<char, int>, glm::dvec3> alpha;
  std::istringstream lines(entry);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("ATOM  "))
      if (const Atom a = atomOf(line); a.name == "CA") alpha[{a.chain, a.residue}] = a.place;

  char angle_text[8];
  std::snprintf(angle_text, sizeof angle_text, "%.0f", angle_deg);
  std::string out =
      "TITLE     HIV-1 PROTEASE, ITS FLAPS TURNED OPEN (A MODEL)\n"
      "REMARK   1 FROM PDB ENTRY 1HPV (CC0): ATOM, HETATM AND TER OF PROTEIN AND DRUG\n"
      "REMARK   1 A MODEL, NOT A MEASURED STRUCTURE: RESIDUES 40-61 OF EACH CHAIN ARE\n"
      "REMARK   1 TURNED BY " +
      std::string(angle_text) +
      " DEGREES ABOUT THE LINE THROUGH CA 40 AND CA 61\n"
      "REMARK   1 LEFT OUT: WATER\n"
      "REMARK   1 MADE BY MOLTACT_GENERATE_MOLECULES\n";
  std::istringstream again(entry);
  for (std::string line; std::getline(again, line);) {
    const bool drug = line.starts_with("HETATM") && line.substr(17, 3) == "478";
    if (!line.starts_with("ATOM  ") && !line.starts_with("TER") && !drug) continue;
    if (line.starts_with("ATOM  ")) {
      const Atom a = atomOf(line);
      if (turns(a)) {
        const glm::dvec3 from = alpha.at({a.chain, kFirst}), to = alpha.at({a.chain, kLast});
        const glm::dvec3 axis = glm::normalize(to - from), floor = alpha.at({a.chain, kFloor}),
                         tip = alpha.at({a.chain, kTip});
        const double angle = angle_deg * std::numbers::pi / 180.0;
        // Toward the side on which the tip gets farther away from the floor of the tunnel.
        const bool opens = glm::distance(turned(tip, from, axis, angle), floor) >
                           glm::distance(turned(tip, from, axis, -angle), floor);
        const glm::dvec3 place = turned(a.place, from, axis, opens ? angle : -angle);
        char fields[32];
        std::snprintf(fields, sizeof fields, "%8.3f%8.3f%8.3f", place.x, place.y, place.z);
        line.replace(30, 24, fields);
      }
    }
    out += line + '\n';
  }
  return out + "END\n";
}

}  // namespace moltact::generator
