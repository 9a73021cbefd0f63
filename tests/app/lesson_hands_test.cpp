// Every lesson of the program in the window, on the frames' clock: once with the mouse only, and once with the keyboard
// only by a student who makes every possible mistake first.
#include "tests/app/lesson_hand.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

void walk(const std::string& lesson, LessonHand::By by) {
  CAPTURE(lesson);
  auto d = startWith(std::string(MOLTACT_SOURCE_DIR) + "/lessons/" + lesson);
  const bool errs = by == LessonHand::By::Keyboard;
  LessonHand hand(*d, by, errs ? LessonHand::First::Wrong : LessonHand::First::Right);
  CHECK(hand.finishLesson());
  CHECK(hand.failed() == "");
  CHECK(d->missing() == "");
  if (errs) CHECK(hand.wrongAnswers() >= 4);
}

}  // namespace

TEST_CASE("a hand at a lesson that did not open says so, in the window's words, and ends") {
  auto d = startWith(std::string(MOLTACT_SOURCE_DIR) + "/lessons/no-such-lesson.md");
  LessonHand hand(*d, LessonHand::By::Mouse);
  CHECK_FALSE(hand.finishLesson());
  CAPTURE(hand.failed());
  CHECK(contains(hand.failed(), "no lesson is open"));
}

TEST_CASE("first-touch.md is finished with the mouse alone, and with the keyboard alone") {
  walk("first-touch.md", LessonHand::By::Mouse);
  walk("first-touch.md", LessonHand::By::Keyboard);
}
TEST_CASE("bond-or-contact.md is finished with the mouse alone, and with the keyboard alone") {
  walk("bond-or-contact.md", LessonHand::By::Mouse);
  walk("bond-or-contact.md", LessonHand::By::Keyboard);
}
TEST_CASE("hydrogen-bonds.md is finished with the mouse alone, and with the keyboard alone") {
  walk("hydrogen-bonds.md", LessonHand::By::Mouse);
  walk("hydrogen-bonds.md", LessonHand::By::Keyboard);
}
TEST_CASE("the-probe-decides.md is finished with the mouse alone, and with the keyboard alone") {
  walk("the-probe-decides.md", LessonHand::By::Mouse);
  walk("the-probe-decides.md", LessonHand::By::Keyboard);
}
TEST_CASE("dna-grooves-blind.md is finished with the mouse alone, and with the keyboard alone") {
  walk("dna-grooves-blind.md", LessonHand::By::Mouse);
  walk("dna-grooves-blind.md", LessonHand::By::Keyboard);
}
TEST_CASE("how-touch-is-computed.md is finished with the mouse alone, and with the keyboard alone") {
  walk("how-touch-is-computed.md", LessonHand::By::Mouse);
  walk("how-touch-is-computed.md", LessonHand::By::Keyboard);
}
TEST_CASE("the-haem-in-its-pocket.md is finished with the mouse alone, and with the keyboard alone") {
  walk("the-haem-in-its-pocket.md", LessonHand::By::Mouse);
  walk("the-haem-in-its-pocket.md", LessonHand::By::Keyboard);
}
TEST_CASE("four-chains-as-one.md is finished with the mouse alone, and with the keyboard alone") {
  walk("four-chains-as-one.md", LessonHand::By::Mouse);
  walk("four-chains-as-one.md", LessonHand::By::Keyboard);
}
TEST_CASE("left-or-right.md is finished with the mouse alone, and with the keyboard alone") {
  walk("left-or-right.md", LessonHand::By::Mouse);
  walk("left-or-right.md", LessonHand::By::Keyboard);
}
TEST_CASE("coils-and-sheets.md is finished with the mouse alone, and with the keyboard alone") {
  walk("coils-and-sheets.md", LessonHand::By::Mouse);
  walk("coils-and-sheets.md", LessonHand::By::Keyboard);
}
TEST_CASE("straight-and-kinked-fats.md is finished with the mouse alone, and with the keyboard alone") {
  walk("straight-and-kinked-fats.md", LessonHand::By::Mouse);
  walk("straight-and-kinked-fats.md", LessonHand::By::Keyboard);
}
TEST_CASE("a-drug-in-its-tunnel.md is finished with the mouse alone, and with the keyboard alone") {
  walk("a-drug-in-its-tunnel.md", LessonHand::By::Mouse);
  walk("a-drug-in-its-tunnel.md", LessonHand::By::Keyboard);
}
TEST_CASE("a-hole-in-the-membrane.md is finished with the mouse alone, and with the keyboard alone") {
  walk("a-hole-in-the-membrane.md", LessonHand::By::Mouse);
  walk("a-hole-in-the-membrane.md", LessonHand::By::Keyboard);
}

TEST_CASE("a-protein-reads-dna.md is finished with the mouse alone, and with the keyboard alone") {
  walk("a-protein-reads-dna.md", LessonHand::By::Mouse);
  walk("a-protein-reads-dna.md", LessonHand::By::Keyboard);
}

TEST_CASE("an-enzymes-door.md is finished with the mouse alone, and with the keyboard alone") {
  walk("an-enzymes-door.md", LessonHand::By::Mouse);
  walk("an-enzymes-door.md", LessonHand::By::Keyboard);
}

TEST_CASE("a-virus-in-the-hand.md is finished with the mouse alone, and with the keyboard alone") {
  walk("a-virus-in-the-hand.md", LessonHand::By::Mouse);
  walk("a-virus-in-the-hand.md", LessonHand::By::Keyboard);
}

TEST_CASE("seeing-by-feeling.md is finished with the mouse alone, and with the keyboard alone") {
  walk("seeing-by-feeling.md", LessonHand::By::Mouse);
  walk("seeing-by-feeling.md", LessonHand::By::Keyboard);
}

}  // namespace moltact
