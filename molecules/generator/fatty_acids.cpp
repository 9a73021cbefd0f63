// Stearic, oleic and elaidic acid: 18 carbons each, with no double bond, a cis one and a trans one between carbons 9
// and 10. Chains, rounded to 0.01 A and 1 degree: R. A. Bonham, L. S. Bartell and D. A. Kohl, J. Am. Chem. Soc. 81,
// 4765 (1959). The double bond, from 2-butene: A. Almenningen, I. M. Anfinsen and A. Haaland, Acta Chem. Scand. 24, 43
// (1970). The acid, from acetic acid: J. L. Derissen, J. Mol. Struct. 7, 67 (1971). The torsions beside the cis bond
// are those of oleic acid's crystals (S. Abrahamsson and I. Ryderstedt-Nahringbauer, Acta Cryst. 15, 1261, 1962), those
// beside the trans bond are the most favourable ones. All others are 180 degrees: the chain is extended.
//
// Each chain is upright with the acid at the top and its first half along y.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "molecules/generator/internal_coordinates.h"
#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

constexpr int kCarbons = 18;
constexpr const char* kResidue = "FAT";  // one name for all three, so that the name of a touched atom gives nothing
                                         // away
constexpr double kC_C = 1.53, kC_C_C = 112, kC_H = 1.09, kH_C_H = 107;
constexpr double kAcidC_C = 1.52, kAcidC_O = 1.21, kAcidC_OH = 1.36, kO_H = 0.97;
constexpr double kC_C_O = 127, kC_C_OH = 111, kC_O_H = 107;
constexpr double kRadiusC = 1.70, kRadiusH = 1.20, kRadiusO = 1.52;

struct Kind {
  bool double_bond;
  double length_A, beside_A, angle_deg;  // of the double bond and of the bonds beside it
  double before_deg, across_deg, after_deg;
};
constexpr Kind kStearic{false, kC_C, kC_C, kC_C_C, 180, 180, 180};
constexpr Kind kOleic{true, 1.35, 1.51, 125, 133, 0, -133};
constexpr Kind kElaidic{true, 1.35, 1.51, 124, 118, 180, -118};

double bond(const Kind& kind, int i) {  // from carbon i to the next one
  return i == 1 ? kAcidC_C : i == 9 ? kind.length_A : i == 8 || i == 10 ? kind.beside_A : kC_C;
}
double angle(const Kind& kind, int i) { return i == 9 || i == 10 ? kind.angle_deg : kC_C_C; }
double torsion(const Kind& kind, int i) {  // about the bond from carbon i to the next one
  return i == 8 ? kind.before_deg : i == 9 ? kind.across_deg : i == 10 ? kind.after_deg : 180;
}

std::vector<MadeAtom> makeAcid(const Kind& kind) {
  std::vector<Vec3> c{{0, 0, 0}, {bond(kind, 1), 0, 0}};
  c.push_back(c[1] + bond(kind, 2) * Vec3(-std::cos(radians(angle(kind, 2))), std::sin(radians(angle(kind, 2))), 0));
  for (int i = 3; i < kCarbons; ++i)  // carbon i + 1, bonded to carbon i
    c.push_back(placeAtom(c[static_cast<std::size_t>(i - 3)], c[static_cast<std::size_t>(i - 2)],
                          c[static_cast<std::size_t>(i - 1)], bond(kind, i), angle(kind, i), torsion(kind, i - 1)));
  const auto carbon = [&](int i) { return c[static_cast<std::size_t>(i - 1)]; };

  std::vector<MadeAtom> out;
  const auto add = [&](const std::string& name, const char* element, Vec3 p) {
    out.push_back({name, kResidue, element, 'A', 1, p, true});
  };
  for (int i = 1; i <= kCarbons; ++i) add("C" + std::to_string(i), "C", carbon(i));
  add("O1", "O", placeAtom(carbon(3), carbon(2), carbon(1), kAcidC_O, kC_C_O, 0));
  const Vec3 oh = placeAtom(carbon(3), carbon(2), carbon(1), kAcidC_OH, kC_C_OH, 180);
  add("O2", "O", oh);
  add("HO2", "H", placeAtom(carbon(2), carbon(1), oh, kO_H, kC_O_H, 180));
  for (int i = 2; i < kCarbons; ++i) {
    const Vec3 to_last = glm::normalize(carbon(i - 1) - carbon(i)), to_next = glm::normalize(carbon(i + 1) - carbon(i));
    const Vec3 away = -glm::normalize(to_last + to_next), side = glm::normalize(glm::cross(to_last, to_next));
    const std::string name = "H" + std::to_string(i);
    if (kind.double_bond && (i == 9 || i == 10)) {
      add(name + "1", "H", carbon(i) + kC_H * away);
      continue;
    }
    const double half = radians(kH_C_H / 2);
    add(name + "1", "H", carbon(i) + kC_H * (std::cos(half) * away + std::sin(half) * side));
    add(name + "2", "H", carbon(i) + kC_H * (std::cos(half) * away - std::sin(half) * side));
  }
  for (int k = 0; k < 3; ++k)
    add("H18" + std::to_string(k + 1), "H",
        placeAtom(carbon(kCarbons - 2), carbon(kCarbons - 1), carbon(kCarbons), kC_H, 111, 60 + 120 * k));

  // The first half is along -y, from the acid down. A bent second half points toward -z; without a bend, the zigzag
  // lies in the yz plane.
  const auto middle = [&](int i) { return 0.5 * (carbon(i) + carbon(i + 1)); };
  const Vec3 down = glm::normalize(middle(7) - middle(1));
  Vec3 bent = middle(17) - middle(11);
  bent -= down * glm::dot(bent, down);
  if (glm::length(bent) < 1.0) {
    bent = carbon(2) - carbon(3);
    bent -= down * glm::dot(bent, down);
  }
  const Vec3 y = -down, z = -glm::normalize(bent), x = glm::cross(y, z);
  for (MadeAtom& a : out)
    a.position_A = {glm::dot(a.position_A, x), glm::dot(a.position_A, y), glm::dot(a.position_A, z)};
  // Centred at the origin.
  Vec3 low(std::numeric_limits<double>::max()), high(-low);
  for (const MadeAtom& a : out) {
    low = glm::min(low, a.position_A);
    high = glm::max(high, a.position_A);
  }
  for (MadeAtom& a : out) a.position_A -= 0.5 * (low + high);
  return out;
}

double radius_A(const MadeAtom& a) { return a.element == "C" ? kRadiusC : a.element == "H" ? kRadiusH : kRadiusO; }

const char* kSources[] = {"CHAINS: R. A. BONHAM, L. S. BARTELL, D. A. KOHL, J. AM. CHEM. SOC. 81, 4765 (1959)",
                          "ACID: J. L. DERISSEN, J. MOL. STRUCT. 7, 67 (1971)"};

std::string write(const std::string& title, const std::vector<MadeAtom>& atoms, const std::string& placed) {
  std::vector<std::string> remarks(std::begin(kSources), std::end(kSources));
  remarks.push_back("DOUBLE BOND: A. ALMENNINGEN, I. M. ANFINSEN, A. HAALAND, ACTA CHEM. SCAND. 24, 43 (1970)");
  remarks.push_back("TORSIONS BESIDE IT: S. ABRAHAMSSON, I. RYDERSTEDT-NAHRINGBAUER, ACTA CRYST. 15, 1261 (1962)");
  remarks.push_back(placed);
  remarks.push_back("MADE BY MOLTACT_GENERATE_MOLECULES");
  return writePdb(title, remarks, atoms);
}

/// Back to back, each with the same side facing outward: chain A toward +x, chain B toward -x.
std::vector<MadeAtom> backToBack(const Kind& front, const Kind& back) {
  constexpr double kApart_A = 16;
  std::vector<MadeAtom> out = makeAcid(front), other = makeAcid(back);
  for (MadeAtom& a : out) a.position_A.x += 0.5 * kApart_A;
  for (MadeAtom& a : other) {
    a.chain = 'B';
    a.position_A = {-a.position_A.x - 0.5 * kApart_A, a.position_A.y, -a.position_A.z};
    out.push_back(a);
  }
  return out;
}

/// Side by side with level tops, in van der Waals contact; seen from +x, chain A is left of chain B. A straight
/// neighbour is rotated, so that the two acids do not keep the chains apart.
std::vector<MadeAtom> sideBySide(const Kind& left, const Kind& right) {
  std::vector<MadeAtom> a = makeAcid(left), b = makeAcid(right);
  if (!right.double_bond)
    for (MadeAtom& m : b) m.position_A *= Vec3(-1, 1, -1);
  const double up_A = a[0].position_A.y - b[0].position_A.y;  // from carbon 1 to carbon 1
  const double far_A = 20;
  for (MadeAtom& m : b) {
    m.chain = 'B';
    m.position_A += Vec3(0, up_A, -far_A);
  }
  double slack_A = far_A;
  for (const MadeAtom& m : a)
    for (const MadeAtom& n : b) {
      const Vec3 d = n.position_A - m.position_A;
      const double sum = radius_A(m) + radius_A(n), across = d.x * d.x + d.y * d.y;
      if (across < sum * sum) slack_A = std::min(slack_A, -d.z - std::sqrt(sum * sum - across));
    }
  for (MadeAtom& n : b) {
    n.position_A.z += slack_A;
    a.push_back(n);
  }
  return a;
}

}  // namespace

std::string makeStearicOleic() {
  return write("STEARIC AND OLEIC ACID", backToBack(kStearic, kOleic),
               "CHAIN A: STEARIC ACID; CHAIN B: OLEIC ACID, BEHIND IT AND TURNED ROUND");
}
std::string makeStearicElaidic() {
  return write("STEARIC AND ELAIDIC ACID", backToBack(kStearic, kElaidic),
               "CHAIN A: STEARIC ACID; CHAIN B: ELAIDIC ACID, BEHIND IT AND TURNED ROUND");
}
std::string makeStraightNeighbours() {
  return write("TWO STEARIC ACIDS SIDE BY SIDE", sideBySide(kStearic, kStearic),
               "MOVED TOGETHER UNTIL THEIR VAN DER WAALS SURFACES TOUCH");
}
std::string makeKinkedNeighbours() {
  return write("STEARIC ACID AND OLEIC ACID SIDE BY SIDE", sideBySide(kStearic, kOleic),
               "MOVED TOGETHER UNTIL THEIR VAN DER WAALS SURFACES TOUCH");
}

}  // namespace moltact::generator
