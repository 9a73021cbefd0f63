// Small molecules whose geometry needs only a few numbers.
#include <cmath>
#include <numbers>

#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

Vec3 onCircle(double radius_A, double deg) {
  const double angle = deg * std::numbers::pi / 180;
  return {radius_A * std::cos(angle), radius_A * std::sin(angle), 0.0};
}

constexpr const char* kMaker = "MADE BY MOLTACT_GENERATE_MOLECULES";
constexpr double kRing_C_C = 1.397, kRing_C_H = 1.084;
constexpr const char* kRingSource = "C-C 1.397 A, C-H 1.084 A: B. P. STOICHEFF, CAN. J. PHYS. 32, 339 (1954)";
constexpr double kO_H = 0.9572, kHalfAngle_deg = 104.52 / 2;
constexpr const char* kWaterSource = "O-H 0.9572 A, H-O-H 104.52 DEGREES: W. S. BENEDICT, N. GAILAR, E. K. PLYLER,";
constexpr const char* kWaterWhere = "J. CHEM. PHYS. 24, 1139 (1956)";
constexpr double kAr_Ar = 3.76;
constexpr const char* kArgonSource = "AR-AR 3.76 A: E. A. COLBOURN, A. E. DOUGLAS, J. CHEM. PHYS. 65, 1741 (1976)";

}  // namespace

std::string makeWater() {
  const auto hydrogen = [&](double side) { return onCircle(kO_H, -90 + side * kHalfAngle_deg); };
  return writePdb("WATER", {kWaterSource, kWaterWhere, kMaker},
                  {{"O", "HOH", "O", 'A', 1, {0, 0, 0}, true},
                   {"H1", "HOH", "H", 'A', 1, hydrogen(-1), true},
                   {"H2", "HOH", "H", 'A', 1, hydrogen(1), true}});
}

std::string makeBenzene() {
  // In a regular hexagon the radius equals the side.
  constexpr double kC_C = kRing_C_C, kC_H = kRing_C_H;
  std::vector<MadeAtom> atoms;
  for (int i = 0; i < 6; ++i)
    atoms.push_back(
        {std::string("C").append(std::to_string(i + 1)), "BNZ", "C", 'A', 1, onCircle(kC_C, 90 - 60 * i), true});
  for (int i = 0; i < 6; ++i)
    atoms.push_back(
        {std::string("H").append(std::to_string(i + 1)), "BNZ", "H", 'A', 1, onCircle(kC_C + kC_H, 90 - 60 * i), true});
  return writePdb("BENZENE", {kRingSource, kMaker}, atoms);
}

// Five hexagons in a row along x. Atoms are numbered from left to right: ring k = 0 … 4 has those from 4 k to 4 k + 5.
std::string makePentacene() {
  constexpr int kRings = 5;
  const double rise_A = std::sqrt(3.0) * kRing_C_C, half_A = kRing_C_C / 2, slant = std::sqrt(3.0) / 2;
  std::vector<MadeAtom> carbons, hydrogens;
  const auto carbon = [&](double x, double y) {
    carbons.push_back(
        {std::string("C").append(std::to_string(carbons.size() + 1)), "PEN", "C", 'A', 1, {x, y, 0}, true});
  };
  const auto hydrogen = [&](double x, double y) {
    hydrogens.push_back(
        {std::string("H").append(std::to_string(hydrogens.size() + 1)), "PEN", "H", 'A', 1, {x, y, 0}, true});
  };
  for (int k = 0; k <= kRings; ++k) {
    // The bond that ring k shares with the preceding ring, perpendicular to the row; at either end it has hydrogens.
    const double x = (k - kRings / 2.0) * rise_A;
    for (const double side : {1.0, -1.0}) carbon(x, side * half_A);
    const double end = k == 0 ? -1 : k == kRings ? 1 : 0;
    if (end != 0.0)
      for (const double side : {1.0, -1.0}) hydrogen(x + end * slant * kRing_C_H, side * (half_A + kRing_C_H / 2));
    if (k == kRings) break;
    for (const double side : {1.0, -1.0}) {
      carbon(x + rise_A / 2, side * kRing_C_C);
      hydrogen(x + rise_A / 2, side * (kRing_C_C + kRing_C_H));
    }
  }
  std::vector<MadeAtom> atoms = carbons;
  atoms.insert(atoms.end(), hydrogens.begin(), hydrogens.end());
  return writePdb("PENTACENE",
                  {"IDEALISED: FIVE REGULAR HEXAGONS WITH THE BOND LENGTHS OF BENZENE,", kRingSource,
                   "IN THE CRYSTAL THE C-C BONDS ARE NOT ALL ALIKE: R. B. CAMPBELL, J. M. ROBERTSON, J. TROTTER,",
                   "ACTA CRYST. 14, 705 (1961)", kMaker},
                  atoms);
}

std::string makeArgon(int count) {
  const double angle_deg = count > 1 ? 360.0 / count : 0.0;
  const double radius_A = count > 1 ? kAr_Ar / (2 * std::sin(std::numbers::pi / count)) : 0.0;
  std::vector<MadeAtom> atoms;
  for (int i = 0; i < count; ++i)
    atoms.push_back({"AR", "AR", "AR", 'A', i + 1, onCircle(radius_A, (count == 2 ? 0 : 90) + i * angle_deg), true});
  const char* titles[] = {"ONE ARGON ATOM", "TWO ARGON ATOMS", "THREE ARGON ATOMS"};
  std::vector<std::string> remarks;
  if (count > 1) remarks = {kArgonSource};
  if (count == 3) remarks.push_back("THE TRIMER AS AN EQUILATERAL TRIANGLE WITH THE DIMER'S DISTANCE");
  remarks.push_back(kMaker);
  return writePdb(titles[count - 1], remarks, atoms);
}

// Four groups around the y axis, each facing its own side: chain A the front, the others in order to the right.
std::string makeArgonShapes() {
  constexpr double kApart_A = 8.0;  // from the axis, so that a probe of water's size passes between any two
  const double corner_A = kAr_Ar / std::sqrt(3.0);
  const std::vector<std::vector<Vec3>> groups{
      {{0, 0, 0}},
      {{0, kAr_Ar / 2, 0}, {0, -kAr_Ar / 2, 0}},
      {{0, kAr_Ar, 0}, {0, 0, 0}, {0, -kAr_Ar, 0}},
      {{0, corner_A, 0}, {-kAr_Ar / 2, -corner_A / 2, 0}, {kAr_Ar / 2, -corner_A / 2, 0}},
  };
  std::vector<MadeAtom> atoms;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    // The group's own x axis and outward direction after g quarter turns.
    const Vec3 across[] = {{1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}},
               out[] = {{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}};
    int number = 0;
    for (const Vec3& p : groups[g])
      atoms.push_back({"AR", "AR", "AR", static_cast<char>('A' + g), ++number,
                       out[g] * kApart_A + across[g] * p.x + Vec3(0, p.y, 0), true});
  }
  return writePdb(
      "ONE ARGON ATOM, TWO, THREE IN A ROW AND THREE IN A TRIANGLE",
      {kArgonSource, "THE ROW AND THE TRIANGLE WITH THE DIMER'S DISTANCE; THE GROUPS 8 A FROM ONE AXIS", kMaker},
      atoms);
}

// Chain A: two waters, of which the upper one is the hydrogen bond's donor; chain B: two argon atoms. The residues are
// not named as water, because waters are left out when a file is read.
std::string makeWaterAndArgon() {
  constexpr double kO_O = 2.976, kBow_deg = 57, kAside_A = 6.0;
  constexpr double kTurned_deg = 28;  // so that a probe reaches the hydrogen bond from the left
  const double free_deg = 2 * kHalfAngle_deg - 90, bow = kBow_deg * std::numbers::pi / 180,
               half = kHalfAngle_deg * std::numbers::pi / 180, free = free_deg * std::numbers::pi / 180,
               turned = kTurned_deg * std::numbers::pi / 180;
  const Vec3 giver(-kAside_A, kO_O / 2, 0), taker(-kAside_A, -kO_O / 2, 0);
  // In the plane of symmetry, the acceptor's hydrogens lean to one side and the donor's free one to the other (trans).
  const Vec3 lean(std::sin(turned), 0, std::cos(turned)), across(std::cos(turned), 0, -std::sin(turned));
  const Vec3 axis = Vec3(0, -std::cos(bow), 0) + std::sin(bow) * lean;
  const auto taken = [&](double side) {
    return taker + kO_H * (std::cos(half) * axis + side * std::sin(half) * across);
  };
  return writePdb(
      "TWO WATERS JOINED BY A HYDROGEN BOND, AND TWO ARGON ATOMS",
      {kWaterSource, kWaterWhere, "O...O 2.976 A, THE TAKER'S AXIS AT 57 DEGREES: J. A. ODUTOLA, T. R. DYKE,",
       "J. CHEM. PHYS. 72, 5062 (1980); IDEALISED: O-H...O STRAIGHT, BOTH WATERS AS IF ALONE", kArgonSource,
       "THE TWO PAIRS STAND SIDE BY SIDE FOR COMPARISON", kMaker},
      {{"O", "WTR", "O", 'A', 1, giver, true},
       {"H1", "WTR", "H", 'A', 1, giver + Vec3(0, -kO_H, 0), true},
       {"H2", "WTR", "H", 'A', 1, giver + kO_H * (Vec3(0, std::sin(free), 0) - std::cos(free) * lean), true},
       {"O", "WTR", "O", 'A', 2, taker, true},
       {"H1", "WTR", "H", 'A', 2, taken(-1), true},
       {"H2", "WTR", "H", 'A', 2, taken(1), true},
       {"AR", "AR", "AR", 'B', 1, {kAside_A, kAr_Ar / 2, 0}, true},
       {"AR", "AR", "AR", 'B', 2, {kAside_A, -kAr_Ar / 2, 0}, true}});
}

}  // namespace moltact::generator
