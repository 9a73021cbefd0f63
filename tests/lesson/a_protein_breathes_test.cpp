// The program's lesson on the breathing of haemoglobin: how far its places give way, how little the gap at the iron
// changes by heat, and how wide it is without the histidine's side chain.
#include <algorithm>
#include <random>

#include "engine/dynamics/normal_modes.h"
#include "tests/lesson/shipped_lesson.h"
#include "tests/lesson/widest_way.h"

using namespace moltact;
using namespace moltact::test;

namespace {

/// The elastic network of haemoglobin, with the springs that give the mean B factor of its file.
struct Breathing {
  Breathing() : scene("2hhb"), network(*ElasticNetwork::make(*scene.molecule)), compliances(nodeCompliances(network)) {
    spring_kcal_mol_A2 = springFromDisplacementFactors(network, *scene.molecule, compliances);
  }
  const glm::dmat3& complianceOf(const std::string& atom) const {
    return compliances[network.nodeOf(scene.select(atom).at(0))];
  }
  /// How far the residue of an atom gives way along this direction under 1 N of the hand, which is 100 pN between the
  /// atoms.
  double given_A_per_N(const std::string& atom, const Vec3& along) const {
    constexpr double kPiconewton_per_kcal_mol_A = 69.4770;
    return glm::dot(along, complianceOf(atom) * along) / spring_kcal_mol_A2 * 100.0 / kPiconewton_per_kcal_mol_A;
  }
  Vec3 outward(const std::string& residue) const {
    Vec3 middle(0.0), place(0.0);
    for (const Sphere& a : scene.molecule->spheres) middle += a.centre_A / double(scene.molecule->spheres.size());
    const auto atoms = scene.select(residue);
    for (const std::uint32_t i : atoms) place += scene.molecule->spheres[i].centre_A / double(atoms.size());
    return glm::normalize(place - middle);
  }

  ShippedScene scene;
  ElasticNetwork network;
  std::vector<glm::dmat3> compliances;
  double spring_kcal_mol_A2 = 0.0;
};

const Breathing& breathing() {
  static const Breathing all;
  return all;
}

const std::string kSoft = "chain A and residue 60", kStiff = "chain B and residue 120";

/// The largest ball that comes from open water to the iron of chain A, on the side of the distal histidine.
double gapAtTheIron(const std::vector<Sphere>& spheres) {
  const ShippedScene& s = breathing().scene;
  const std::uint32_t iron = s.select("chain A and element Fe").at(0),
                      below = s.select("chain A and residue 87 and name NE2").at(0);
  const Vec3 at = spheres[iron].centre_A, out = glm::normalize(at - spheres[below].centre_A);
  const WidestWay way(spheres, at + 3.0 * out, 14.0, 0.4);
  return way.to(spheres[iron], [&](const Vec3& p) { return glm::dot(p - at, out) > 1.0; });
}

std::vector<Sphere> atRest() {
  const auto& spheres = breathing().scene.molecule->spheres;
  return {spheres.begin(), spheres.end()};
}

}  // namespace

TEST_CASE(
    "a-protein-breathes.md, and the same in German, asks a dark task before and after in the same elastic scene, in 5 "
    "steps and an extra one") {
  for (const char* file : {"a-protein-breathes", "a-protein-breathes.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 6);
    CHECK(std::count_if(lesson.steps.begin(), lesson.steps.end(), [](const Step& s) { return s.extra; }) == 1);
    CHECK(tasksOf(lesson, "same") == 2);
    CHECK(tasksOf(lesson, "fit") == 1);
    CHECK(tasksOf(lesson, "cross") == 1);
    for (const Step& step : lesson.steps)
      for (const TaskSpec& t : step.tasks)
        if (t.kind == "same") CHECK(step.scene.elastic);
    const TaskSpec* same = nullptr;
    for (const TaskSpec& t : lesson.steps[0].tasks) same = &t;
    REQUIRE(same);
    CHECK(same->values["same"].selection.text() == kStiff);
    CHECK(same->values["place"].selection.text() == kSoft);
  }
}

TEST_CASE(
    "pushed toward the middle of haemoglobin by 1 N, lysine 60 of chain A gives way by 0.98 A and lysine 120 of chain "
    "B "
    "by 0.56 A, and in all directions of the outer side the first gives way farther") {
  SAYS(linesSaying("a-protein-breathes", {"lysine 60 of chain A gives way by 0.98 Å and lysine 120 of chain B by 0.56",
                                          "equal springs of 0.17 kcal/mol/Å²"}));
  const Breathing& b = breathing();
  CHECK(b.spring_kcal_mol_A2 == doctest::Approx(0.17).epsilon(0.01));
  CHECK(b.scene.molecule->residues[b.scene.atom(kSoft + " and name CA").residue].name == "LYS");
  CHECK(b.scene.molecule->residues[b.scene.atom(kStiff + " and name CA").residue].name == "LYS");
  CHECK(b.given_A_per_N(kSoft, b.outward(kSoft)) == doctest::Approx(0.98).epsilon(0.006));
  CHECK(b.given_A_per_N(kStiff, b.outward(kStiff)) == doctest::Approx(0.56).epsilon(0.01));
  // Where the probe rests on them from outside, within 60 degrees of the direction in which the view shows them.
  const auto bounds = [&](const std::string& residue) {
    double low = 1e9, high = 0.0, mean = 0.0;
    int n = 0;
    for (const SurfacePlace& p : b.scene.places(residue, 1.4, 200)) {
      if (glm::dot(p.outward, b.outward(residue)) < 0.5) continue;
      const double gives = b.given_A_per_N(residue, p.outward);
      low = std::min(low, gives), high = std::max(high, gives), mean += gives, ++n;
    }
    REQUIRE(n > 20);
    return std::array<double, 3>{low, mean / n, high};
  };
  const auto soft = bounds(kSoft), stiff = bounds(kStiff);
  MESSAGE("lysine 60: " << soft[0] << " to " << soft[2] << " A/N, lysine 120: " << stiff[0] << " to " << stiff[2]);
  CHECK(soft[1] > 1.4 * stiff[1]);
  // The hand's spring of 2000 N/m at 0.4 A/mm is 5 N/A: springs in series. Pushed in equally far, the soft place pushes
  // back about two thirds as hard.
  SAYS(lineSaying("a-protein-breathes", "about two thirds of what it shows on stiff ground"));
  CHECK((0.2 + stiff[1]) / (0.2 + soft[1]) == doctest::Approx(0.67).epsilon(0.1));
}

TEST_CASE(
    "in forty snapshots of the twenty softest motions at 300 K a ball of 0.68 A to 0.78 A comes to the iron of chain "
    "A, "
    "as in the file one of 0.73 A; histidine 58 itself trembles by 0.9 A") {
  SAYS(linesSaying("a-protein-breathes", {"it let in a ball of 0.68 Å to 0.78 Å", "In the file it is 0.73 Å",
                                          "makes histidine 58 tremble by 0.9 Å"}));
  const Breathing& b = breathing();
  CHECK(gapAtTheIron(atRest()) == doctest::Approx(0.73).epsilon(0.01));
  CHECK(std::sqrt(kThermalEnergy_kcal_mol / b.spring_kcal_mol_A2 *
                  fluctuation(b.complianceOf("chain A and residue 58 and name CA"))) ==
        doctest::Approx(0.9).epsilon(0.05));
  const auto modes = lowestModes(b.network, 20);
  REQUIRE(modes);
  std::mt19937 random(1);
  std::normal_distribution<double> bell;
  double least_A = 1e9, most_A = 0.0;
  for (int snapshot = 0; snapshot < 40; ++snapshot) {
    std::vector<Vec3> moved_A(b.network.nodes().size(), Vec3(0.0));
    for (std::size_t k = 0; k < modes->count(); ++k) {
      const double by_A =
          bell(random) * std::sqrt(kThermalEnergy_kcal_mol / (b.spring_kcal_mol_A2 * modes->eigenvalues[k]));
      for (std::size_t n = 0; n < moved_A.size(); ++n) moved_A[n] += by_A * modes->mode(k)[n];
    }
    std::vector<Sphere> spheres = atRest();
    for (std::size_t i = 0; i < spheres.size(); ++i)
      if (const auto node = b.network.nodeOf(i); node != ElasticNetwork::kNoNode) spheres[i].centre_A += moved_A[node];
    const double gap_A = gapAtTheIron(spheres);
    least_A = std::min(least_A, gap_A), most_A = std::max(most_A, gap_A);
  }
  MESSAGE("the gap in forty snapshots: " << least_A << " A to " << most_A << " A");
  CHECK(least_A > 0.60);
  CHECK(most_A < 0.90);
}

TEST_CASE(
    "without the side chain of histidine 58 a ball of 1.45 A or more comes to the iron of chain A on any way: an "
    "oxygen "
    "atom to within what the grid resolves, and twice as large a one as with it") {
  SAYS(lineSaying("a-protein-breathes", "1.52 Å: an oxygen atom just passes"));
  const Breathing& b = breathing();
  std::vector<Sphere> spheres = atRest();
  for (const std::uint32_t i : b.scene.select("chain A and residue 58 and sidechain")) spheres[i].radius_A = -20.0;
  CHECK(gapAtTheIron(spheres) > 1.35);
  CHECK(gapAtTheIron(spheres) > 1.8 * gapAtTheIron(atRest()));
}
