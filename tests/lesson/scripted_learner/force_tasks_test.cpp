// Touch tasks in scenes with forces between atoms, on small molecules of ions: they are done by who follows their
// demonstration, and not by who does not feel. Oracles: Coulomb's energy and force of four charges, in closed form.
#include <cmath>
#include <set>

#include "engine/core/even_directions.h"
#include "engine/core/random.h"
#include "engine/lesson/check.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "tests/lesson/scripted_learner/step_picture.h"
#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

constexpr double kCoulomb = 332.0637;  // kcal/mol A / e^2
constexpr double kForce_pN = 69.477;   // of 1 kcal/mol/A
constexpr double kContact_A = 2.9;     // spheres of 1.7 A, of which the body's are felt 0.5 A smaller

// "salt": Cl- at the origin and Na+ 4 A beside it; the hand can hold Na+ above the first and Cl- above the second, 3.6 A
// off. "ball": a ball of neutral atoms on whose surface one is Cl-. "row": three places 20 A apart: Na+, Cl-, and two Cl-
// side by side.
Expected<std::shared_ptr<const Molecule>> molecules(const NamedMolecule& named) {
  MoleculeByHand b;
  b.made.id = named.name;
  int number = 0;
  const auto ion = [&](const char* chain, const char* name, int element, const Vec3& at) {
    b.residue(chain, name, ++number, ResidueKind::Ion).atom(name, element, at);
  };
  if (named.name == "salt") {
    ion("A", "CL", 17, {0, 0, 0});
    ion("A", "NA", 11, {4, 0, 0});
    ion("B", "NA", 11, {0, 0, 3.6});
    ion("B", "CL", 17, {4, 0, 3.6});
  } else if (named.name == "ball") {
    b.residue("A", "BAL", ++number, ResidueKind::Ligand);
    for (int k = 1; k < 60; ++k) b.atom("AR", 18, 8.0 * evenDirection(k, 60));
    ion("A", "CL", 17, 8.0 * evenDirection(0, 60));
  } else if (named.name == "row") {
    ion("A", "MG", 12, {0, 0, 0});
    ion("B", "CL", 17, {20, 0, 0});
    ion("C", "CL", 17, {40, 0, 0});
    ion("C", "CL", 17, {43, 0, 0});
  } else {
    return Problem{{}, 0, 0, "there is no such molecule", {}};
  }
  return std::make_shared<const Molecule>(b.molecule());
}

std::string text(const std::string& molecule, const std::string& scene, const std::string& touch) {
  return "---\ntitle: T\nminutes: 3\ngoals: G\nmolecules: " + molecule +
         "\nauthor: A\nlicence: L\n---\n## A step\n```scene\nmolecule: " + molecule + "\n" + scene + "```\n```touch\n" +
         touch + "\nsay: Do it.\n```\n";
}

// Charges in a vacuum, and a spring so stiff that no field turns the body or makes it snap.
const std::string kHeld = "in-hand: chain B\nforces: electrostatic\ndielectric: vacuum\ncoupling: 150 N/m\n";
const std::string kPulled = "in-hand: chain B\nforces: electrostatic\ndielectric: distance\ncoupling: 100 N/m\n";
const std::string kProbe = "forces: electrostatic\nprobe-charge: 1\ndielectric: vacuum\n";

std::vector<std::string> errorsOf(const std::string& lesson) {
  std::vector<std::string> out;
  for (const Problem& p : checkLesson("l.md", lesson, molecules).errors) out.push_back(p.text());
  return out;
}

// One student at one task.
struct Student {
  explicit Student(const std::string& lesson_text, std::uint64_t seed = 0)
      : learner(read(lesson_text), molecules, [this](const LearnerEvent& e) {
          if (e.kind == LearnerEvent::Kind::Task || e.kind == LearnerEvent::Kind::GaveUp) last = e;
        }) {
    random = seed;
    REQUIRE(learner.enterStep());
  }
  static std::shared_ptr<const Lesson> read(const std::string& lesson_text) {
    LessonReading reading = readLessonText("l.md", lesson_text);
    for (const Problem& p : reading.errors) MESSAGE(p.text());
    REQUIRE(reading.lesson);
    return std::make_shared<const Lesson>(*std::move(reading.lesson));
  }
  bool done() const { return learner.session().finished(); }
  const Task& task() const { return *learner.session().taskAt(0); }
  double figureOf(std::string_view name) const {
    for (const TaskFigure& f : last.figures)
      if (f.name == name) return f.value;
    return std::nan("");
  }

  LearnerEvent last;
  ScriptedLearner learner;
  std::uint64_t random = 0;
};

// The energy of the held pair above the other, at this height: two contacts, two diagonals.
double energy_kcal_mol(double z) { return 2.0 * kCoulomb * (1.0 / std::hypot(z, 4.0) - 1.0 / z); }
// The force at this height, in a medium of four times the distance: the energy of two charges is as 1 / (4 r^2).
double force_pN(double z) { return kCoulomb * kForce_pN * (1.0 / (z * z * z) - z / ((z * z + 16.0) * (z * z + 16.0))); }

const Quat kTurnedOver(0.0, 0.0, 1.0, 0.0);  // half a turn about y: Na+ above Na+

}  // namespace

TEST_CASE(
    "dock with an energy is done by its demonstration, with a pose and anywhere, and the attempt holds the energy: "
    "that "
    "of four charges in contact, -94.6 kcal/mol") {
  for (const char* keys : {"dock: file\nwithin: 2 Å\nenergy: -85", "dock: anywhere\nenergy: -85"}) {
    CAPTURE(keys);
    CHECK(errorsOf(text("salt", kHeld, keys)) == std::vector<std::string>());
    Student student(text("salt", kHeld, keys));
    const bool done = student.learner.doTask();
    CAPTURE(student.last.note);
    CHECK(done);
    CHECK(student.figureOf("lowest energy") == doctest::Approx(energy_kcal_mol(kContact_A)).epsilon(0.01));
    CHECK(student.figureOf("energy") <= -85.0);
  }
}

TEST_CASE(
    "a body that is put down in the well, led straight to it turned over, or brought there and drawn out after 0.3 s "
    "has "
    "not docked, with a pose and anywhere") {
  for (const char* keys : {"dock: file\nwithin: 2 Å\nenergy: -85", "dock: anywhere\nenergy: -85"}) {
    CAPTURE(keys);
    const std::string lesson = text("salt", kHeld, keys);
    const PointA place{{2, 0, 3.2}}, above{{2, 0, 25}};
    Student looker(lesson), guesser(lesson), jabber(lesson), honest(lesson);
    looker.learner.follow({{.to = above, .turned_to = kNoRotation, .placed = true, .wait_s = 0.1},
                           {.to = place, .placed = true, .wait_s = 4.0}});
    CHECK_FALSE(looker.done());
    guesser.learner.follow({{.to = above, .turned_to = kTurnedOver, .placed = true, .wait_s = 0.1},
                            {.to = place, .speed_A_per_s = 20.0, .wait_s = 4.0}});
    CHECK_FALSE(guesser.done());
    HandPlan jabs{{.to = above, .turned_to = kNoRotation, .placed = true, .wait_s = 0.1}};
    for (int k = 0; k < 10; ++k) {
      jabs.push_back({.to = place, .speed_A_per_s = 60.0, .wait_s = 0.3});
      jabs.push_back({.to = above, .speed_A_per_s = 60.0, .wait_s = 0.5});
    }
    jabber.learner.follow(jabs);
    CHECK_FALSE(jabber.done());
    honest.learner.follow({{.to = above, .turned_to = kNoRotation, .placed = true, .wait_s = 0.1},
                           {.to = place, .speed_A_per_s = 20.0, .wait_s = 4.0}});
    CHECK(honest.done());
  }
}

TEST_CASE("a body in its pose, but 5 A above the charges, is not deep enough, and the task says so without a number") {
  Student student(text("salt", kHeld, "dock: 2, 0, 5\nwithin: 2 Å\nenergy: -85"));
  student.learner.follow({{.to = PointA{{2, 0, 25}}, .turned_to = kNoRotation, .placed = true, .wait_s = 0.1},
                          {.to = PointA{{2, 0, 5}}, .speed_A_per_s = 20.0, .wait_s = 4.0}});
  CHECK_FALSE(student.done());
  const std::string said = student.task().sentence();
  CAPTURE(said);
  CHECK(said.starts_with("It is in its place, but not deep enough in the well."));
  CHECK(std::none_of(said.begin(), said.end(), [](char c) { return c >= '0' && c <= '9'; }));
}

TEST_CASE(
    "check: an energy without forces, without a body and lower than any fall reaches, and 'anywhere' without an energy "
    "or "
    "with a key of a pose, are errors at their lines") {
  const auto first = [&](const std::string& scene, const std::string& keys) {
    const std::vector<std::string> errors = errorsOf(text("salt", scene, keys));
    return errors.empty() ? std::string() : errors[0];
  };
  const std::string bare = first("in-hand: chain B\n", "dock: file\nenergy: -85");
  CAPTURE(bare);
  CHECK(bare.find("no forces between atoms act in this scene") != std::string::npos);
  CHECK(bare.starts_with("l.md:16:9:"));
  CHECK(first("forces: all\n", "dock: file\nenergy: -85").find("'dock' needs a body in the hand") != std::string::npos);
  for (const char* keys : {"dock: file\nwithin: 2 Å\nenergy: -96", "dock: anywhere\nenergy: -96"}) {
    const std::string deep = first(kHeld, keys);
    CAPTURE(deep);
    // The deepest of all is the contact of both pairs at once.
    CHECK(deep.find("searches is -94.6") != std::string::npos);
    CHECK(deep.find("write 'energy: -94' or a higher number") != std::string::npos);
  }
  CHECK(first(kHeld, "dock: anywhere").find("without a pose the energy must say") != std::string::npos);
  CHECK(first(kHeld, "dock: anywhere\nenergy: -85\nwithin: 2 Å").find("'within' belongs to a pose") !=
        std::string::npos);
}

TEST_CASE(
    "a pair of ions pulled straight off another shows the force of four charges in contact, 0.83 nN, as the greatest, "
    "and "
    "a curve that falls with the distance as their force does") {
  const std::string lesson = text("salt", kPulled, "pull: 6 Å\nfrom: 2, 0, 2.91");
  CHECK(errorsOf(lesson) == std::vector<std::string>());
  Student student(lesson);
  REQUIRE(student.task().stage().body_begins);
  CHECK(glm::distance(student.task().stage().body_begins->A, Vec3(2, 0, 2.91)) < 1e-9);
  // Pressed in first, by 1 A and three times that force.
  student.learner.follow({{.to = PointA{{2, 0, 2.91}}, .turned_to = kNoRotation, .placed = true, .wait_s = 0.5},
                          {.to = PointA{{2, 0, 2.7}}, .wait_s = 0.5},
                          {.to = PointA{{2, 0, 30}}, .speed_A_per_s = 2.0}});
  REQUIRE(student.done());
  const double pN = student.figureOf("greatest force between the atoms");
  CHECK(pN == doctest::Approx(force_pN(kContact_A)).epsilon(0.03));
  const TaskCurves& curve = *student.task().curves();
  CHECK(curve.complete);
  CHECK_FALSE(curve.drawing);
  // 1 N in the hand is the same force between the atoms at every distance.
  const double N_per_pN = student.figureOf("greatest force of the pull") / pN;
  std::size_t compared = 0;
  for (std::size_t k = 1; k < curve.felt.size(); ++k) {
    const double from_A = 2.91 + (double(k) - 0.5) / double(curve.felt.size() - 1) * 6.0;  // the greatest of the piece
    if (from_A > 6.5) continue;  // the energy of the diagonals ends between 8 and 10 A
    REQUIRE(std::isfinite(curve.felt[k]));
    CHECK(curve.felt[k] == doctest::Approx(N_per_pN * force_pN(from_A)).epsilon(0.05));
    ++compared;
  }
  CHECK(compared >= 12);
  CHECK(student.last.note.find("The greatest force on the way was") != std::string::npos);
  // The attempt gets the curve, as a felt one.
  std::size_t kept = 0;
  for (const SessionEvent& e : student.learner.session().events())
    if (const auto* known = std::get_if<CurveKnown>(&e)) {
      CHECK(known->felt);
      CHECK(known->x_name == "distance");
      CHECK(known->x_max_A == 6.0);
      CHECK(known->force_N.size() == curve.felt.size());
      ++kept;
    }
  CHECK(kept == 1);
  Student demonstrated(lesson);
  CHECK(demonstrated.learner.doTask());
}

TEST_CASE(
    "a pull with 'draw' waits for the drawn curve, keeps it beside the felt one, and states how far they agree: the "
    "felt "
    "curve drawn agrees by more than 95 %, none at all by 0") {
  const std::string lesson = text("salt", kPulled, "pull: 6 Å\nfrom: 2, 0, 2.91\ndraw: yes");
  CHECK(errorsOf(lesson) == std::vector<std::string>());
  CHECK(errorsOf(text("salt", kPulled, "pull: 6 Å\nfrom: 2, 0, 2.91\nmost: 2 N")).size() == 1);
  const HandPlan out{{.to = PointA{{2, 0, 2.91}}, .turned_to = kNoRotation, .placed = true, .wait_s = 0.5},
                     {.to = PointA{{2, 0, 30}}, .speed_A_per_s = 2.0}};
  Student student(lesson);
  CHECK(student.task().curves()->drawing);
  student.learner.follow(out);
  CHECK_FALSE(student.done());
  CHECK(student.task().sentence().starts_with("First draw the force that you expect"));
  const std::size_t n = student.task().curves()->drawn.size();
  student.learner.tell({.curve = std::vector<double>(n, 0.0)});
  CHECK_FALSE(student.task().curves()->drawing);
  student.learner.follow(out);
  REQUIRE(student.done());
  CHECK(*student.task().curves()->agreement == 0.0);
  CHECK(student.task().curves()->max_N == 3.3);
  std::vector<double> felt = student.task().curves()->felt;
  for (double& f : felt)
    if (!std::isfinite(f)) f = 0.0;
  std::vector<bool> kept;
  for (const SessionEvent& e : student.learner.session().events())
    if (const auto* known = std::get_if<CurveKnown>(&e)) kept.push_back(known->felt);
  CHECK(kept == std::vector<bool>{false, true});
  Student sure(lesson);
  sure.learner.tell({.curve = felt});
  sure.learner.follow(out);
  REQUIRE(sure.done());
  CHECK(*sure.task().curves()->agreement > 0.95);
  CHECK(sure.figureOf("agreement") > 95.0);
  Student demonstrated(lesson);
  CHECK(demonstrated.learner.doTask());
}

TEST_CASE("a body that is let back in and pulled out anew gives the curve of the last way out") {
  Student once(text("salt", kPulled, "pull: 6 Å\nfrom: 2, 0, 2.91")),
      twice(text("salt", kPulled, "pull: 6 Å\nfrom: 2, 0, 2.91"));
  HandPlan out{{.to = PointA{{2, 0, 2.91}}, .turned_to = kNoRotation, .placed = true, .wait_s = 0.5},
               {.to = PointA{{2, 0, 30}}, .speed_A_per_s = 2.0}};
  once.learner.follow(out);
  out.insert(out.begin() + 1, {{.to = PointA{{2, 0, 8}}, .speed_A_per_s = 9.0}, {.to = PointA{{2, 0, 2.91}}}});
  twice.learner.follow(out);
  REQUIRE(once.done());
  REQUIRE(twice.done());
  for (std::size_t k = 1; k < once.task().curves()->felt.size(); ++k)
    CHECK(twice.task().curves()->felt[k] == doctest::Approx(once.task().curves()->felt[k]).epsilon(0.02));
}

TEST_CASE(
    "who is put down outside, jumps out, pulls 5 A of 6, or turns the body in its place has not pulled it out; the "
    "jump "
    "begins another pull in the place") {
  const std::string lesson = text("salt", kHeld, "pull: 6 Å");
  const PointA in{{2, 0, 3.6}}, out{{2, 0, 20}};
  Student looker(lesson), jumper(lesson), short_of(lesson), turner(lesson);
  looker.learner.follow({{.to = out, .turned_to = kNoRotation, .placed = true, .wait_s = 2.0}});
  CHECK_FALSE(looker.done());
  const int before = jumper.task().stage().presentation;
  jumper.learner.follow({{.to = in, .turned_to = kNoRotation, .placed = true, .wait_s = 0.3},
                         {.to = out, .placed = true, .wait_s = 2.0}});
  CHECK_FALSE(jumper.done());
  CHECK(jumper.task().stage().presentation > before);
  short_of.learner.follow({{.to = in, .turned_to = kNoRotation, .placed = true, .wait_s = 0.3},
                           {.to = PointA{{2, 0, 8.4}}, .wait_s = 2.0}});
  CHECK_FALSE(short_of.done());
  turner.learner.follow({{.to = in, .turned_to = kNoRotation, .placed = true, .wait_s = 0.3},
                         {.turned_to = Quat(0.5, 0.0, 0.0, std::sqrt(0.75)), .wait_s = 2.0}});
  CHECK_FALSE(turner.done());
  CHECK(errorsOf(text("salt", "in-hand: chain B\n", "pull: 6 Å")).size() == 1);
  CHECK(errorsOf(text("salt", "forces: all\n", "pull: 6 Å")).size() == 1);
  CHECK(errorsOf(text("salt", kHeld, "pull: 2 Å")).size() == 1);
}

TEST_CASE(
    "find: lowest-energy is done by its demonstration, by button and by rest; the place is beside the one charge of "
    "the "
    "ball, and a neutral probe has none") {
  for (const char* by : {"", "\nby: hold"}) {
    const std::string lesson = text("ball", kProbe, std::string("find: lowest-energy") + by);
    CHECK(errorsOf(lesson) == std::vector<std::string>());
    Student student(lesson);
    const bool done = student.learner.doTask();
    CAPTURE(student.last.note);
    CHECK(done);
    CHECK(student.figureOf("guesses") == 1.0);
  }
  const std::vector<std::string> neutral = errorsOf(text("ball", "forces: electrostatic\n", "find: lowest-energy"));
  REQUIRE(neutral.size() == 1);
  CHECK(neutral[0].find("nothing attracts the probe") != std::string::npos);
  CHECK(errorsOf(text("ball", "", "find: lowest-energy")).size() == 1);
  // A named atom is found in such a scene as in another.
  Student atom(text("ball", kProbe, "find: name CL"));
  CHECK(atom.learner.doTask());
}

TEST_CASE(
    "of 200 students who press at three random places of the ball and say it is there, as many find the charge as "
    "there "
    "is room for, under 15 %") {
  const std::string lesson = text("ball", kProbe, "find: lowest-energy");
  int found = 0;
  constexpr int kStudents = 200;
  std::uint64_t random = 20261126;
  const Lesson read = *Student::read(lesson);
  const auto molecule = *molecules({"ball"});
  const auto forces = sceneForces(read.steps[0].scene, molecule, {}, nullptr);
  REQUIRE(forces);
  for (int k = 0; k < kStudents; ++k) {
    const auto t = makeTask(read.steps[0].tasks[0], *molecule);
    t->takeForces(forces);
    t->drawBy(random);
    double time_s = 0.0;
    for (int guess = 0; guess < 3 && !t->done(); ++guess) {
      const Vec3 way = evenDirection(int(nextRandom(random) % 5000), 5000);
      TouchSample s;
      s.contact.scp.A = way * 11.2;
      s.contact.feature = Feature::Sphere;
      s.contact.atoms = {int(nextRandom(random) % 60), -1, -1};
      s.energy.emplace().parts[EnergyPart::Electrostatic] = -5.0;
      for (int n = 0; n < 300; ++n) {
        s.time_s = time_s += 0.001;
        t->feed(s);
      }
      t->answer({.word = "here"});
    }
    found += t->done();
  }
  MESSAGE("found by chance: " << found << " of " << kStudents);
  CHECK(found < 0.15 * kStudents);
}

TEST_CASE(
    "a hand of a mouse that hovers in the field neither feels a place nor changes the one it felt; one that presses "
    "does") {
  const Lesson read = *Student::read(text("ball", kProbe, "find: lowest-energy"));
  const auto molecule = *molecules({"ball"});
  const auto t = makeTask(read.steps[0].tasks[0], *molecule);
  t->takeForces(sceneForces(read.steps[0].scene, molecule, {}, nullptr));
  TouchSample s;
  s.energy = MolecularEnergy{.parts = {{{0.0, -5.0}}}};
  const auto stay = [&](const Vec3& at, bool hovering) {
    s.contact.scp.A = at;
    s.hovering = hovering;
    for (int n = 0; n < 300; ++n) {
      s.time_s += 0.001;
      t->feed(s);
    }
  };
  const Vec3 charge = evenDirection(0, 60);
  stay(11.1 * charge, true);
  CHECK(t->buttons().size() == 1);  // only the look
  stay(11.1 * charge, false);
  CHECK(t->buttons().size() == 2);
  stay(-11.1 * charge, true);
  t->answer({.word = "here"});
  CHECK(t->solved());
}

TEST_CASE(
    "order by energy: the program puts two chlorides before one, and one before a magnesium that repels the probe, "
    "whatever order the author wrote; two equal places are an error") {
  for (const char* order : {"chain A then chain B then chain C", "chain C then chain B then chain A"}) {
    const std::string lesson =
        text("row", kProbe, std::string("order: ") + order + "\nby: energy\nfirst: the strongest\nfor: 0.2 s");
    CHECK(errorsOf(lesson) == std::vector<std::string>());
    Student student(lesson);
    const bool done = student.learner.doTask();
    CAPTURE(student.last.note);
    CHECK(done);
    CHECK(student.figureOf("places in order at first") == 3.0);
  }
  // The order is that of the wells: who answers in the order of the chains is wrong for most draws.
  const Lesson read = *Student::read(
      text("row", kProbe,
           "order: chain A then chain B then chain C\nby: energy\nfirst: the strongest\nfor: 0.2 s\nattempts: 1"));
  const auto molecule = *molecules({"row"});
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto t = makeTask(read.steps[0].tasks[0], *molecule);
    t->takeForces(sceneForces(read.steps[0].scene, molecule, {}, nullptr));
    t->drawBy(seed);
    double time_s = 0.0;
    for (int place = 0; place < 3; ++place) {
      TouchSample s;
      s.contact.scp.A = t->stage().facing->A + Vec3(0, 0, 3.3);
      for (int n = 0; n < 400; ++n) {
        s.time_s = time_s += 0.001;
        t->feed(s);
      }
      t->answer({.word = "next"});
    }
    t->answer({.word = "place-1"});
    t->answer({.word = "place-2"});
    solved += t->solved();
  }
  // One order in six.
  CHECK(solved > 300 / 6 - 35);
  CHECK(solved < 300 / 6 + 35);
  const std::vector<std::string> equal = errorsOf(
      text("salt", kProbe, "order: chain A and name CL then chain B and name CL\nby: energy\nfirst: the strongest"));
  REQUIRE(equal.size() == 1);
  CHECK(equal[0].find("two places bind the probe nearly alike") != std::string::npos);
}

TEST_CASE(
    "same with forces on and off is done by its demonstration and gives d'; the words are those of either, whichever "
    "is "
    "felt") {
  const std::string lesson = text("ball", kProbe, "same: name CL\nforces: none\ntrials: 8\nfor: 0.3 s");
  CHECK(errorsOf(lesson) == std::vector<std::string>());
  Student student(lesson);
  const bool done = student.learner.doTask();
  CAPTURE(student.last.note);
  CHECK(done);
  CHECK(student.figureOf("d'") > 2.0);
  CHECK(student.figureOf("right") == 8.0);
  // What a place counts as depends neither on a contact nor on the energy.
  const Lesson read = *Student::read(lesson);
  const auto molecule = *molecules({"ball"});
  const Vec3 charge = evenDirection(0, 60);
  std::set<std::string> said;
  for (const bool touching : {false, true})
    for (const bool field : {false, true}) {
      const auto t = makeTask(read.steps[0].tasks[0], *molecule);
      t->takeForces(sceneForces(read.steps[0].scene, molecule, {}, nullptr));
      TouchSample s;
      s.contact.scp.A = 11.6 * charge;
      if (touching) s.contact.atoms = {59, -1, -1}, s.contact.feature = Feature::Sphere;
      if (field) s.energy = MolecularEnergy{.parts = {{{0.0, -9.0}}}};
      for (int n = 0; n < 100; ++n) {
        s.time_s += 0.001;
        t->feed(s);
      }
      said.insert(t->sentence());
    }
  CHECK(said.size() == 1);
}

TEST_CASE(
    "the lesson tests/lesson/in_the_forces.md, with a drug and a protease, has no fault and is demonstrated to its "
    "end: the "
    "drug docks below -22 kcal/mol and is pulled out against 0.3 to 3 nN") {
  LessonReading reading = readLesson(MOLTACT_SOURCE_DIR "/tests/lesson/in_the_forces.md");
  for (const Problem& p : reading.errors) MESSAGE(p.text());
  REQUIRE(reading.lesson);
  for (const Problem& p : checkAgainstMolecules(*reading.lesson, test::knownMolecule)) FAIL_CHECK(p.text());
  std::vector<LearnerEvent> events;
  ScriptedLearner learner(std::make_shared<const Lesson>(*std::move(reading.lesson)), test::knownMolecule,
                          [&](const LearnerEvent& e) {
                            if (e.kind != LearnerEvent::Kind::Step) events.push_back(e);
                          });
  const bool finished = learner.demonstrate();
  for (const LearnerEvent& e : events)
    if (e.kind == LearnerEvent::Kind::GaveUp) MESSAGE(e.note);
  CHECK(finished);
  REQUIRE(events.size() == 5);
  const auto value = [&](std::size_t k, std::string_view name) {
    for (const TaskFigure& f : events[k].figures)
      if (f.name == name) return f.value;
    return std::nan("");
  };
  CHECK(value(0, "energy") <= -22.0);
  CHECK(value(1, "greatest force between the atoms") > 300.0);
  CHECK(value(1, "greatest force between the atoms") < 3000.0);
}
