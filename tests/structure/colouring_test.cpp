// Colours of atoms and their legend.
#include "engine/structure/colouring.h"

#include <set>

#include "engine/molecule/elements.h"
#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

Colouring coloured(const Molecule& m, const char* scheme) {
  const auto found = findColouringScheme(scheme);
  REQUIRE(found);
  return colourMolecule(m, **found);
}

std::string names(const Legend& legend) {
  std::string out;
  for (const Legend::Entry& e : legend.entries) out += (out.empty() ? "" : "|") + e.name;
  return out;
}

std::size_t atomOf(const Molecule& m, int residue, const char* name) {
  for (std::size_t i = 0; i < m.atoms.size(); ++i)
    if (m.residues[m.atoms[i].residue].number == residue && m.atoms[i].nameText() == name) return i;
  FAIL("no such atom");
  return 0;
}

}  // namespace

TEST_CASE("every scheme colours every atom, and every colour of a scheme of classes stands in its legend") {
  for (const char* file : {"1ubq.pdb", "2hhb.pdb", "b-dna.pdb", "benzene.pdb", "argon.pdb"})
    for (const ColouringScheme& scheme : colouringSchemes()) {
      const Molecule m = libraryMolecule(file);
      CAPTURE(file);
      CAPTURE(scheme.name);
      const Colouring c = colourMolecule(m, scheme);
      REQUIRE(c.of_atom.size() == m.atoms.size());
      CHECK(c.legend.title == scheme.label);
      CHECK_FALSE(c.legend.entries.empty());
      if (c.legend.gradient) continue;
      std::set<Rgb8> reported;
      for (const Legend::Entry& e : c.legend.entries) {
        CHECK_FALSE(e.name.empty());
        reported.insert(e.colour);
      }
      for (const Rgb8& colour : c.of_atom) CHECK(reported.contains(colour));
    }
}

TEST_CASE("no two entries of a legend look alike, nor like a target") {
  // The colours of targets on a dark and on a light ground (engine/render/view_scene.cpp).
  const Rgb8 targets[] = {{0xFF, 0xB0, 0x00}, {0xFF, 0x5A, 0x00}};
  for (const char* file : {"1ubq.pdb", "1hel.pdb", "2hhb.pdb", "b-dna.pdb", "1hpv.pdb"})
    for (const ColouringScheme& scheme : colouringSchemes()) {
      const Molecule m = libraryMolecule(file, {.waters = true});
      const Legend legend = colourMolecule(m, scheme).legend;
      CAPTURE(file);
      CAPTURE(scheme.name);
      for (std::size_t a = 0; a < legend.entries.size(); ++a) {
        const Legend::Entry& one = legend.entries[a];
        CAPTURE(one.name);
        // Elements keep the customary colours; their phosphorus and iron are kept apart from each other below.
        if (scheme.name != "element")
          for (const Rgb8& target : targets) CHECK(colourDistance(one.colour, target) > 20.0);
        for (std::size_t b = 0; b < a; ++b) {
          CAPTURE(legend.entries[b].name);
          CHECK(colourDistance(one.colour, legend.entries[b].colour) > 10.0);
        }
      }
    }
}

TEST_CASE("among the elements of living things no two oranges are alike") {
  const int numbers[] = {6, 7, 8, 9, 11, 12, 15, 16, 17, 19, 20, 25, 26, 27, 28, 29, 30, 34, 35, 53};
  for (const int a : numbers)
    for (const int b : numbers) {
      if (a >= b) continue;
      CAPTURE(element(a).symbol);
      CAPTURE(element(b).symbol);
      CHECK(colourDistance(element(a).colour, element(b).colour) > 10.0);
    }
}

TEST_CASE("own colours differ from one another and from targets; their names and #rrggbb are read") {
  for (const NamedColour& one : namedColours()) {
    CAPTURE(one.name);
    CHECK(*parseColour(one.name) == one.colour);
    for (const Rgb8& target : {Rgb8{0xFF, 0xB0, 0x00}, Rgb8{0xFF, 0x5A, 0x00}})
      CHECK(colourDistance(one.colour, target) > 20.0);
    for (const NamedColour& other : namedColours())
      if (&one != &other) CHECK(colourDistance(one.colour, other.colour) > 15.0);
  }
  CHECK(*parseColour("#0180ff") == Rgb8{1, 128, 255});
  for (const char* text : {"", "#12345", "#12345g", "orange", "Red"}) {
    const auto read = parseColour(text);
    REQUIRE_FALSE(read);
    CHECK(read.problem().message == "'" + std::string(text) + "' is no colour");
    CHECK(read.problem().remedy.find("red, ") != std::string::npos);
  }
}

TEST_CASE("distances of colours are those of CIE L*a*b*: white to black 100, a colour to itself 0") {
  CHECK(colourDistance({255, 255, 255}, {0, 0, 0}) == doctest::Approx(100.0).epsilon(0.001));
  CHECK(colourDistance({12, 200, 100}, {12, 200, 100}) == 0.0);
  // Pure red and green lie at L*a*b* (53.24, 80.09, 67.20) and (87.73, -86.18, 83.18).
  CHECK(colourDistance({255, 0, 0}, {0, 255, 0}) == doctest::Approx(170.57).epsilon(0.001));
}

TEST_CASE("haemoglobin has four chains in the legend, its secondary structure helices and coil") {
  const Molecule m = libraryMolecule("2hhb.pdb");
  CHECK(names(coloured(m, "chain").legend) == "chain A|chain B|chain C|chain D|without a chain");
  const std::string structure = names(coloured(m, "structure").legend);
  CHECK(structure.starts_with("alpha helix|3-10 helix|"));
  CHECK(structure.ends_with("coil|other"));
}

TEST_CASE("at pH 7 Lys 27 of ubiquitin is positive, Glu 24 negative, their backbones are not, nor is His 68") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  const Colouring c = coloured(m, "charge");
  const auto& e = c.legend.entries;
  REQUIRE(names(c.legend) == "negative (−1)|positive (+1)|uncharged");
  CHECK(c.of_atom[atomOf(m, 24, "OE1")] == e[0].colour);
  CHECK(c.of_atom[atomOf(m, 27, "NZ")] == e[1].colour);
  CHECK(c.of_atom[atomOf(m, 27, "N")] == e[2].colour);
  CHECK(c.of_atom[atomOf(m, 68, "NE2")] == e[2].colour);
}

TEST_CASE("the rainbow goes from the first residue's colour to the last's, B factors from the least to the greatest") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  const Colouring rainbow = coloured(m, "rainbow");
  CHECK(rainbow.legend.gradient);
  CHECK(rainbow.of_atom.front() == rainbow.legend.entries.front().colour);
  CHECK(rainbow.of_atom.back() == rainbow.legend.entries.back().colour);
  const Colouring b = coloured(m, "b-factor");
  std::size_t low = 0, high = 0;
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    if (m.atoms[i].b_factor_A2 < m.atoms[low].b_factor_A2) low = i;
    if (m.atoms[i].b_factor_A2 > m.atoms[high].b_factor_A2) high = i;
  }
  CHECK(b.of_atom[low] == b.legend.entries.front().colour);
  CHECK(b.of_atom[high] == b.legend.entries.back().colour);
  CHECK(b.legend.entries.front().name == "2\u00A0Å²");
  CHECK(names(coloured(libraryMolecule("argon.pdb"), "b-factor").legend) == "the file has none");
}

TEST_CASE("isoleucine is at the brown end of hydropathy, arginine at the blue end, as Kyte and Doolittle have them") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  const Colouring c = coloured(m, "hydrophobicity");
  REQUIRE(c.legend.entries.size() == 3);
  CHECK(c.of_atom[atomOf(m, 3, "CA")] == c.legend.entries[2].colour);
  CHECK(c.of_atom[atomOf(m, 42, "CA")] == c.legend.entries[0].colour);
}

TEST_CASE("parts have their own colour over the scheme's, the later over the earlier, and stand first in the legend") {
  const Molecule m = libraryMolecule("benzene.pdb");
  Colouring c = coloured(m, "element");
  const Rgb8 before = c.of_atom[5];
  const OwnColour parts[] = {{{0, 1, 99}, {1, 2, 3}, "one side"}, {{1, 2}, {4, 5, 6}, ""}};
  colourParts(c, parts);
  CHECK(c.of_atom[0] == Rgb8{1, 2, 3});
  CHECK(c.of_atom[1] == Rgb8{4, 5, 6});
  CHECK(c.of_atom[5] == before);
  REQUIRE(c.legend.parts.size() == 1);
  CHECK(c.legend.parts[0].name == "one side");
}

TEST_CASE(
    "fluctuation colours from blue at the smallest to red at the largest, water beyond the range as the largest; "
    "without "
    "a trajectory the legend says so and every atom is grey") {
  Molecule m = libraryMolecule("1ubq.pdb");
  std::vector<float> fluctuation(m.atoms.size(), 1.0f);
  fluctuation[3] = 0.25f;
  fluctuation[7] = 2.25f;
  const auto scheme = findColouringScheme("fluctuation");
  REQUIRE(scheme);
  const Colouring c = colourMolecule(m, **scheme, {.fluctuation_A = fluctuation});
  const Colouring b = coloured(m, "b-factor");
  CHECK(c.of_atom[3] == b.legend.entries.front().colour);
  CHECK(c.of_atom[7] == b.legend.entries.back().colour);
  CHECK(names(c.legend) == "0.25\u00a0Å|1.25\u00a0Å|2.25\u00a0Å");
  CHECK(c.legend.gradient);
  const Colouring none = coloured(m, "fluctuation");
  CHECK(names(none.legend) == "no trajectory has been read");
  CHECK(none.of_atom[3] == none.legend.entries.front().colour);
  const std::vector<float> too_few(3, 1.0f);
  CHECK(colourMolecule(m, **scheme, {.fluctuation_A = too_few}).of_atom[0] == none.of_atom[0]);
}

TEST_CASE("an unknown scheme is reported with the known ones") {
  const auto found = findColouringScheme("colour");
  REQUIRE_FALSE(found);
  CHECK(found.problem().text() ==
        "there is no colouring named 'colour'; the names are element, chain, residue, residue-type, hydrophobicity, "
        "charge, potential, structure, b-factor, fluctuation, rainbow");
}
