// The report's data in the program's lessons: every goal has a task or question, and wrong choices name their
// misconceptions, in both languages alike.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "engine/lesson/lesson_files.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

std::vector<std::string> shippedNames() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons"))
    if (looksLikeLesson(entry.path())) out.push_back(entry.path().stem().string());
  std::sort(out.begin(), out.end());
  return out;
}

std::set<std::size_t> servedGoals(const Step& step) {
  std::set<std::size_t> out;
  for (const TaskSpec& t : step.tasks) out.insert(t.goals.begin(), t.goals.end());
  for (const Question& q : step.questions) out.insert(q.goals.begin(), q.goals.end());
  return out;
}

/// The tags of a lesson, one for each wrong choice that has one.
std::vector<std::string> tagsOf(const Lesson& lesson) {
  std::vector<std::string> out;
  for (const Step& step : lesson.steps)
    for (const Question& q : step.questions)
      for (const Choice& c : q.choices)
        if (!c.tag.empty()) out.push_back(c.tag);
  return out;
}

}  // namespace

TEST_CASE(
    "every goal of every shipped lesson is served by a task or a question of its way, and by none of a side path") {
  int goals = 0;
  for (const std::string& name : shippedNames()) {
    CAPTURE(name);
    const Lesson lesson = shippedLesson(name);
    std::set<std::size_t> served;
    for (const Step& step : lesson.steps) {
      // The report counts everything done for a goal; side paths are optional.
      if (step.aside) {
        CAPTURE(step.title);
        CHECK(servedGoals(step).empty());
      }
      served.merge(servedGoals(step));
    }
    for (std::size_t g = 0; g < lesson.goals.size(); ++g) CHECK_MESSAGE(served.count(g) == 1, lesson.goals[g]);
    goals += static_cast<int>(lesson.goals.size());
  }
  CHECK(goals >= 75);
}

TEST_CASE(
    "every shipped lesson with choices tags at least one misconception, on wrong choices and names it in a few words") {
  int tags = 0;
  for (const std::string& name : shippedNames()) {
    CAPTURE(name);
    const Lesson lesson = shippedLesson(name);
    bool choices = false;
    for (const Step& step : lesson.steps)
      for (const Question& q : step.questions)
        for (const Choice& c : q.choices) {
          CAPTURE(plainText(c.text));
          choices = true;
          CHECK_FALSE((c.right && !c.tag.empty()));
          // A tag is words of a line of the report, no sentence.
          if (!c.tag.empty()) CHECK(std::string(".!?").find(c.tag.back()) == std::string::npos);
        }
    const std::vector<std::string> here = tagsOf(lesson);
    CHECK((!choices || !here.empty()));
    tags += static_cast<int>(here.size());
  }
  CHECK(tags >= 240);
}

TEST_CASE(
    "a lesson and its German sister serve the same goals task by task and question by question and tag the same "
    "choices, and one misconception has one name in each language over all lessons") {
  std::map<std::string, std::string> german_of, english_of;
  int sisters = 0;
  for (const std::string& name : shippedNames()) {
    if (!name.ends_with(".de")) continue;
    CAPTURE(name);
    const Lesson english = shippedLesson(name.substr(0, name.size() - 3)), german = shippedLesson(name);
    CHECK(tagsOf(german).size() == tagsOf(english).size());
    REQUIRE(german.goals.size() == english.goals.size());
    REQUIRE(german.steps.size() == english.steps.size());
    for (std::size_t s = 0; s < english.steps.size(); ++s) {
      const Step &from = english.steps[s], &to = german.steps[s];
      CAPTURE(from.title);
      CHECK(to.goals == from.goals);
      REQUIRE(to.tasks.size() == from.tasks.size());
      for (std::size_t t = 0; t < from.tasks.size(); ++t) CHECK(to.tasks[t].goals == from.tasks[t].goals);
      REQUIRE(to.questions.size() == from.questions.size());
      for (std::size_t q = 0; q < from.questions.size(); ++q) {
        CHECK(to.questions[q].goals == from.questions[q].goals);
        REQUIRE(to.questions[q].choices.size() == from.questions[q].choices.size());
        for (std::size_t c = 0; c < from.questions[q].choices.size(); ++c) {
          const std::string &a = from.questions[q].choices[c].tag, &b = to.questions[q].choices[c].tag;
          CAPTURE(a);
          CAPTURE(b);
          CHECK(a.empty() == b.empty());
          if (a.empty() || b.empty()) continue;
          CHECK(german_of.emplace(a, b).first->second == b);
          CHECK(english_of.emplace(b, a).first->second == a);
        }
      }
    }
    ++sisters;
  }
  CHECK(sisters >= 12);
}
