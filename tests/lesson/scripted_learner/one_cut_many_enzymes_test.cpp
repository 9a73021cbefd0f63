// The shipped lesson on serine proteases: the energies of its keys by a sum of their own, the pull of the charge, and the
// three pockets.
#include <cmath>

#include "engine/haptics/body/held_body.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/structure/interaction_input.h"
#include "tests/lesson/scripted_learner/unfeeling_students.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kCut = "one-cut-many-enzymes";

// Coulomb and Lennard-Jones of all pairs in double, from docs/forces.md; no list, no grid.
std::pair<double, double> ownSum_kcal_mol(const PairField& field, const PoseA& pose) {
  double repelled = 0.0, charged = 0.0;
  for (const PairAtom& b : field.atoms)
    for (const PairAtom& a : field.held) {
      const double r = glm::distance(pose.place.A + pose.orientation * a.centre_A, b.centre_A);
      if (r >= 10.0) continue;
      const double u = (100.0 - r * r) / 36.0, off = r <= 8.0 ? 1.0 : u * u * (3.0 - 2.0 * u);
      const double x = std::pow((double(a.half_minimum_A) + double(b.half_minimum_A)) / r, 6);
      const double water = -8.5525 + 86.9525 / (1.0 + 7.7839 * std::exp(-0.003627 * 86.9525 * r));
      repelled += off * std::sqrt(double(a.depth_kcal_mol) * double(b.depth_kcal_mol)) * (x * x - 2.0 * x);
      charged += off * 332.0637 * double(a.charge_e) * double(b.charge_e) / (water * r);
    }
  return {repelled, charged};
}

}  // namespace

TEST_CASE(
    "one-cut-many-enzymes.md, and the same in German: 5 steps of the core and one extra; the same dark task before and "
    "after, a dock and a ranking") {
  for (const char* file : {kCut, "one-cut-many-enzymes.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 6);
    CHECK(tasksOf(lesson, "same") == 2);
    for (const char* kind : {"dock", "rank"}) CHECK(tasksOf(lesson, kind) == 1);
  }
}

TEST_CASE(
    "the wells of the three keys in trypsin are -22.5, -15.5 and -5.6 kcal/mol by the program and by a sum over all "
    "pairs "
    "in double; in the placed pose of lysine's key the charges give -12.2, the rest -10.3") {
  SAYS(linesSaying(kCut, {"−22.5, −15.5 and −5.6 kcal/mol", "of which −12.2 come from charges in the placed pose",
                          "without them the key would have −10.3 kcal/mol here"}));
  const ShippedScene trypsin("1f0t");
  TouchSetup touch;
  touch.forces = "all";
  touch.coupling_N_per_mm = 0.01;
  const auto others = trypsin.select("ligand");
  const auto spheres = std::make_shared<const SphereGrid>(trypsin.molecule->spheres, others);
  for (const auto& [key, said] :
       {std::pair{"chain L", -22.54}, std::pair{"chain F", -15.50}, std::pair{"chain M", -5.58}}) {
    CAPTURE(key);
    const auto body = heldBody(trypsin.molecule->spheres, trypsin.select(key));
    REQUIRE(body);
    const SceneForces forces(touch, trypsin.molecule, spheres, body);
    const auto wells = wellsBeside(PoseGoal(body, PoseA{body->middle}), {2.0, std::numbers::pi}, forces, 6);
    REQUIRE_FALSE(wells.empty());
    const auto field = pairField(touch, *trypsin.molecule, *spheres, body.get());
    REQUIRE(field);
    const auto [rest, charged] = ownSum_kcal_mol(*field, wells.front().pose);
    const double told = wells.front().energy.total_kcal_mol();
    MESSAGE(key, ": ", told, " kcal/mol by the program, ", rest + charged, " by the sum of all pairs");
    CHECK(std::abs(told - said) < 0.05);
    CHECK(std::abs(rest + charged - told) < 0.01);
    if (std::string(key) != "chain L") continue;
    const auto [placed, by_charge] = ownSum_kcal_mol(*field, PoseA{body->middle});
    CHECK(std::abs(by_charge + 12.2) < 0.05);
    CHECK(std::abs(placed + 10.3) < 0.05);
  }
}

TEST_CASE(
    "a probe of charge +1 finds a well of -13.4 kcal/mol in trypsin's pocket with charges and of -3.8 without, and "
    "none "
    "below -6 in chymotrypsin's") {
  SAYS(lineSaying(kCut, "−13.4 kcal/mol with charges and −3.8 without"));
  const auto deepest = [](const char* name, const char* which) {
    const ShippedScene s(name);
    const auto keys = parseSelection("ligand")->select(*s.molecule);
    const auto spheres = std::make_shared<const SphereGrid>(s.molecule->spheres, keys);
    const Vec3 bottom = s.atom("residue 189 and name CB").position.A;
    TouchSetup touch;
    touch.forces = which;
    touch.probe_charge_e = 1.0;
    touch.coupling_N_per_mm = 0.004;
    const SceneForces forces(touch, s.molecule, spheres, nullptr);
    double low = 0.0;
    for (const Well& w : forces.wells(60, {}, [&](const Vec3& p) { return glm::distance(p, bottom) < 9.0; }))
      if (glm::distance(w.pose.place.A, bottom) < 8.0) low = std::min(low, w.energy.total_kcal_mol());
    return low;
  };
  const double with = deepest("1f0t", "all"), without = deepest("1f0t", "van-der-waals"), none = deepest("1cho", "all");
  MESSAGE(with, " with charges, ", without, " without, ", none, " in chymotrypsin");
  CHECK(std::abs(with + 13.4) < 0.1);
  CHECK(std::abs(without + 3.8) < 0.1);
  CHECK(none > -6.0);
}
