// Small molecules whose geometry is a line of numbers.
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

}  // namespace

std::string makeWater() {
  constexpr double kO_H = 0.9572, kHalfAngle_deg = 104.52 / 2;
  const auto hydrogen = [&](double side) { return onCircle(kO_H, -90 + side * kHalfAngle_deg); };
  return writePdb("WATER",
                  {"O-H 0.9572 A, H-O-H 104.52 DEGREES: W. S. BENEDICT, N. GAILAR, E. K. PLYLER,",
                   "J. CHEM. PHYS. 24, 1139 (1956)", kMaker},
                  {{"O", "HOH", "O", 'A', 1, {0, 0, 0}, true},
                   {"H1", "HOH", "H", 'A', 1, hydrogen(-1), true},
                   {"H2", "HOH", "H", 'A', 1, hydrogen(1), true}});
}

std::string makeBenzene() {
  constexpr double kC_C = 1.397, kC_H = 1.084;  // in a regular hexagon the radius equals the side
  std::vector<MadeAtom> atoms;
  for (int i = 0; i < 6; ++i)
    atoms.push_back(
        {std::string("C").append(std::to_string(i + 1)), "BNZ", "C", 'A', 1, onCircle(kC_C, 90 - 60 * i), true});
  for (int i = 0; i < 6; ++i)
    atoms.push_back(
        {std::string("H").append(std::to_string(i + 1)), "BNZ", "H", 'A', 1, onCircle(kC_C + kC_H, 90 - 60 * i), true});
  return writePdb("BENZENE", {"C-C 1.397 A, C-H 1.084 A: B. P. STOICHEFF, CAN. J. PHYS. 32, 339 (1954)", kMaker},
                  atoms);
}

std::string makeArgon(int count) {
  constexpr double kAr_Ar = 3.76;
  const double angle_deg = count > 1 ? 360.0 / count : 0.0;
  const double radius_A = count > 1 ? kAr_Ar / (2 * std::sin(std::numbers::pi / count)) : 0.0;
  std::vector<MadeAtom> atoms;
  for (int i = 0; i < count; ++i)
    atoms.push_back({"AR", "AR", "AR", 'A', i + 1, onCircle(radius_A, (count == 2 ? 0 : 90) + i * angle_deg), true});
  const char* titles[] = {"ONE ARGON ATOM", "TWO ARGON ATOMS", "THREE ARGON ATOMS"};
  std::vector<std::string> remarks;
  if (count > 1) remarks = {"AR-AR 3.76 A: E. A. COLBOURN, A. E. DOUGLAS, J. CHEM. PHYS. 65, 1741 (1976)"};
  if (count == 3) remarks.push_back("THE TRIMER AS AN EQUILATERAL TRIANGLE WITH THE DIMER'S DISTANCE");
  remarks.push_back(kMaker);
  return writePdb(titles[count - 1], remarks, atoms);
}

}  // namespace moltact::generator
