// Oracle: the student's actions, in order.
#include "engine/results/session_facts.h"

#include <doctest/doctest.h>

#include "tests/results/small_lesson.h"

namespace moltact {
namespace {

// What an attempt records of a session in a frame.
std::vector<AttemptEvent> factsOf(LessonSession& session, SessionFacts& facts, double t_s, InputKind by) {
  std::vector<AttemptEvent> out;
  for (const SessionEvent& e : session.takeEvents()) out.push_back(facts.factOf(e, t_s, by));
  return out;
}

// The kinds of the events as one word: "enter begin".
std::string reported(const std::vector<AttemptEvent>& events) {
  std::string out;
  for (const AttemptEvent& e : events) {
    const char* word = std::holds_alternative<StepEntered>(e.what) ? "enter"
                       : std::holds_alternative<TaskBegun>(e.what) ? "begin"
                       : std::holds_alternative<TaskDone>(e.what)  ? "done"
                       : std::holds_alternative<Answered>(e.what)  ? "answer"
                                                                   : "other";
    out += (out.empty() ? "" : " ") + std::string(word);
  }
  return out;
}

TEST_CASE("a way through a lesson of 3 steps gives each of its events once, in the frame after it happened") {
  LessonSession session(smallLesson());
  session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  SessionFacts facts;
  CHECK(reported(factsOf(session, facts, 1.0, InputKind::Mouse)) == "enter begin");
  CHECK(factsOf(session, facts, 2.0, InputKind::Mouse).empty());

  touchFor150ms(session, 0, 2.0);
  auto events = factsOf(session, facts, 4.5, InputKind::Keyboard);
  CHECK(reported(events) == "done begin");
  const auto& done = std::get<TaskDone>(events[0].what);
  CHECK(done.step == "one");
  CHECK(done.task == 0);
  CHECK(done.took_s == doctest::Approx(3.5));
  CHECK(done.by == InputKind::Keyboard);
  CHECK_FALSE(done.figures.empty());

  session.choose(0, {1});
  events = factsOf(session, facts, 5.0, InputKind::Mouse);
  REQUIRE(reported(events) == "answer");
  CHECK_FALSE(std::get<Answered>(events[0].what).right);
  session.choose(0, {0});
  events = factsOf(session, facts, 6.0, InputKind::Mouse);
  REQUIRE(reported(events) == "answer");
  CHECK(std::get<Answered>(events[0].what).right);
  CHECK(std::get<Answered>(events[0].what).attempt == 2);
  CHECK(std::get<Answered>(events[0].what).question == "which");

  // Done and gone on between two frames.
  touchFor150ms(session, 1, 7.0);
  session.next();
  CHECK(reported(factsOf(session, facts, 8.0, InputKind::Mouse)) == "done enter");
  session.write(0, "1.45 Å");
  session.next();
  events = factsOf(session, facts, 9.0, InputKind::Mouse);
  REQUIRE(reported(events) == "answer enter");
  CHECK(std::get<Answered>(events[0].what).written == "1.45 Å");
  const ProgressMade progress = SessionFacts::progressOf(session);
  CHECK(progress.done == 4);
  CHECK(progress.of == 4);
  CHECK(progress.step == "three");
}

TEST_CASE(
    "a force curve is recorded when it is handed in, before anything is felt, and the felt one when "
    "both are known") {
  LessonReading read =
      readLessonText("p.md",
                     "---\ntitle: P\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n"
                     "## One\n```scene\nmolecule: mix\n```\n```touch\npredict: anywhere\ndeep: 0.5 Å\nmost: 2 "
                     "N\nagree: 90\nsay: S\n```\n");
  REQUIRE(read.lesson);
  LessonSession session(std::make_shared<const Lesson>(*std::move(read.lesson)));
  session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  SessionFacts facts;
  factsOf(session, facts, 0.0, InputKind::Mouse);
  double time_s = 0.0;
  // 2 N for each A, against a drawn curve of so much at every depth.
  const auto predict = [&](double drawn_N, double N_per_A) {
    session.answerTask({{}, std::vector<double>(session.taskAt(0)->curves()->drawn.size(), drawn_N)});
    const auto drawn = factsOf(session, facts, 1.0, InputKind::Mouse);
    REQUIRE(drawn.size() == 1);
    CHECK_FALSE(std::get<CurveKept>(drawn[0].what).felt);
    CHECK(std::get<CurveKept>(drawn[0].what).force_N.front() == drawn_N);
    for (int k = 0; k <= 500; ++k) {
      TouchSample s = touching(0, time_s += 0.001, N_per_A * 0.001 * k);
      s.hip.A.z = -0.001 * k;
      stretchToScp(s.contact, s.hip);
      session.feed(s);
    }
    return factsOf(session, facts, 2.0, InputKind::Mouse);
  };
  auto events = predict(2.0, 2.0);
  REQUIRE(events.size() == 1);
  const CurveKept& felt = std::get<CurveKept>(events[0].what);
  CHECK(felt.felt);
  CHECK(felt.axis == "depth");
  CHECK(felt.to_A == 0.5);
  // Told when enough was felt: the deepest places are still missing.
  CHECK(felt.force_N[12] == doctest::Approx(0.5).epsilon(0.05));
  CHECK_FALSE(session.task(0).done);
  // Predicted anew, and now right: the felt one is constant, too.
  session.answerTask({{}, std::vector<double>(felt.force_N.size(), 1.0)});
  CHECK(factsOf(session, facts, 3.0, InputKind::Mouse).size() == 1);
  for (int k = 0; k <= 500; ++k) {
    TouchSample s = touching(0, time_s += 0.001, 1.0);
    s.hip.A.z = -0.001 * k;
    stretchToScp(s.contact, s.hip);
    session.feed(s);
  }
  events = factsOf(session, facts, 4.0, InputKind::Mouse);
  REQUIRE(events.size() == 2);
  CHECK(std::get<CurveKept>(events[0].what).felt);
  CHECK(std::holds_alternative<TaskDone>(events[1].what));
  CHECK(factsOf(session, facts, 5.0, InputKind::Mouse).empty());
}

TEST_CASE("a task begun again is recorded as begun, and a lesson that was read again repeats no events") {
  LessonSession session(smallLesson());
  session.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  SessionFacts facts;
  factsOf(session, facts, 0.0, InputKind::Mouse);
  touchFor150ms(session, 0, 0.0);
  factsOf(session, facts, 1.0, InputKind::Mouse);
  session.restartTask(0);
  const auto events = factsOf(session, facts, 2.0, InputKind::Mouse);
  REQUIRE(reported(events) == "begin");
  CHECK(std::get<TaskBegun>(events[0].what).task == 0);
  session.choose(0, {0});
  factsOf(session, facts, 3.0, InputKind::Mouse);
  session.replaceLesson(smallLesson());
  CHECK(reported(factsOf(session, facts, 4.0, InputKind::Mouse)) == "enter begin");
}

}  // namespace
}  // namespace moltact
