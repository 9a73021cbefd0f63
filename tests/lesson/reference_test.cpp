// The pages for authors agree with the program: the reference with the tables, the first lesson with the checks.
#include "engine/lesson/reference.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/lesson/check.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/new_lesson.h"
#include "engine/lesson/tasks/registry.h"

using namespace moltact;

namespace {

std::string contents(const std::string& file) {
  std::ifstream in(MOLTACT_SOURCE_DIR "/" + file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

LessonCheck referenceChecked(const std::string& text) {
  LessonMolecules molecules;
  return checkLesson("lesson.md", text, [&](const NamedMolecule& name) { return molecules.find("lesson.md", name); });
}

/// The contents of a page's fenced blocks of the given kinds, in order.
std::string fences(const std::string& page, const std::string& from, const std::string& to) {
  std::istringstream in(page);
  std::string line, out, close;
  bool here = false;
  while (std::getline(in, line)) {
    if (line.starts_with(from)) here = true;
    if (line.starts_with(to)) here = false;
    if (!here) continue;
    if (!close.empty()) {
      if (line == close) {
        close.clear();
        out += '\n';
      } else {
        out += line + '\n';
      }
    } else if (line == "```yaml" || line == "````markdown") {
      close = line.substr(0, line.find_first_of("ym"));
    }
  }
  return out;
}

}  // namespace

TEST_CASE("docs/lesson-reference.md is what `moltact lesson-reference` prints") {
  const bool same = contents("docs/lesson-reference.md") == lessonReference();
  CHECK_MESSAGE(same, "renew it: build/release/moltact lesson-reference > docs/lesson-reference.md");
}

TEST_CASE("the reference has every key of every table, and a heading for every kind of task") {
  const std::string page = lessonReference();
  for (const KeyBlock block :
       {KeyBlock::FrontMatter, KeyBlock::Step, KeyBlock::Scene, KeyBlock::Touch, KeyBlock::Answer, KeyBlock::Facts})
    for (const KeySpec& k : keysOf(block))
      CHECK(page.find("\n| `" + std::string(k.name) + "` | ") != std::string::npos);
  for (const TaskKind& kind : taskKinds()) {
    const std::size_t at = page.find("\n### " + std::string(kind.name) + "\n");
    REQUIRE(at != std::string::npos);
    for (const KeySpec& k : kind.keys)
      CHECK(page.find("\n| `" + std::string(k.name) + "` | ", at) != std::string::npos);
  }
}

TEST_CASE("docs/writing-tasks.md says of every kind of task how a looker, a guesser and a jabber fare") {
  const std::string page = contents("docs/writing-tasks.md");
  for (const TaskKind& kind : taskKinds()) {
    CAPTURE(kind.name);
    CHECK(page.find("\n| `" + std::string(kind.name) + "` | ") != std::string::npos);
  }
}

TEST_CASE("the lesson that docs/write-a-lesson.md builds up has 2 steps, 2 tasks and 1 question, and no fault") {
  const LessonCheck check = referenceChecked(fences(contents("docs/write-a-lesson.md"), "## 2.", "## 6."));
  for (const auto* list : {&check.errors, &check.warnings})
    for (const Problem& p : *list) FAIL_CHECK(p.text());
  REQUIRE(check.lesson);
  REQUIRE(check.lesson->steps.size() == 2);
  CHECK(check.lesson->steps[0].tasks.size() == 2);
  CHECK(check.lesson->steps[1].questions.size() == 1);
}

TEST_CASE("a new lesson has no fault, and its name makes its title and file") {
  const LessonCheck check = referenceChecked(newLessonText("Haem pockets"));
  for (const auto* list : {&check.errors, &check.warnings})
    for (const Problem& p : *list) FAIL_CHECK(p.text());
  REQUIRE(check.lesson);
  CHECK(check.lesson->title == "Haem pockets");
  CHECK(check.lesson->steps.size() == 3);
  CHECK(lessonFileName("Haem pockets") == "haem-pockets.md");
  CHECK(lessonFileName("haem-pockets.md") == "haem-pockets.md");
  CHECK(lessonFileName(" ?! ").empty());
  CHECK(lessonTitle("haem-pockets.md") == "Haem pockets");
  CHECK(lessonTitle("A well-known pocket") == "A well-known pocket");
}
