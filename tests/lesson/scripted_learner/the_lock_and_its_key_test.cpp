// The shipped lesson on the forces that hold amprenavir in HIV protease: its energies by a sum of their own, the hole of
// the mutant as the hand feels it in the dark, the pull, and students without touch at its ranking.
#include <cmath>
#include <numeric>

#include "engine/core/random.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/methods.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/structure/interaction_input.h"
#include "tests/lesson/scripted_learner/unfeeling_students.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kLock = "the-lock-and-its-key";

// Lennard-Jones and Coulomb of all pairs in double, from docs/forces.md; no list, no grid.
double summed_kcal_mol(const PairField& field, const PoseA& pose) {
  double sum = 0.0;
  for (std::size_t j = 0; j < field.atoms.size(); ++j) {
    const PairAtom& b = field.atoms[j];
    if (!field.places->touchable(j)) continue;
    for (const PairAtom& a : field.held) {
      const double r = glm::distance(pose.place.A + pose.orientation * a.centre_A, b.centre_A);
      if (r >= 10.0) continue;
      const double u = (100.0 - r * r) / 36.0, off = r <= 8.0 ? 1.0 : u * u * (3.0 - 2.0 * u);
      const double minimum = double(a.half_minimum_A) + double(b.half_minimum_A), x = std::pow(minimum / r, 6);
      const double water = -8.5525 + 86.9525 / (1.0 + 7.7839 * std::exp(-0.003627 * 86.9525 * r));
      sum += off * (std::sqrt(double(a.depth_kcal_mol) * double(b.depth_kcal_mol)) * (x * x - 2.0 * x) +
                    332.0637 * double(a.charge_e) * double(b.charge_e) / (water * r));
    }
  }
  return sum;
}

struct HeldThere {
  HeldThere(const std::string& name, const std::string& in_hand, const std::string& removed = "") : whole(name) {
    const auto held = whole.select(in_hand);
    body = heldBody(whole.molecule->spheres, held);
    REQUIRE(body);
    std::vector<std::uint32_t> out = held;
    if (!removed.empty())
      for (const std::uint32_t i : whole.select(removed)) out.push_back(i);
    std::sort(out.begin(), out.end());
    spheres = std::make_shared<const SphereGrid>(whole.molecule->spheres, out);
    touch.forces = "all";
    touch.coupling_N_per_mm = 0.01;
    const SceneForces forces(touch, whole.molecule, spheres, body);
    const auto wells = wellsBeside(PoseGoal(body, PoseA{body->middle}), {2.0, std::numbers::pi}, forces, 6);
    REQUIRE_FALSE(wells.empty());
    well = wells.front();
    field = pairField(touch, *whole.molecule, *spheres, body.get());
    REQUIRE(field);
  }
  double told() const { return well.energy.total_kcal_mol(); }
  double summed() const { return summed_kcal_mol(*field, well.pose); }

  ShippedScene whole;
  std::shared_ptr<const HeldBody> body;
  std::shared_ptr<const SphereGrid> spheres;
  TouchSetup touch;
  Well well;
  std::shared_ptr<const PairField> field;
};

const Lesson& lockLesson() {
  static const Lesson lesson = shippedLesson(kLock);
  return lesson;
}

Found lockTask(const char* step, std::string_view kind) {
  const Step& s = lockLesson().steps[lockLesson().find(step).value()];
  for (std::size_t k = 0; k < s.tasks.size(); ++k)
    if (s.tasks[k].kind == kind) return {&lockLesson(), &s, k};
  FAIL(step);
  return {&lockLesson(), &s, 0};
}

}  // namespace

TEST_CASE(
    "the-lock-and-its-key.md, and the same in German: 6 steps of the core and one extra; the same dark task before and "
    "after, a dock, a pull and a ranking") {
  for (const char* file : {kLock, "the-lock-and-its-key.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 7);
    CHECK(tasksOf(lesson, "same") == 2);
    for (const char* kind : {"dock", "pull", "rank"}) CHECK(tasksOf(lesson, kind) == 1);
  }
}

TEST_CASE(
    "amprenavir's wells are -42.9 kcal/mol in the shut lock, -26.7 in the open one, -19.6 outside, and -41.5 in I84V: "
    "by "
    "the program, and by a sum over all pairs in double within 0.01; the open lock's is more than nine tenths van der "
    "Waals; exp of the difference over kT at 37 degrees is 10.5") {
  SAYS(linesSaying(kLock, {"−42.9, −26.7 and −19.6 kcal/mol", "costs 1.5 of 42.9 kcal/mol, 3 %", "= 10.5 at 37 °C",
                           "The wells are −42.92 kcal/mol in 1HPV and −41.47 kcal/mol"}));
  const HeldThere shut("1hpv-three-holds", "chain C", "chain F or chain G"),
      open("1hpv-three-holds", "chain F", "chain C or chain G"),
      outside("1hpv-three-holds", "chain G", "chain C or chain F"), mutant("1hpv-i84v", "ligand"),
      wild("1hpv", "ligand");
  for (const auto& [held, said] : {std::pair{&shut, -42.9}, std::pair{&open, -26.7}, std::pair{&outside, -19.6},
                                   std::pair{&mutant, -41.47}, std::pair{&wild, -42.92}}) {
    CAPTURE(said);
    MESSAGE(held->told(), " kcal/mol by the program, ", held->summed(), " by the sum of all pairs");
    CHECK(std::abs(held->told() - said) < 0.05);
    CHECK(std::abs(held->summed() - held->told()) < 0.01);
  }
  CHECK(open.well.energy.parts[EnergyPart::VanDerWaals] < 0.9 * open.told());
  const double lost = mutant.told() - wild.told();
  CHECK(std::abs(lost - 1.45) < 0.02);
  CHECK(std::exp(1.45 / (0.0019872 * 310.15)) == doctest::Approx(10.5).epsilon(0.01));
}

TEST_CASE(
    "1hpv-i84v is 1hpv without CD1 of both isoleucines 84, no atom moved, with valine's names of its carbons; "
    "1hpv-three-holds overlaps nowhere more than 1hpv does") {
  const ShippedScene wild("1hpv"), mutant("1hpv-i84v");
  CHECK(wild.molecule->atoms.size() == mutant.molecule->atoms.size() + 2);
  CHECK(mutant.select("residue 84 and resname VAL").size() == 14);
  for (const char* chain : {"chain A", "chain B"})
    for (const auto& [was, is] : {std::pair{"CG1", "CG2"}, std::pair{"CG2", "CG1"}, std::pair{"CB", "CB"}}) {
      const std::string at = std::string(chain) + " and residue 84 and name ";
      CHECK(wild.atom(at + was).position.A == mutant.atom(at + is).position.A);
    }
  // Valine's carbons go round CB as in another valine of the entry.
  const auto hand = [](const ShippedScene& s, const std::string& residue) {
    const auto at = [&](const char* name) { return s.atom(residue + " and name " + name).position.A; };
    return glm::dot(at("CA") - at("CB"), glm::cross(at("CG1") - at("CB"), at("CG2") - at("CB")));
  };
  const double usual = hand(wild, "chain A and residue 82");
  for (const char* residue : {"chain A and residue 84", "chain B and residue 84"})
    CHECK(usual * hand(mutant, residue) > 0);
}

TEST_CASE(
    "pressed within 1 A of the methyl group in the middle of the view, the probe comes to rest 0.8 A or more deeper "
    "without it; both count as the place; at the middle it rests on the methyl group, and on valine's atoms without "
    "it") {
  SAYS(lineSaying(kLock, "a ball falls away from under the hand, a hole holds it"));
  const TaskSpec& spec = lockTask("whole-or-hollow", "same").spec();
  const StepPicture picture(*lockTask("whole-or-hollow", "same").step);
  const Molecule& m = *picture.molecule;
  const AtomSet counted(spec.values["same"].selection, m);
  const auto drug = parseSelection("ligand")->select(m);
  const auto without = parseSelection("ligand or (residue 84 and name CD1)")->select(m);
  const std::shared_ptr<const SphereGrid> scenes[] = {std::make_shared<const SphereGrid>(m.spheres, drug),
                                                      std::make_shared<const SphereGrid>(m.spheres, without)};
  const Camera& c = picture.camera();
  const auto methyl = parseSelection("chain A and residue 84 and name CD1")->select(m);
  REQUIRE(methyl.size() == 1);
  const glm::dvec2 at = picture.seen(methyl);
  const double px_per_A =
      glm::length(glm::dvec2(c.project({m.spheres[methyl[0]].centre_A + c.orientation * Vec3(1, 0, 0)},
                                       StepPicture::kSize_px, StepPicture::kSize_px)) -
                  at);
  MESSAGE("the methyl group is ", glm::length(at - glm::dvec2(400, 400)) / px_per_A, " A off the middle of the view");
  CHECK(glm::length(at - glm::dvec2(400, 400)) / px_per_A < 1.0);
  const auto rests = [&](int k, glm::dvec2 px) {
    const auto exact = findMethod("exact")->make(scenes[k], 1.4);
    const Ray ray = c.rayThrough(px.x, px.y, StepPicture::kSize_px, StepPicture::kSize_px);
    Contact contact;
    for (double a = c.distance_A - 40; a < c.distance_A + 30; a += 0.01) {
      const Vec3 hand = ray.origin.A + ray.direction * a;
      contact = exact->step({hand});
      if (contact.touching() && glm::distance(contact.scp.A, hand) > 1.0) break;
    }
    return std::pair(contact, glm::dot(contact.scp.A - ray.origin.A, ray.direction));
  };
  for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0})
    for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      if (x * x + y * y > 1.0) continue;
      CAPTURE(x);
      CAPTURE(y);
      const auto [ball, ball_A] = rests(0, at + px_per_A * glm::dvec2(x, y));
      const auto [hole, hole_A] = rests(1, at + px_per_A * glm::dvec2(x, y));
      MESSAGE(x, " ", y, ": ", hole_A - ball_A, " A, on ", m.describe(std::uint32_t(ball.atoms[0])), " and ",
              m.describe(std::uint32_t(hole.atoms[0])));
      CHECK(hole_A - ball_A >= 0.8);
      CHECK(counted.touchedBy(ball));
      CHECK(counted.touchedBy(hole));
    }
}

TEST_CASE(
    "on the ways that the program finds out of the open lock the greatest force between the atoms is 0.7 to 1 nN, "
    "and "
    "in the first 4 A") {
  SAYS(linesSaying(kLock, {"the greatest force is 0.7 nN to 1 nN", "At the start, in the first 4 Å"}));
  const Found f = lockTask("what-does-it-cost-to-leave", "pull");
  for (int attempt = 0; attempt < 4; ++attempt) {
    CAPTURE(attempt);
    Alone student(f, 1);
    student.learner.follow(student.task().demonstrate(student.learner.view(attempt)));
    REQUIRE(student.done());
    const std::vector<double>& felt = student.task().curves()->felt;
    const auto most =
        std::max_element(felt.begin(), felt.end(), [](double a, double b) { return !(a >= b) && b == b; });
    const double at_A = student.task().curves()->x_max_A * double(most - felt.begin()) / double(felt.size() - 1);
    double most_pN = 0.0;
    for (const TaskFigure& one : student.task().figures())
      if (one.name == "greatest force between the atoms") most_pN = one.value;
    MESSAGE(most_pN, " pN at ", at_A, " A");
    CHECK(at_A <= 4.0);
    CHECK(most_pN >= 700.0);
    CHECK(most_pN <= 1000.0);
  }
}

TEST_CASE(
    "of 600 students who put the three holds in order without feeling them one in six has them right at first; a "
    "jabber "
    "who pulls for 0.3 s is never asked for the order") {
  const Found f = lockTask("three-holds-in-the-dark", "rank");
  int right = 0, backwards = 0;
  const HeldThere shut("1hpv-three-holds", "chain C", "chain F or chain G");
  const auto forces = std::make_shared<const SceneForces>(shut.touch, shut.whole.molecule, shut.spheres, shut.body);
  const auto task = makeTask(f.spec(), *shut.whole.molecule);
  task->takeForces(forces);
  std::mt19937 random(20261128);
  double time_s = 0.0;
  const auto feels = [&](double for_s) {
    TouchSample s;
    s.energy.emplace();
    s.contact_reset = true;
    REQUIRE(task->stage().body_begins);
    const Vec3 place = task->stage().body_begins->A;
    for (int n = 0; n < int(for_s * 50.0); ++n) {
      s.hip.A = place + Vec3(0, 0, n < 3 ? 0.1 : 1.5);
      s.body = PoseA{{s.hip.A}, kNoRotation};
      s.time_s = time_s += 0.02;
      task->feed(s);
      s.contact_reset = false;
    }
  };
  const auto offered = [&](std::string_view word) {
    for (const TaskButton& b : task->buttons())
      if (b.word == word) return true;
    return false;
  };
  task->reset();
  feels(0.3);
  CHECK_FALSE(offered("next"));
  for (int round = 0; round < 600; ++round) {
    for (const bool drawn : {true, false}) {
      task->reset();
      task->drawBy(mixedSeed(7, std::uint64_t(round)));
      std::vector<int> order{1, 2, 3};
      if (drawn)
        std::shuffle(order.begin(), order.end(), random);
      else
        std::reverse(order.begin(), order.end());
      for (int k = 0; k < 3; ++k) {
        feels(3.3);
        task->answer({.word = "next"});
      }
      for (int k = 0; k < 2; ++k) task->answer({.word = "ligand-" + std::to_string(order[std::size_t(k)])});
      (drawn ? right : backwards) += task->done();
    }
  }
  MESSAGE("drawn: ", right / 6.0, " % right at first, always backwards: ", backwards / 6.0, " %; chance 16.7 %");
  CHECK(std::abs(right / 600.0 - 1.0 / 6.0) < 0.06);
  CHECK(std::abs(backwards / 600.0 - 1.0 / 6.0) < 0.06);
}
