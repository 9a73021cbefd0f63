// Questions, predictions and free answers of a lesson: what counts as an attempt, which feedback is given when, and the
// order of choices.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/session.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const std::string kQuestionHead = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n";
const std::string kQuestionScene = "## A\n```scene\nmolecule: mix\n```\n";
const std::string kTouch = "```touch\nreach: atom 0\nsay: S\npraise: P.\n```\n";
const std::string kPrediction =
    "### Prediction: P?\n- [ ] up → It went down.\n- [x] down → So it is.\n- [ ] aside → No.\n";

std::shared_ptr<const Lesson> questionLesson(const std::string& body) {
  LessonReading read = readLessonText("l.md", kQuestionHead + body);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

std::vector<Problem> questionErrorsOf(const std::string& body) {
  return readLessonText("l.md", kQuestionHead + body).errors;
}

void touchAtom0(LessonSession& session) {
  for (int i = 0; i <= 150; ++i) {
    TouchSample s;
    s.time_s = i * 0.001;
    s.contact.feature = Feature::Sphere;
    s.contact.atoms[0] = 0;
    session.feed(s);
  }
}

}  // namespace

TEST_CASE("a prediction can be changed, and gets no feedback, until the step's task is done; then it stays") {
  LessonSession session(questionLesson(kQuestionScene + kPrediction + kTouch));
  session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  CHECK(session.step().questions[0].prediction);
  CHECK(session.takesAnswer(0));
  session.choose(0, {1});
  CHECK_FALSE(session.feedbackVisible(0));
  CHECK(session.feedback(0).empty());
  session.choose(0, {0});
  CHECK(session.question(0).attempts == 2);
  CHECK(session.question(0).answered_right);  // nothing is left to do with it
  CHECK(session.feedback(0).empty());
  touchAtom0(session);
  REQUIRE(session.task(0).done);
  CHECK(session.feedbackVisible(0));
  CHECK(plainText(session.feedback(0).at(0)) == "It went down.");
  CHECK_FALSE(session.takesAnswer(0));
  CHECK_FALSE(session.choose(0, {1}));
  CHECK(session.question(0).chosen == std::vector<std::size_t>{0});
  CHECK(session.question(0).attempts == 2);
  CHECK(session.finished());
}

TEST_CASE("a prediction made after the touch is resolved at once; a step is not done without its prediction") {
  LessonSession session(questionLesson(kQuestionScene + kPrediction + kTouch));
  session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  touchAtom0(session);
  CHECK_FALSE(session.stepDone());
  CHECK(session.takesAnswer(0));
  CHECK(session.choose(0, {1}));
  CHECK(plainText(session.feedback(0).at(0)) == "So it is.");
  CHECK(session.stepDone());
}

TEST_CASE("a prediction without a task is warned of, one that is a free answer is an error") {
  const LessonCheck found = checkLesson("l.md", kQuestionHead + kQuestionScene + kPrediction,
                                        [](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
                                          return std::make_shared<const Molecule>(mixedMolecule());
                                        });
  CHECK(std::any_of(found.warnings.begin(), found.warnings.end(), [](const Problem& p) {
    return p.message.find("prediction") != std::string::npos && p.line == 13;
  }));
  const auto errors = questionErrorsOf(kQuestionScene + "### Prediction: P?\n```answer\nfree: yes\n```\n" + kTouch);
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].line == 13);
}

TEST_CASE(
    "an answer that is not a number is asked again and is not an attempt: words, another quantity, nothing; a comma is "
    "one") {
  LessonSession session(
      questionLesson(kQuestionScene + "### Question: N?\n```answer\nnumber: 1.4 Å\ntolerance: 0.1 Å\n```\n"));
  for (const char* none : {"about 1.4", "1.4 N", "so wide"}) {
    CHECK_FALSE(session.write(0, none));
    CHECK(session.question(0).attempts == 0);
    CHECK(session.question(0).again.find(none) != std::string::npos);
    CHECK(session.feedback(0).empty());
  }
  CHECK_FALSE(session.write(0, "1.6"));
  CHECK(session.question(0).attempts == 1);
  CHECK(session.question(0).again.empty());
  CHECK(session.write(0, "0.14 nm"));
  CHECK(session.question(0).attempts == 2);
}

TEST_CASE("a free answer is kept and never called right; the author's own stands beside it afterwards") {
  LessonSession session(
      questionLesson(kQuestionScene + "### Question: Why?\n```answer\nfree: yes\nmodel: Because it fits.\n```\n"));
  CHECK(session.feedback(0).empty());
  session.write(0, "It does not.");
  REQUIRE(session.feedback(0).size() == 1);
  CHECK(plainText(session.feedback(0)[0]) == "Because it fits.");
  CHECK(session.stepDone());
  const auto errors = questionErrorsOf(kQuestionScene + "### Question: N?\n```answer\nnumber: 1\nmodel: One.\n```\n");
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].line == 16);
}

TEST_CASE(
    "choices stand as written without a seed and in a numbered list; else each of 4 comes first in 22 to 28 % of "
    "4000") {
  const std::string four = "- [ ] a → A\n- [x] b → B\n- [ ] c → C\n- [ ] d → D\n",
                    numbered = "1. [ ] a → A\n2. [x] b → B\n3. [ ] c → C\n";
  LessonSession session(questionLesson(kQuestionScene + "### Question: Q?\n" + four + "### Question: R?\n" + four +
                                       "### Question: O?\n" + numbered));
  const std::vector<std::size_t> written{0, 1, 2, 3};
  CHECK(session.choiceOrder(0) == written);
  std::array<int, 4> first{};
  int alike = 0;
  std::set<std::vector<std::size_t>> orders;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    session.setOrderSeed(seed);
    const auto order = session.choiceOrder(0);
    CHECK(std::is_permutation(order.begin(), order.end(), written.begin(), written.end()));
    ++first[order[0]];
    alike += order == session.choiceOrder(1);
    orders.insert(order);
    CHECK(session.choiceOrder(0) == order);
    CHECK(session.choiceOrder(2) == std::vector<std::size_t>{0, 1, 2});
  }
  for (const int n : first) CHECK((n > 880 && n < 1120));
  CHECK(orders.size() == 24);
  CHECK((alike > 100 && alike < 240));  // 1 of 24, by chance
  // What is chosen is what was written there, wherever it stands.
  CHECK(session.choose(0, {1}));
}

TEST_CASE("a question all of whose choices are right, and a number with decimals without tolerance, are warned of") {
  const auto warnings =
      readLessonText("l.md", kQuestionHead + kQuestionScene + "### Question: Q?\n- [x] a → A\n- [x] b → B\n" +
                                 "### Question: N?\n```answer\nnumber: 1.4 Å\n```\n")
          .warnings;
  REQUIRE(warnings.size() == 2);
  CHECK(warnings[0].line == 13);
  CHECK(warnings[1].line == 18);
}
