// The task rank on ligands of ions over a pair of ions, in a vacuum: it is done by who follows its demonstration, by
// chance as often as the number of orders says, and its words depend on the hand's way only. Oracle: Coulomb's energy in
// closed form.
#include <cmath>
#include <set>

#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "engine/lesson/tasks/held_way.h"
#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

// The site: Cl- at the origin and Na+ 4 A beside it. Three ligands overlap 3.6 A above it: a pair of Na+ and Cl- (chain B),
// Mg2+ (C) and Na+ (D). Chain E is another Na+ where D is, F a neutral atom.
Expected<std::shared_ptr<const Molecule>> siteOfIons(const NamedMolecule& named) {
  MoleculeByHand b;
  b.made.id = named.name;
  int number = 0;
  const auto ion = [&](const char* chain, const char* name, int element, const Vec3& at) {
    b.residue(chain, name, ++number, ResidueKind::Ion).atom(name, element, at);
  };
  ion("A", "CL", 17, {0, 0, 0});
  ion("A", "NA", 11, {4, 0, 0});
  ion("B", "NA", 11, {0, 0, 3.6});
  ion("B", "CL", 17, {4, 0, 3.6});
  ion("C", "MG", 12, {0, 0.1, 3.6});
  ion("D", "NA", 11, {0, 0.2, 3.6});
  ion("E", "NA", 11, {0, 0.3, 3.6});
  b.residue("F", "AR", ++number, ResidueKind::Ligand).atom("AR", 18, {0, 0.4, 3.6});
  return std::make_shared<const Molecule>(b.molecule());
}

const std::string kRankScene =
    "in-hand: chain D\nremove: chain B or chain C or chain E or chain F\nforces: electrostatic\ndielectric: "
    "vacuum\ncoupling: 150 N/m\n";

std::string rankLesson(const std::string& ligands, const std::string& more = "",
                       const std::string& scene = kRankScene) {
  return "---\ntitle: T\nminutes: 3\ngoals: G\nmolecules: ions\nauthor: A\nlicence: L\n---\n## A step\n```scene\n"
         "molecule: ions\n" +
         scene + "```\n```touch\nrank: " + ligands + "\nfirst: the firmest\nfor: 1 s\n" + more + "say: Do it.\n```\n";
}
constexpr const char* kThree = "chain B then chain C then chain D";

std::vector<std::string> errorsOfRank(const std::string& lesson) {
  std::vector<std::string> out;
  for (const Problem& p : checkLesson("l.md", lesson, siteOfIons).errors) out.push_back(p.text());
  return out;
}

std::shared_ptr<const Lesson> readRank(const std::string& text) {
  LessonReading reading = readLessonText("l.md", text);
  for (const Problem& p : reading.errors) MESSAGE(p.text());
  REQUIRE(reading.lesson);
  return std::make_shared<const Lesson>(*std::move(reading.lesson));
}

// A task alone, and a hand that feeds it synthetic samples.
struct Alone {
  std::shared_ptr<const Lesson> lesson;
  std::shared_ptr<const Molecule> molecule = *siteOfIons({"ions"});
  std::unique_ptr<Task> task;
  double time_s = 0.0;

  explicit Alone(std::uint64_t seed, const std::string& more = "") : lesson(readRank(rankLesson(kThree, more))) {
    static const auto forces =
        sceneForces(lesson->steps[0].scene, molecule, std::vector<std::uint32_t>{2, 3, 4, 5, 6, 7}, nullptr);
    task = makeTask(lesson->steps[0].tasks[0], *molecule);
    task->takeForces(forces);
    task->drawBy(seed);
  }
  // The hand stays there; the body and its energy are whatever the test says.
  void stay(const Vec3& hand, double seconds, bool placed = false, const Vec3& body_off = Vec3(0.0),
            double energy_kcal_mol = -10.0, bool hovering = false) {
    TouchSample s;
    s.hip.A = hand;
    s.body = PoseA{{hand + body_off}, kNoRotation};
    s.energy.emplace();
    s.energy->parts[EnergyPart::Electrostatic] = energy_kcal_mol;
    s.hovering = hovering;
    s.contact_reset = placed;
    for (int n = int(seconds * 1000.0); n > 0; --n) {
      s.time_s = time_s += 0.001;
      task->feed(s);
      s.contact_reset = false;
    }
  }
  Vec3 place() const { return task->stage().body_begins->A; }
  bool offers(std::string_view word) const {
    for (const TaskButton& b : task->buttons())
      if (b.word == word) return true;
    return false;
  }
};

}  // namespace

TEST_CASE(
    "rank is done by its demonstration in whatever order the author wrote the ligands: Mg2+ before a pair of ions, at "
    "-94.6 kcal/mol, before Na+") {
  for (const char* ligands : {kThree, "chain D then chain B then chain C", "chain C then chain D then chain B"}) {
    CAPTURE(ligands);
    CHECK(errorsOfRank(rankLesson(ligands)) == std::vector<std::string>());
    LearnerEvent last;
    ScriptedLearner learner(readRank(rankLesson(ligands)), siteOfIons, [&](const LearnerEvent& e) {
      if (e.kind == LearnerEvent::Kind::Task || e.kind == LearnerEvent::Kind::GaveUp) last = e;
    });
    REQUIRE(learner.enterStep());
    const bool done = learner.doTask();
    CAPTURE(last.note);
    CHECK(done);
    double right = 0.0;
    for (const TaskFigure& f : last.figures)
      if (f.name == "ligands in order at first") right = f.value;
    CHECK(right == 3.0);
  }
  // The well of the pair is the contact of both ions at once.
  const auto molecule = *siteOfIons({"ions"});
  const auto lesson = readRank(rankLesson(kThree));
  const std::uint32_t pair[] = {2, 3}, magnesium[] = {4}, sodium[] = {5};
  const auto all = sceneForces(lesson->steps[0].scene, molecule, std::vector<std::uint32_t>{2, 3, 4, 5, 6, 7}, nullptr);
  const auto deepest = [&](std::span<const std::uint32_t> atoms) {
    const auto body = heldBody(molecule->spheres, atoms);
    return wellsBeside(PoseGoal(body, PoseA{body->middle}), {2.0, 3.2}, *all->holding(body), 6)
        .front()
        .energy.total_kcal_mol();
  };
  constexpr double kCoulombUnit = 332.0637, kTouch_A = 2.9;
  const double of_pair = deepest(pair);
  CHECK(of_pair ==
        doctest::Approx(2.0 * kCoulombUnit * (1.0 / std::hypot(kTouch_A, 4.0) - 1.0 / kTouch_A)).epsilon(0.01));
  CHECK(deepest(magnesium) < of_pair - 2.0);
  CHECK(deepest(sodium) > of_pair + 2.0);
}

TEST_CASE(
    "the hand holds each ligand in turn, in an order of its own for each student, in the dark and without names; "
    "afterwards it holds what the scene says") {
  std::set<std::vector<std::vector<std::uint32_t>>> orders;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Alone a(seed);
    std::vector<std::vector<std::uint32_t>> held;
    for (int k = 0; k < 3; ++k) {
      const TaskStage stage = a.task->stage();
      CHECK(stage.dark);
      CHECK(stage.unnamed);
      held.push_back(stage.in_hand);
      a.stay(a.place(), 0.01, true);
      a.stay(a.place() + Vec3(0, 0, 2), 1.1);
      REQUIRE(a.offers("next"));
      a.task->answer({.word = "next"});
    }
    std::set<std::vector<std::uint32_t>> each(held.begin(), held.end());
    CHECK(each == std::set<std::vector<std::uint32_t>>{{2, 3}, {4}, {5}});
    orders.insert(held);
    // The right order: Mg2+, the pair, Na+.
    for (const std::vector<std::uint32_t>& right : {std::vector<std::uint32_t>{4}, {2, 3}}) {
      const auto at = std::find(held.begin(), held.end(), right) - held.begin();
      a.task->answer({.word = "ligand-" + std::to_string(at + 1)});
    }
    CHECK(a.task->solved());
    CHECK(a.task->stage() == TaskStage());
  }
  CHECK(orders.size() == 6);
}

TEST_CASE("of 600 guessers who felt all three, a sixth have the order right") {
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Alone a(seed, "attempts: 1\n");
    for (int k = 0; k < 3; ++k) {
      a.stay(a.place(), 0.01, true);
      a.stay(a.place() + Vec3(1, 0, 0), 1.1);
      a.task->answer({.word = "next"});
    }
    a.task->answer({.word = "ligand-1"});
    a.task->answer({.word = "ligand-2"});
    REQUIRE(a.task->done());
    solved += a.task->solved();
  }
  MESSAGE("in order by chance: " << solved << " of 600");
  CHECK(solved > 100 - 40);
  CHECK(solved < 100 + 40);
}

TEST_CASE(
    "a ligand counts as felt by a hand that took it in its place, has pulled by 0.5 A and is within 4 A; not by "
    "one that rests there, hovers, is put down outside, or still holds the ligand before") {
  Alone a(1);
  CHECK_FALSE(a.offers("next"));
  a.stay(a.place() + Vec3(0, 0, 2), 3.0);  // ticks of the scene before
  CHECK_FALSE(a.offers("next"));
  a.stay(a.place() + Vec3(0, 0, 2), 3.0, true);  // put down outside
  CHECK_FALSE(a.offers("next"));
  a.stay(a.place(), 3.0, true);  // it rests
  CHECK_FALSE(a.offers("next"));
  a.stay(a.place() + Vec3(0, 0, 2), 3.0, false, Vec3(0.0), -10.0, true);  // it hovers
  CHECK_FALSE(a.offers("next"));
  a.stay(a.place() + Vec3(0, 0, 2), 3.0);  // it has let go before
  CHECK_FALSE(a.offers("next"));
  CHECK(a.offers("anew"));
  const int before = a.task->stage().presentation;
  a.task->answer({.word = "anew"});
  CHECK(a.task->stage().presentation == before + 1);
  a.stay(a.place(), 0.01, true);
  a.stay(a.place() + Vec3(0, 0, 5), 3.0);  // too far
  CHECK_FALSE(a.offers("next"));
  a.stay(a.place() + Vec3(0, 0, 3), 0.6);
  CHECK_FALSE(a.offers("next"));
  a.stay(a.place() + Vec3(0, -3, 0), 0.6);
  CHECK(a.offers("next"));
  // Jabs of 0.2 s from outside never take it.
  Alone jabber(2);
  for (int k = 0; k < 40; ++k) {
    jabber.stay(jabber.place() + Vec3(0, 0, 6), 0.2, true);
    jabber.stay(jabber.place() + Vec3(0, 0, 1.0 + 0.05 * k), 0.2);
  }
  CHECK_FALSE(jabber.offers("next"));
}

TEST_CASE("the words are the same whether the ligand follows the hand or stays, and whatever its energy") {
  std::set<std::string> said;
  for (const double energy : {-200.0, -5.0, 3.0})
    for (const double follows : {0.0, 0.5, 1.0}) {
      Alone a(3);
      std::string words;
      a.stay(a.place(), 0.05, true, Vec3(0.0), energy);
      words += a.task->sentence();
      for (const double off_A : {0.3, 1.0, 2.5, 4.5, 2.0}) {
        a.stay(a.place() + Vec3(0, 0, off_A), 0.2, false, Vec3(0, 0, (follows - 1.0) * off_A), energy);
        words += a.task->sentence();
      }
      said.insert(words);
    }
  CHECK(said.size() == 1);
}

TEST_CASE(
    "check: a ligand that is part of the scene, one that is not bound, two alike, shared atoms, a scene without a "
    "body, forces or coupling are errors at their lines") {
  const auto first = [&](const std::string& ligands, const std::string& scene = kRankScene) {
    const std::vector<std::string> errors = errorsOfRank(rankLesson(ligands, "", scene));
    return errors.empty() ? std::string() : errors[0];
  };
  const auto says = [&](const std::string& error, const char* part) {
    CAPTURE(error);
    CHECK(error.find(part) != std::string::npos);
    CHECK(error.starts_with("l.md:"));
  };
  says(first("chain A then chain B"), "this ligand would be in the way of the others");
  says(first("chain B then chain F"), "this ligand is not bound in its place");
  says(first("chain D then chain E"), "two ligands are bound nearly alike");
  says(first("chain B then chain B and name NA"), "two of the ligands share atoms");
  says(first("chain B"), "at least two ligands are needed");
  says(first(kThree, "remove: chain B or chain C or chain D\nforces: all\ncoupling: 30 N/m\n"),
       "'rank' needs a body in the hand");
  says(first(kThree, "in-hand: chain D\nremove: chain B or chain C\ncoupling: 30 N/m\n"), "nothing holds the ligands");
  says(first(kThree, "in-hand: chain D\nremove: chain B or chain C\nforces: electrostatic\n"),
       "each ligand would hang on a spring of another stiffness");
  says(first("chain B then chain X"), "chain 'X' is not in ions");
}
