// Molecules for the forces between atoms, with the charges of AMBER in the file: three pairs that hold together more and
// less firmly, and bases of DNA with their partners.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <span>

#include "molecules/generator/internal_coordinates.h"
#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

struct ChargedAtom {
  std::string name, residue, element;
  char chain = 'A';
  int number = 1;
  Vec3 position_A{0.0};
  double charge_e = 0.0;
  bool polar = false;  // a hydrogen on nitrogen or oxygen
};

// Such that what the hand holds, 0.5 A smaller, stops where a hydrogen bond has its least energy. Bondi's radii (J. Phys.
// Chem. 68, 441, 1964) would stop it before.
double radiusOf(const ChargedAtom& a) {
  constexpr double kPolarHydrogen_A = 0.75, kWaterOxygen_A = 1.668, kWaterHydrogen_A = 0.76, kAmmonium_A = 1.724;
  if (a.residue == "WTR") return a.polar ? kWaterHydrogen_A : kWaterOxygen_A;
  if (a.residue == "MAM" && a.element == "N") return kAmmonium_A;
  if (a.polar) return kPolarHydrogen_A;
  static const std::map<std::string, double> kRadii{{"H", 1.20}, {"C", 1.808}, {"N", 1.60}, {"O", 1.561}, {"AR", 1.88}};
  return kRadii.at(a.element);
}

std::string writePqr(const std::vector<std::string>& remarks, const std::vector<ChargedAtom>& atoms) {
  std::string out;
  for (const std::string& remark : remarks) out += "REMARK   1 " + remark + '\n';
  int serial = 0;
  for (const ChargedAtom& a : atoms) {
    char line[128];
    std::snprintf(line, sizeof line, "HETATM %4d %-4s %-3s %c %3d %8.3f %8.3f %8.3f %8.4f %6.3f %s\n", ++serial,
                  a.name.c_str(), a.residue.c_str(), a.chain, a.number, a.position_A.x + 0.0, a.position_A.y + 0.0,
                  a.position_A.z + 0.0, a.charge_e + 0.0, radiusOf(a), a.element.c_str());
    out += line;
  }
  return out + "END\n";
}

constexpr const char* kForceMaker = "MADE BY MOLTACT_GENERATE_MOLECULES";
constexpr const char* kPolarRemark = "RADII: SUCH THAT A HELD BODY STOPS WHERE A HYDROGEN BOND HAS ITS LEAST ENERGY";

Vec3 aboutZ(const Vec3& v, double deg) {
  const double a = radians(deg);
  return {v.x * std::cos(a) - v.y * std::sin(a), v.x * std::sin(a) + v.y * std::cos(a), v.z};
}

// Pairs along +y: the partner at y = 0, what is held above it.

void addArgons(std::vector<ChargedAtom>& out, char fixed, char held) {
  out.push_back({"AR", "AR", "AR", fixed, 1, {0, 0, 0}});
  out.push_back({"AR", "AR", "AR", held, 1, {0, 3.76, 0}});
}

// The dimer of Odutola and Dyke, as in water-and-argon.pdb; charges of TIP3P.
void addWaters(std::vector<ChargedAtom>& out, char fixed, char held) {
  constexpr double kO_H = 0.9572, kO_O = 2.976, kBow_deg = 57;
  const double half = radians(104.52 / 2), free = radians(104.52 - 90.0), bow = radians(kBow_deg);
  const Vec3 lean(0, 0, 1), across(1, 0, 0), axis = Vec3(0, -std::cos(bow), 0) + std::sin(bow) * lean,
                                             giver(0, kO_O, 0);
  const auto add = [&](char chain, const Vec3& o, const Vec3& h1, const Vec3& h2) {
    out.push_back({"O", "WTR", "O", chain, 1, o, -0.834});
    out.push_back({"H1", "WTR", "H", chain, 1, h1, 0.417, true});
    out.push_back({"H2", "WTR", "H", chain, 1, h2, 0.417, true});
  };
  const auto taken = [&](double side) { return kO_H * (std::cos(half) * axis + side * std::sin(half) * across); };
  add(fixed, Vec3(0.0), taken(-1), taken(1));
  add(held, giver, giver + Vec3(0, -kO_H, 0), giver + kO_H * (Vec3(0, std::sin(free), 0) - std::cos(free) * lean));
}

// Acetate and methylammonium: the ends of aspartate and lysine, with their charges in ff14SB; those of the methyl groups
// make the sums -1 and 1.
void addSaltBridge(std::vector<ChargedAtom>& out, char fixed, char held) {
  constexpr double kC_O = 1.25, kO_C_O_deg = 125, kN_O = 2.80, kC_C = 1.52, kC_N = 1.49, kC_H = 1.09, kN_H = 1.01,
                   kTetrahedral_deg = 109.47;
  const double half = radians(kO_C_O_deg / 2);
  const Vec3 c(0, -kC_O * std::cos(half), 0), o1(-kC_O * std::sin(half), 0, 0), o2(kC_O * std::sin(half), 0, 0),
      methyl = c + Vec3(0, -kC_C, 0);
  out.push_back({"C", "ACT", "C", fixed, 1, c, 0.7994});
  out.push_back({"O1", "ACT", "O", fixed, 1, o1, -0.8014});
  out.push_back({"O2", "ACT", "O", fixed, 1, o2, -0.8014});
  out.push_back({"CH3", "ACT", "C", fixed, 1, methyl, -0.1600});
  for (int k = 0; k < 3; ++k)
    out.push_back({"H" + std::to_string(k + 1), "ACT", "H", fixed, 1,
                   placeAtom(o1, c, methyl, kC_H, kTetrahedral_deg, 120.0 * k + 90.0), -0.0122});
  const Vec3 n(0, std::sqrt(kN_O * kN_O - o2.x * o2.x), 0), carbon = n + Vec3(0, kC_N, 0);
  out.push_back({"N1", "MAM", "N", held, 1, n, -0.3854});
  // Two of the three hydrogens lean to the oxygens.
  for (int k = 0; k < 3; ++k)
    out.push_back({"HN" + std::to_string(k + 1), "MAM", "H", held, 1,
                   placeAtom(carbon + Vec3(0, 0, 1), carbon, n, kN_H, kTetrahedral_deg, 120.0 * k), 0.3400, true});
  out.push_back({"C1", "MAM", "C", held, 1, carbon, 0.0249});
  for (int k = 0; k < 3; ++k)
    out.push_back({"H" + std::to_string(k + 1), "MAM", "H", held, 1,
                   placeAtom(n + Vec3(0, 0, 1), n, carbon, kC_H, kTetrahedral_deg, 120.0 * k + 60.0), 0.1135});
}

template <class Add>
void placed(std::vector<ChargedAtom>& out, double deg, double far_A, Add add) {
  std::vector<ChargedAtom> pair;
  add(pair);
  for (ChargedAtom& a : pair) {
    a.position_A = aboutZ(a.position_A + Vec3(0, far_A, 0), deg);
    out.push_back(std::move(a));
  }
}

// Bases of DNA: places in the fibre of B-DNA (b_dna.cpp names the source) and charges of AMBER's OL15.
struct BaseAtom {
  const char* name;
  double radius_A, angle_deg, height_A, charge_e;
};
struct BaseHydrogen {
  const char *name, *carrier;
  double charge_e;
};

constexpr BaseAtom kAdenineAtoms[] = {{"N9", 4.63, 76.6, 0.42, -0.0268},  {"C8", 4.84, 93.0, 0.50, 0.1607},
                                      {"N7", 3.95, 105.4, 0.43, -0.6175}, {"C5", 2.74, 94.0, 0.28, 0.0725},
                                      {"C6", 1.41, 107.2, 0.15, 0.6897},  {"N6", 1.83, 154.0, 0.14, -0.9123},
                                      {"N1", 0.86, 40.1, 0.03, -0.7624},  {"C2", 2.17, 30.6, 0.04, 0.5716},
                                      {"N3", 3.24, 47.0, 0.16, -0.7417},  {"C4", 3.33, 70.5, 0.28, 0.3800}};
constexpr BaseHydrogen kAdenineHydrogens[] = {
    {"H8", "C8", 0.1877}, {"H61", "N6", 0.4167}, {"H62", "N6", 0.4167}, {"H2", "C2", 0.0598}};
constexpr BaseAtom kGuanineAtoms[] = {
    {"N9", 4.63, 76.6, 0.42, 0.0577},  {"C8", 4.82, 93.2, 0.50, 0.0736},  {"N7", 3.92, 105.7, 0.42, -0.5725},
    {"C5", 2.70, 94.0, 0.28, 0.1991},  {"C6", 1.39, 109.3, 0.15, 0.4918}, {"O6", 1.71, 154.6, 0.13, -0.5699},
    {"N1", 0.92, 37.9, 0.03, -0.5053}, {"C2", 2.28, 28.7, 0.03, 0.7432},  {"N2", 3.01, 4.2, -0.10, -0.9230},
    {"N3", 3.29, 46.7, 0.16, -0.6636}, {"C4", 3.33, 70.3, 0.28, 0.1814}};
constexpr BaseHydrogen kGuanineHydrogens[] = {
    {"H8", "C8", 0.1997}, {"H1", "N1", 0.3520}, {"H21", "N2", 0.4235}, {"H22", "N2", 0.4235}};
constexpr BaseAtom kCytosineAtoms[] = {{"N1", 4.63, 76.6, 0.42, -0.0339},  {"C2", 3.40, 67.4, 0.27, 0.7959},
                                       {"O2", 3.69, 47.9, 0.18, -0.6548},  {"N3", 2.31, 83.9, 0.22, -0.7748},
                                       {"C4", 2.94, 110.0, 0.32, 0.8439},  {"N4", 2.76, 136.6, 0.27, -0.9773},
                                       {"C5", 4.35, 107.0, 0.47, -0.5222}, {"C6", 4.99, 92.2, 0.52, -0.0183}};
constexpr BaseHydrogen kCytosineHydrogens[] = {
    {"H41", "N4", 0.4314}, {"H42", "N4", 0.4314}, {"H5", "C5", 0.1863}, {"H6", "C6", 0.2293}};
constexpr BaseAtom kThymineAtoms[] = {
    {"N1", 4.63, 76.6, 0.42, -0.0239}, {"C2", 3.42, 67.3, 0.27, 0.5677},   {"O2", 3.64, 47.8, 0.18, -0.5881},
    {"N3", 2.36, 85.2, 0.23, -0.4340}, {"C4", 2.98, 111.9, 0.32, 0.5194},  {"O4", 2.82, 136.3, 0.27, -0.5563},
    {"C5", 4.38, 106.9, 0.47, 0.0025}, {"C7", 5.40, 119.8, 0.58, -0.2269}, {"C6", 5.01, 92.3, 0.52, -0.2209}};
constexpr BaseHydrogen kThymineHydrogens[] = {
    {"H3", "N3", 0.3420}, {"H71", "C7", 0.0770}, {"H72", "C7", 0.0770}, {"H73", "C7", 0.0770}, {"H6", "C6", 0.2607}};

struct Base {
  const char* residue;
  std::span<const BaseAtom> atoms;
  std::span<const BaseHydrogen> hydrogens;
};
const Base& baseOf(char letter) {
  static const Base kAdenine{"ADE", kAdenineAtoms, kAdenineHydrogens},
      kGuanine{"GUA", kGuanineAtoms, kGuanineHydrogens}, kCytosine{"CYT", kCytosineAtoms, kCytosineHydrogens},
      kThymine{"THY", kThymineAtoms, kThymineHydrogens};
  return letter == 'A' ? kAdenine : letter == 'G' ? kGuanine : letter == 'C' ? kCytosine : kThymine;
}

// The base alone: a hydrogen stands where DNA has its sugar, with the charge that makes the sum zero. `strand` -1 is the
// partner. All atoms are laid into the pair's mean plane, z = 0.
std::vector<ChargedAtom> baseAlone(char letter, int strand, char chain, const Vec3& shift) {
  constexpr double kCovalent_A = 1.75, kN_H = 1.01, kC_H = 1.08, kMethyl_C_H = 1.09;
  const Base& base = baseOf(letter);
  std::vector<ChargedAtom> out;
  double sum_e = 0.0;
  for (const BaseAtom& a : base.atoms) {
    const double angle = radians(strand * a.angle_deg);
    out.push_back({a.name, base.residue, std::string(1, a.name[0]), chain, 1,
                   Vec3(a.radius_A * std::cos(angle), a.radius_A * std::sin(angle), 0.0), a.charge_e});
    sum_e += a.charge_e;
  }
  const std::vector<ChargedAtom> heavy = out;
  const auto add = [&](const char* name, const char* carrier, double charge_e, int of_carrier) {
    const auto at = std::find_if(heavy.begin(), heavy.end(), [&](const auto& a) { return a.name == carrier; });
    const bool nitrogen = at->element == "N";
    std::vector<Vec3> near;
    Vec3 next(0.0);
    for (const ChargedAtom& a : heavy)
      if (const double d = glm::distance(a.position_A, at->position_A); d > 0.1 && d < kCovalent_A)
        near.push_back(a.position_A);
    Vec3 place(0.0);
    if (near.size() == 2) {
      place = at->position_A + (nitrogen ? kN_H : kC_H) * glm::normalize(2.0 * at->position_A - near[0] - near[1]);
    } else {
      for (const ChargedAtom& a : heavy)
        if (const double d = glm::distance(a.position_A, near[0]);
            d > 0.1 && d < kCovalent_A && a.position_A != at->position_A) {
          next = a.position_A;
          break;
        }
      place = nitrogen ? placeAtom(next, near[0], at->position_A, kN_H, 120.0, 180.0 * of_carrier)
                       : placeAtom(next, near[0], at->position_A, kMethyl_C_H, 109.47, 120.0 * of_carrier);
    }
    out.push_back({name, base.residue, "H", chain, 1, place, charge_e, nitrogen});
  };
  std::map<std::string, int> carried;
  for (const BaseHydrogen& h : base.hydrogens) {
    add(h.name, h.carrier, h.charge_e, carried[h.carrier]++);
    sum_e += h.charge_e;
  }
  const bool purine = letter == 'A' || letter == 'G';
  add(purine ? "H9" : "H1", purine ? "N9" : "N1", -sum_e, 0);
  for (ChargedAtom& a : out) a.position_A += shift;
  return out;
}

void append(std::vector<ChargedAtom>& out, std::vector<ChargedAtom> more) {
  out.insert(out.end(), more.begin(), more.end());
}

}  // namespace

std::string makeThreePairs() {
  constexpr double kFar_A = 13.0;  // from the middle: more than the cut-off of 10 A between any two pairs
  std::vector<ChargedAtom> atoms;
  placed(atoms, 0.0, kFar_A, [](auto& out) { addArgons(out, 'A', 'D'); });
  placed(atoms, 120.0, kFar_A, [](auto& out) { addWaters(out, 'B', 'E'); });
  placed(atoms, 240.0, kFar_A, [](auto& out) { addSaltBridge(out, 'C', 'F'); });
  return writePqr({"TWO ARGON ATOMS (A, D); TWO WATERS (B, E); ACETATE AND METHYLAMMONIUM (C, F)",
                   "AR-AR 3.76 A: E. A. COLBOURN, A. E. DOUGLAS, J. CHEM. PHYS. 65, 1741 (1976)",
                   "WATERS: J. A. ODUTOLA, T. R. DYKE, J. CHEM. PHYS. 72, 5062 (1980); CHARGES OF TIP3P",
                   "ENDS OF ASPARTATE AND LYSINE: IDEAL ANGLES, CHARGES OF AMBER FF14SB, METHYL MADE UP TO -1 AND 1 E",
                   kPolarRemark, kForceMaker},
                  atoms);
}

std::string makeBasePartners() {
  constexpr double kAside_A = 12.0, kAway_A = 5.0;
  std::vector<ChargedAtom> atoms;
  append(atoms, baseAlone('A', 1, 'A', {-kAside_A, kAway_A, 0}));
  append(atoms, baseAlone('T', -1, 'B', {-kAside_A, 0, 0}));
  append(atoms, baseAlone('C', -1, 'C', {kAside_A, 0, 0}));
  return writePqr(
      {"ADENINE (A), 5 A AWAY FROM ITS PLACE OPPOSITE THYMINE (B); CYTOSINE (C), AS IF IT STOOD THERE INSTEAD",
       "PLACES IN THE FIBRE OF B-DNA: S. ARNOTT, D. W. L. HUKINS, B.B.R.C. 47, 1504 (1972), MADE FLAT",
       "CHARGES OF AMBER OL15; A HYDROGEN IN PLACE OF THE SUGAR MAKES THE SUM ZERO", kPolarRemark, kForceMaker},
      atoms);
}

std::string makeBasePairs() {
  constexpr double kAside_A = 26.0, kClear_A = 0.15, kKept_A = 3.0;
  std::vector<ChargedAtom> atoms;
  append(atoms, baseAlone('T', -1, 'A', {-kAside_A, 0, 0}));
  append(atoms, baseAlone('C', -1, 'B', {0, 0, 0}));
  append(atoms, baseAlone('C', -1, 'C', {kAside_A, 0, 0}));
  append(atoms, baseAlone('A', 1, 'D', {-kAside_A, kClear_A, 0}));
  append(atoms, baseAlone('G', 1, 'E', {0, 2 * kClear_A, 0}));
  append(atoms, baseAlone('A', 1, 'F', {kAside_A, kKept_A, 0}));
  return writePqr(
      {"THREE PAIRS OF BASES SIDE BY SIDE: T AND A (A, D), C AND G (B, E), C AND A (C, F), 3 A APART",
       "PLACES IN THE FIBRE OF B-DNA: S. ARNOTT, D. W. L. HUKINS, B.B.R.C. 47, 1504 (1972), MADE FLAT",
       "CHARGES OF AMBER OL15; A HYDROGEN IN PLACE OF THE SUGAR MAKES THE SUM ZERO", kPolarRemark, kForceMaker},
      atoms);
}

}  // namespace moltact::generator
