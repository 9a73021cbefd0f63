// The lessons' claims about touchable atoms, by two searches that are more thorough than the claims need: all straight
// lines from outside, and a flood fill of the free space (ways_in.h).
#include <set>

#include "tests/lesson/shipped_lesson.h"
#include "tests/lesson/ways_in.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr double kSliver = 0.001;  // of a sphere: less than a hand finds

struct Touchable {
  std::set<std::string> straight, crooked;  // "NE 36"
};

struct Searched {
  Searched(const std::string& molecule, double sphere_A, const std::string& without = {}) : scene(molecule) {
    std::vector<bool> out(scene.spheres.size());
    if (!without.empty())
      for (const std::uint32_t i : scene.select(without)) out[i] = true;
    std::vector<Sphere> kept;
    for (std::uint32_t i = 0; i < scene.spheres.size(); ++i) {
      index.push_back(out[i] ? -1 : int(kept.size()));
      if (!out[i]) kept.push_back(scene.spheres[i]);
    }
    ways.emplace(kept, sphere_A);
  }
  std::string name(std::uint32_t i) const {
    const Atom& a = scene.molecule->atoms[i];
    return std::string(a.nameText()) + ' ' + std::to_string(scene.molecule->residues[a.residue].number);
  }
  Touchable of(const std::string& text) const {
    Touchable out;
    for (const std::uint32_t i : scene.select(text)) {
      if (index[i] < 0) continue;
      if (ways->straight(std::uint32_t(index[i]))) out.straight.insert(name(i));
      if (ways->crooked(std::uint32_t(index[i]))) out.crooked.insert(name(i));
    }
    return out;
  }
  double share(const std::string& text) const { return ways->share(std::uint32_t(index[scene.select(text).at(0)])); }

  ShippedScene scene;
  std::vector<int> index;
  std::optional<WaysIn> ways;
};

using Names = std::set<std::string>;

const char* const kSixteen = "(residue 13 and name NZ) or (residue 36 88 123 156 167 and name NE NH1 NH2)";
const char* const kTwelve = "(residue 2 4 6 7 8 and name N7 O6) or (residue 9 and name N7 N6)";

}  // namespace

TEST_CASE(
    "adenylate kinase: of sixteen nitrogens a sphere of 1.4 A touches 16 straight in the open form, 3 in the shut one, "
    "4 "
    "without "
    "AP5A; crooked ways add 3, each by less than 1 % of its sphere") {
  CAPTURE(linesSaying("an-enzymes-door",
                      {"At least fifteen of the sixteen can be touched straight from outside", "- [x] Three of them",
                       "Along a straight line a probe now comes to three of the sixteen only, all of arginine 36",
                       "comes to three of the sixteen nitrogens in the shut form (NE, NH1 and NH2 of Arg 36), and with "
                       "AP₅A taken out to four (NH1 of Arg 123 too)",
                       "it comes to three more (NH1 of Arg 88, 123 and 156, each by less than 1 %"}));
  const Names arginine{"NE 36", "NH1 36", "NH2 36"};
  CHECK(Searched("4ake", 1.4).of(kSixteen).straight.size() == 16);
  const Searched shut("1ake", 1.4);
  const Touchable of = shut.of(kSixteen);
  CHECK(of.straight == arginine);
  CHECK(of.crooked == Names{"NE 36", "NH1 36", "NH2 36", "NH1 88", "NH1 123", "NH1 156"});
  for (const char* residue : {"88", "123", "156"})
    CHECK(shut.share(std::string("residue ") + residue + " and name NH1") < 0.01);
  CHECK(Searched("1ake", 1.4, "ligand").of(kSixteen).straight == Names{"NE 36", "NH1 36", "NH2 36", "NH1 123"});
}

TEST_CASE(
    "of the 57 atoms of AP5A a sphere of 1.4 A touches 5 straight and 11 by crooked ways, 8 of these of the "
    "phosphates; "
    "one of "
    "2 A none of the phosphates; two of one adenine are touched head-on") {
  CAPTURE(linesSaying("an-enzymes-door",
                      {"AP₅A has 57 atoms", "comes to five of its atoms along a straight line",
                       "comes to five along a straight line (N1A, C2A, C2B, O2A, O1D) and to eleven by crooked ways, "
                       "eight of them of the phosphates; a ball of 2 Å comes to no phosphate",
                       "Round corners a patient ball comes to some of the phosphates too"}));
  const Searched shut("1ake", 1.4);
  CHECK(shut.scene.select("ligand").size() == 57);
  const Touchable of = shut.of("ligand");
  CHECK(of.straight == Names{"N1A 215", "C2A 215", "C2B 215", "O2A 215", "O1D 215"});
  CHECK(of.crooked == Names{"N1A 215", "C2A 215", "C2B 215", "O2A 215", "O2B 215", "O2G 215", "O3G 215", "PD 215",
                            "O1D 215", "O3D 215", "O2E 215"});
  CHECK(shut.scene.openPlaces("ligand and name C2A N1A", 1.4) == shut.scene.openPlaces("ligand", 1.4));
  // A flood with a sphere that is smaller by what its grid may miss.
  CHECK(Searched("1ake", 2.0 - WaysIn::kMissed_A).of("ligand").crooked == Names{"N1A 215", "C2A 215"});
}

TEST_CASE(
    "HIV protease: with amprenavir no atom of either Asp 25 is touched by any way, without it four straight and one "
    "more by a "
    "sliver; of the drug's 35 atoms 10 by any way") {
  CAPTURE(linesSaying("a-drug-in-its-tunnel", {"- [x] No, not a single atom", "- [x] Four: the oxygens at their ends",
                                               "Of the 16 atoms of both Asp 25",
                                               "by a crooked way of CG of chain A, on one ten-thousandth of its sphere",
                                               "Fewer than a dozen of its 35 atoms can be touched at all"}));
  const Searched with("1hpv", 1.4), without("1hpv-empty", 1.4);
  CHECK(with.scene.select("residue 25").size() == 16);
  CHECK((with.of("residue 25").straight.empty() && with.of("residue 25").crooked.empty()));
  for (const char* chain : {"A", "B"}) {
    CAPTURE(chain);
    const Touchable of = without.of(std::string("residue 25 and chain ") + chain);
    CHECK(of.straight == Names{"OD1 25", "OD2 25"});
    Names crooked{"OD1 25", "OD2 25"};
    if (*chain == 'A') crooked.insert("CG 25");
    CHECK(of.crooked == crooked);
  }
  CHECK(without.share("residue 25 and chain A and name CG") < kSliver);
  CHECK(with.scene.select("ligand").size() == 35);
  CHECK(with.of("ligand").straight.size() == 10);
  CHECK(with.of("ligand").crooked.size() == 10);
}

TEST_CASE(
    "the twelve atoms of six letters in the wide groove are all touched straight without the protein, and with it none "
    "by any "
    "way but for a sliver of O6 of guanine 2") {
  CAPTURE(
      linesSaying("a-protein-reads-dna", {"12 of 12 on the bare DNA, 0 of 12 in the complex", "- [x] None of them →",
                                          "one ten-thousandth of the sphere of O6 of guanine 2"}));
  const Searched complex("1a1f", 1.4);
  CHECK(Searched("1a1f-dna", 1.4).of(kTwelve).straight.size() == 12);
  const Touchable of = complex.of(kTwelve);
  CHECK(of.straight == Names{"O6 2"});
  CHECK(of.crooked == Names{"O6 2"});
  CHECK(complex.share("residue 2 and name O6") < kSliver);
}

TEST_CASE("of the side chains 23, 26 and 30 of ubiquitin one of eleven atoms is touched, straight and by any way") {
  CAPTURE(lineSaying("coils-and-sheets",
                     "Of the eleven side-chain atoms of 23, 26 and 30 a probe of 1.4 Å comes to one only"));
  const Searched ubiquitin("1ubq", 1.4);
  const char* const kInner = "residue 23 26 30 and sidechain";
  CHECK(ubiquitin.scene.select(kInner).size() == 11);
  CHECK(ubiquitin.of(kInner).straight == Names{"CG2 30"});
  CHECK(ubiquitin.of(kInner).crooked == Names{"CG2 30"});
}

TEST_CASE(
    "of lysozyme's 1001 atoms a sphere of 1.4 A touches about 570 and one of 3.5 A about 330, straight as well as by "
    "any "
    "way, and "
    "the larger one no atom of Gln 57 but some of Glu 35 and Asp 52") {
  CAPTURE(linesSaying("the-probe-decides", {"the probe of 1.4 Å can touch about 570", "- [x] About 330",
                                            "crooked ways add one atom at most"}));
  for (const auto& [sphere_A, said] : {std::pair{1.4, 570.0}, std::pair{3.5, 330.0}}) {
    CAPTURE(sphere_A);
    const ShippedScene lysozyme("1hel");
    REQUIRE(lysozyme.spheres.size() == 1001);
    const WaysIn ways(lysozyme.spheres.spheres(), sphere_A);
    const std::vector<std::uint32_t> all = lysozyme.select("all");
    const auto straight = ways.straight(all).size(), crooked = ways.crooked(all).size();
    CHECK(double(straight) == doctest::Approx(said).epsilon(0.01));
    CHECK(crooked >= straight);
    CHECK(crooked <= straight + 1);
  }
  const Searched large("1hel", 3.5);
  CHECK(large.of("residue 57").crooked.empty());
  CHECK_FALSE(large.of("residue 35").straight.empty());
  CHECK_FALSE(large.of("residue 52").straight.empty());
}
