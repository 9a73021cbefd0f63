// The form of the three concept tests: what a student could use instead of knowledge.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/session.h"

namespace moltact {
namespace {

constexpr std::array kTests{"surface-and-probe", "binding-and-inhibition", "dna-and-proteins"};

Lesson conceptTest(const std::string& name, const std::string& language) {
  const LessonReading reading =
      readLesson(std::string(MOLTACT_SOURCE_DIR "/assets/studies/") + name + (language == "en" ? "" : ".de") + ".md");
  for (const Problem& p : reading.errors) MESSAGE(p.text());
  for (const Problem& p : reading.warnings) MESSAGE(p.text());
  CHECK(reading.warnings.empty());
  REQUIRE(reading.lesson);
  return *reading.lesson;
}

std::size_t keyOf(const Question& question) {
  for (std::size_t k = 0; k < question.choices.size(); ++k)
    if (question.choices[k].right) return k;
  return question.choices.size();
}

std::size_t lengthOf(const Choice& choice) { return characterCount(plainText(choice.text)); }

}  // namespace

TEST_CASE(
    "each concept test has twelve items of four choices, each key three times, and a named misconception behind every "
    "wrong choice") {
  for (const char* name : kTests)
    for (const char* language : {"en", "de"}) {
      CAPTURE(name);
      CAPTURE(language);
      const Lesson test = conceptTest(name, language);
      CHECK(test.test);
      CHECK(test.language == language);
      REQUIRE(test.steps.size() == 12);
      std::array<int, 4> keys{};
      std::set<std::size_t> goals;
      for (const Step& step : test.steps) {
        REQUIRE(step.questions.size() == 1);
        const Question& question = step.questions[0];
        REQUIRE(question.choices.size() == 4);
        CHECK(question.rightChoices() == 1);
        ++keys[keyOf(question)];
        for (const Choice& choice : question.choices) {
          CHECK(choice.tag.empty() == choice.right);
          CHECK(choice.feedback.empty());
        }
        REQUIRE(question.goals.size() == 1);
        goals.insert(question.goals[0]);
      }
      for (const int n : keys) CHECK(n == 3);
      CHECK(goals.size() == test.goals.size());
    }
}

TEST_CASE(
    "the length of a choice tells nothing: the right one is the longest or the shortest as often as chance makes it") {
  int longest = 0, shortest = 0, items = 0;
  for (const char* name : kTests)
    for (const char* language : {"en", "de"}) {
      const Lesson test = conceptTest(name, language);
      for (const Step& step : test.steps) {
        const Question& question = step.questions[0];
        const std::size_t key = lengthOf(question.choices[keyOf(question)]);
        std::size_t longer = 0, shorter = 0;
        double others = 0.0;
        for (const Choice& choice : question.choices) {
          longer += lengthOf(choice) > key;
          shorter += lengthOf(choice) < key;
          if (!choice.right) others += double(lengthOf(choice)) / 3.0;
        }
        longest += longer == 0 && shorter == 3;
        shortest += shorter == 0 && longer == 3;
        ++items;
        CAPTURE(plainText(question.title));
        CHECK(double(key) / others > 0.75);
        CHECK(double(key) / others < 1.25);
      }
    }
  // 72 items, a quarter by chance: 18 with a standard deviation of 3.7.
  CHECK(items == 72);
  CHECK(longest <= 25);
  CHECK(shortest <= 25);
}

TEST_CASE("the German and the English of a concept test have the same keys, goals and numbers") {
  for (const char* name : kTests) {
    const Lesson english = conceptTest(name, "en"), german = conceptTest(name, "de");
    for (std::size_t s = 0; s < english.steps.size(); ++s) {
      const Question &a = english.steps[s].questions[0], &b = german.steps[s].questions[0];
      CHECK(keyOf(a) == keyOf(b));
      CHECK(a.goals == b.goals);
      const auto digits = [](const Question& q) {
        std::string all = plainText(q.title), out;
        for (const Choice& c : q.choices) all += plainText(c.text);
        for (const char c : all)
          if (c >= '0' && c <= '9') out += c;
        return out;
      };
      CHECK(digits(a) == digits(b));
    }
  }
}

TEST_CASE(
    "a test judges no answer before the student: each can be changed, none gets feedback, and the last one is "
    "reported") {
  LessonSession session(std::make_shared<const Lesson>(conceptTest("surface-and-probe", "en")));
  CHECK_FALSE(session.mayGoOn());
  const std::size_t key = keyOf(session.step().questions[0]);
  session.choose(0, {key});
  CHECK_FALSE(session.feedbackVisible(0));
  CHECK(session.feedback(0).empty());
  CHECK(session.takesAnswer(0));
  CHECK(session.mayGoOn());
  session.choose(0, {(key + 1) % 4});
  CHECK(session.question(0).chosen == std::vector{(key + 1) % 4});
  CHECK_FALSE(session.question(0).last_right);
  const std::vector<SessionEvent>& events = session.events();
  const auto& last = std::get<AnswerJudged>(events.back());
  CHECK(last.attempt == 2);
  CHECK_FALSE(last.right);
}

}  // namespace moltact
