// Net charges of 1UBQ, 1HPV and 2HHB, the states of histidine and the number of polar hydrogens are those that OpenMM
// 7.7 and pdb2pqr 3.5.2 assign.
#include "engine/structure/amber/pair_atoms.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/haptics/field/pair_sum.h"
#include "engine/structure/amber/charge_faults.h"
#include "engine/structure/bonds.h"
#include "tests/structure/library.h"

using namespace moltact;

namespace {

using PairAtomsKind = PairAtoms::Note::Kind;

std::size_t count(const PairAtoms& a, PairAtomsKind kind) {
  return std::size_t(std::count_if(a.notes.begin(), a.notes.end(), [&](const auto& n) { return n.kind == kind; }));
}

}  // namespace

TEST_CASE("1UBQ, 1HPV and 2HHB have net charges of 0, 4 and 2, and every atom of their proteins its template's place") {
  const PairAtoms u = pairAtoms(test::libraryMolecule("1ubq.pdb")), p = pairAtoms(test::libraryMolecule("1hpv.pdb")),
                  h = pairAtoms(test::libraryMolecule("2hhb.pdb"));
  CHECK(u.net_charge_e == doctest::Approx(0.0).epsilon(0.001));
  CHECK(p.net_charge_e == doctest::Approx(4.0).epsilon(0.001));
  // The protein alone; each haem has 2 charges less: its iron 2, its ring -2, its propionates -1 each.
  CHECK(h.net_charge_e == doctest::Approx(2.0 - 4 * 2.0).epsilon(0.001));
  for (const PairAtoms* a : {&u, &p, &h}) {
    CHECK(count(*a, PairAtomsKind::OtherAtoms) == 0);
    CHECK(count(*a, PairAtomsKind::MissingAtoms) == 0);
  }
  CHECK(count(u, PairAtomsKind::NoTemplate) == 0);
  CHECK(count(p, PairAtomsKind::Ligand) == 1);  // amprenavir
  CHECK(count(u, PairAtomsKind::Terminus) == 2);
  CHECK(count(p, PairAtomsKind::Terminus) == 4);
  // Polar hydrogens: 332 of the protein's 1516 heavy atoms, 4 of amprenavir.
  CHECK(p.placed_hydrogens == 336);
  CHECK(p.atoms.size() == p.carrier.size());
}

// obabel -ipdb amprenavir.pdb -h --partialcharge gasteiger -omol2 (Open Babel 3.1.1), of the lines HETATM cut to their
// first 66 columns. The charges of hydrogens on carbon are added to it.
TEST_CASE(
    "amprenavir in 1HPV has Open Babel's Gasteiger charges within 0.002, four polar hydrogens and the net charge 0") {
  constexpr struct {
    const char* name;
    float charge_e;
  } kRight[] = {{"C1", 0.2042f},   {"C2", 0.0749f},  {"C3", 0.4009f},  {"C4", 0.2057f},  {"C5", 0.1101f},
                {"C6", 0.1507f},   {"C7", 0.0598f},  {"C8", -0.0455f}, {"C9", 0.0035f},  {"C10", 0.0035f},
                {"C11", 0.0003f},  {"C12", 0.0003f}, {"C13", 0.0001f}, {"C14", 0.1423f}, {"C15", 0.1121f},
                {"C16", -0.0015f}, {"C17", 0.1056f}, {"C18", 0.0302f}, {"C19", 0.0244f}, {"C20", 0.0247f},
                {"C21", 0.0244f},  {"C22", 0.0302f}, {"C23", 0.0084f}, {"C24", 0.0084f}, {"C25", 0.1635f},
                {"N1", -0.2754f},  {"N2", -0.1738f}, {"N3", -0.3580f}, {"O1", -0.4447f}, {"O2", -0.2265f},
                {"O3", -0.3886f},  {"O4", -0.1528f}, {"O5", -0.1528f}, {"O6", -0.3760f}, {"S1", 0.0609f}};
  const Molecule m = test::libraryMolecule("1hpv.pdb");
  const PairAtoms a = pairAtoms(m);
  std::size_t seen = 0, hydrogens = 0;
  double net_e = 0.0;
  for (std::size_t k = 0; k < a.atoms.size(); ++k) {
    const Atom& carrier = m.atoms[a.carrier[k]];
    if (m.residues[carrier.residue].name != "478") continue;
    net_e += double(a.atoms[k].charge_e);
    CAPTURE(carrier.nameText());
    if (k >= m.atoms.size()) {
      ++hydrogens;
      const double right = carrier.nameText() == "N1" ? 0.1524 : carrier.nameText() == "N3" ? 0.1423 : 0.2099;
      CHECK(std::abs(double(a.atoms[k].charge_e) - right) < 0.002);
      continue;
    }
    for (const auto& right : kRight)
      if (carrier.nameText() == right.name) {
        ++seen;
        CHECK(std::abs(a.atoms[k].charge_e - right.charge_e) < 0.002f);
      }
  }
  CHECK(seen == 35);
  CHECK(hydrogens == 4);
  CHECK(std::abs(net_e) < 1e-4);
}

TEST_CASE("the proton of HIS 69 of HIV protease is on ND1, in both chains") {
  const Molecule m = test::libraryMolecule("1hpv.pdb");
  int seen = 0;
  for (const auto& n : pairAtoms(m).notes) {
    if (n.kind != PairAtomsKind::Histidine) continue;
    ++seen;
    CHECK(n.template_name == "HID");
    CHECK(m.residues[n.residue].number % 100 == 69);
  }
  CHECK(seen == 2);
}

TEST_CASE("in haemoglobin the histidine on an iron has no proton there") {
  const Molecule m = test::libraryMolecule("2hhb.pdb");
  int bound = 0;
  for (const auto& n : pairAtoms(m).notes) {
    if (n.kind != PairAtomsKind::Histidine) continue;
    const int number = m.residues[n.residue].number;
    const bool alpha = m.residues[n.residue].chain % 2 == 0;
    if (number != (alpha ? 87 : 92)) continue;
    ++bound;
    CHECK(n.template_name == "HID");
  }
  CHECK(bound == 4);
}

TEST_CASE(
    "placed hydrogens of 1UBQ: bonds of 0.96, 1.01 and 1.336 A, angles of 100 to 130 degrees, none within 1.2 A of "
    "an atom that does not carry it") {
  const Molecule m = test::libraryMolecule("1ubq.pdb");
  const PairAtoms a = pairAtoms(m);
  const BondTable bonds(m.atoms.size(), findBonds(m));
  CHECK(a.placed_hydrogens == 144);
  for (std::size_t k = m.atoms.size(); k < a.atoms.size(); ++k) {
    const std::uint32_t carrier = a.carrier[k];
    CAPTURE(m.describe(carrier));
    const Vec3 bond = a.atoms[k].centre_A - m.spheres[carrier].centre_A;
    const int element = m.atoms[carrier].atomic_number;
    CHECK(glm::length(bond) == doctest::Approx(element == 16 ? 1.336 : element == 8 ? 0.96 : 1.01));
    for (const std::uint32_t i : bonds.neighbours(carrier)) {
      const double cosine =
          glm::dot(glm::normalize(bond), glm::normalize(m.spheres[i].centre_A - m.spheres[carrier].centre_A));
      CHECK(cosine < std::cos(100.0 * 3.14159265 / 180));
      CHECK(cosine > std::cos(130.0 * 3.14159265 / 180));
    }
    for (std::size_t j = 0; j < a.atoms.size(); ++j)
      if (j != k && j != carrier && a.carrier[j] != carrier)
        CHECK(glm::distance(a.atoms[j].centre_A, a.atoms[k].centre_A) > 1.2);
  }
}

TEST_CASE(
    "a protein beside DNA has a whole net charge within 0.01, and DNA without its hydrogens -1 for each phosphate") {
  const double complex = pairAtoms(test::libraryMolecule("1a1f.pdb")).net_charge_e;
  CHECK(std::abs(complex - std::round(complex)) < 0.01);
  const Molecule dna = test::libraryMolecule("b-dna.pdb");
  const auto phosphates =
      std::count_if(dna.atoms.begin(), dna.atoms.end(), [](const Atom& a) { return a.atomic_number == 15; });
  CHECK(pairAtoms(dna).net_charge_e == doctest::Approx(-double(phosphates)).epsilon(0.01));
}

TEST_CASE("a hydrogen that the file has keeps its place and charge, and none is placed there") {
  const std::string text = test::libraryText("alpha-helix.pdb");
  const Molecule without = test::moleculeOf(text);
  const PairAtoms a = pairAtoms(without);
  // The hydrogen of the sixth residue, written into the file 0.05 A beside its computed place.
  std::size_t placed = without.atoms.size();
  while (without.atoms[a.carrier[placed]].residue != 5) ++placed;
  const Vec3 at = a.atoms[placed].centre_A + Vec3(0.05, 0, 0);
  char line[96];
  std::snprintf(line, sizeof line, "ATOM   9999  H   ALA A   6    %8.3f%8.3f%8.3f  1.00  0.00           H\n", at.x,
                at.y, at.z);
  const std::size_t next = text.find("ALA A   7");
  REQUIRE(next != std::string::npos);
  std::string added = text;
  added.insert(text.rfind('\n', next) + 1, line);
  const Molecule with = test::moleculeOf(added);
  const PairAtoms b = pairAtoms(with);
  REQUIRE(with.atoms.size() == without.atoms.size() + 1);
  CHECK(b.placed_hydrogens + 1 == a.placed_hydrogens);
  CHECK(b.net_charge_e == doctest::Approx(a.net_charge_e).epsilon(1e-6));
  const auto hydrogen =
      std::find_if(with.atoms.begin(), with.atoms.end(), [](const Atom& x) { return x.atomic_number == 1; });
  const PairAtom& kept = b.atoms[std::size_t(hydrogen - with.atoms.begin())];
  CHECK(glm::distance(kept.centre_A, at) < 0.001);
  CHECK(kept.charge_e == doctest::Approx(0.2719));
}

TEST_CASE(
    "a file's net charge 0.4 e from a whole number is noted with the residue that is not whole; 0.05 e is rounding") {
  const auto pqr = [](const char* second) {
    return test::moleculeOf(std::string("ATOM 1 N ALA A 1 0 0 0 -0.3 1.8\nATOM 2 CA ALA A 1 1.5 0 0 0.3 1.8\n"
                                        "ATOM 3 N GLY A 2 6 0 0 0.5 1.8\nATOM 4 CA GLY A 2 7.5 0 0 ") +
                                second + " 1.8\n",
                            "x.pqr");
  };
  const PairAtoms off = pairAtoms(pqr("0.9"));
  CHECK(off.net_charge_e == doctest::Approx(1.4));
  REQUIRE(count(off, PairAtomsKind::FractionalCharge) == 1);
  for (const auto& n : off.notes)
    if (n.kind == PairAtomsKind::FractionalCharge) {
      CHECK(n.residue == 1);
      CHECK(n.residue_charge_e == doctest::Approx(1.4));
    }
  CHECK(count(pairAtoms(pqr("0.55")), PairAtomsKind::FractionalCharge) == 0);
  CHECK(count(pairAtoms(pqr("0.5")), PairAtomsKind::FractionalCharge) == 0);
}

TEST_CASE("an atom of an unknown element is noted by its residue; its charge is 0, or the file's") {
  const std::string pdbqt =
      "ATOM      1  C1  LIG A   7       1.000   0.000   0.000  1.00  0.00    +0.250 C \n"
      "ATOM      2  Q1  LIG A   7       2.500   0.000   0.000  1.00  0.00    -0.250 QQ\n";
  const PairAtoms with = pairAtoms(test::moleculeOf(pdbqt, "x.pdbqt"));
  CHECK(count(with, PairAtomsKind::UnknownElement) == 1);
  CHECK(with.atoms[1].charge_e == -0.25f);
  const std::string pdb =
      "HETATM    1  C1  LIG A   7       1.000   0.000   0.000  1.00  0.00           C\n"
      "HETATM    2 QQ1  LIG A   7       2.500   0.000   0.000  1.00  0.00          QQ\n";
  const Molecule m = test::moleculeOf(pdb, "x.pdb");
  const PairAtoms without = pairAtoms(m);
  REQUIRE(count(without, PairAtomsKind::UnknownElement) == 1);
  CHECK(without.atoms[1].charge_e == 0.0f);
  CHECK(without.atoms[1].half_minimum_A == float(m.spheres[1].radius_A));
  CHECK(count(pairAtoms(test::libraryMolecule("2hhb.pdb")), PairAtomsKind::UnknownElement) == 0);
}

TEST_CASE(
    "what is wrong with a molecule's charges is one sentence, with the number of residues of each kind; else none") {
  CHECK(chargeFaults(pairAtoms(test::libraryMolecule("1ubq.pdb"))).empty());
  CHECK(chargeFaults(pairAtoms(test::libraryMolecule("1hpv.pdb"))).empty());
  const auto faults = [](const std::string& text, const char* name) {
    return chargeFaults(pairAtoms(test::moleculeOf(text, name)));
  };
  const std::string ending = ". 'moltact info --charges' names the residues.";
  const std::string unknown =
      "ATOM      1  C1  LIG A   7       1.000   0.000   0.000  1.00  0.00    +0.250 C \n"
      "ATOM      2  Q1  LIG A   7       2.500   0.000   0.000  1.00  0.00    -0.250 QQ\n";
  CHECK(faults(unknown, "x.pdbqt") == "Forces between atoms: 1 residue has atoms of unknown elements" + ending);
  CHECK(
      faults("ATOM 1 N ALA A 1 0 0 0 -0.5 1.8\nATOM 2 CA ALA A 1 1.5 0 0 0.5 1.8\nATOM 3 CB ALA A 1 1.5 0 0 0.3 1.8\n",
             "x.pqr") == "Forces between atoms: the net charge is 0.30 e from a whole number" + ending);
}

TEST_CASE("two atoms in one place are noted, and their forces on a third are finite at every distance") {
  const Molecule m = test::moleculeOf(
      "ATOM 1 N ALA A 1 0 0 0 -0.5 1.8\nATOM 2 CA ALA A 1 1.5 0 0 0.5 1.8\nATOM 3 CB ALA A 1 1.5 0 0 0.3 1.8\n"
      "ATOM 4 O HOH B 2 9 0 0 -0.3 1.8\n",
      "x.pqr", {.waters = true});
  const PairAtoms a = pairAtoms(m);
  REQUIRE(count(a, PairAtomsKind::SamePlace) == 1);
  for (const auto& n : a.notes)
    if (n.kind == PairAtomsKind::SamePlace) CHECK(n.residue == 0);
  CHECK(count(pairAtoms(test::libraryMolecule("1hpv.pdb")), PairAtomsKind::SamePlace) == 0);
  std::vector<Sphere> places;
  for (const PairAtom& atom : a.atoms) places.push_back({atom.centre_A, 1.0});
  for (const double wall : {double(INFINITY), 1.0}) {
    PairModel model;
    model.wall_kcal_mol = wall;
    PairSum sum(std::make_shared<const SphereGrid>(places), a.atoms, {a.atoms[3]}, model);
    for (int k = 0; k <= 4000; ++k) {
      const PairEnergy found = sum.at({{Vec3(1.5 - 9.0 + 0.001 * k, 0, 0)}, kNoRotation});
      REQUIRE(std::isfinite(found.energy.felt_kcal_mol));
      REQUIRE(finite(found.force_kcal_mol_A));
      REQUIRE(finite(found.torque_kcal_mol));
    }
  }
}

TEST_CASE(
    "two argon atoms have the well of their pair, 0.2846 kcal/mol at 3.76 A, without a charge or a note; a residue of "
    "one "
    "oxygen and two hydrogens has TIP3P's parameters whatever its name is, and one that is bonded elsewhere has not") {
  const PairAtoms argon = pairAtoms(test::libraryMolecule("argon-pair.pdb"));
  CHECK(argon.notes.empty());
  for (const PairAtom& a : argon.atoms) {
    CHECK(2.0 * double(a.half_minimum_A) == doctest::Approx(3.76));
    CHECK(a.depth_kcal_mol == 0.2846f);
    CHECK(a.charge_e == 0.0f);
  }
  const PairAtoms both = pairAtoms(test::libraryMolecule("water-and-argon.pdb"));
  CHECK(both.notes.empty());
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK(both.atoms[k].charge_e == (k % 3 == 0 ? -0.834f : 0.417f));
    CHECK(both.atoms[k].depth_kcal_mol == (k % 3 == 0 ? 0.152f : 0.0f));
  }
  // Neon beside xenon: the rules of Lorentz and Berthelot. Methanol's oxygen is no water's.
  const PairAtoms noble =
      pairAtoms(test::moleculeOf("HETATM    1 NE    NE A   1       0.000   0.000   0.000  1.00  0.00          NE\n"
                                 "HETATM    2 XE    XE A   2       6.000   0.000   0.000  1.00  0.00          XE\n",
                                 "x.pdb"));
  CHECK(noble.notes.empty());
  CHECK(noble.atoms[0].depth_kcal_mol < noble.atoms[1].depth_kcal_mol);
  const PairAtoms split =
      pairAtoms(test::moleculeOf("HETATM    1  O1  UNK A   1       0.000   0.000   0.000  1.00  0.00           O\n"
                                 "HETATM    2  H1  UNK A   1       0.960   0.000   0.000  1.00  0.00           H\n"
                                 "HETATM    3  H2  UNK A   1      -4.000   0.000   0.000  1.00  0.00           H\n"
                                 "HETATM    4  C1  UNL A   2      -0.500   1.300   0.000  1.00  0.00           C\n",
                                 "x.pdb"));
  CHECK(split.atoms[0].charge_e != -0.834f);
}
