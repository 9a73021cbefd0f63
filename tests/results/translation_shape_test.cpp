// A translation that a learning platform could not count together with its lesson.
#include "engine/results/translation_shape.h"

#include <doctest/doctest.h>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/platform/folders.h"
#include "engine/results/lesson_language.h"

namespace moltact {
namespace {

const std::string kHead =
    "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: argon-pair\nauthor: A\nlicence: CC-BY-4.0\n---\n";
const std::string kOne =
    "## One\n```scene\nmolecule: argon-pair\n```\n```touch\nreach: all\nsay: Touch it.\n```\n"
    "### Question: Q?\n- [x] yes → Right.\n- [ ] no → No.\n";
const std::string kTwo = "## Two\n```touch\npress: anywhere\nuntil: 0.8 N\nsay: Push.\n```\n";

Lesson read(const std::string& text) {
  LessonReading reading = readLessonText("lesson.md", kHead + text);
  REQUIRE(reading.lesson);
  return *std::move(reading.lesson);
}

std::string with(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  REQUIRE(at != std::string::npos);
  return text.replace(at, before.size(), after);
}

}  // namespace

TEST_CASE("a translation with other texts fits; each of 8 changes of shape is named at its line, with what to do") {
  const Lesson lesson = read(kOne + kTwo);
  CHECK_FALSE(translationFault(lesson, "l.md", read(with(with(kOne, "One", "Eins"), "yes", "ja") + kTwo), "l.de.md"));
  struct Case {
    std::string text;
    std::size_t line;
    std::string message;
  };
  for (const Case& c : {Case{kOne, 0, "it has 1 step, but l.md has 2"},
                        {kOne + kTwo + "## Three\nText.\n", 26, "it has 3 steps, but l.md has 2"},
                        {kOne + with(kTwo, "## Two", "## Aside: Two"), 20,
                         "step 2 is no part of the core, but that of "
                         "l.md is"},
                        {kOne + "## Two\nText.\n", 20, "step 2 has 0 tasks, that of l.md has 1"},
                        {kOne + with(kTwo, "press: anywhere\nuntil: 0.8 N", "reach: all"), 21,
                         "task 1 of step 2 is 'reach', that of l.md is 'press'"},
                        {with(kOne, "- [ ] no → No.\n", "- [ ] no → No.\n- [ ] or → No.\n") + kTwo, 17,
                         "question 1 of step 1 has 3 choices, that of l.md has 2"},
                        {with(with(kOne, "[x] yes", "[ ] yes"), "[ ] no", "[x] no") + kTwo, 17,
                         "question 1 of step 1 has other right choices than that of l.md"},
                        {kOne + kTwo + "### Question: More?\n- [x] a → b.\n- [ ] c → d.\n", 26,
                         "step 2 has 1 question, that of l.md has 0"}}) {
    CAPTURE(c.message);
    const Lesson translation = read(c.text);
    const auto fault = translationFault(lesson, "l.md", translation, "l.de.md");
    REQUIRE(fault);
    CHECK(fault->message == c.message);
    CHECK(fault->line == c.line);
    CHECK(fault->file == "l.de.md");
    CHECK(fault->remedy.find("same steps, tasks, questions and choices") != std::string::npos);
  }
}

TEST_CASE("every shipped translation has the shape of its lesson") {
  std::size_t pairs = 0;
  for (const auto& german : lessonsIn(lessonsFolder()).lessons) {
    const LessonName name = lessonName(german);
    if (name.language.empty()) continue;
    const auto english = german.parent_path() / (name.id + ".md");
    const LessonReading a = readLesson(english), b = readLesson(german);
    if (!a.lesson || !b.lesson) continue;
    ++pairs;
    const auto fault = translationFault(*a.lesson, english.filename().string(), *b.lesson, german.filename().string());
    CHECK_MESSAGE(!fault, (fault ? fault->text() : std::string()));
    CHECK(sameLesson(outlineOf(*a.lesson, {}), outlineOf(*b.lesson, {})));
  }
  CHECK(pairs > 5);
}

}  // namespace moltact
