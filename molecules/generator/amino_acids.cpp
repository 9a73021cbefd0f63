// An amino acid and its mirror image, as in water and in crystals: NH3+ and COO-. The geometry at the alpha carbon is
// that of L-alanine's crystal by neutron diffraction: M. S. Lehmann, T. F. Koetzle and W. C. Hamilton, J. Am. Chem.
// Soc. 94, 2657-2660 (1972), rounded to 0.01 A and 1 degree. The ring of phenylalanine: R. A. Engh and R. Huber, Acta
// Cryst. A47, 392-400 (1991). Its side chain is anti to the nitrogen, a common rotamer.
//
// The L form is at +x with its alpha hydrogen toward +x and its carboxylate toward +y; the mirror is the plane x = 0.
// Turned to the front, each is seen from its hydrogen, with the carboxylate at the top.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "molecules/generator/internal_coordinates.h"
#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

constexpr double kCA_N = 1.49, kCA_C = 1.53, kCA_CB = 1.52, kC_O = 1.25, kN_H = 1.04, kC_H = 1.09;
constexpr double kN_CA_C = 110, kN_CA_CB = 110, kC_CA_CB = 111, kCA_C_O = 117, kTetrahedral = 109.5;
constexpr double kN_CA_C_O = -18;  // the carboxylate's torsion in the crystal
constexpr double kCB_CG = 1.502, kCA_CB_CG = 113.8, kRing = 1.39, kRing_H = 1.08;
constexpr double kChi1 = 180, kChi2 = 90;

struct Named {
  const char* name;
  const char* element;
  Vec3 place;
};

/// The L form: the alpha carbon at the origin, its hydrogen toward +x, the carboxylate's carbon at the top.
std::vector<Named> makeLForm(bool ring) {
  const auto c = [](double deg) { return std::cos(radians(deg)); };
  const double s = std::sin(radians(kN_CA_C));
  const Vec3 to_n(1, 0, 0), to_c(c(kN_CA_C), s, 0);
  const double y = (c(kC_CA_CB) - c(kN_CA_C) * c(kN_CA_CB)) / s;
  const Vec3 to_cb(c(kN_CA_CB), y, std::sqrt(1 - c(kN_CA_CB) * c(kN_CA_CB) - y * y));
  const Vec3 x = -glm::normalize(to_n + to_c + to_cb);
  const Vec3 up = glm::normalize(to_c - x * glm::dot(to_c, x)), side = glm::cross(x, up);
  const auto seen = [&](Vec3 p) { return Vec3(glm::dot(p, x), glm::dot(p, up), glm::dot(p, side)); };

  const Vec3 ca(0.0), n = kCA_N * seen(to_n), carboxyl = kCA_C * seen(to_c), cb = kCA_CB * seen(to_cb);
  std::vector<Named> out{{"N", "N", n}, {"CA", "C", ca}, {"C", "C", carboxyl}};
  out.push_back({"O", "O", placeAtom(n, ca, carboxyl, kC_O, kCA_C_O, kN_CA_C_O)});
  out.push_back({"OXT", "O", placeAtom(n, ca, carboxyl, kC_O, kCA_C_O, kN_CA_C_O + 180)});
  out.push_back({"CB", "C", cb});
  std::vector<Named> hydrogens{{"HA", "H", kC_H * Vec3(1, 0, 0)}};
  const char* on_n[] = {"H1", "H2", "H3"};
  const char* on_cb[] = {"HB1", "HB2", "HB3"};
  for (int k = 0; k < 3; ++k)
    hydrogens.push_back({on_n[k], "H", placeAtom(carboxyl, ca, n, kN_H, kTetrahedral, 60 + 120 * k)});
  for (int k = 0; k < 3; ++k) {
    const double turn = kChi1 + 120 * k;
    if (ring && k == 0) continue;
    hydrogens.push_back({on_cb[k], "H", placeAtom(n, ca, cb, kC_H, kTetrahedral, turn)});
  }
  if (ring) {
    const Vec3 cg = placeAtom(n, ca, cb, kCB_CG, kCA_CB_CG, kChi1);
    const char* ring_atoms[] = {"CG", "CD1", "CE1", "CZ", "CE2", "CD2"};
    const char* ring_hydrogens[] = {"", "HD1", "HE1", "HZ", "HE2", "HD2"};
    // in a regular hexagon the radius equals the side
    const Vec3 out_of_cb = glm::normalize(cg - cb), middle = cg + kRing * out_of_cb;
    const Vec3 cd1 = placeAtom(ca, cb, cg, kRing, 120, kChi2);
    const Vec3 across = glm::normalize((cd1 - cg) - out_of_cb * glm::dot(cd1 - cg, out_of_cb));
    for (int k = 0; k < 6; ++k) {
      const double angle = radians(180 - 60 * k);
      const Vec3 outward = std::cos(angle) * out_of_cb + std::sin(angle) * across;
      out.push_back({ring_atoms[k], "C", middle + kRing * outward});
      if (k > 0) hydrogens.push_back({ring_hydrogens[k], "H", middle + (kRing + kRing_H) * outward});
    }
  }
  out.insert(out.end(), hydrogens.begin(), hydrogens.end());
  return out;
}

std::string makePair(const std::string& title, const char* l_name, const char* d_name, bool ring,
                     double grid_spacing_A) {
  std::vector<Named> l_form = makeLForm(ring);
  // Centred on the line of sight, so that a view from the front does not tilt it.
  const auto [low_y, high_y] = std::minmax_element(
      l_form.begin(), l_form.end(), [](const Named& a, const Named& b) { return a.place.y < b.place.y; });
  const auto [low_z, high_z] = std::minmax_element(
      l_form.begin(), l_form.end(), [](const Named& a, const Named& b) { return a.place.z < b.place.z; });
  const Vec3 middle(0.0, 0.5 * (low_y->place.y + high_y->place.y), 0.5 * (low_z->place.z + high_z->place.z));
  for (Named& a : l_form) a.place -= middle;
  std::vector<MadeAtom> atoms;
  for (const double side : {1.0, -1.0})
    for (const Named& a : l_form)
      atoms.push_back({a.name,
                       side > 0 ? l_name : d_name,
                       a.element,
                       side > 0 ? 'A' : 'B',
                       1,
                       {side * (a.place.x + 0.5 * grid_spacing_A), a.place.y, a.place.z},
                       true});
  std::vector<std::string> remarks{"L-ALANINE BY NEUTRON DIFFRACTION: M. S. LEHMANN, T. F. KOETZLE, W. C. HAMILTON,",
                                   "J. AM. CHEM. SOC. 94, 2657 (1972), ROUNDED TO 0.01 A AND 1 DEGREE"};
  if (ring) remarks.push_back("THE RING: R. A. ENGH, R. HUBER, ACTA CRYST. A47, 392 (1991)");
  remarks.push_back("CHAIN A: THE L FORM; CHAIN B: ITS MIRROR IMAGE, THE D FORM; THE MIRROR IS THE PLANE X = 0");
  remarks.push_back("MADE BY MOLTACT_GENERATE_MOLECULES");
  return writePdb(title, remarks, atoms);
}

}  // namespace

std::string makeAlaninePair() { return makePair("L- AND D-ALANINE", "ALA", "DAL", false, 8.0); }

std::string makePhenylalaninePair() { return makePair("L- AND D-PHENYLALANINE", "PHE", "DPN", true, 9.0); }

}  // namespace moltact::generator
