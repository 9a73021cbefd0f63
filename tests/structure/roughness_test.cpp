// The factors of the textures, against the scales of which they are made.
#include "engine/structure/roughness.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/haptics/texture_choices.h"
#include "engine/structure/colouring.h"
#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE("an even surface and an unknown texture have no factors") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  CHECK_FALSE(roughness(m, kNoTexture));
  CHECK_FALSE(roughness(m, "velvet"));
}

TEST_CASE(
    "every texture that is offered, but for the even one, has a factor from 0 to 2 for each atom, and two at least") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  for (const OfferedWord& word : textureChoices()) {
    CAPTURE(std::string(word.name));
    const auto factors = roughness(m, word.name);
    if (word.name == kNoTexture) continue;
    REQUIRE(factors);
    REQUIRE(factors->size() == m.atoms.size());
    const auto [low, high] = std::minmax_element(factors->begin(), factors->end());
    CHECK(*low >= 0.0f);
    CHECK(*high <= kMaxRoughness);
    CHECK(*low < *high);
  }
}

TEST_CASE(
    "in ubiquitin oxygen drags 1.75 times as much as carbon, isoleucine 0.25 and arginine 1.75 times, lysine's side "
    "chain 1.75 and glutamate's 0.25 times") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  const auto element = roughness(m, kElementTexture), hydropathy = roughness(m, kHydrophobicityTexture),
             charge = roughness(m, kChargeTexture);
  int oxygen = 0, isoleucine = 0, arginine = 0, charged = 0;
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    const Residue& r = m.residues[m.atoms[i].residue];
    const std::string_view atom = m.atoms[i].nameText(), name = r.name;
    const bool backbone = atom == "N" || atom == "CA" || atom == "C" || atom == "O";
    if (m.atoms[i].atomic_number == 6) CHECK((*element)[i] == 1.0f);
    if (m.atoms[i].atomic_number == 8) {
      CHECK((*element)[i] == 1.75f);
      ++oxygen;
    }
    if (name == "ILE") {
      CHECK((*hydropathy)[i] == 0.25f);
      ++isoleucine;
    }
    if (name == "ARG") {
      CHECK((*hydropathy)[i] == 1.75f);
      ++arginine;
    }
    if (name == "LYS" || name == "ARG") {
      CHECK((*charge)[i] == (backbone ? 1.0f : 1.75f));
      ++charged;
    }
    if (name == "GLU" || name == "ASP") {
      CHECK((*charge)[i] == (backbone ? 1.0f : 0.25f));
      ++charged;
    }
    if (name == "GLN") CHECK((*charge)[i] == 1.0f);
  }
  CHECK(oxygen > 100);
  CHECK(isoleucine == 7 * 8);
  CHECK(arginine == 4 * 11);
  CHECK(charged > 100);
}
