// An ideal right-handed alpha-helix of 20 alanines. Torsions and the angle at the alpha carbon: the fibre
// structure of poly-L-alanine, S. Arnott and S. D. Dover, J. Mol. Biol. 30, 209-212 (1967); other bond
// lengths and angles: R. A. Engh and R. Huber, Acta Cryst. A47, 392-400 (1991). Heavy atoms only, as in the
// crystal structures of the library.
#include <cmath>
#include <numbers>

#include "molecules/generator/internal_coordinates.h"
#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

constexpr int kResidues = 20;
constexpr double kPhi = -57.4, kPsi = -47.5, kOmega = -179.8;
constexpr double kN_CA = 1.458, kCA_C = 1.525, kC_N = 1.329, kC_O = 1.231, kCA_CB = 1.521;
constexpr double kN_CA_C = 109.7, kCA_C_N = 116.2, kC_N_CA = 121.7, kCA_C_O = 120.8, kN_CA_CB = 110.4;
// The torsion C-N-CA-CB less phi: from the chirality of L-alanine with the angles above.
constexpr double kCB_C_CA = 110.5;

/// The torsion X-N-CA-CB relative to X-N-CA-C, from the three angles at CA (spherical cosines); L: it lies
/// before C.
double cbTorsion(double phi) {
  const double cosine = (std::cos(radians(kCB_C_CA)) - std::cos(radians(kN_CA_C)) * std::cos(radians(kN_CA_CB))) /
                        (std::sin(radians(kN_CA_C)) * std::sin(radians(kN_CA_CB)));
  return phi - std::acos(cosine) * 180 / std::numbers::pi;
}

}  // namespace

std::string makeAlphaHelix() {
  // The chain N, CA, C, N, CA, C, … first; one residue more at each end gives the torsions there.
  std::vector<Vec3> chain = {{0, 0, 0}, {kN_CA, 0, 0}};
  chain.push_back(chain[1] + kCA_C * Vec3(-std::cos(radians(kN_CA_C)), std::sin(radians(kN_CA_C)), 0));
  const double torsion[3] = {kPsi, kOmega, kPhi}, length[3] = {kC_N, kN_CA, kCA_C},
               angle[3] = {kCA_C_N, kC_N_CA, kN_CA_C};
  while (chain.size() < 3 * (kResidues + 2)) {
    const std::size_t k = chain.size(), kind = k % 3;
    chain.push_back(placeAtom(chain[k - 3], chain[k - 2], chain[k - 1], length[kind], angle[kind], torsion[kind]));
  }
  // The axis: the C-alphas turn about it, so the second differences of their places point to it.
  const auto ca = [&](int i) { return chain[static_cast<std::size_t>(3 * i + 1)]; };
  const Vec3 in1 = glm::normalize(ca(5) - 2.0 * ca(6) + ca(7)), in2 = glm::normalize(ca(6) - 2.0 * ca(7) + ca(8));
  const Vec3 z = glm::normalize(glm::cross(in1, in2));
  const double turn = std::acos(glm::dot(in1, in2));
  const Vec3 across = (ca(7) - ca(6)) - glm::dot(ca(7) - ca(6), z) * z;
  const Vec3 on_axis = ca(6) + in1 * (glm::length(across) / (2 * std::sin(turn / 2)));
  const Vec3 x = -in1, y = glm::cross(z, x);
  Vec3 middle(0.0);
  for (int i = 1; i <= kResidues; ++i) middle += ca(i) / static_cast<double>(kResidues);
  const Vec3 origin = on_axis + z * glm::dot(middle - on_axis, z);
  const auto seen = [&](Vec3 p) {
    return Vec3(glm::dot(p - origin, x), glm::dot(p - origin, y), glm::dot(p - origin, z));
  };

  std::vector<MadeAtom> atoms;
  for (int i = 1; i <= kResidues; ++i) {
    const std::size_t k = static_cast<std::size_t>(3 * i);
    const auto add = [&](const char* name, const char* element, Vec3 p) {
      atoms.push_back({name, "ALA", element, 'A', i, seen(p)});
    };
    add("N", "N", chain[k]);
    add("CA", "C", chain[k + 1]);
    add("C", "C", chain[k + 2]);
    // the carbonyl oxygen lies opposite to the next nitrogen, in the plane of the peptide
    add("O", "O", placeAtom(chain[k], chain[k + 1], chain[k + 2], kC_O, kCA_C_O, kPsi + 180));
    add("CB", "C", placeAtom(chain[k - 1], chain[k], chain[k + 1], kCA_CB, kN_CA_CB, cbTorsion(kPhi)));
    if (i == kResidues) add("OXT", "O", placeAtom(chain[k], chain[k + 1], chain[k + 2], kC_O, 118.0, kPsi));
  }
  return writePdb("IDEAL ALPHA-HELIX, 20 ALANINES",
                  {"BOND LENGTHS AND ANGLES: R. A. ENGH, R. HUBER, ACTA CRYST. A47, 392 (1991)",
                   "TORSIONS OF POLY-L-ALANINE: S. ARNOTT, S. D. DOVER, J. MOL. BIOL. 30, 209 (1967)",
                   "NO HYDROGENS, AS IN THE CRYSTAL STRUCTURES", "MADE BY MOLTACT_GENERATE_MOLECULES"},
                  atoms);
}

}  // namespace moltact::generator
