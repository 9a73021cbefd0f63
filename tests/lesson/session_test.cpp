#include "engine/lesson/session.h"

#include <doctest/doctest.h>

#include "engine/lesson/reader.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const std::string kSessionHead =
    "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix, water\nauthor: A\nlicence: L\n---\n";
const std::string kSessionBody =
    "## A\n```scene\nmolecule: mix\n```\n```touch\nreach: atom 0\nsay: S\npraise: P.\n```\n```touch\nreach: atom "
    "1\nsay: Then this.\n```\n"
    "### Question: Q?\n- [x] yes → Good\n- [x] also → Fine\n- [ ] no → Bad\n"
    "## B\n### Question: N?\n```answer\nnumber: 1.4 Å\ntolerance: 0.1 Å\nwrong: Measure again.\n```\n### Question: "
    "W?\n```answer\ntext: crease, groove\n```\n"
    "## C\n```scene\nmolecule: water\n```\n";

std::shared_ptr<const Lesson> sessionLesson(const std::string& body) {
  LessonReading read = readLessonText("l.md", kSessionHead + body);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

void sessionTouch(LessonSession& session, std::int32_t atom, double from_s) {
  for (int i = 0; i <= 150; ++i) {
    TouchSample s;
    s.time_s = from_s + i * 0.001;
    s.contact.feature = Feature::Sphere;
    s.contact.atoms[0] = atom;
    session.feed(s);
  }
}

}  // namespace

TEST_CASE(
    "Next and Back pass an aside over; from it both lead to the step that linked to it, and progress does not count "
    "it") {
  LessonSession s(
      sessionLesson("## A\n```scene\nmolecule: mix\n```\n[x](#aside-x)\n## Aside: X\n```scene\nprobe: 2 "
                    "Å\n```\n[y](#aside-y)\n### Question: Q?\n- [x] a\n- [ ] b\n"
                    "## B\n## Aside: Y\nText.\n"));
  CHECK(s.lesson().steps[1].title == "X");
  CHECK(s.lesson().steps[1].scene.touch.probe_A == 2.0);
  CHECK(s.lesson().steps[2].scene.touch.probe_A == 1.4);
  s.next();
  CHECK(s.step().id == "b");
  CHECK_FALSE(s.hasNext());
  s.back();
  CHECK(s.step().id == "a");
  CHECK_FALSE(s.hasBack());
  REQUIRE(s.goTo("#aside-x"));
  CHECK((s.hasNext() && s.hasBack()));
  REQUIRE(s.goTo("#aside-y"));
  s.next();
  CHECK(s.step().id == "a");
  CHECK(s.finished());
  s.next();
  REQUIRE(s.goTo("#aside-y"));
  s.back();
  CHECK(s.step().id == "b");
}

TEST_CASE("tasks wait for the molecule, then are done one at a time in their order") {
  LessonSession session(sessionLesson(kSessionBody));
  sessionTouch(session, 0, 0.0);
  CHECK_FALSE(session.task(0).done);
  session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  CHECK(session.task(0).current);
  CHECK(session.task(0).say == "S");
  CHECK(session.task(1).sentence.empty());
  CHECK(session.task(1).say == "Then this.");
  sessionTouch(session, 1, 1.0);
  CHECK_FALSE(session.task(1).done);
  sessionTouch(session, 0, 2.0);
  CHECK(session.task(0).done);
  CHECK(session.task(0).sentence == "P.");
  CHECK(session.task(1).current);
  sessionTouch(session, 1, 3.0);
  CHECK(session.task(1).done);
  CHECK_FALSE(session.stepDone());
  CHECK(session.progress() == doctest::Approx(2.0 / 5));
  session.restartTask(0);
  CHECK_FALSE(session.task(0).done);
}

TEST_CASE(
    "a task's figures tell 0.15 s of contact at 0.5 N over a way of 0.15 A, and stay when the step is left and entered "
    "again") {
  LessonSession session(sessionLesson(kSessionBody));
  CHECK(session.taskFigures(0).empty());
  session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  const auto figure = [&](std::string_view name) {
    for (const TaskFigure& f : session.taskFigures(0))
      if (f.name == name) return f.value;
    return -1.0;
  };
  for (int i = 0; i <= 150; ++i) {
    TouchSample s;
    s.time_s = i * 0.001;
    s.contact.feature = Feature::Sphere;
    // The task ends after 0.1 s on its atom; before that the hand is 0.05 s on another.
    s.contact.atoms[0] = i <= 49 ? 3 : 0;
    s.contact.scp.A = {0.001 * i, 0, 0};
    s.force.N = {0, 0.3, 0.4};
    session.feed(s);
  }
  const auto check = [&] {
    CHECK(figure("contact time") == doctest::Approx(0.15).epsilon(0.01));
    CHECK(figure("mean force") == doctest::Approx(0.5));
    CHECK(figure("greatest force") == doctest::Approx(0.5));
    CHECK(figure("way") == doctest::Approx(0.15).epsilon(0.01));
  };
  check();
  REQUIRE(session.task(0).done);
  session.next();
  session.back();
  check();
  session.restartTask(0);
  CHECK(figure("time") == 0.0);
}

TEST_CASE("a question with two right choices takes exactly these two, and a wrong attempt gives feedback") {
  LessonSession session(sessionLesson(kSessionBody));
  CHECK_FALSE(session.choose(0, {0}));
  CHECK(plainText(session.feedback(0).at(0)) == "Good");
  CHECK(plainText(session.feedback(0).at(1)) == "Look again: more than one is right.");
  CHECK_FALSE(session.choose(0, {0, 1, 2}));
  CHECK_FALSE(session.choose(0, {0, 1, 99}));
  CHECK_FALSE(session.choose(0, {}));
  CHECK(session.choose(0, {1, 0, 1}));
  CHECK(session.question(0).answered_right);
  CHECK(session.question(0).attempts == 5);
  CHECK_FALSE(session.choose(0, {2}));
  CHECK(session.question(0).answered_right);
}

TEST_CASE("1.4 Å with tolerance 0.1 Å takes 1.5, 0.14 nm and 1.3 Å, not 1.6; words are taken in capitals") {
  for (const char* right : {"1.5", "0.14 nm", "1.3 Å", " 1.4 "}) {
    LessonSession session(sessionLesson(kSessionBody));
    session.next();
    for (const char* wrong : {"1.6", "14 nm"}) CHECK_FALSE(session.write(0, wrong));
    CHECK(plainText(session.feedback(0).at(0)) == "Measure again.");
    CHECK(session.question(0).attempts == 2);
    CHECK_FALSE(session.write(0, "  "));
    CHECK(session.question(0).attempts == 2);
    CHECK(session.write(0, right));
    // What is right stays so.
    CHECK_FALSE(session.write(0, "1.6"));
    CHECK(session.question(0).attempts == 3);
    CHECK_FALSE(session.write(1, "ridge"));
    CHECK(session.write(1, " Groove "));
  }
}

TEST_CASE("next, back and links move between 3 steps and stop at the ends; the scene's molecule follows") {
  LessonSession session(sessionLesson(kSessionBody));
  session.back();
  CHECK(session.stepIndex() == 0);
  const std::size_t scene = session.sceneNumber();
  session.next();
  CHECK(session.scene().molecule == "mix");
  session.next();
  CHECK(session.scene().molecule == "water");
  CHECK(session.sceneNumber() > scene);
  session.next();
  CHECK(session.stepIndex() == 2);
  CHECK(session.goTo("#a"));
  CHECK(session.stepIndex() == 0);
  CHECK_FALSE(session.goTo("#nowhere"));
  CHECK(session.stepIndex() == 0);
}

TEST_CASE("a lesson read again keeps the step by its id and what was done in steps of the same shape") {
  LessonSession session(sessionLesson(kSessionBody));
  session.choose(0, {0, 1});
  session.next();
  session.write(0, "1.4");
  session.replaceLesson(sessionLesson("## New\n```scene\nmolecule: mix\n```\n" + kSessionBody));
  CHECK(session.step().id == "b");
  CHECK(session.stepIndex() == 2);
  CHECK(session.question(0).answered_right);
  session.replaceLesson(sessionLesson("## Z\n```scene\nmolecule: mix\n```\n"));
  CHECK(session.stepIndex() == 0);
  CHECK(session.progress() == 1.0);
}

TEST_CASE("a step that has the same molecule with its waters is another scene: its tasks wait for that molecule") {
  LessonSession session(
      sessionLesson("## A\n```scene\nmolecule: mix\n```\nText.\n## B\n```scene\nwaters: yes\n```\n"
                    "```touch\nreach: atom 0\nsay: S\n```\n## C\n```scene\nprobe: 2 Å\n```\nText.\n"));
  session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  session.next();
  CHECK(session.scene().molecule == NamedMolecule("mix", {.waters = true}));
  CHECK(session.molecule() == nullptr);
  CHECK(session.taskAt(0) == nullptr);
  const auto with_waters = std::make_shared<const Molecule>(mixedMolecule());
  session.setMolecule(with_waters);
  session.next();
  CHECK(session.molecule() == with_waters.get());
}

TEST_CASE(
    "what a task draws is another for each student, sitting and time that the step is entered, and the same else") {
  const std::string body = "## A\n```scene\nmolecule: mix\n```\n```touch\nfind: atom 0\nsay: S\n```\n## B\nText.\n";
  const auto turnedFor = [&](std::uint64_t seed, std::size_t sitting, int entered) {
    LessonSession s(sessionLesson(body));
    s.setOrderSeed(seed, sitting);
    s.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
    for (int k = 0; k < entered; ++k) {
      s.next();
      s.back();
    }
    REQUIRE(s.taskStage().turned);
    return *s.taskStage().turned;
  };
  const Quat first = turnedFor(1, 0, 0);
  CHECK(turnedFor(1, 0, 0) == first);
  CHECK(turnedFor(2, 0, 0) != first);
  CHECK(turnedFor(1, 1, 0) != first);
  CHECK(turnedFor(1, 0, 1) != first);
  CHECK(turnedFor(1, 0, 2) != turnedFor(1, 0, 1));
}

TEST_CASE("one slide from atom 0 over the crease to atom 1 fulfils a task to feel the crease and one to cross it") {
  const auto two = sessionLesson(
      "## A\n```scene\nmolecule: mix\n```\n```touch\nfeel: crease\nsay: S\n```\n"
      "```touch\ncross: atom 0\nto: atom 1\nsay: T\n```\n");
  const auto slide = [&](LessonSession& s, double gap_s) {
    s.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
    double time_s = 0.0;
    const auto rest = [&](std::initializer_list<std::int32_t> atoms, double for_s) {
      for (int i = 0; i < int(for_s * 1000.0); ++i) {
        TouchSample sample;
        sample.time_s = time_s += 0.001;
        sample.contact.feature = static_cast<Feature>(atoms.size());
        std::copy(atoms.begin(), atoms.end(), sample.contact.atoms.begin());
        s.feed(sample);
      }
    };
    rest({0}, 0.3);
    rest({}, gap_s);
    rest({0, 1}, 0.3);
    CHECK(s.task(0).done);
    rest({1}, 0.3);
  };
  LessonSession slid(two), lifted(two);
  slide(slid, 0.0);
  CHECK(slid.task(1).done);
  // A hand that lost contact on the way has not slid.
  slide(lifted, 0.5);
  CHECK_FALSE(lifted.task(1).done);
}

TEST_CASE(
    "of four steps one of which is an aside the third that counts is step 3 of 3, and in the aside step 1 stays") {
  LessonSession s(
      sessionLesson("## A\n```scene\nmolecule: mix\n```\n[x](#aside-x)\n## Aside: X\nT\n## B\nT\n## C\nT\n"));
  CHECK(s.route().size() == 3);
  REQUIRE(s.goTo("#aside-x"));
  CHECK(s.numberOf(s.mainStepIndex()) == 1);
  REQUIRE(s.goTo("#c"));
  CHECK(s.numberOf(s.mainStepIndex()) == 3);
}
