// What the teacher sees, on a virtual clock: who is stuck, misconceptions held now, predictions, held steps.
#include "engine/classroom/class_view.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/classroom/live_page.h"
#include "engine/classroom/qr_code.h"
#include "engine/classroom/stuck.h"
#include "engine/core/random.h"
#include "tests/classroom/small_class.h"

namespace moltact {
namespace {

using namespace test;

const StudentRow& rowOf(const ClassView& view, const std::string& name) {
  const auto found =
      std::find_if(view.students.begin(), view.students.end(), [&](const auto& r) { return r.name == name; });
  REQUIRE(found != view.students.end());
  return *found;
}

TEST_CASE(
    "stuck is who needs longer than the slowest of the fastest three quarters: 20 000 classes against the sorted "
    "times") {
  std::uint64_t seed = 11;
  std::size_t stuck = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::size_t n = 3 + nextRandom(seed) % 12;
    std::vector<StepTime> others(n);
    std::vector<double> left;
    for (StepTime& one : others) {
      one = {double(nextRandom(seed) % 200), nextRandom(seed) % 4 != 0};
      left.push_back(one.left ? one.spent_s : 1e9);  // who is still there has not been faster
    }
    const double own_s = 30.0 + double(nextRandom(seed) % 300);
    // The time in which three quarters of the others, rounded up, have left.
    std::sort(left.begin(), left.end());
    const bool expected = own_s > left[(3 * n + 3) / 4 - 1];
    CHECK(isStuck(own_s, others) == expected);
    stuck += expected;
  }
  CHECK(stuck > 4000);
  CHECK(stuck < 16000);
  const std::vector<StepTime> fast(4, {5.0, true});
  CHECK_FALSE(isStuck(29.0, fast));
  CHECK(isStuck(30.0, fast));
  CHECK_FALSE(isStuck(500.0, std::vector<StepTime>(2, {5.0, true})));
}

TEST_CASE("of eight who left a step after 40 to 47 s, who stays is stuck from 46 s on, and no longer after the step") {
  ClassRoom room(smallLessons(), 1);
  std::vector<SmallStudent> others;
  for (int k = 0; k < 8; ++k) {
    others.emplace_back(room, "o" + std::to_string(k));
    others.back().at(0.0, StepEntered{"one"});
  }
  SmallStudent slow(room, "slow");
  slow.at(10.0, StepEntered{"one"});  // the attempt's own clock
  for (int k = 0; k < 8; ++k) others[std::size_t(k)].at(40.0 + k, StepEntered{"two"});
  // 40, 41, … 45 are six of eight: three quarters.
  slow.at(10.0 + 45.0, Heartbeat{});
  CHECK_FALSE(rowOf(viewOf(room, 55.0), "slow").stuck);
  slow.at(10.0 + 45.9, Heartbeat{});
  CHECK(rowOf(viewOf(room, 56.0), "slow").stuck);
  CHECK(viewOf(room, 56.0).students.front().name == "slow");
  CHECK(viewOf(room, 56.0).lessons[0].steps[0].stuck == 1);
  CHECK(rowOf(viewOf(room, 56.0), "slow").on_step_s == doctest::Approx(45.9));
  // Nobody is stuck where the teacher holds the class, nor once away.
  room.hold("bumps", 0);
  CHECK_FALSE(rowOf(viewOf(room, 56.0), "slow").stuck);
  room.open("bumps");
  CHECK(rowOf(viewOf(room, 56.0), "slow").stuck);
  CHECK(rowOf(viewOf(room, 90.0), "slow").away);
  CHECK_FALSE(rowOf(viewOf(room, 90.0), "slow").stuck);
  slow.at(60.0, StepEntered{"two"});
  CHECK_FALSE(rowOf(viewOf(room, 60.0), "slow").stuck);
}

TEST_CASE("all who come to a step together are not stuck by being first, however long the step takes") {
  ClassRoom room(smallLessons(), 1);
  std::vector<SmallStudent> all;
  for (int k = 0; k < 10; ++k) {
    all.emplace_back(room, "s" + std::to_string(k));
    all.back().at(double(k), StepEntered{"one"});
    all.back().at(600.0, Heartbeat{});
  }
  CHECK(viewOf(room, 600.0).stuck == 0);
}

TEST_CASE("a row has the step, the task under way, hints and progress of the attempt that is worked on") {
  ClassRoom room(smallLessons(), 1);
  SmallStudent ada(room, "Ada");
  CHECK(rowOf(viewOf(room, 0.0), "Ada").step_number == 0);
  ada.at(0.0, StepEntered{"one"});
  CHECK(rowOf(viewOf(room, 0.0), "Ada").task == 1);
  ada.at(3.0, TaskDone{"one", 0, 3.0, InputKind::Mouse, {}, true});
  ada.at(4.0, HintOpened{"one"});
  ada.at(4.0, ProgressMade{"one", 1, 4});
  StudentRow row = rowOf(viewOf(room, 5.0), "Ada");
  CHECK(row.task == 2);
  CHECK(row.tasks == 2);
  CHECK(row.hints == 1);
  CHECK(row.done == 1);
  CHECK(row.of == 4);
  CHECK(viewOf(room, 5.0).lessons[0].steps[0].hints == 1);
  ada.at(6.0, TaskDone{"one", 1, 3.0, InputKind::Mouse, {}, true});
  CHECK(rowOf(viewOf(room, 6.0), "Ada").task == 0);
  // A step that is visited again adds its time.
  ada.at(10.0, StepEntered{"two"});
  ada.at(15.0, StepEntered{"one"});
  ada.at(18.0, Heartbeat{});
  CHECK(rowOf(viewOf(room, 18.0), "Ada").on_step_s == doctest::Approx(13.0));
  ada.at(20.0, ProgressMade{"one", 4, 4});
  CHECK(rowOf(viewOf(room, 20.0), "Ada").finished);
  CHECK(viewOf(room, 20.0).finished == 1);
}

TEST_CASE("a misconception counts while the latest answer shows it, once per student, with the names") {
  ClassRoom room(smallLessons(), 1);
  SmallStudent ada(room, "Ada"), bo(room, "Bo");
  for (SmallStudent* one : {&ada, &bo}) {
    one->at(0.0, StepEntered{"two"});
    one->at(1.0, Answered{"two", "which", 1, {0}, "", false, InputKind::Mouse});
  }
  ClassView view = viewOf(room, 1.0);
  REQUIRE(view.misconceptions.size() == 1);
  CHECK(view.misconceptions[0].words == "takes <this> for that");
  CHECK(view.misconceptions[0].students == std::vector<std::string>{"Ada", "Bo"});
  ada.at(2.0, Answered{"two", "which", 2, {1}, "", true, InputKind::Mouse});
  CHECK(viewOf(room, 2.0).misconceptions[0].students == std::vector<std::string>{"Bo"});
  bo.at(3.0, Answered{"two", "which", 2, {1}, "", true, InputKind::Mouse});
  CHECK(viewOf(room, 3.0).misconceptions.empty());
}

TEST_CASE(
    "predictions of a question are counted by choice, typed ones are listed without names, drawn curves lie over each "
    "other") {
  ClassRoom room(smallLessons(), 1);
  std::vector<SmallStudent> all;
  for (std::size_t k = 0; k < 5; ++k) {
    all.emplace_back(room, "name" + std::to_string(k));
    all.back().at(0.0, StepEntered{"one"});
    all.back().at(1.0,
                  Answered{"one", "expect", 1, {k == 0 ? 1u : 0u}, k == 3 ? "like jelly" : "", true, InputKind::Mouse});
    if (k < 3) all.back().at(2.0, CurveKept{"one", 0, false, "depth", 0.8, 3.3, {0.0, 1.0, double(k)}});
  }
  all[4].at(3.0, Answered{"one", "expect", 2, {1}, "", true, InputKind::Mouse});  // has thought again
  const LessonView lesson = viewOf(room, 3.0).lessons[0];
  REQUIRE(lesson.predictions.size() == 1);
  CHECK(lesson.predictions[0].students == 5);
  CHECK(lesson.predictions[0].counts == std::vector<std::size_t>{3, 2});
  CHECK(lesson.predictions[0].written == std::vector<std::string>{"like jelly"});
  REQUIRE(lesson.curves.size() == 1);
  CHECK(lesson.curves[0].curves.size() == 3);
}

TEST_CASE(
    "students of a translation stand in the same steps, and its misconceptions have the words of the teacher's "
    "lesson") {
  ClassRoom room(smallLessons(), 1);
  LessonOutline german = smallOutline();
  german.file = "bumps.de.md";
  german.title = "Beulen";
  for (std::size_t k = 0; k < 3; ++k) german.steps[k].id = "schritt-" + std::to_string(k);
  german.steps[1].questions[0].id = "welches";
  german.steps[1].questions[0].tags = {"hält dies für das", ""};
  const std::size_t s = room.join("Änne", "t", 0.0)->student;
  room.take(s, "a", 0,
            {headerLine("", german), eventLine(0.0, StepEntered{"schritt-1"}),
             eventLine(1.0, Answered{"schritt-1", "welches", 1, {0}, "", false, InputKind::Mouse})},
            0.0);
  const ClassView view = viewOf(room, 1.0);
  REQUIRE(view.lessons.size() == 1);
  CHECK(view.lessons[0].steps[1].here == 1);
  REQUIRE(view.misconceptions.size() == 1);
  CHECK(view.misconceptions[0].words == "takes <this> for that");
}

TEST_CASE("of four, who has not begun 60 s after joining is stuck once the three others have begun, unless away") {
  ClassRoom room(smallLessons(), 1);
  std::vector<SmallStudent> others;
  for (int k = 0; k < 2; ++k) others.emplace_back(room, "o" + std::to_string(k), 0.0);
  const std::size_t slow = room.join("slow", "t", 10.0)->student;
  room.seen(slow, 80.0);
  CHECK_FALSE(rowOf(viewOf(room, 80.0), "slow").stuck);  // two of two others
  others.emplace_back(room, "o2", 20.0);
  CHECK_FALSE(rowOf(viewOf(room, 69.9), "slow").stuck);
  CHECK(rowOf(viewOf(room, 70.1), "slow").stuck);
  CHECK(viewOf(room, 70.1).students.front().name == "slow");
  CHECK(viewOf(room, 70.1).stuck == 1);
  CHECK(teacherPage(viewOf(room, 70.1), {"http://h/", true}).find("has not begun") != std::string::npos);
  CHECK_FALSE(rowOf(viewOf(room, 100.0), "slow").stuck);  // away
  // One of four has begun fewer than three quarters of them.
  room.join("late", "t2", 75.0);
  room.join("later", "t3", 75.0);
  CHECK_FALSE(rowOf(viewOf(room, 80.0), "slow").stuck);
}

TEST_CASE("one student's lines cannot bend the class's page: repeated choices, long curves, odd lessons and times") {
  ClassRoom room(smallLessons(), 1);
  SmallStudent bad(room, "bad");
  bad.at(0.0, StepEntered{"one"});
  bad.at(1.0, Answered{"one", "expect", 1, std::vector<std::size_t>(5000, 0), "", true, InputKind::Mouse});
  std::vector<double> rising(10000);
  for (std::size_t k = 0; k < rising.size(); ++k) rising[k] = double(k) / 9999.0;
  bad.at(2.0, CurveKept{"one", 0, false, "depth", 0.8, 3.3, rising});
  bad.at(2.0, CurveKept{"one", 9, false, "depth", 0.8, 3.3, rising});
  LessonView lesson = viewOf(room, 2.0).lessons[0];
  CHECK(lesson.predictions[0].counts == std::vector<std::size_t>{1, 0});
  REQUIRE(lesson.curves.size() == 1);
  const std::vector<double>& kept = lesson.curves[0].curves[0].force_N;
  CHECK(kept.size() == kMaxKeptCurvePoints);
  CHECK(kept.front() == 0.0);
  CHECK(kept.back() == 1.0);
  // A time beyond every clock counts for nothing; one before the attempt is its beginning.
  bad.send(R"({"kind":"step","t":1e300,"step":"two"})", 3.0);
  bad.send(R"({"kind":"still","t":1e300})", 3.0);
  CHECK(room.students()[0].attempts[0].now_s == 2.0);
  CHECK(rowOf(viewOf(room, 3.0), "bad").step_number == 1);
  bad.send(R"({"kind":"step","t":-30.0,"step":"two"})", 3.0);
  CHECK(rowOf(viewOf(room, 3.0), "bad").step_number == 2);
  CHECK(rowOf(viewOf(room, 3.0), "bad").on_step_s == 2.0);
  CHECK_FALSE(teacherPage(viewOf(room, 3.0), {"http://h/", true}).empty());
  // A lesson of the student's own, with 10 000 steps and long titles: a row with 200 characters of it, and no card.
  LessonOutline own;
  own.file = "own.md";
  own.hash = "feedfeedfeedfeed";
  for (int k = 0; k < 10000; ++k) own.steps.push_back({"s" + std::to_string(k), "", {}, {}});
  for (int k = 0; k < 500; ++k) own.title += "ä";
  REQUIRE(room.take(0, "own", 0, {headerLine("", own)}, 4.0).refused == ClassRoom::Refused::No);
  const ClassView view = viewOf(room, 4.0);
  CHECK(view.lessons.size() == 1);
  CHECK(rowOf(view, "bad").lesson.size() == 2 * kMaxShownTitle);
}

TEST_CASE("the teacher's page escapes every name, title and answer") {
  ClassRoom room(smallLessons(), 1);
  SmallStudent bad(room, "<script>alert(1)</script>");
  bad.at(0.0, StepEntered{"one"});
  bad.at(1.0, Answered{"one", "expect", 1, {}, "<img src=x onerror=alert(2)>", true, InputKind::Mouse});
  bad.at(2.0, StepEntered{"two"});
  bad.at(3.0, Answered{"two", "which", 1, {0}, "", false, InputKind::Mouse});
  const std::string page = teacherPage(viewOf(room, 3.0), {"http://h/\"><script>/", true});
  CHECK(page.find("<script>alert") == std::string::npos);
  CHECK(page.find("<img") == std::string::npos);
  CHECK(page.find("<b>it</b>") == std::string::npos);
  CHECK(page.find("\"><script>/") == std::string::npos);
  CHECK(page.find("&lt;script&gt;alert(1)&lt;/script&gt;") != std::string::npos);
  CHECK(page.find("&lt;img src=x onerror=alert(2)&gt;") != std::string::npos);
  CHECK(page.find("takes &lt;this&gt; for that") != std::string::npos);
}

TEST_CASE("a QR code of an address has its three finders, and its text two rows of modules in a line") {
  const QrCode code = qrCode("http://192.168.1.23:8230/abc234/");
  REQUIRE(code.width >= 21);
  CHECK((code.width - 17) % 4 == 0);
  // ISO/IEC 18004: seven modules square, dark outside, light ring, dark middle of three.
  for (const auto& [top, left] :
       {std::pair{std::size_t{0}, std::size_t{0}}, {std::size_t{0}, code.width - 7}, {code.width - 7, std::size_t{0}}})
    for (std::size_t r = 0; r < 7; ++r)
      for (std::size_t c = 0; c < 7; ++c) {
        const std::size_t ring = std::min({r, c, 6 - r, 6 - c});
        CHECK(code.at(top + r, left + c) == (ring != 1));
      }
  const std::string text = qrText(code);
  CHECK(std::size_t(std::count(text.begin(), text.end(), '\n')) == (code.width + 8 + 1) / 2);
  CHECK(qrSvg(code, "a\"b").find("aria-label=\"a&quot;b\"") != std::string::npos);
  CHECK(qrCode(std::string(5000, 'x')).width == 0);
}

}  // namespace
}  // namespace moltact
