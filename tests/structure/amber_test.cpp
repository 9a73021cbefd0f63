#include "engine/structure/amber/amber.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace moltact;

namespace {

double charge(std::span<const AmberAtom> residue) {
  double sum = 0;
  for (const AmberAtom& a : residue) sum += double(a.charge_e);
  return sum;
}

const AmberAtom& named(std::string_view residue, std::string_view atom) {
  for (const AmberAtom& a : amberTemplate(residue))
    if (a.name == atom) return a;
  FAIL(residue, " has no ", atom);
  return amberTemplate("ALA").front();
}

}  // namespace

TEST_CASE("the 78 templates of residues inside and at the ends of peptide chains have whole charges, within 1e-4") {
  int seen = 0;
  for (const std::string_view name : amberTemplateNames()) {
    const bool nucleic = name.size() <= 3 && std::string_view("ACGUD").find(name.front()) != std::string_view::npos &&
                         amberTemplate(name).size() >= 28;
    if (nucleic) continue;
    CAPTURE(name);
    ++seen;
    CHECK(std::abs(charge(amberTemplate(name)) - std::round(charge(amberTemplate(name)))) < 1e-4);
  }
  CHECK(seen == 78);
  CHECK(charge(amberTemplate("ASP")) == doctest::Approx(-1).epsilon(1e-4));
  CHECK(charge(amberTemplate("LYS")) == doctest::Approx(1).epsilon(1e-4));
  CHECK(charge(amberTemplate("HIP")) == doctest::Approx(1).epsilon(1e-4));
  CHECK(charge(amberTemplate("NALA")) == doctest::Approx(1).epsilon(1e-4));
  CHECK(charge(amberTemplate("CALA")) == doctest::Approx(-1).epsilon(1e-4));
}

TEST_CASE("a strand of DNA or RNA from its 5' to its 3' end has a charge of -1 for each phosphate, within 1e-3") {
  for (const std::string base : {"DA", "DC", "DG", "DT", "A", "C", "G", "U"}) {
    CAPTURE(base);
    CHECK(charge(amberTemplate(base)) == doctest::Approx(-1).epsilon(1e-3));
    CHECK(charge(amberTemplate(base + "5")) + charge(amberTemplate(base + "3")) == doctest::Approx(-1).epsilon(1e-3));
  }
}

TEST_CASE("the peptide group has the charges of Cornell et al. (1995): N -0.4157, H 0.2719, C 0.5973, O -0.5679") {
  CHECK(named("ALA", "N").charge_e == doctest::Approx(-0.4157));
  CHECK(named("ALA", "H").charge_e == doctest::Approx(0.2719));
  CHECK(named("ALA", "C").charge_e == doctest::Approx(0.5973));
  CHECK(named("ALA", "O").charge_e == doctest::Approx(-0.5679));
}

TEST_CASE("every atom of a template has a type, and every hydrogen but free protons a heavy atom that carries it") {
  for (const std::string_view name : amberTemplateNames()) {
    const auto residue = amberTemplate(name);
    for (const AmberAtom& a : residue) {
      CAPTURE(name);
      CAPTURE(a.name);
      REQUIRE(amberType(a.type));
      const bool hydrogen = a.type.front() == 'H';
      CHECK((a.parent >= 0) == hydrogen);
      if (hydrogen) CHECK(residue[std::size_t(a.parent)].type.front() != 'H');
    }
  }

  CHECK(amberType("C")->half_minimum_A == doctest::Approx(1.908));
  CHECK(amberType("C")->depth_kcal_mol == doctest::Approx(0.086));
  CHECK(amberType("HO")->depth_kcal_mol == 0.0f);
  CHECK(amberType("nothing") == nullptr);
  CHECK(amberTemplate("nothing").empty());
}

TEST_CASE("the polar hydrogens of serine are H and HG, of arginine six, of leucine H alone") {
  const auto polar = [](std::string_view name) {
    std::string out;
    const auto residue = amberTemplate(name);
    for (const AmberAtom& a : residue)
      if (polarHydrogen(residue, a)) out += std::string(a.name) + " ";
    return out;
  };
  CHECK(polar("SER") == "H HG ");
  CHECK(polar("ARG") == "H HE HH11 HH12 HH21 HH22 ");
  CHECK(polar("LEU") == "H ");
}
