#include "app/ui/scene/contact_text.h"

#include <doctest/doctest.h>

#include <random>

#include "app/ui/scene/state_line.h"
#include "engine/molecule/reader.h"

using namespace moltact;

namespace {

const char* const kTwoResidues =
    "ATOM      1  CA  ASP A  52       0.000   0.000   0.000  1.00  0.00           C\n"
    "ATOM      2  C   ASP A  52       1.500   0.000   0.000  1.00  0.00           C\n"
    "ATOM      3  O   ASP A  52       2.200   1.000   0.000  1.00  0.00           O\n"
    "ATOM      4  N   TYR A  53       2.100  -1.100   0.000  1.00  0.00           N\n";

Molecule read(std::string text, const char* name) {
  auto made = readMoleculeBytes(std::move(text), name);
  if (!made) FAIL(made.problem().text());
  return *std::move(made);
}

Contact on(Feature feature, std::array<std::int32_t, 3> atoms) {
  Contact c;
  c.feature = feature;
  c.atoms = atoms;
  return c;
}

}  // namespace

TEST_CASE("sphere, crease and pit are described with element, atom, residue and newtons to one decimal") {
  const Molecule m = read(kTwoResidues, "two.pdb");
  CHECK(contactText(&m, on(Feature::Sphere, {2, -1, -1}), 0.449) == "touching: oxygen O of Asp 52, 0.4\u00a0N");
  CHECK(contactText(&m, on(Feature::Circle, {1, 2, -1}), 1.2) ==
        "touching: carbon C of Asp 52, crease with its oxygen O, 1.2\u00a0N");
  CHECK(contactText(&m, on(Feature::Point, {1, 2, 3}), 1.25) ==
        "touching: carbon C of Asp 52, pit with its oxygen O and nitrogen N of Tyr 53, 1.2\u00a0N");
  CHECK(touchedText(m, on(Feature::Point, {0, 1, 2})) == "carbon CA of Asp 52, pit with its carbon C and oxygen O");
  CHECK(touchedText(m, on(Feature::Point, {3, 1, 2})) ==
        "nitrogen N of Tyr 53, pit with carbon C and oxygen O of Asp 52");
  CHECK(contactText(&m, on(Feature::Circle, {2, 3, -1}), 3.0, false) ==
        "touching: oxygen O of Asp 52, crease with nitrogen N of Tyr 53, force is off");
  CHECK(contactText(&m, {}, 0) == "not touching");
  // A body's contacts form no crease and no pit.
  CHECK(contactText(&m, on(Feature::Circle, {2, 3, -1}), 3.0, true, true).find("crease") == std::string::npos);
  CHECK(touchedText(m, on(Feature::Circle, {1, 2, -1}), true) == "carbon C of Asp 52 and its oxygen O");
  CHECK(touchedText(m, on(Feature::Point, {0, 1, 2}), true) == "carbon CA of Asp 52, its carbon C and oxygen O");
  CHECK(contactText(nullptr, {}, 0) == "no molecule");
}

TEST_CASE(
    "of two chains the text names the chain; atoms without residues are counted; atoms out of range are left out") {
  std::string two = kTwoResidues;
  for (std::size_t at = two.find(" A  53"); at != std::string::npos; at = two.find(" A  53")) two.replace(at, 2, " B");
  const Molecule m = read(two, "two.pdb");
  CHECK(touchedText(m, on(Feature::Circle, {1, 3, -1})) ==
        "carbon C of Asp 52 (chain A), crease with nitrogen N of Tyr 53 (chain B)");
  CHECK(touchedText(m, on(Feature::Circle, {1, 77, -1})) == "carbon C of Asp 52 (chain A)");
  const Molecule bare = read("0 0 0 1.5\n2 0 0 1.5\n", "bare.xyzr");
  CHECK(touchedText(bare, on(Feature::Circle, {0, 1, -1})) == "atom 0, crease with atom 1");
}

TEST_CASE(
    "the direction of the surface's push is described in eight directions, and as straight ahead "
    "within 15 degrees") {
  CHECK(pushText({0, 0, 1}) == "pushed toward you");
  CHECK(pushText({0.2, -0.1, 0.97}) == "pushed toward you");
  CHECK(pushText({0, 0, -1}) == "pushed away from you");
  CHECK(pushText({0.6, 0, 0.8}) == "pushed to the right");
  CHECK(pushText({-0.6, 0.1, 0.79}) == "pushed to the left");
  CHECK(pushText({0, 0.6, 0.8}) == "pushed up");
  CHECK(pushText({-0.4, -0.4, 0.82}) == "pushed down and to the left");
}

TEST_CASE(
    "for reading the line changes at most every 0.4 s, for speaking every 1.5 s, however fast the force trembles; seed "
    "11") {
  for (const StateLine::Pace pace : {StateLine::reading(), StateLine::speaking()}) {
    std::mt19937 random(11);
    StateLine line(pace);
    double last_s = -10, least_s = 10;
    int changes = 0;
    for (int frame = 0; frame < 1200; ++frame) {
      const double now_s = frame / 60.0, force_N = double(random() % 30) / 10.0;
      const std::string what = random() % 40 == 0 ? "b" : "a";
      if (line.update(what, what + std::to_string(force_N), force_N, now_s)) {
        if (last_s > -10) least_s = std::min(least_s, now_s - last_s);
        last_s = now_s;
        ++changes;
      }
    }
    CHECK(changes > 5);
    CHECK(least_s >= pace.pace_s - 1e-9);
  }
}

TEST_CASE(
    "a contact of 50 ms is not reported, one that stays is reported once after 100 ms, and 0.05 N "
    "more is no news") {
  StateLine line(StateLine::reading());
  CHECK(line.update("free", "not touching", 0, 0.0));
  CHECK_FALSE(line.update("atom", "atom, 1 N", 1.0, 1.00));
  CHECK_FALSE(line.update("free", "not touching", 0, 1.05));
  CHECK_FALSE(line.update("atom", "atom, 1 N", 1.0, 1.10));
  CHECK_FALSE(line.update("atom", "atom, 1 N", 1.0, 1.19));
  CHECK(line.update("atom", "atom, 1 N", 1.0, 1.21));
  CHECK(line.text() == "atom, 1 N");
  CHECK_FALSE(line.update("atom", "atom, 1.05 N", 1.05, 3.0));
  CHECK(line.update("atom", "atom, 1.2 N", 1.2, 3.1));
}
