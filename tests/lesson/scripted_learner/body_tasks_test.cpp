// Touch tasks with a body in the hand: which kinds judge it, what they judge of it, and that they can be demonstrated.
// Oracles: closed forms of two spheres, and the atoms that a hand-made sample says were pressed.
#include <cmath>
#include <numbers>

#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scripted_learner/answers_file.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

const std::string kHead = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: dock\nauthor: A\nlicence: L\n---\n";

// Atoms 0 to 2: spheres of 3 A at the origin, of 2 A at x = 12, of 2 A at y = 12. Atoms 3 and 4: the ligand, two spheres of
// 1.7 A (1.2 A as they are felt in the hand) 2 A apart along x, at z = 30.
Molecule dock() {
  MoleculeByHand b;
  b.made.id = "dock";
  b.residue("A", "ALA", 1, ResidueKind::AminoAcid)
      .atom("N", 7, {0, 0, 0}, 3.0)
      .atom("CA", 6, {12, 0, 0}, 2.0)
      .atom("C", 6, {0, 12, 0}, 2.0);
  b.residue("B", "LIG", 1, ResidueKind::Ligand).atom("C1", 6, {-1, 0, 30}).atom("C2", 6, {1, 0, 30});
  return b.molecule();
}

Expected<std::shared_ptr<const Molecule>> molecules(const NamedMolecule&) {
  return std::make_shared<const Molecule>(dock());
}

std::string step(const std::string& keys, const std::string& scene = "in-hand: resname LIG\n") {
  return "## A step\n```scene\nmolecule: dock\n" + scene + "```\n" +
         (keys.empty() ? "Text.\n" : "```touch\n" + keys + "\nsay: Do it.\n```\n");
}

std::shared_ptr<const Lesson> lesson(const std::string& body) {
  LessonReading read = readLessonText("l.md", kHead + body);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

std::vector<std::string> errorsOf(const std::string& body) {
  std::vector<std::string> out;
  for (const Problem& p : checkLesson("l.md", kHead + body, molecules).errors) out.push_back(p.text());
  return out;
}

SceneSpec heldScene() { return lesson(step(""))->steps[0].scene; }

Quat aboutZ(double deg) { return glm::angleAxis(glm::radians(deg), Vec3(0, 0, 1)); }
double apart_deg(const Quat& a, const Quat& b) { return glm::degrees(glm::length(rotationBetween(a, b))); }

// Samples of a hand that presses the body against these atoms for this time.
void pressWithBody(Task& task, double& time_s, std::array<std::int32_t, 3> atoms, double force_N, double for_s,
                   const Vec3& middle_A = Vec3(0.0)) {
  TouchSample s;
  s.contact.atoms = atoms;
  s.contact.feature = Feature::Sphere;
  s.contact.scp.A = middle_A;
  s.probe_A = 0.0;
  s.force.N = {0, 0, force_N};
  s.body = PoseA{{middle_A}, kNoRotation};
  for (const double end_s = time_s + for_s; time_s < end_s;) {
    s.time_s = time_s += 0.001;
    task.feed(s);
  }
}

}  // namespace

TEST_CASE(
    "reach, hold, press, feel: atoms, compare: places and contacts judge a body; all other forms are an error at their "
    "line") {
  const std::vector<std::string> judged{"reach: name CA",
                                        "hold: name CA",
                                        "hold: anywhere",
                                        "press: name CA\nuntil: 0.5 N",
                                        "press: anywhere\nuntil: 0.5 N",
                                        "feel: atoms",
                                        "compare: places\nof: name N then name CA",
                                        "contacts: anywhere\ncount: 2",
                                        "same: name N\nplace: name CA"};
  for (const std::string& keys : judged) {
    CAPTURE(keys);
    CHECK(errorsOf(step(keys)) == std::vector<std::string>());
  }
  const std::vector<std::pair<std::string, std::string>> refused{
      {"hold: pit", "'hold' in this form"},
      {"press: crease\nuntil: 0.5 N", "'press' in this form"},
      {"feel: sphere", "'feel' in this form"},
      {"compare: exact, penalty", "'compare' in this form"},
      {"cross: name N\nto: name CA", "'cross'"},
      {"avoid: name N", "'avoid'"},
      {"meet: lost", "'meet'"},
      {"trace: name N then name CA", "'trace'"},
      {"find: name N", "'find'"},
      {"predict: name N", "'predict'"},
      {"same: anywhere\nfriction: 0.5", "'same' in this form"},
      {"fit: name N\nmost: 6 Å", "'fit'"},
      {"measure: name N\nto: name CA", "'measure'"},
      {"order: name N then name CA\nfirst: the larger", "'order'"}};
  for (const auto& [keys, says] : refused) {
    CAPTURE(keys);
    const std::vector<std::string> errors = errorsOf(step(keys));
    std::size_t reported = 0;
    for (const std::string& e : errors) {
      CAPTURE(e);
      if (!e.starts_with("l.md:14:4: " + says +
                         " judges a probe, and here the hand holds a body; write 'in-hand: none'"))
        continue;
      CHECK(e.find("reach, hold, press, feel, compare") != std::string::npos);
      ++reported;
    }
    CHECK(reported == 1);
    for (const std::string& e : errorsOf(step(keys, ""))) CHECK(e.find("judges a probe") == std::string::npos);
  }
}

TEST_CASE("the atoms that the body presses hardest are judged, with the force on the whole body") {
  double t = 0.0;
  const auto reach = task("reach", {{"reach", "name CA"}}, dock());
  pressWithBody(*reach, t, {0, -1, -1}, 0.5, 1.0);
  CHECK_FALSE(reach->done());
  CHECK(reach->sentence().find("the surface") != std::string::npos);
  pressWithBody(*reach, t, {1, -1, -1}, 0.5, 0.2);
  CHECK(reach->solved());

  const auto press = task("press", {{"press", "name CA"}, {"until", "0.8 N"}}, dock());
  pressWithBody(*press, t, {1, -1, -1}, 0.7, 1.0);
  CHECK_FALSE(press->done());
  CHECK(press->progress() == doctest::Approx(0.875));
  pressWithBody(*press, t, {0, -1, -1}, 0.9, 1.0);
  CHECK_FALSE(press->done());
  pressWithBody(*press, t, {1, -1, -1}, 0.81, 0.2);
  CHECK(press->solved());

  // 'near' counts from the body's middle: 4.9 A from the centre of the atom, and then 5.1 A.
  for (const double off_A : {5.1, 4.9}) {
    const auto near = task("reach", {{"reach", "name CA"}, {"near", "5 Å"}}, dock());
    pressWithBody(*near, t, {0, -1, -1}, 0.5, 0.3, Vec3(12.0 - off_A, 0, 0));
    CHECK(near->solved() == (off_A < 5.0));
  }
}

TEST_CASE("what is said speaks of what the hand holds, not of a probe") {
  const auto reach = task("reach", {{"reach", "name CA"}}, dock());
  TouchSample s;
  s.time_s = 1.0;
  reach->feed(s);
  CHECK(reach->sentence().starts_with("Move the probe to"));
  s.time_s = 2.0;
  s.body = PoseA{};
  reach->feed(s);
  CHECK(reach->sentence().starts_with("Move what you hold to"));
  s.time_s = 3.0;
  s.contact.fault = Fault::StartedInside;
  reach->feed(s);
  CHECK(reach->sentence().starts_with("What you hold began inside"));
}

TEST_CASE(
    "an act leads place and orientation together and evenly: 3 A at 3 A/s and 90 degrees at 60 degrees/s take 1.5 s") {
  const PoseA from{{{1, 0, 0}}, kNoRotation};
  const HandAct act{.to = PointA{{4, 0, 0}}, .turned_to = aboutZ(90.0)};
  const HandWay way = wayOf(act, from, 0.001);
  CHECK(way.ticks == 1500);
  CHECK(way.at(1500).place == PointA{{4, 0, 0}});
  CHECK(way.at(1500).orientation == *act.turned_to);
  for (const std::size_t k : {std::size_t{1}, std::size_t{375}, std::size_t{750}, std::size_t{1499}}) {
    CAPTURE(k);
    const double part = double(k) / 1500.0;
    CHECK(glm::distance(way.at(k).place.A, Vec3(1.0 + 3.0 * part, 0, 0)) < 1e-12);
    CHECK(apart_deg(way.at(k).orientation, aboutZ(90.0 * part)) < 1e-9);
  }
  // By the shorter arc, whatever sign the quaternion has; and a hand that is led nowhere takes no tick.
  const HandWay back = wayOf({.turned_to = -aboutZ(-80.0)}, from, 0.001);
  CHECK(apart_deg(back.at(back.ticks / 2).orientation, aboutZ(-40.0)) < 0.1);
  CHECK(wayOf({.wait_s = 1.0}, from, 0.001).ticks == 0);
}

TEST_CASE(
    "the virtual hand leads the body: turned by 90 degrees it meets the atom at x = 12 by 1 A later, in its middle") {
  VirtualTouch touch;
  touch.begin(std::make_shared<const Molecule>(dock()), heldScene());
  // Along x, two atoms of 1.2 A with 1 A to the middle: the foremost touches the sphere of 2 A at 12 + 2 + 1.2 + 1; upright
  // both touch it where its middle is sqrt(3.2^2 - 1^2) from the centre.
  const auto met_A = [&](const Quat& q) {
    touch.place({{{20, 0, 0}}, q});
    for (double x = 20.0; x > 12.0; x -= 0.002) {
      const TouchSample s = touch.tick({{{x, 0, 0}}, q});
      REQUIRE(s.body);
      CHECK(apart_deg(s.orientation, q) < 1e-6);
      CHECK(apart_deg(s.body->orientation, q) < 1e-6);
      if (s.contact.touching()) return x;
      CHECK(glm::distance(s.body->place.A, Vec3(x, 0, 0)) < 1e-9);
    }
    return 0.0;
  };
  CHECK(met_A(kNoRotation) == doctest::Approx(16.2).epsilon(3e-4));
  CHECK(met_A(aboutZ(90.0)) == doctest::Approx(12.0 + std::sqrt(3.2 * 3.2 - 1.0)).epsilon(3e-4));
  // A probe has no body.
  touch.begin(std::make_shared<const Molecule>(dock()), lesson(step("", ""))->steps[0].scene);
  touch.place({{{20, 0, 0}}});
  CHECK_FALSE(touch.tick({{{20, 0, 0}}}).body);
}

TEST_CASE("a body's open places are where it first meets the atom, most frontal first: a closed form for two spheres") {
  VirtualTouch touch;
  touch.begin(std::make_shared<const Molecule>(dock()), heldScene());
  const std::uint32_t atom[] = {1};
  const std::vector<SurfacePlace> places = openPlaces(touch.view(0), atom, Feature::Sphere);
  REQUIRE(places.size() >= 10);
  for (const SurfacePlace& p : places) {
    const Vec3 one = p.scp_A - Vec3(1, 0, 0) - Vec3(12, 0, 0), other = p.scp_A + Vec3(1, 0, 0) - Vec3(12, 0, 0);
    CHECK(std::min(glm::length(one), glm::length(other)) == doctest::Approx(3.2).epsilon(1e-9));
    CHECK(p.atoms[0] == 1);
  }
  CHECK(openPlaces(touch.view(0), atom, Feature::Circle).empty());
}

TEST_CASE("each form of task that judges a body is done with it by the student who follows its demonstration") {
  for (const char* keys :
       {"reach: name CA", "reach: name N\nside: name CA", "hold: name C\nfor: 1 s\nforce: 0.2 N to 0.9 N",
        "press: name CA\nuntil: 0.6 N", "feel: atoms\ncount: 3", "compare: places\nof: name N then name CA\nfor: 0.5 s",
        "contacts: name N\ncount: 2\nfor: 0.5 s"}) {
    CAPTURE(keys);
    std::vector<LearnerEvent> events;
    ScriptedLearner learner(lesson(step(keys)), molecules, [&](const LearnerEvent& e) { events.push_back(e); });
    const bool finished = learner.demonstrate();
    for (const LearnerEvent& e : events)
      if (e.kind == LearnerEvent::Kind::GaveUp) MESSAGE(e.note);
    CHECK(finished);
    CHECK(learner.time_s() < 40.0);
  }
}

TEST_CASE("a script names poses: it brings the turned body against an atom, and the task is done") {
  const std::string answers = "pose 20, 0, 0\npose 14.5, 0, 0, 0.7071, 0, 0, 0.7071\nwait 0.5 s\n";
  const AnswersReading read = readAnswers("a.txt", answers);
  REQUIRE(read.problems.empty());
  REQUIRE(read.acts.size() == 3);
  CHECK_FALSE(read.acts[0].turned_to);
  CHECK(apart_deg(*read.acts[1].turned_to, aboutZ(90.0)) < 1e-9);
  ScriptedLearner learner(lesson(step("reach: name CA")), molecules, [](const LearnerEvent&) {});
  CHECK(carryOut(learner, read.acts, "a.txt").empty());
  CHECK(learner.session().finished());

  const struct {
    const char* text;
    const char* says;
  } wrong[] = {{"pose", "a.txt:1:5: this act needs a place"},
               {"pose 1, 2", "a.txt:1:6: a pose has 3 or 7 numbers, here are 2; write X, Y, Z in angstroms"},
               {"pose 1, 2, 3, 1", "a.txt:1:6: a pose has 3 or 7 numbers, here are 4"},
               {"pose 1, two, 3", "a.txt:1:9: 'two' is no number"},
               {"pose 1, 2, 3e9", "a.txt:1:12: this number is too large"},
               {"pose 1, 2, 3, 0, 0, 0, 0", "a.txt:1:15: these four numbers are no rotation"},
               {"pose 1, 2, 3, 1, 1, 0, 0", "a.txt:1:15: these four numbers are no rotation"}};
  for (const auto& w : wrong) {
    const AnswersReading bad = readAnswers("a.txt", w.text);
    REQUIRE(bad.problems.size() == 1);
    CAPTURE(bad.problems[0].text());
    CHECK(bad.problems[0].text().starts_with(w.says));
    CHECK(bad.acts.empty());
  }
}

TEST_CASE(
    "contacts counts the body's atoms that touch at once: a dumbbell across a sphere of 3 A touches with both where "
    "its "
    "middle is sqrt(4.2^2 - 1) A above, with one 0.06 A above that on one side, and with none of another atom") {
  const double across_A = std::sqrt(4.2 * 4.2 - 1.0);
  const auto body = [] {
    const std::uint32_t held[] = {3, 4};
    return heldBody(dock().spheres, held);
  };
  const struct {
    const char* atoms;
    const char* count;
    Vec3 middle;
    bool solved;
  } cases[] = {{"name N", "2", {0, 0, across_A}, true},
               {"anywhere", "2", {0, 0, across_A + 0.04}, true},
               {"name N", "2", {0, 0, across_A + 0.06}, false},
               {"name CA", "1", {0, 0, across_A}, false},
               {"name N", "1", {1.0, 0, 4.2}, true},
               {"name N", "2", {1.0, 0, 4.2}, false},
               {"name CA", "1", {12.0 - 3.2 - 1.0, 0, 0}, true}};
  for (const auto& c : cases) {
    CAPTURE(c.atoms);
    CAPTURE(c.middle.z);
    for (const double for_s : {0.9, 1.1}) {
      const auto t = task("contacts", {{"contacts", c.atoms}, {"count", c.count}}, dock());
      t->takeInHand(body());
      double time_s = 0.0;
      pressWithBody(*t, time_s, {0, -1, -1}, 0.5, for_s, c.middle);
      CHECK(t->solved() == (c.solved && for_s > 1.0));
    }
  }
  // An untouchable atom does not count, nor a body without contact.
  const auto t = task("contacts", {{"contacts", "anywhere"}, {"count", "1"}}, dock());
  const std::uint32_t first[] = {0};
  t->leaveOut(first);
  t->takeInHand(body());
  double time_s = 0.0;
  pressWithBody(*t, time_s, {0, -1, -1}, 0.5, 2.0, {0, 0, across_A});
  CHECK_FALSE(t->done());
  CHECK(errorsOf(step("contacts: anywhere", "")).size() == 1);
  REQUIRE(errorsOf(step("contacts: anywhere\ncount: 3")).size() == 1);
  CHECK(errorsOf(step("contacts: anywhere\ncount: 3"))[0].find("the body has only 2 atoms") != std::string::npos);
}

TEST_CASE("contacts in a scene with 'then', which moves the atoms, is one error at the task; dock there is none") {
  const std::string moves = "in-hand: resname LIG\nthen: dock\n";
  const std::vector<std::string> errors = errorsOf(step("contacts: anywhere\ncount: 2", moves));
  REQUIRE(errors.size() == 1);
  CAPTURE(errors[0]);
  CHECK(errors[0].starts_with("l.md:15:4: 'contacts' judges the atoms where they are at the start of the scene"));
  CHECK(errors[0].find("leave out 'then', or use 'dock'") != std::string::npos);
  CHECK(errorsOf(step("dock: file", moves)).empty());
}

TEST_CASE(
    "same with a body: it begins before each place by the same way, in the file's orientation; it counts as felt "
    "while the hand holds it, wherever forces draw it, and not in a hand that hovers") {
  const auto held = lesson(step("same: name CA\nplace: name C\nfor: 0.5 s\ntrials: 4\nright: 4"));
  const auto molecule = std::make_shared<const Molecule>(dock());
  const std::uint32_t atoms[] = {3, 4};
  const auto body = heldBody(molecule->spheres, atoms);
  std::size_t firsts = 0, seconds = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    auto task = makeTask(held->steps[0].tasks[0], *molecule);
    task->takeInHand(body);
    task->drawBy(seed);
    double time_s = 0.0;
    const auto stay = [&](const Vec3& at, bool hovering) {
      TouchSample s;
      s.body = PoseA{{at}, kNoRotation};
      s.hovering = hovering;
      for (int k = 0; k < 800; ++k) {
        s.time_s = time_s += 0.001;
        task->feed(s);
      }
    };
    const TaskStage stage = task->stage();
    REQUIRE(stage.body_begins);
    CHECK(stage.dark);
    CHECK(stage.unnamed);
    CHECK(stage.body_turned == kNoRotation);
    CHECK(stage.in_hand == std::vector<std::uint32_t>{3, 4});
    // The place: CA at x = 12 for the first thing, C at y = 12 for the second, whose body begins 12 A to the left and above.
    const bool second = glm::distance(stage.body_begins->A, Vec3(-12, 12, 30)) < 1e-9;
    if (!second) CHECK(glm::distance(stage.body_begins->A, Vec3(0, 0, 30)) < 1e-9);
    ++(second ? seconds : firsts);
    const Vec3 place = second ? Vec3(0, 12, 0) : Vec3(12, 0, 0);
    stay(place + Vec3(0, 0, 3.0), true);
    CHECK(task->buttons().empty());
    stay(place + Vec3(0, 0, seed % 2 ? 3.0 : 30.0), false);
    CHECK(task->buttons().size() == 1);
  }
  CHECK(firsts > 0);
  CHECK(seconds > 0);
  ScriptedLearner learner(held, molecules, [](const LearnerEvent&) {});
  REQUIRE(learner.enterStep());
  CHECK(learner.doTask());
}
