// Radii as published, and the default for unknown elements.
#include "engine/molecule/elements.h"

#include <doctest/doctest.h>

#include <set>

#include "engine/molecule/radius_tables.h"
#include "engine/molecule/reader.h"

using namespace moltact;

TEST_CASE("Bondi's radii: H 1.20, C 1.70, N 1.55, O 1.52, F 1.47, P 1.80, S 1.80, Cl 1.75, Zn 1.39, I 1.98 A") {
  const struct {
    int z;
    const char* symbol;
    double radius;
  } rows[] = {{1, "H", 1.20},  {6, "C", 1.70},   {7, "N", 1.55},   {8, "O", 1.52},  {9, "F", 1.47},  {15, "P", 1.80},
              {16, "S", 1.80}, {17, "Cl", 1.75}, {30, "Zn", 1.39}, {53, "I", 1.98}, {18, "Ar", 1.88}};
  for (const auto& row : rows) {
    CHECK(element(row.z).symbol == row.symbol);
    CHECK(radiusTables().front().radius(row.z) == row.radius);
  }
}

TEST_CASE(
    "Alvarez's radii: H 1.20, C 1.77, N 1.66, O 1.50, F 1.46, P 1.90, S 1.89, Cl 1.82, Zn 2.39, I 2.04 A; both tables "
    "give Ca 2.62, Mn 2.45, Fe 2.44 and Co 2.40 A, which Bondi does not list") {
  const RadiusTable& alvarez = radiusTable("alvarez");
  CHECK(alvarez.word.name == "alvarez");
  for (const auto& [z, radius] : {std::pair{1, 1.20},
                                  {6, 1.77},
                                  {7, 1.66},
                                  {8, 1.50},
                                  {9, 1.46},
                                  {15, 1.90},
                                  {16, 1.89},
                                  {17, 1.82},
                                  {30, 2.39},
                                  {53, 2.04}})
    CHECK(alvarez.radius(z) == radius);
  for (const char* name : {"bondi", "alvarez"})
    for (const auto& [z, radius] : {std::pair{20, 2.62}, {25, 2.45}, {26, 2.44}, {27, 2.40}})
      CHECK(radiusTable(name).radius(z) == radius);
}

TEST_CASE(
    "the tables of Bondi and Alvarez know 93 of 118 elements; each table gives those it does not know 1.70 A and the "
    "others 1.0 "
    "to 3.6 A; names and symbols differ") {
  std::set<std::string_view> symbols, names;
  for (int z = 1; z <= kElementCount; ++z) symbols.insert(element(z).symbol);
  CHECK(symbols.size() == 118);
  for (const RadiusTable& table : radiusTables()) {
    CAPTURE(std::string(table.word.name));
    CHECK(names.insert(table.word.name).second);
    CHECK(&radiusTable(table.word.name) == &table);
    CHECK(table.body_overlap_A > table.ligand_overlap_A);
    int known = 0;
    for (int z = 1; z <= kElementCount; ++z) {
      known += table.knows(z);
      CHECK(table.radius(z) > 1.0);
      CHECK(table.radius(z) < 3.6);
      if (!table.knows(z)) CHECK(table.radius(z) == 1.70);
    }
    if (table.word.name == "bondi" || table.word.name == "alvarez") CHECK(known == 93);
  }
}

TEST_CASE("an atomic number of 0, -1 or 119 gives the unknown element with 1.70 A") {
  for (int z : {0, -1, 119}) {
    CHECK(element(z).symbol == "?");
    for (const RadiusTable& table : radiusTables()) CHECK(table.radius(z) == 1.70);
  }
}

TEST_CASE("a carbon and an oxygen of a PDB file have 1.70 and 1.52 A, and with 'radii: alvarez' 1.77 and 1.50 A") {
  const std::string lines =
      "HETATM    1  C   CO  A   1       0.000   0.000   0.000  1.00  0.00           C\n"
      "HETATM    2  O   CO  A   1       1.128   0.000   0.000  1.00  0.00           O\nEND\n";
  const auto usual = readMoleculeBytes(lines, "co.pdb"),
             other = readMoleculeBytes(lines, "co.pdb", {.radii = "alvarez"});
  REQUIRE(usual);
  REQUIRE(other);
  CHECK(usual->spheres[0].radius_A == 1.70);
  CHECK(usual->spheres[1].radius_A == 1.52);
  CHECK(other->spheres[0].radius_A == 1.77);
  CHECK(other->spheres[1].radius_A == 1.50);
  CHECK(usual->body_overlap_A == radiusTable("bondi").body_overlap_A);
  CHECK(other->body_overlap_A == radiusTable("alvarez").body_overlap_A);
}
