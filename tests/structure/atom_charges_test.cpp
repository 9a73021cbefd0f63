// Atomic charges by source, against manual counts.
#include "engine/structure/atom_charges.h"

#include <doctest/doctest.h>

#include <map>
#include <numeric>
#include <set>

#include "engine/haptics/interactions.h"
#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

double sum_e(const std::vector<float>& charges) { return std::accumulate(charges.begin(), charges.end(), 0.0); }

/// The net charge of the named residues, each by its charge at pH 7.
int countedCharge_e(const Molecule& m) {
  const std::map<std::string_view, int> charge{{"ASP", -1}, {"GLU", -1}, {"LYS", 1}, {"ARG", 1}};
  int out = 0;
  for (const Residue& r : m.residues)
    if (const auto at = charge.find(r.name); at != charge.end()) out += at->second;
  return out;
}

}  // namespace

TEST_CASE("formal charges of ubiquitin sum to 0: 11 Asp and Glu against 11 Lys and Arg") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  const std::vector<float> charges = formalCharges_e(m);
  REQUIRE(charges.size() == m.atoms.size());
  CHECK(std::abs(sum_e(charges)) < 1e-6);
  int negative = 0, positive = 0;
  for (std::size_t i = 0; i < charges.size(); ++i) {
    const std::string_view name = m.atoms[i].nameText();
    if (charges[i] < 0) {
      ++negative;
      CHECK((name == "OD1" || name == "OD2" || name == "OE1" || name == "OE2"));
      CHECK(charges[i] == -0.5F);
    } else if (charges[i] > 0) {
      ++positive;
      CHECK(charges[i] == (name == "NZ" ? 1.0F : 0.5F));
    }
  }
  CHECK(negative == 22);
  CHECK(positive == 7 + 2 * 4);
}

TEST_CASE("formal charges of every residue sum to the residue's charge, and of B-DNA to -1 for each phosphate") {
  for (const char* file : {"1hel.pdb", "1ubq.pdb"}) {
    const Molecule m = libraryMolecule(file);
    CHECK(sum_e(formalCharges_e(m)) == doctest::Approx(countedCharge_e(m)));
  }
  const Molecule dna = libraryMolecule("b-dna.pdb");
  int phosphates = 0;
  for (const Atom& a : dna.atoms) phosphates += a.nameText() == "P";
  CHECK(phosphates == 22);
  CHECK(sum_e(formalCharges_e(dna)) == doctest::Approx(-phosphates));
}

TEST_CASE("a residue whose file lacks one of two carriers has its whole charge on the other") {
  Molecule m = libraryMolecule("1ubq.pdb");
  std::vector<Atom> atoms = m.atoms.copy();
  std::uint32_t of = kNoResidue;
  for (Atom& a : atoms)
    if (of == kNoResidue && a.nameText() == "OE1" && m.residues[a.residue].name == "GLU") {
      of = a.residue;
      a.name = {'X'};
    }
  m.atoms = atoms;
  const std::vector<float> charges = formalCharges_e(m);
  for (std::size_t i = 0; i < charges.size(); ++i)
    if (m.atoms[i].residue == of && m.atoms[i].nameText() == "OE2") CHECK(charges[i] == -1.0F);
  CHECK(std::abs(sum_e(charges)) < 1e-6);
}

TEST_CASE("chemistry has one element and one type for each atom, and charges only from a source that has them") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  const AtomChemistry none = atomChemistry(m, "none"), formal = atomChemistry(m, "formal");
  REQUIRE(none.types.size() == m.atoms.size());
  REQUIRE(none.atomic_numbers.size() == m.atoms.size());
  CHECK(none.charges_e.empty());
  CHECK(atomChemistry(m, "file").charges_e.empty());
  CHECK(formal.charges_e.size() == m.atoms.size());
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    CHECK(none.atomic_numbers[i] == m.atoms[i].atomic_number);
    CHECK(none.type_names[none.types[i]] ==
          std::string(m.residues[m.atoms[i].residue].name) + ' ' + std::string(m.atoms[i].nameText()));
  }
  // Distinct names only.
  CHECK(std::set<std::string>(none.type_names.begin(), none.type_names.end()).size() == none.type_names.size());
}

TEST_CASE("charges of a PQR file reach an atom's chemistry unchanged") {
  Molecule m = libraryMolecule("alpha-helix.pdb");
  std::vector<float> charges(m.atoms.size());
  for (std::size_t i = 0; i < charges.size(); ++i) charges[i] = 0.01F * float(i % 7) - 0.03F;
  m.charges_e = charges;
  CHECK(atomChemistry(m, "file").charges_e == charges);
  CHECK(atomChemistry(m, "none").charges_e.empty());
}

TEST_CASE("contact needs no chemistry, so none is made for the probe or the body") {
  const Molecule m = libraryMolecule("alpha-helix.pdb");
  for (const InteractionKind& kind : interactionKinds()) {
    TouchSetup touch;
    touch.interaction = kind.name;
    touch.charges = "formal";
    CHECK((chemistryFor(touch, m) != nullptr) == kind.needs_chemistry);
  }
}
