// Ideal helices and strands of alanine. The torsions and the angle at the alpha carbon are those of fibre structures of
// poly-L-alanine. Alpha: S. Arnott and S. D. Dover, J. Mol. Biol. 30, 209-212 (1967). Beta: S. Arnott, S. D. Dover and
// A. Elliott, J. Mol. Biol. 30, 201-208 (1967). Other bond lengths and angles: R. A. Engh and R. Huber, Acta Cryst.
// A47, 392-400 (1991). Heavy atoms only, as in the crystal structures of the library.
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "molecules/generator/internal_coordinates.h"
#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

struct Torsions {
  double phi, psi, omega;  // degree
};
constexpr Torsions kAlpha{-57.4, -47.5, -179.8}, kBeta{-139, 135, -178};
constexpr double kN_CA = 1.458, kCA_C = 1.525, kC_N = 1.329, kC_O = 1.231, kCA_CB = 1.521;
constexpr double kN_CA_C = 109.7, kCA_C_N = 116.2, kC_N_CA = 121.7, kCA_C_O = 120.8, kN_CA_CB = 110.4;
// Angle C-CA-CB. cbTorsion() computes the torsion C-N-CA-CB from it, with the chirality of L-alanine.
constexpr double kCB_C_CA = 110.5;

/// The torsion X-N-CA-CB relative to X-N-CA-C, from the three angles at CA (spherical law of cosines). For L, CB
/// precedes C.
double cbTorsion(double phi) {
  const double cosine = (std::cos(radians(kCB_C_CA)) - std::cos(radians(kN_CA_C)) * std::cos(radians(kN_CA_CB))) /
                        (std::sin(radians(kN_CA_C)) * std::sin(radians(kN_CA_CB)));
  return phi - std::acos(cosine) * 180 / std::numbers::pi;
}

/// N, CA and C of a chain, with one extra residue at each end for the torsions there.
class Chain {
 public:
  Chain(int residues, const Torsions& torsions) : residues_(residues), torsions_(torsions) {
    places_ = {{0, 0, 0}, {kN_CA, 0, 0}};
    places_.push_back(places_[1] + kCA_C * Vec3(-std::cos(radians(kN_CA_C)), std::sin(radians(kN_CA_C)), 0));
    const double torsion[3] = {torsions.psi, torsions.omega, torsions.phi}, length[3] = {kC_N, kN_CA, kCA_C},
                 angle[3] = {kCA_C_N, kC_N_CA, kN_CA_C};
    while (places_.size() < 3 * (static_cast<std::size_t>(residues) + 2)) {
      const std::size_t k = places_.size(), kind = k % 3;
      places_.push_back(
          placeAtom(places_[k - 3], places_[k - 2], places_[k - 1], length[kind], angle[kind], torsion[kind]));
    }
  }

  Vec3 ca(int i) const { return places_[static_cast<std::size_t>(3 * i + 1)]; }
  Vec3 cb(int i) const {
    const std::size_t k = static_cast<std::size_t>(3 * i);
    return placeAtom(places_[k - 1], places_[k], places_[k + 1], kCA_CB, kN_CA_CB, cbTorsion(torsions_.phi));
  }
  Vec3 middle() const {
    Vec3 out(0.0);
    for (int i = 1; i <= residues_; ++i) out += ca(i) / static_cast<double>(residues_);
    return out;
  }

  /// Residues 1 to `residues`; `seen` transforms each place.
  std::vector<MadeAtom> atoms(const std::function<Vec3(Vec3)>& seen, const char* name = "ALA", char chain = 'A') const {
    std::vector<MadeAtom> out;
    for (int i = 1; i <= residues_; ++i) {
      const std::size_t k = static_cast<std::size_t>(3 * i);
      const auto add = [&](const char* atom, const char* element, Vec3 p) {
        out.push_back({atom, name, element, chain, i, seen(p)});
      };
      const auto onC = [&](double angle, double turn) {
        return placeAtom(places_[k], places_[k + 1], places_[k + 2], kC_O, angle, torsions_.psi + turn);
      };
      add("N", "N", places_[k]);
      add("CA", "C", places_[k + 1]);
      add("C", "C", places_[k + 2]);
      // the carbonyl oxygen is opposite to the next nitrogen, in the plane of the peptide
      add("O", "O", onC(kCA_C_O, 180));
      add("CB", "C", cb(i));
      if (i == residues_) add("OXT", "O", onC(118.0, 0));
    }
    return out;
  }

 private:
  int residues_;
  Torsions torsions_;
  std::vector<Vec3> places_;
};

/// The helix's own axes: z along it, alpha carbon 6 toward x, the centroid of the alpha carbons at the origin.
std::function<Vec3(Vec3)> helixAxes(const Chain& chain) {
  // The alpha carbons rotate about the axis, so the second differences of their places point to it.
  const auto ca = [&](int i) { return chain.ca(i); };
  const Vec3 in1 = glm::normalize(ca(5) - 2.0 * ca(6) + ca(7)), in2 = glm::normalize(ca(6) - 2.0 * ca(7) + ca(8));
  const Vec3 z = glm::normalize(glm::cross(in1, in2));
  const double turn = std::acos(glm::dot(in1, in2));
  const Vec3 across = (ca(7) - ca(6)) - glm::dot(ca(7) - ca(6), z) * z;
  const Vec3 on_axis = ca(6) + in1 * (glm::length(across) / (2 * std::sin(turn / 2)));
  const Vec3 x = -in1, y = glm::cross(z, x);
  const Vec3 origin = on_axis + z * glm::dot(chain.middle() - on_axis, z);
  return [=](Vec3 p) { return Vec3(glm::dot(p - origin, x), glm::dot(p - origin, y), glm::dot(p - origin, z)); };
}

constexpr const char* kBonds = "BOND LENGTHS AND ANGLES: R. A. ENGH, R. HUBER, ACTA CRYST. A47, 392 (1991)";
constexpr const char* kAlphaTorsions =
    "TORSIONS OF POLY-L-ALANINE: S. ARNOTT, S. D. DOVER, J. MOL. BIOL. 30, 209 (1967)";
constexpr const char* kNoHydrogens = "NO HYDROGENS, AS IN THE CRYSTAL STRUCTURES";
constexpr const char* kMaker = "MADE BY MOLTACT_GENERATE_MOLECULES";

}  // namespace

std::string makeAlphaHelix() {
  const Chain chain(20, kAlpha);
  return writePdb("IDEAL ALPHA-HELIX, 20 ALANINES", {kBonds, kAlphaTorsions, kNoHydrogens, kMaker},
                  chain.atoms(helixAxes(chain)));
}

std::string makeHelixPair() {
  constexpr double kApart_A = 18;
  const Chain chain(12, kAlpha);
  const auto axes = helixAxes(chain);
  // Upright: the helix at +x, its mirror image at -x.
  const auto right = [&](Vec3 p) {
    const Vec3 q = axes(p);
    return Vec3(q.x + 0.5 * kApart_A, q.z, -q.y);
  };
  std::vector<MadeAtom> atoms = chain.atoms(right);
  for (MadeAtom& a : chain.atoms([&](Vec3 p) { return right(p) * Vec3(-1, 1, 1); }, "DAL", 'B')) atoms.push_back(a);
  return writePdb("A RIGHT-HANDED AND A LEFT-HANDED ALPHA-HELIX, 12 ALANINES EACH",
                  {kBonds, kAlphaTorsions, "CHAIN A: L-ALANINE, RIGHT-HANDED; CHAIN B: ITS MIRROR IMAGE, D-ALANINE",
                   kNoHydrogens, kMaker},
                  atoms);
}

std::string makeBetaStrand() {
  constexpr int kResidues = 20;
  const Chain chain(kResidues, kBeta);
  // Along x, with the side chains at the centre pointing up and down.
  const Vec3 x = glm::normalize(chain.ca(kResidues - 1) + chain.ca(kResidues) - chain.ca(1) - chain.ca(2));
  const Vec3 knob = chain.cb(kResidues / 2) - chain.cb(kResidues / 2 + 1);
  const Vec3 y = glm::normalize(knob - x * glm::dot(knob, x)), z = glm::cross(x, y), origin = chain.middle();
  return writePdb(
      "IDEAL BETA STRAND, 20 ALANINES",
      {kBonds, "TORSIONS OF POLY-L-ALANINE: S. ARNOTT, S. D. DOVER, A. ELLIOTT, J. MOL. BIOL. 30, 201 (1967)",
       kNoHydrogens, kMaker},
      chain.atoms(
          [&](Vec3 p) { return Vec3(glm::dot(p - origin, x), glm::dot(p - origin, y), glm::dot(p - origin, z)); }));
}

}  // namespace moltact::generator
