// A scripted learner on small molecules, with lessons as texts; no window, virtual clock.
#include "engine/lesson/scripted_learner/scripted_learner.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "engine/lesson/reader.h"
#include "engine/lesson/scripted_learner/answers_file.h"
#include "engine/lesson/tasks/registry.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const std::string kHead =
    "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: pair, cage, ring, well\nauthor: A\nlicence: L\n---\n";

std::shared_ptr<const Lesson> lesson(const std::string& body) {
  LessonReading read = readLessonText("l.md", kHead + body);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

/// "pair": two spheres of 1.88 A side by side; "cage": a small atom wholly inside a large one; "ring": six spheres of 1.5 A
/// 3 A round the z axis, through which a probe of 1.5 A passes; "well": the same with a sphere of 1 A
/// on a floor behind its middle, which a probe of 2.25 A just comes to.
Expected<std::shared_ptr<const Molecule>> molecules(const NamedMolecule& named) {
  const std::string& name = named.name;
  MoleculeByHand b;
  if (name == "pair")
    b.atom("AR", 18, {-1.88, 0, 0}, 1.88).atom("AR", 18, {1.88, 0, 0}, 1.88);
  else if (name == "cage")
    b.atom("C", 6, {0, 0, 0}, 1.0).atom("U", 92, {0.1, 0, 0}, 4.0);
  else if (name == "ring" || name == "well") {
    for (int k = 0; k < 6; ++k)
      b.atom("C", 6, {3.0 * std::cos(k * 1.0471975511965976), 3.0 * std::sin(k * 1.0471975511965976), 0}, 1.5);
    if (name == "well") b.atom("O", 8, {0, 0, -1.0}, 1.0).atom("U", 92, {0, 0, -4.0}, 3.5);
  } else
    return Problem{{}, 0, 0, "there is no molecule '" + name + "'", {}};
  return std::make_shared<const Molecule>(b.molecule());
}

struct Played {
  std::vector<LearnerEvent> events;
  std::vector<Problem> problems;
  bool finished = false;
  double time_s = 0.0;

  const LearnerEvent* find(LearnerEvent::Kind kind, std::size_t nth = 0) const {
    for (const LearnerEvent& e : events)
      if (e.kind == kind && nth-- == 0) return &e;
    return nullptr;
  }
};

Played demonstrate(const std::string& body, ScriptedLearner::Options options = {}) {
  Played out;
  ScriptedLearner learner(
      lesson(body), molecules, [&](const LearnerEvent& e) { out.events.push_back(e); }, options);
  out.finished = learner.demonstrate();
  out.time_s = learner.time_s();
  return out;
}

Played play(const std::string& body, const std::string& answers) {
  Played out;
  const AnswersReading read = readAnswers("a.txt", answers);
  REQUIRE_MESSAGE(read.problems.empty(), read.problems.front().text());
  ScriptedLearner learner(lesson(body), molecules, [&](const LearnerEvent& e) { out.events.push_back(e); });
  out.problems = carryOut(learner, read.acts, "a.txt");
  out.finished = learner.session().finished();
  out.time_s = learner.time_s();
  return out;
}

std::string step(const std::string& tasks, const std::string& molecule = "pair") {
  return "## A step\n```scene\nmolecule: " + molecule + "\n```\n" + tasks;
}
std::string touch(const std::string& keys) { return "```touch\n" + keys + "\nsay: Do it.\n```\n"; }

using Kind = LearnerEvent::Kind;

}  // namespace

TEST_CASE(
    "an answer to a question that is answered, or one that is no number, is not taken: it is neither "
    "right nor wrong, and the reason is reported") {
  const std::string questions = step("") +
                                "### Question: Which?\n\n- [x] This → Right so.\n- [ ] That → No.\n\n### Question: How "
                                "many?\n\n```answer\nnumber: 3\ntolerance: 0\nright: Right so.\n```\n";
  const Played played = play(questions, "answer 1: 1\nanswer 1: 2\nanswer 2: many\nanswer 2: 3\nanswer 2: 4\n");
  std::string reported;
  for (const LearnerEvent& e : played.events)
    if (e.kind == LearnerEvent::Kind::Question)
      reported += std::string(!e.taken ? "not taken" : e.right ? "right" : "wrong") + ": " + e.note + "\n";
  CHECK(reported ==
        "right: Right so.\nnot taken: the question is answered and takes no other answer\nnot taken: 'many' is no "
        "number. Write one, for example 12 or 0.5.\nright: Right so.\nnot taken: the question is answered and takes no "
        "other answer\n");
  CHECK(played.finished);
}

TEST_CASE("each kind of task is done on two spheres by the student who follows its demonstration, in at most 30 s") {
  const std::vector<std::pair<std::string, std::string>> all{
      {"reach", "reach: atom 1"},
      {"hold", "hold: crease\nfor: 1 s\nforce: 0.3 N to 1 N"},
      {"press", "press: atom 0\nuntil: 1.5 N"},
      {"feel", "feel: sphere, crease"},
      {"cross", "cross: atom 0\nto: atom 1\ntimes: 2"},
      {"avoid", "avoid: atom 0\nfor: 1 s"},
      {"compare", "compare: places\nof: atom 0 then atom 1\nfor: 1 s"},
      {"compare", "compare: exact, paper, mesh960\nfor: 1 s"},
      {"trace", "trace: crease\nof: all\nwithin: 0.3 Å"},
      {"trace", "trace: atom 0 then atom 1"},
      {"find", "find: atom 1"},
      {"find", "find: atom 0\nby: hold"},
      {"predict", "predict: atom 0"},
      {"predict", "predict: atom 0\nalong: atom 1"},
      {"same", "same: anywhere\nprobe: 2 Å\ntrials: 2\nfor: 0.2 s"},
      {"same", "same: atom 0\nplace: atom 1\ntrials: 4\nfor: 0.2 s"},
      {"same", "same: anywhere\nmethod: mesh80\ntrials: 4\nfor: 0.2 s"},
      {"measure", "measure: atom 0\nto: atom 1\nbetween: 4 Å to 8 Å"},
      {"order", "order: atom 0 then atom 1\nfirst: the left one\nfor: 0.2 s"}};
  // Below: they want a method that jumps, a ring, and a body; rank_test.cpp: forces between atoms.
  std::set<std::string, std::less<>> kinds{"meet", "fit", "rank", "dock", "pull", "pass", "contacts"};
  for (const auto& [kind, keys] : all) {
    CAPTURE(keys);
    kinds.insert(kind);
    const Played p = demonstrate(step(touch(keys)));
    if (const LearnerEvent* gave_up = p.find(Kind::GaveUp)) MESSAGE(gave_up->note);
    CHECK(p.finished);
    CHECK(p.time_s <= 30.0);
  }
  const Played meets = demonstrate("## A\n```scene\nmolecule: pair\nmethod: mesh80\n```\n" + touch("meet: jump"));
  CHECK(meets.finished);
  for (const char* keys :
       {"fit: all\nway: through\nmost: 3 Å", "fit: all\nway: through\nmost: 3 Å\nwant: smallest",
        "fit: atom 6\nleast: 0.5 Å\nmost: 4 Å", "fit: atom 6\nwant: smallest\nleast: 0.5 Å\nmost: 4 Å"}) {
    CAPTURE(keys);
    const Played p = demonstrate(step(touch(keys), std::string(keys).starts_with("fit: all") ? "ring" : "well"));
    if (const LearnerEvent* gave_up = p.find(Kind::GaveUp)) MESSAGE(gave_up->note);
    CHECK(p.finished);
    CHECK(p.time_s <= 30.0);
  }
  const Played passes = demonstrate(step(touch("pass: all"), "ring"));
  if (const LearnerEvent* gave_up = passes.find(Kind::GaveUp)) MESSAGE(gave_up->note);
  CHECK(passes.finished);
  const Played docks =
      demonstrate("## A\n```scene\nmolecule: ring\nin-hand: atom 0\n```\n" + touch("dock: file\nwithin: 1 Å"));
  if (const LearnerEvent* gave_up = docks.find(Kind::GaveUp)) MESSAGE(gave_up->note);
  CHECK(docks.finished);
  const Played presses =
      demonstrate("## A\n```scene\nmolecule: ring\nin-hand: atom 0 1\n```\n" + touch("contacts: anywhere\ncount: 2"));
  if (const LearnerEvent* gave_up = presses.find(Kind::GaveUp)) MESSAGE(gave_up->note);
  CHECK(presses.finished);
  for (const TaskKind& kind : taskKinds()) CHECK_MESSAGE(kinds.contains(kind.name), std::string(kind.name));
}

TEST_CASE(
    "the spring of the virtual hand is the scene's: pressing until 1.5 N reads 1.5 to 1.8 N in the task's figures") {
  const Played p = demonstrate(step(touch("press: atom 0\nuntil: 1.5 N")));
  const LearnerEvent* done = p.find(Kind::Task);
  REQUIRE(done);
  for (const TaskFigure& f : done->figures)
    if (f.name == "greatest force") {
      CHECK(f.value >= 1.5);
      CHECK(f.value <= 1.8);
    }
}

TEST_CASE(
    "an atom that no probe can reach is given up with its step and task, and the rest of the lesson is still done") {
  const Played p = demonstrate(step(touch("reach: atom 0") + touch("reach: atom 1"), "cage") +
                               "### Question: Q?\n- [x] a\n- [ ] b\n## Next step\n```scene\nmolecule: pair\n```\n" +
                               touch("reach: atom 0"));
  CHECK_FALSE(p.finished);
  const LearnerEvent* gave_up = p.find(Kind::GaveUp);
  REQUIRE(gave_up);
  CHECK(gave_up->step == "a-step");
  CHECK(gave_up->index == 0);
  CHECK(gave_up->place.line == 13);
  CHECK(gave_up->note.starts_with("no place for it is open to the probe from outside"));
  REQUIRE(p.find(Kind::Question));
  CHECK(p.find(Kind::Question)->right);
  REQUIRE(p.find(Kind::Task));
  CHECK(p.find(Kind::Task)->step == "next-step");
}

TEST_CASE("a force of 15 N that no hand is given is given up after 20 s on the virtual clock where that is the limit") {
  const Played p = demonstrate(step(touch("press: atom 0\nuntil: 15 N")), {.task_s = 20.0, .attempts = 1000});
  CHECK_FALSE(p.finished);
  REQUIRE(p.find(Kind::GaveUp));
  CHECK(p.time_s == doctest::Approx(20.0).epsilon(0.01));
  CHECK(p.find(Kind::GaveUp)->note.starts_with("not done after 20\u00a0s of trying"));
}

TEST_CASE("an atom that a task takes out is not felt until it is put back") {
  VirtualTouch touch;
  touch.begin(*molecules({"pair"}), SceneSpec());
  const auto felt = [&] {
    touch.place({{{-8.0, 0.0, 0.0}}});
    bool met = false;
    for (double x = -8.0; x < -1.88; x += 0.02) met = touch.tick({{{x, 0.0, 0.0}}}).contact.touching();
    return met;
  };
  CHECK(felt());
  TaskStage without;
  without.removed = {0};
  touch.setStage(without);
  CHECK(touch.spheres().untouchable() == std::vector<std::uint32_t>{0});
  CHECK_FALSE(felt());
  touch.setStage({});
  CHECK(touch.spheres().untouchable().empty());
  CHECK(felt());
}

TEST_CASE("a molecule that is not there is fault at its place in the lesson, and nothing hangs") {
  const Played p = demonstrate("## A\n```scene\nmolecule: pair\n```\n" + touch("reach: all") +
                               "## B\n```scene\nmolecule: cage\n```\n");
  CHECK(p.finished);
  Played out;
  ScriptedLearner learner(
      lesson(step(touch("reach: all"))),
      [](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
        return Problem{{}, 0, 0, "gone", {}};
      },
      [&](const LearnerEvent& e) { out.events.push_back(e); });
  CHECK_FALSE(learner.demonstrate());
  REQUIRE(out.find(Kind::Fault));
  CHECK(out.find(Kind::Fault)->place.line == 11);
}

TEST_CASE(
    "a script touches, presses, slides, gives a wrong answer that is reported and a right one, and finishes the "
    "lesson") {
  const std::string body = step(touch("reach: atom 0") + touch("press: atom 0\nuntil: 0.8 N") +
                                touch("cross: atom 0\nto: atom 1\ndirection: either")) +
                           "### Question: How many?\n- [ ] One -> No.\n- [x] Two -> Yes.\n### Question: "
                           "Radius?\n```answer\nnumber: 1.88 Å\ntolerance: 0.1 Å\n```\n";
  const Played p = play(body,
                        "touch atom 0       # the left one\npress 0.9 N\ntouch atom 0\nslide atom 1\n"
                        "answer how-many: One\nanswer 1: 2\nanswer radius: 1.9 Å\n");
  for (const Problem& problem : p.problems) MESSAGE(problem.text());
  CHECK(p.problems.empty());
  CHECK(p.finished);
  REQUIRE(p.find(Kind::Question, 2));
  CHECK_FALSE(p.find(Kind::Question, 0)->right);
  CHECK(p.find(Kind::Question, 0)->note == "No.");
  CHECK(p.find(Kind::Question, 1)->right);
  CHECK(p.find(Kind::Question, 2)->right);
}

TEST_CASE("a script finds in the dark, distinguishes same from different and draws a curve") {
  const Played p =
      play(step(touch("find: atom 1") + touch("same: atom 0\nplace: atom 1\ntrials: 2\nright: 1\nfor: 0.2 s") +
                touch("predict: atom 0\ndeep: 1 Å")),
           "touch atom 0\nsay here\ntouch atom 1\nsay here\n"
           "do\n"
           "draw 0 N, 3.3 N\ntouch atom 0\npress 0.01 N\npress 3.4 N\n");
  for (const Problem& problem : p.problems) MESSAGE(problem.text());
  CHECK(p.problems.empty());
  CHECK(p.finished);
}

TEST_CASE("what a script refers to and the lesson lacks is reported at its line, and the rest continues") {
  const Played p = play(
      step(touch("reach: atom 0")) + "### Question: Q?\n- [x] a\n- [ ] b\n",
      "slide atom 0\nanswer what: a\nanswer q: c\nsay here\ntouch element Xe\nnext\ndraw 1 N\ndo\ndo\nanswer q: a\n");
  std::vector<std::string> reported;
  for (const Problem& problem : p.problems) reported.push_back(problem.text());
  REQUIRE(reported.size() == 8);
  CHECK(reported[0] == "a.txt:1:1: the hand touches nothing; touch a place first");
  CHECK(reported[1] == "a.txt:2:1: the step 'a-step' has no question 'what'; its questions: q");
  CHECK(reported[2] == "a.txt:3:1: 'c' is none of the 2 choices; write a choice's number or its whole text");
  CHECK(reported[3] == "a.txt:4:1: the task does not offer 'here' now; it offers nothing; touch first");
  CHECK(reported[4].starts_with("a.txt:5:1: element 'Xe' is not in"));
  CHECK(reported[5] == "a.txt:6:1: this is the last step; take the line out");
  CHECK(reported[6] == "a.txt:7:1: no curve is asked for now; take the line out");
  CHECK(reported[7] == "a.txt:9:1: the step has no task left to do; take the line out, or go on with 'next'");
  CHECK(p.finished);
}

TEST_CASE("faults in the text of a script are all reported, with line, column and remedy") {
  const AnswersReading read = readAnswers(
      "a.txt",
      "tuch atom 0\n\npress 4\npress 1 N on elment O\n# only a comment\nmethod exakt\nanswer q\nwait\ndo it\n");
  std::vector<std::string> reported;
  for (const Problem& p : read.problems) reported.push_back(p.text());
  REQUIRE(reported.size() == 7);
  CHECK(reported[0] == "a.txt:1:1: there is no act 'tuch'; did you mean 'touch'?");
  CHECK(reported[1].starts_with("a.txt:3:7: '4' needs a unit: "));
  CHECK(reported[2].starts_with("a.txt:4:14: "));
  CHECK(reported[3] == "a.txt:6:8: there is no haptic method 'exakt'; did you mean 'exact'?");
  CHECK(reported[4].starts_with("a.txt:7:"));
  CHECK(reported[5].starts_with("a.txt:8:"));
  CHECK(reported[6] == "a.txt:9:4: nothing comes after this act; take it out");
  CHECK(read.acts.empty());
}
