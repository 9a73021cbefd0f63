// Conditions, tries and required steps: the effects of answers on the order of steps, and the messages for authors.
#include "engine/lesson/step_rules.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "engine/core/random.h"
#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/session.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const std::string kStepRulesHead =
    "---\ntitle: T\nminutes: 1\ngoals:\n- One\n- Two\nmolecules: mix\nauthor: A\nlicence: L\n---\n";
const std::string kStepRulesScene = "```scene\nmolecule: mix\n```\n";
const std::string kChoices = "### Question: Q?\n- [ ] no → Look [again](#aside-why).\n- [x] yes → So it is.\n";

std::string answer(const std::string& lines) { return "```answer\n" + lines + "```\n"; }

// Three steps and an aside; a question with these lines in the second.
std::string withRules(const std::string& lines) {
  return "## A\nText.\n" + kStepRulesScene + "## B\n" + kChoices + answer(lines) +
         "## C\nText.\n### Question: C?\n- [x] x\n- [ ] y\n## D\nText.\n## Aside: Why\nText.\n";
}

std::shared_ptr<const Lesson> stepRulesLesson(const std::string& body) {
  LessonReading read = readLessonText("l.md", kStepRulesHead + body);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

LessonCheck stepRulesChecked(const std::string& body) {
  return checkLesson("l.md", kStepRulesHead + body,
                     [](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
                       return std::make_shared<const Molecule>(mixedMolecule());
                     });
}

std::size_t lineOf(const std::string& body, std::string_view text) {
  const std::string all = kStepRulesHead + body;
  return std::size_t(std::count(all.begin(), all.begin() + std::ptrdiff_t(all.find(text)), '\n')) + 1;
}

const std::vector<std::size_t> kWrong{0}, kRight{1};

}  // namespace

TEST_CASE(
    "after two wrong answers Next leads into the aside once; the question waits for it, and continues afterwards") {
  LessonSession s(stepRulesLesson(withRules("after 2 wrong: go to #aside-why\n")));
  s.next();
  s.choose(0, kWrong);
  CHECK_FALSE(s.leadsTo());
  s.choose(0, kWrong);
  REQUIRE(s.leadsTo());
  CHECK(s.lesson().steps[*s.leadsTo()].id == "aside-why");
  CHECK_FALSE(s.takesAnswer(0));
  CHECK_FALSE(s.choose(0, kRight));
  CHECK(s.question(0).attempts == 2);
  s.next();
  CHECK(s.step().id == "aside-why");
  s.next();
  CHECK(s.step().id == "b");
  CHECK_FALSE(s.leadsTo());
  CHECK(s.takesAnswer(0));
  s.choose(0, kWrong);
  CHECK_FALSE(s.leadsTo());
  CHECK(s.choose(0, kRight));
  s.next();
  CHECK(s.step().id == "c");
}

TEST_CASE("a step is named by its link or its heading, an aside with or without the word") {
  for (const char* name : {"#aside-why", "Aside: Why", "Why", "aside-why"}) {
    CAPTURE(name);
    const auto l = stepRulesLesson(withRules("after 1 wrong: go to " + std::string(name) + "\n"));
    CHECK(l->steps[1].questions[0].rules[0].steps == std::vector<std::string>{"aside-why"});
  }
}

TEST_CASE(
    "'if right: skip' passes a step over and takes it out of the progress, at whichever try; 'at first' at the first "
    "only") {
  for (const bool at_first_only : {false, true})
    for (const bool wrong_before : {false, true}) {
      CAPTURE(at_first_only);
      CAPTURE(wrong_before);
      LessonSession s(
          stepRulesLesson(withRules(at_first_only ? "if right at first: skip #c\n" : "if right: skip #c\n")));
      s.next();
      if (wrong_before) s.choose(0, kWrong);
      s.choose(0, kRight);
      const bool skips = !at_first_only || !wrong_before;
      CHECK(s.skipped(2) == skips);
      CHECK(s.parts().of == (skips ? 1 : 2));
      s.next();
      CHECK(s.step().id == (skips ? "d" : "c"));
      CHECK(s.finished() == skips);
      s.back();
      CHECK(s.step().id == "b");
    }
}

TEST_CASE("leading forward passes over what stands between, also when one comes back and continues by Next") {
  LessonSession s(stepRulesLesson(withRules("if right: go to #d\n")));
  s.next();
  s.choose(0, kRight);
  s.next();
  CHECK(s.step().id == "d");
  s.back();
  CHECK(s.step().id == "b");
  s.next();
  CHECK(s.step().id == "d");
  CHECK(s.finished());
}

TEST_CASE("after the last try the right answer stands there and one continues; it counts as done and not as right") {
  LessonSession s(stepRulesLesson("## A\n" + kStepRulesScene + kChoices + answer("attempts: 2\n") +
                                  "### Question: N?\n" + answer("number: 1.4 Å\ntolerance: 0.1 Å\nattempts: 1\n") +
                                  "### Question: W?\n" + answer("text: crease, groove\nattempts: 1\nwrong: No.\n") +
                                  "## Aside: Why\nText.\n"));
  CHECK(s.triesLeft(0) == 2);
  s.choose(0, kWrong);
  CHECK(s.triesLeft(0) == 1);
  CHECK(plainText(s.feedback(0).back()) == "1 try is left.");
  s.choose(0, kWrong);
  CHECK(s.question(0).shown);
  CHECK_FALSE(s.question(0).answered_right);
  CHECK_FALSE(s.takesAnswer(0));
  CHECK_FALSE(s.choose(0, kRight));
  REQUIRE(s.feedback(0).size() == 3);
  CHECK(plainText(s.feedback(0)[1]) == "That was the last try. Right is: yes");
  CHECK(plainText(s.feedback(0)[2]) == "So it is.");
  s.write(1, "3");
  REQUIRE(s.feedback(1).size() == 1);
  CHECK(plainText(s.feedback(1)[0]) == "That was the last try. Right is: 1.4\u00a0Å");
  s.write(2, "pit");
  REQUIRE(s.feedback(2).size() == 2);
  CHECK(plainText(s.feedback(2)[0]) == "No.");
  CHECK(plainText(s.feedback(2)[1]) == "That was the last try. Right is: crease");
  CHECK(s.finished());
}

TEST_CASE("a required step is left by Next and by links only once it is done, by an answer that leads away, and back") {
  const std::string required = "```step\nrequired: yes\n```\n";
  LessonSession s(stepRulesLesson("## A\n" + kStepRulesScene + "## B\n" + required + kChoices +
                                  answer("after 2 wrong: go to #aside-why\n") + "## C\nText.\n## Aside: Why\nText.\n"));
  s.next();
  CHECK_FALSE(s.mayGoOn());
  s.next();
  CHECK(s.step().id == "b");
  CHECK_FALSE(s.mayGoTo("#c"));
  CHECK(s.mayGoTo("#a"));
  CHECK(s.mayGoTo("#aside-why"));
  s.choose(0, kWrong);
  s.choose(0, kWrong);
  CHECK(s.mayGoOn());
  s.next();
  CHECK(s.step().id == "aside-why");
  CHECK_FALSE(s.mayGoTo("#c"));
  s.next();
  CHECK_FALSE(s.mayGoOn());
  s.choose(0, kRight);
  CHECK((s.mayGoOn() && s.mayGoTo("#c")));
  s.next();
  CHECK(s.step().id == "c");
  s.back();
  CHECK(s.step().id == "b");
}

TEST_CASE("'required' in the front matter holds for every step that does not say otherwise, and for no aside") {
  std::string head = kStepRulesHead;
  head.insert(head.find("molecules"), "required: yes\n");
  const LessonReading read =
      readLessonText("l.md", head + "## A\n" + kStepRulesScene +
                                 "## B\n```step\nrequired: no\n```\nText.\n## Aside: C\nText. [a](#aside-c)\n");
  REQUIRE(read.lesson);
  CHECK(read.lesson->required);
  CHECK(read.lesson->steps[0].required);
  CHECK_FALSE(read.lesson->steps[1].required);
  CHECK_FALSE(read.lesson->steps[2].required);
}

TEST_CASE("earlier work is restored: used tries, a pending move to another step, and one that was made") {
  const auto l = stepRulesLesson(withRules("attempts: 3\nafter 2 wrong: go to #aside-why\n"));
  for (const bool gone : {false, true}) {
    CAPTURE(gone);
    LessonSession s(l);
    SessionMemory memory{"b", {{"b", {}, {}, {{"q", {}}}}}};
    memory.steps[0].questions[0].second.attempts = 2;
    memory.steps[0].questions[0].second.chosen = kWrong;
    memory.steps[0].questions[0].second.left_since_answer = gone;
    s.restore(memory);
    CHECK(s.leadsTo().has_value() != gone);
    CHECK(s.takesAnswer(0) == gone);
  }
  LessonSession s(l);
  SessionMemory memory{"b", {{"b", {}, {}, {{"q", {}}}}}};
  memory.steps[0].questions[0].second.attempts = 3;
  s.restore(memory);
  CHECK(s.question(0).shown);
  CHECK_FALSE(s.takesAnswer(0));
}

TEST_CASE(
    "no rules trap a student: of 2000 lessons with random rules each is finished by Next and right "
    "answers") {
  std::uint64_t seed = 20261123;
  MESSAGE("seed ", seed);
  const auto draw = [&](std::size_t below) { return std::size_t(nextRandom(seed) % below); };
  std::set<std::size_t> lengths;
  for (int run = 0; run < 2000; ++run) {
    const std::size_t steps = 2 + draw(5);
    std::string body;
    for (std::size_t k = 0; k < steps; ++k) {
      const bool aside = k > 0 && draw(4) == 0;
      body += "## " + std::string(aside ? "Aside: " : "") + "S" + std::to_string(k) + "\n" +
              (k == 0 ? kStepRulesScene : "") + "Text.\n" + (!aside && draw(2) ? "```step\nrequired: yes\n```\n" : "") +
              "### Question: Q?\n- [ ] no\n- [x] yes\n```answer\n" + (draw(3) ? "" : "attempts: 3\n");
      for (const char* when : {"if right", "if right at first", "after 1 wrong", "after 2 wrong"})
        if (const std::size_t to = draw(steps); draw(2) && to != k)
          body += when + std::string(draw(2) ? ": go to S" : ": skip S") + std::to_string(to) + "\n";
      body += "```\n";
    }
    LessonReading read = readLessonText("l.md", kStepRulesHead + body);
    CAPTURE(body);
    REQUIRE(read.lesson);
    LessonSession s(std::make_shared<const Lesson>(*std::move(read.lesson)));
    std::size_t moves = 0;
    std::vector<std::size_t> wrong(steps, 0);
    for (std::size_t& w : wrong) w = draw(4);
    for (; s.hasNext() && moves < 200; ++moves) {
      while (s.takesAnswer(0)) s.choose(0, wrong[s.stepIndex()] > 0 ? (--wrong[s.stepIndex()], kWrong) : kRight);
      REQUIRE(s.mayGoOn());
      s.next();
    }
    CHECK(moves < 200);
    lengths.insert(moves);
  }
  CHECK(lengths.size() > 5);
}

TEST_CASE("each mistake in a condition is reported at its line") {
  struct Mistake {
    std::string lines, at, says;
    bool warning = false;
  };
  const Mistake mistakes[]{
      {"after 2 wrong: go to #asid-why\n", "after 2", "aside-why"},
      {"after 2 wrong: #aside-why\n", "after 2", "does not say where to go"},
      {"after two wrong: go to #aside-why\n", "after two", "no number of wrong answers"},
      {"after 2 wrong: go to #b\n", "after 2", "the student is at"},
      {"after 2 wrong: go to #c, #d\n", "after 2", "one step only"},
      {"attempts: 2\nafter 3 wrong: go to #aside-why\n", "after 3", "never happens"},
      {"if right: skip #aside-why\n", "if right", "not on the way"},
      {"if right: skip #a\n", "if right", "have passed it", true},
      {"if wrong: go to #aside-why\n", "if wrong", "after 2 wrong"},
      {"if correct: skip #c\n", "if correct", "if right"},
      {"attempts: 0\n", "attempts", "too small"},
      {"goal: 3\n", "goal", "no goal 3"},
      {"goal: 1, x\n", "goal", "x"},
      {"right: Yes.\n", "right", "choice"},
  };
  for (const Mistake& m : mistakes) {
    CAPTURE(m.lines);
    const std::string body = withRules(m.lines) + "[why](#aside-why)\n";
    const LessonCheck found = stepRulesChecked(body);
    const std::vector<Problem>& reported = m.warning ? found.warnings : found.errors;
    CHECK(std::any_of(reported.begin(), reported.end(), [&](const Problem& p) {
      return p.line == lineOf(body, m.lines) + (m.lines.starts_with(m.at) ? 0 : 1) &&
             (p.message + p.remedy).find(m.says) != std::string::npos && !p.remedy.empty();
    }));
    CHECK(found.errors.size() == (m.warning ? 0 : 1));
  }
}

TEST_CASE(
    "a condition on answers that are not judged is reported, as are a required aside and a required "
    "step without anything to do") {
  const auto line = [](const std::string& body, std::string_view at, bool warning = false) {
    const LessonCheck found = stepRulesChecked(body);
    const std::vector<Problem>& reported = warning ? found.warnings : found.errors;
    return std::any_of(reported.begin(), reported.end(), [&](const Problem& p) { return p.line == lineOf(body, at); });
  };
  CHECK(line("## A\n" + kStepRulesScene + "### Question: F?\n" + answer("free: yes\nattempts: 2\n"), "attempts: 2"));
  CHECK(line("## A\n" + kStepRulesScene + "### Prediction: F?\n- [ ] a\n- [x] b\n" + answer("if right: skip B\n") +
                 "## B\nT.\n",
             "if right"));
  CHECK(
      line("## A\n" + kStepRulesScene + "[w](#aside-w)\n## Aside: W\n```step\nrequired: yes\n```\nText.\n", "```step"));
  CHECK(line("## A\n" + kStepRulesScene + "## B\n```step\nrequired: yes\n```\nText.\n", "```step", true));
  CHECK(line("## A\n" + kStepRulesScene + "## B\n```step\ngoal: 1\n```\n```step\ngoal: 2\n```\nText.\n",
             "```step\ngoal: 2"));
}

TEST_CASE("an aside to which only a condition leads is reached; goals of a step are those of its parts") {
  const LessonCheck found =
      stepRulesChecked("## A\n```step\ngoal: 1, 2\n```\n" + kStepRulesScene +
                       "```touch\nreach: atom 0\nsay: S\n```\n```touch\nreach: atom 0\nsay: S\ngoal: 2\n```\n" +
                       kChoices + answer("after 1 wrong: go to Why\n") + "## Aside: Why\nText.\n");
  REQUIRE(found.lesson);
  CHECK(found.errors.empty());
  using Goals = std::vector<std::size_t>;
  CHECK(found.lesson->steps[0].tasks[0].goals == Goals{0, 1});
  CHECK(found.lesson->steps[0].tasks[1].goals == Goals{1});
  CHECK(found.lesson->steps[0].questions[0].goals == Goals{0, 1});
}
