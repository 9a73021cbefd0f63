// The order of a lesson's steps in the window: effects of answers, required steps, and the end.
#include <filesystem>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/widget_map.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

constexpr const char* kWayHead =
    "---\ntitle: Ways\nminutes: 1\ngoals:\n  - Go\nmolecules:\n  - argon\nauthor: A\nlicence: L\n---\n\n";

struct WayOpened {
  ScratchFolder scratch;
  std::unique_ptr<ScriptedUser> driver;
  WayOpened() {
    writeFile(scratch.path / "ways.md",
              std::string(kWayHead) +
                  "## First\n\n```step\nrequired: yes\n```\n\n```scene\nmolecule: argon\n```\n\n"
                  "See [the end](#last).\n\n### Question: Which?\n\n1. [x] This → Yes.\n2. [ ] That → No.\n\n"
                  "```answer\nattempts: 3\nafter 2 wrong: go to #aside-why\nif right: skip #middle\n```\n\n"
                  "## Middle\n\nText.\n\n## Last\n\nText.\n\n## Aside: Why\n\nText.\n");
    driver = startWith((scratch.path / "ways.md").string());
  }
  LessonSession& session() { return *driver->app().lesson.session(); }
  std::string step() { return session().step().id; }
  bool click(const std::string& name) {
    const bool there = driver->click(name);
    driver->frames(3);
    return there;
  }
};

}  // namespace

TEST_CASE("a required step says so in place of Next, shows 3 tries, and releases the student when it is done") {
  WayOpened o;
  CHECK(o.driver->text("lesson/next") == "Finish this step first");
  CHECK(o.driver->text("question/0/tries") == "You have 3 tries.");
  o.click("lesson/next");
  CHECK(o.step() == "first");
  CHECK(o.driver->app().lesson.follow("#last"));
  CHECK(o.step() == "first");
  CHECK(o.click("question/0/0"));
  CHECK(o.driver->text("lesson/next") == "Next");
  CHECK(o.driver->text("lesson/place") == "Step 1 of 2");
  CHECK(o.click("lesson/next"));
  CHECK(o.step() == "last");
}

TEST_CASE(
    "after two wrong answers a button leads into the aside, and from there back; after the third the right one stands "
    "there") {
  WayOpened o;
  CHECK(o.click("question/0/1"));
  CHECK_FALSE(o.driver->shows("question/0/go on"));
  CHECK(o.click("question/0/1"));
  CHECK(o.driver->text("question/0/go on") == "Go on: Why");
  CHECK(o.click("question/0/go on"));
  CHECK(o.step() == "aside-why");
  CHECK(o.click("lesson/next"));
  CHECK(o.step() == "first");
  CHECK(o.click("question/0/1"));
  CHECK(o.session().question(0).shown);
  CHECK(o.driver->text("question/0/feedback/1") == "That was the last try. Right is: This");
  CHECK(o.click("lesson/next"));
  CHECK(o.step() == "middle");
}

TEST_CASE(
    "the lessons of the program stand by the places that their authors gave; the card at the end names the next one") {
  const auto d = startWith("");
  d->app().panels.pages.welcome = true;
  d->frames(5);
  for (int k = 0; k < 600 && (k < 60 || d->app().extensions().lesson_list.live()); ++k) d->frames(1);
  const std::vector<LessonCard>& cards = d->app().extensions().lesson_list.cards();
  REQUIRE(cards.size() >= 16);
  for (int k = 0; k < 16; ++k) {
    CAPTURE(cards[std::size_t(k)].title);
    CHECK(cards[std::size_t(k)].order == k + 1);
    CHECK_FALSE(cards[std::size_t(k)].description.empty());
  }
  CHECK(cards[0].id == "first-touch");
  REQUIRE(d->app().extensions().lesson_list.after(cards[0].file));
  CHECK(d->app().extensions().lesson_list.after(cards[0].file)->id == "bond-or-contact");
  CHECK(contains(d->text("welcome/lesson/first-touch"), cards[0].description));
}

}  // namespace moltact
