// Lessons in German: the texts of tasks, the feedback to questions, the messages about a lesson's faults. The oracle is
// the small catalogue of tests/language; the program's own catalogue is used to check that every kind of task is
// translated.
#include <doctest/doctest.h>

#include "engine/language/catalogue.h"
#include "engine/language/figure_title.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/reference.h"
#include "engine/lesson/session.h"
#include "tests/language/in_german.h"
#include "tests/lesson/task_hand.h"

using namespace moltact;

TEST_CASE("hold says in German how long and how hard, with a decimal comma: 1,2 s of 2,0 s, 0,20 N") {
  const InGerman german;
  auto t = task("hold", {{"hold", "element O"}, {"for", "2 s"}, {"force", "0.2 N to 0.6 N"}});
  CHECK(t->sentence() == "Berühre ein Sauerstoffatom und bleib 2,0\u00a0s dort.");
  Hand hand{*t};
  hand.touch({3}, 0.1, 0.1);
  CHECK(t->sentence() == "Drücke etwas stärker: 0,20\u00a0N genügen.");
  hand.touch({3}, 1.2, 0.4);
  CHECK(t->sentence() == "Halte es: 1,2\u00a0s von 2,0\u00a0s.");
  hand.touch({3}, 1.0, 0.4);
  CHECK(t->done());
  CHECK(t->sentence() == "Geschafft.");
}

TEST_CASE("a task that is under way speaks the language that is chosen while it runs, and keeps the author's words") {
  auto t = task("hold", {{"hold", "element O"}, {"for", "2 s"}, {"praise", "Done."}});
  Hand{*t}.touch({1}, 0.1);
  CHECK(t->sentence() == "You are on the surface. Slide on to find an oxygen atom.");
  {
    const InGerman german;
    CHECK(t->sentence() == "Du bist auf der Oberfläche. Gleite weiter, bis du ein Sauerstoffatom findest.");
    Hand{*t, 1.0}.touch({3}, 2.1);
    CHECK(t->sentence() == "Done.");  // the author wrote it
  }
}

TEST_CASE("each kind of task begins with another sentence in German than in English") {
  const std::vector<std::pair<std::string, Keys>> kinds{
      {"reach", {{"reach", "element O"}}},
      {"hold", {{"hold", "crease"}}},
      {"press", {{"press", "pit"}, {"until", "0.4 N"}}},
      {"feel", {{"feel", "sphere, crease"}}},
      {"cross", {{"cross", "atom 0"}, {"to", "atom 1"}, {"times", "2"}}},
      {"avoid", {{"avoid", "chain B"}}},
      {"compare", {{"compare", "exact, mesh80"}}},
      {"meet", {{"meet", "jump"}}},
      {"trace", {{"trace", "crease"}, {"of", "all"}}},
      {"find", {{"find", "ligand"}}},
      {"predict", {{"predict", "anywhere"}}},
      {"same", {{"same", "anywhere"}, {"probe", "2 Å"}}},
      {"fit", {{"fit", "atom 0"}}},
      {"measure", {{"measure", "atom 0"}, {"to", "atom 3"}}},
      {"order", {{"order", "atom 0 then atom 5"}, {"first", "the smaller"}}},
      {"rank", {{"rank", "atom 0 then atom 5"}, {"first", "the firmest"}}},
      {"dock", {{"dock", "file"}}},
      {"pull", {{"pull", "5 Å"}}},
      {"pass", {{"pass", "atom 0-3"}}},
      {"contacts", {{"contacts", "anywhere"}}}};
  REQUIRE(kinds.size() == taskKinds().size());
  for (const auto& [kind, keys] : kinds) {
    CAPTURE(kind);
    auto t = task(kind, keys);
    const std::string english = t->sentence();
    const InGerman german(MOLTACT_TRANSLATIONS);
    CHECK(t->sentence() != english);
    CHECK(t->sentence() == task(kind, keys)->sentence());
    for (const TaskFigure& f : t->figures())
      CHECK_MESSAGE((f.name == "d'" || figureTitle(std::string(f.name)) != f.name), f.name);
  }
}

TEST_CASE(
    "a key of another task, a misspelt one and a time for a length are reported in German, the keys "
    "as they are") {
  const InGerman german;
  std::vector<Problem> problems;
  specOf("hold", {{"hold", "crease"}, {"fro", "2 s"}}, problems);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].message == "der Block touch kennt „fro“ nicht");
  CHECK(problems[0].remedy == "meintest du „for“?");
  CHECK(problemOf("reach", {{"reach", "element O"}, {"near", "4 s"}}) ==
        "„4 s“ ist eine Zeit, gebraucht wird eine Länge: Å oder nm");
  const auto why = parseSelection("chain C")->whyEmpty(mixedMolecule());
  CHECK(why.message == "in mix ist keine Kette C (A, B)");

  // Whose a key is does not hang on what the message says.
  const LessonReading read = readLessonText(
      "l.md",
      "---\ntitle: T\nminutes: 1\ngoals: g\nmolecules: water\nauthor: a\nlicence: l\n---\n## A\n```scene\nmolecule: "
      "water\n```\n```touch\nreach: element O\nuntil: 1 N\nsay: S\n```\n");
  REQUIRE(read.errors.size() == 1);
  CHECK(read.errors[0].message == "der Block touch kennt „until“ nicht");
  CHECK(read.errors[0].remedy == "dieser Schlüssel gehört zu „press“");
}

TEST_CASE(
    "an answer that is wrong is reported in German where the author wrote nothing, and in the "
    "author's words where so") {
  const std::string head =
      "---\ntitle: T\nminutes: 1\ngoals: g\nmolecules: water\nauthor: a\nlicence: l\n---\n## A\n```scene\nmolecule: "
      "water\n```\n### Question: N?\n```answer\nnumber: 2\n";
  for (const bool own : {false, true}) {
    const LessonReading read = readLessonText("l.md", head + (own ? "wrong: Not yet. Try again.\n```\n" : "```\n"));
    REQUIRE(read.lesson);
    LessonSession session(std::make_shared<const Lesson>(*read.lesson));
    CHECK_FALSE(session.write(0, "3"));
    const InGerman german;
    REQUIRE(session.feedback(0).size() == 1);
    CHECK(plainText(session.feedback(0)[0]) == (own ? "Not yet. Try again." : "Noch nicht."));
  }
}

TEST_CASE("the authors' reference is in English in every language") {
  const std::string english = lessonReference();
  const InGerman german(MOLTACT_TRANSLATIONS);
  CHECK(lessonReference() == english);
}
