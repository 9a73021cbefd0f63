// Lengths, angles and torsions: closed forms, and the geometry of a helix.
#include "engine/structure/measure.h"

#include <cmath>
#include <numbers>
#include <random>

#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

PointA at(double x, double y, double z) { return {Vec3(x, y, z)}; }

PointA measureNamed(const Molecule& m, int residue, const char* name) {
  for (const PlacedAtom& a : m.placedAtoms())
    if (m.residues[a.residue].number == residue && a.nameText() == name) return a.position;
  FAIL("no such atom");
  return {};
}

}  // namespace

TEST_CASE("angles of 0, 60, 90 and 180 degrees are that, to 1e-9, and near 180 as exact as elsewhere") {
  CHECK(angle_deg(at(1, 0, 0), at(0, 0, 0), at(2, 0, 0)) == doctest::Approx(0.0).epsilon(1e-9));
  CHECK(angle_deg(at(1, 0, 0), at(0, 0, 0), at(0.5, std::sqrt(0.75), 0)) == doctest::Approx(60.0).epsilon(1e-9));
  CHECK(angle_deg(at(1, 0, 0), at(0, 0, 0), at(0, 0, 3)) == doctest::Approx(90.0).epsilon(1e-9));
  CHECK(angle_deg(at(1, 0, 0), at(0, 0, 0), at(-1, 0, 0)) == doctest::Approx(180.0).epsilon(1e-9));
  const double small = 1e-7;  // radian
  CHECK(180.0 - angle_deg(at(1, 0, 0), at(0, 0, 0), at(-std::cos(small), std::sin(small), 0)) ==
        doctest::Approx(small * 180.0 / std::numbers::pi).epsilon(1e-6));
}

TEST_CASE("a torsion is the turn about its middle bond, clockwise positive, and its mirror image has the other sign") {
  const unsigned seed = 7;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(-179.0, 179.0), length(0.5, 2.0);
  for (int k = 0; k < 50; ++k) {
    const double deg = turn(random), rad = deg * std::numbers::pi / 180.0, r = length(random), s = length(random);
    // Seen along +z, from b to c, clockwise is from +x toward +y.
    const PointA a = at(r, 0, -0.4), b = at(0, 0, 0), c = at(0, 0, 1.5),
                 d = at(s * std::cos(rad), s * std::sin(rad), 1.9);
    CHECK(torsion_deg(a, b, c, d) == doctest::Approx(deg).epsilon(1e-9));
    CHECK(torsion_deg(d, c, b, a) == doctest::Approx(deg).epsilon(1e-9));
    CHECK(torsion_deg(at(-r, 0, -0.4), b, c, at(-d.A.x, d.A.y, d.A.z)) == doctest::Approx(-deg).epsilon(1e-9));
  }
}

TEST_CASE("in the helix of ubiquitin phi and psi of Lys 27 to Lys 29 lie within 20 degrees of -62 and -42") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  for (int r = 27; r <= 29; ++r) {
    CAPTURE(r);
    CHECK(std::abs(torsion_deg(measureNamed(m, r - 1, "C"), measureNamed(m, r, "N"), measureNamed(m, r, "CA"),
                               measureNamed(m, r, "C")) +
                   62.0) < 20.0);
    CHECK(std::abs(torsion_deg(measureNamed(m, r, "N"), measureNamed(m, r, "CA"), measureNamed(m, r, "C"),
                               measureNamed(m, r + 1, "N")) +
                   42.0) < 20.0);
  }
}

TEST_CASE("a measure is written with its unit: two places a length, three an angle, four a torsion, else nothing") {
  const std::vector<PointA> places{at(0, 0, 0), at(3, 4, 0), at(3, 4, 2), at(8, 4, 2)};
  CHECK(measureText(std::span(places).first(2)) == "5.00\u00A0Å");
  CHECK(measureText(std::span(places).first(3)) == "90.0°");
  CHECK(measureText(places).ends_with("°"));
  CHECK(measureText(std::span(places).first(1)).empty());
}
