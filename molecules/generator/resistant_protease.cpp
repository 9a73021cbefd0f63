// HIV-1 protease of PDB entry 1HPV with isoleucine 84 of both chains changed to valine, as in viruses that resist the
// drug; and one file with the drug in three places. Both are models: no atom moves to make room or to fill it.
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <sstream>
#include <vector>

#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

constexpr const char* kChanged = "  84";
constexpr double kApart_A = 80.0;  // of the two proteases in the file with three places

// The deepest place outside the tunnel that 40 falls onto the shut protease found (SceneForces::wells with forces: all
// in water, and a coupling of 10 N/m): the middle of the drug, and its turn from the crystal's pose.
constexpr glm::dvec3 kOutside_A{13.9425, 24.8811, 29.8303};
constexpr glm::dquat kOutsideTurn{0.376865, -0.804874, -0.302632, -0.344333};

bool isDrug(const std::string& line) { return line.starts_with("HETATM") && line.substr(17, 3) == "478"; }

glm::dvec3 atomPlace(const std::string& line) {
  return {std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)), std::stod(line.substr(46, 8))};
}

std::vector<std::string> linesOf(const std::string& text, bool drug) {
  std::vector<std::string> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (drug ? isDrug(line) : line.starts_with("ATOM  ") || line.starts_with("TER")) out.push_back(line);
  return out;
}

// Adds lines with their atoms numbered on, in another chain and at other places.
template <class Move>
void append(std::string& out, int& serial, const std::vector<std::string>& lines, const char* chains, Move&& move) {
  for (std::string line : lines) {
    char number[12];
    std::snprintf(number, sizeof number, "%5d", ++serial);
    line.replace(6, 5, number);
    if (line.size() > 21) line[21] = line[21] == 'B' ? chains[1] : chains[0];
    if (!line.starts_with("TER")) {
      const glm::dvec3 place = move(atomPlace(line));
      char fields[32];
      std::snprintf(fields, sizeof fields, "%8.3f%8.3f%8.3f", place.x, place.y, place.z);
      line.replace(30, 24, fields);
    }
    out += line + '\n';
  }
}

}  // namespace

std::string makeResistantProtease(const std::string& entry) {
  std::string out =
      "TITLE     HIV-1 PROTEASE I84V WITH AMPRENAVIR (A MODEL)\n"
      "REMARK   1 FROM PDB ENTRY 1HPV (CC0): ATOM, HETATM AND TER OF PROTEIN AND DRUG\n"
      "REMARK   1 A MODEL, NOT A MEASURED STRUCTURE: ISOLEUCINE 84 OF BOTH CHAINS IS\n"
      "REMARK   1 CHANGED TO VALINE. CD1 IS LEFT OUT, CG1 AND CG2 CHANGE THEIR NAMES,\n"
      "REMARK   1 WHICH VALINE HAS THE OTHER WAY ROUND. NO ATOM MOVES.\n"
      "REMARK   1 LEFT OUT: WATER\n"
      "REMARK   1 MADE BY MOLTACT_GENERATE_MOLECULES\n";
  std::istringstream lines(entry);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("ATOM  ") && !line.starts_with("TER") && !isDrug(line)) continue;
    if (line.starts_with("ATOM  ") && line.substr(22, 4) == kChanged && line.substr(17, 3) == "ILE") {
      const std::string name = line.substr(12, 4);
      if (name == " CD1") continue;
      line.replace(17, 3, "VAL");
      if (name == " CG1") line.replace(12, 4, " CG2");
      if (name == " CG2") line.replace(12, 4, " CG1");
    }
    out += line + '\n';
  }
  return out + "END\n";
}

std::string makeThreeHolds(const std::string& entry, const std::string& open) {
  std::string out =
      "TITLE     AMPRENAVIR IN THREE PLACES OF HIV-1 PROTEASE (A MODEL)\n"
      "REMARK   1 FROM PDB ENTRY 1HPV (CC0): ATOM, HETATM AND TER OF PROTEIN AND DRUG\n"
      "REMARK   1 CHAINS A, B: THE PROTEASE AS IN THE ENTRY. C: THE DRUG IN ITS TUNNEL\n"
      "REMARK   1 CHAINS D, E: 1HPV-OPEN, MOVED BY 80 A ALONG X. F: THE DRUG IN ITS TUNNEL\n"
      "REMARK   1 CHAIN G: THE DRUG OUTSIDE ON A AND B, WHERE THE DEEPEST OF 40 FALLS ENDS\n"
      "REMARK   1 D, E AND G ARE MODELS, NOT MEASURED STRUCTURES\n"
      "REMARK   1 LEFT OUT: WATER\n"
      "REMARK   1 MADE BY MOLTACT_GENERATE_MOLECULES\n";
  const std::vector<std::string> drug = linesOf(entry, true);
  glm::dvec3 middle(0.0);
  for (const std::string& line : drug) middle += atomPlace(line) / double(drug.size());
  int serial = 0;
  const auto stay = [](const glm::dvec3& p) { return p; };
  const auto beside = [](const glm::dvec3& p) { return p + glm::dvec3(kApart_A, 0.0, 0.0); };
  const auto outside = [&](const glm::dvec3& p) { return kOutside_A + glm::normalize(kOutsideTurn) * (p - middle); };
  append(out, serial, linesOf(entry, false), "AB", stay);
  append(out, serial, linesOf(open, false), "DE", beside);
  append(out, serial, drug, "CC", stay);
  append(out, serial, drug, "FF", beside);
  append(out, serial, drug, "GG", outside);
  return out + "END\n";
}

}  // namespace moltact::generator
