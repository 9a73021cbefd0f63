// The outcomes of a class by goal, by misconception, and by the order of steps. Oracles: the sessions at their end, and
// manual counts.
#include <doctest/doctest.h>

#include <algorithm>

#include "engine/results/class_csv.h"
#include "engine/results/class_page.h"
#include "engine/results/progress.h"
#include "engine/results/session_facts.h"
#include "tests/results/sample_attempt.h"
#include "tests/results/small_lesson.h"

namespace moltact {
namespace {

std::shared_ptr<const Lesson> branchingLesson() {
  LessonReading read = readLessonText(
      "lessons/ways.md",
      "---\ntitle: Ways\nminutes: 1\ngoals:\n- Feel it\n- Say it\nmolecules: mix\nauthor: A\nlicence: L\n---\n"
      "## One\n```step\ngoal: 2\n```\n```scene\nmolecule: mix\n```\n"
      "### Question: Which?\n- [x] yes → Good.\n- [ ] no → See below. → thinks no\n- [ ] never → No. → thinks no\n"
      "```answer\nattempts: 3\nafter 2 wrong: go to Why\nif right at first: skip #two\n```\n"
      "## Two\n```touch\nreach: atom 0\nsay: S\ngoal: 1\n```\n"
      "## Three\n### Question: How?\n- [x] so\n- [ ] thus → No. → thinks thus\n```answer\ngoal: 1, 2\n```\n"
      "## Aside: Why\nText.\n");
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

// A student in the lesson, kept as a file line by line and read back.
struct WayStudent {
  explicit WayStudent(const std::string& name) : session(lesson) {
    session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
    AttemptHeader header;
    header.began = "2026-11-21T10:58:14Z";
    header.student = name;
    header.lesson = outlineOf(*lesson, "0");
    file = lineOf(header);
    keep();
  }
  void keep() {
    t_s += 1.0;
    for (const SessionEvent& e : session.takeEvents()) file += lineOf(facts.factOf(e, t_s, InputKind::Mouse));
    file += lineOf({t_s, SessionFacts::progressOf(session)});
  }
  void choose(std::size_t choice) {
    session.choose(0, {choice});
    keep();
  }
  void next() {
    session.next();
    keep();
  }
  Attempt attempt() const {
    const ScratchFolder scratch;
    writeFile(scratch.path / "a.jsonl", file);
    const Expected<Attempt> read = readAttempt(scratch.path / "a.jsonl", ReadDepth::NoHipSamples);
    REQUIRE(bool(read));
    CHECK(read->problems.empty());
    return *read;
  }

  std::shared_ptr<const Lesson> lesson = branchingLesson();
  LessonSession session;
  SessionFacts facts;
  std::string file;
  double t_s = 0.0;
};

// Right at first: step 2 is skipped.
WayStudent quick() {
  WayStudent s("Quick");
  s.choose(0);
  s.next();
  s.choose(0);
  return s;
}

// Wrong twice, to the aside and back, right; the touch done; wrong once at the end.
WayStudent winding() {
  WayStudent s("Winding");
  s.choose(1);
  s.choose(2);
  s.next();
  s.next();
  s.choose(0);
  s.next();
  touchFor150ms(s.session, 0, 100.0);
  s.keep();
  s.next();
  s.choose(1);
  s.choose(0);
  return s;
}

// Wrong three times: the tries are used up.
WayStudent stuck() {
  WayStudent s("Stuck");
  s.choose(1);
  s.choose(1);
  s.next();
  s.next();
  s.choose(2);
  return s;
}

}  // namespace

TEST_CASE(
    "an attempt that is taken up again stands where it stood, whatever the student had done with the conditions") {
  for (const WayStudent& before : {quick(), winding(), stuck()}) {
    CAPTURE(before.file);
    const SessionMemory memory = memoryOf(before.attempt());
    LessonSession after(before.lesson);
    after.restore(memory);
    CHECK(after.stepIndex() == before.session.stepIndex());
    CHECK(after.progress() == before.session.progress());
    CHECK(after.leadsTo() == before.session.leadsTo());
    for (std::size_t s = 0; s < before.lesson->steps.size(); ++s) {
      CHECK(after.skipped(s) == before.session.skipped(s));
      CHECK(after.stepDone(s) == before.session.stepDone(s));
      for (std::size_t q = 0; q < before.lesson->steps[s].questions.size(); ++q) {
        CHECK(after.question(s, q).shown == before.session.question(s, q).shown);
        CHECK(after.question(s, q).left_since_answer == before.session.question(s, q).left_since_answer);
      }
    }
  }
  // In the middle: sent to the aside but not there yet, then there.
  WayStudent waits("Waits");
  waits.choose(1);
  waits.choose(1);
  LessonSession after(waits.lesson);
  after.restore(memoryOf(waits.attempt()));
  REQUIRE(after.leadsTo());
  CHECK_FALSE(after.takesAnswer(0));
  waits.next();
  waits.next();
  LessonSession later(waits.lesson);
  later.restore(memoryOf(waits.attempt()));
  CHECK_FALSE(later.leadsTo());
  CHECK(later.takesAnswer(0));
}

TEST_CASE("the report lists the steps of each student, with the rules that led there") {
  const ClassSummary summary = summarise({quick().attempt(), winding().attempt(), stuck().attempt()});
  REQUIRE(summary.lessons.size() == 1);
  const auto ways = [&](const std::string& name) {
    for (const PersonScore& p : summary.lessons[0].people)
      if (p.person == name) return wayText(summary.lessons[0].lesson, p);
    return std::string();
  };
  CHECK(ways("Quick") == "1 (if right at first: skips 2) 3");
  CHECK(ways("Winding") == "1 (after 2 wrong: goes to a1) a1 1 2 3");
  CHECK(ways("Stuck") == "1 (after 2 wrong: goes to a1) a1 1");
  CHECK(classPage(summary, {}, "").find("a1 1 2 3") != std::string::npos);
  CHECK(classCsv(summary).find("1 (after 2 wrong: goes to a1) a1 1 2 3") != std::string::npos);
}

TEST_CASE("who skips a step is finished without it; who used up the tries continued without being right") {
  const ClassSummary summary = summarise({quick().attempt(), winding().attempt(), stuck().attempt()});
  for (const PersonScore& p : summary.lessons[0].people) {
    CAPTURE(p.person);
    CHECK(p.finished() == (p.person != "Stuck"));
    CHECK(p.answers.at({"one", "which"}).right == (p.person != "Stuck"));
    if (p.person == "Quick") CHECK((p.done == 2 && p.of == 2));
    if (p.person == "Stuck") CHECK((p.done == 1 && p.of == 3));
  }
}

TEST_CASE("each goal counts its own tasks and questions, with what was done and what was right at first") {
  const ClassSummary summary = summarise({quick().attempt(), winding().attempt(), stuck().attempt()});
  const LessonSummary& lesson = summary.lessons[0];
  CHECK(lesson.lesson.goals == std::vector<std::string>{"Feel it", "Say it"});
  // By hand, of parts, done, answered, right at first. Goal 1: the touch and the last question; goal 2: both questions.
  const std::map<std::string, std::array<std::array<std::size_t, 4>, 2>> wanted{
      {"Quick", {{{2, 1, 1, 1}, {2, 2, 2, 2}}}},
      {"Winding", {{{2, 2, 1, 0}, {2, 2, 2, 0}}}},
      {"Stuck", {{{2, 0, 0, 0}, {2, 0, 1, 0}}}}};
  for (const PersonScore& p : lesson.people)
    for (std::size_t g = 0; g < 2; ++g) {
      CAPTURE(p.person);
      CAPTURE(g);
      const GoalScore score = goalScore(lesson.lesson, p, g);
      CHECK(std::array{score.parts, score.done, score.answered, score.first_right} == wanted.at(p.person)[g]);
    }
  const std::string page = classPage(summary, {}, "");
  CHECK(page.find("1. Feel it") != std::string::npos);
  CHECK(page.find("2. Say it") != std::string::npos);
}

TEST_CASE("a tag that several wrong choices share is counted once a student and each time that it was given") {
  const ClassSummary summary = summarise({quick().attempt(), winding().attempt(), stuck().attempt()});
  std::map<std::string, std::pair<std::size_t, std::size_t>> met;  // students, times
  for (const PersonScore& p : summary.lessons[0].people)
    for (const auto& [tag, times] : p.misconceptions) {
      ++met[tag].first;
      met[tag].second += times;
    }
  CHECK(met == decltype(met){{"thinks no", {2, 5}}, {"thinks thus", {1, 1}}});
  const std::string page = classPage(summary, {}, ""), table = classCsv(summary);
  CHECK(page.find("thinks no") != std::string::npos);
  CHECK(page.find("See below. →") == std::string::npos);
  CHECK(table.find("thinks no (2) | thinks thus") != std::string::npos);
  CHECK(table.find("thinks no (3)") != std::string::npos);
}

TEST_CASE("a tag is never shown to students: the feedback ends before it") {
  const auto lesson = branchingLesson();
  const Choice& no = lesson->steps[0].questions[0].choices[1];
  CHECK(plainText(no.text) == "no");
  CHECK(plainText(no.feedback) == "See below.");
  CHECK(no.tag == "thinks no");
}

}  // namespace moltact
