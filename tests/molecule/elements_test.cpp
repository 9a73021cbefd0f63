// Radii as published, and the default for unknown elements.
#include "engine/molecule/elements.h"

#include <doctest/doctest.h>

#include <set>

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
    CHECK(element(row.z).radius_A == row.radius);
    CHECK(element(row.z).source == RadiusSource::Bondi);
  }
}

TEST_CASE("Alvarez gives Ca 2.62, Mn 2.45, Fe 2.44 and Co 2.40 A, which Bondi does not have") {
  for (const auto& [z, radius] : {std::pair{20, 2.62}, {25, 2.45}, {26, 2.44}, {27, 2.40}}) {
    CHECK(element(z).radius_A == radius);
    CHECK(element(z).source == RadiusSource::Alvarez);
  }
}

TEST_CASE("of 118 elements 38 have Bondi's radius, 55 Alvarez's, and 25 the default 1.70 A; the symbols differ") {
  int count[3] = {};
  std::set<std::string_view> symbols;
  for (int z = 1; z <= kElementCount; ++z) {
    ++count[static_cast<int>(element(z).source)];
    symbols.insert(element(z).symbol);
    CHECK(element(z).radius_A > 1.1);
    CHECK(element(z).radius_A < 3.6);
  }
  CHECK(symbols.size() == 118);
  CHECK(count[0] == 38);
  CHECK(count[1] == 55);
  CHECK(count[2] == 25);
}

TEST_CASE("an atomic number of 0, -1 or 119 gives the unknown element with 1.70 A") {
  for (int z : {0, -1, 119}) {
    CHECK(element(z).symbol == "?");
    CHECK(element(z).radius_A == 1.70);
  }
}
