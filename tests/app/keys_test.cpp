// Keyboard only: Tab reaches every control, keys open menus, and keys that no control uses act on the molecule.
#include <algorithm>
#include <set>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/key_focus.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// The controls of panels that are drawn and can be used now. A list's rows that are out of sight are not drawn.
std::set<std::string> controls() {
  std::set<std::string> out;
  for (const auto& [name, record] : widgets().all())
    if (record.key_stop) out.insert(name);
  return out;
}

// Where Tab leads until the keys are at the molecule again.
std::vector<std::string> tabbed(ScriptedUser& d, const char* key = "Tab") {
  std::vector<std::string> out;
  for (int k = 0; k < 200; ++k) {
    d.tap(key);
    d.frames(2);
    if (!d.app().panels.keys_in_panels) return out;
    out.push_back(controlOfKeys());
    CHECK_MESSAGE(d.shows(out.back()), out.back());
  }
  FAIL("no end");
  return out;
}

}  // namespace

TEST_CASE(
    "Tab leads once through every control of each step of a lesson, of the touch panel and the tool bar, scrolled into "
    "sight, and back to the molecule") {
  auto d = startWith(MOLTACT_SOURCE_DIR "/tests/app/keyboard_lesson.md");
  const std::size_t steps = d->app().lesson.session()->lesson().steps.size();
  for (std::size_t k = 0; k < steps; ++k) {
    CAPTURE(k);
    const std::vector<std::string> way = tabbed(*d);
    REQUIRE_FALSE(way.empty());
    CHECK(std::set<std::string>(way.begin(), way.end()) == controls());
    CHECK(way.size() == controls().size());
    CHECK(way.front().find("tool/") == std::string::npos);
    std::vector<std::string> back = tabbed(*d, "Shift+Tab");
    std::reverse(back.begin(), back.end());
    CHECK(back == way);
    d->app().lesson.next();
    d->app().finishLoading();
    d->frames(20);
  }
}

TEST_CASE("Tab visits every control of each page, and Enter presses the one that it is at") {
  for (const char* keys : {"Ctrl+,", "Ctrl+D", "Ctrl+O"}) {
    CAPTURE(keys);
    auto d = startWith("argon");
    d->tap(keys);
    d->frames(3);
    std::set<std::string> seen;
    for (int k = 0; k < 120; ++k) {
      d->tap("Tab");
      d->frames(2);
      seen.insert(controlOfKeys());
    }
    std::string close;
    for (const auto& [name, record] : widgets().all())
      if (record.key_stop && !name.starts_with("tool/") && !name.starts_with("show/") &&
          name.find("/") != std::string::npos && name != "view/reset")
        CHECK_MESSAGE(seen.contains(name), name);
    for (const std::string& name : seen)
      if (name.ends_with("/close")) close = name;
    REQUIRE_FALSE(close.empty());
    for (int k = 0; k < 120 && controlOfKeys() != close; ++k) d->tap("Tab"), d->frames(1);
    d->tap("Enter");
    d->frames(3);
    CHECK_FALSE(d->shows(close));
  }
}

TEST_CASE("where Tab has led the keys to a panel, arrows and Space work its controls and not the probe, until Escape") {
  auto d = startWith("argon");
  const auto at = [&] { return d->app().scene.controls.lead().A; };
  for (int k = 0; k < 30 && controlOfKeys() != "probe"; ++k) d->tap("Tab"), d->frames(1);
  REQUIRE(controlOfKeys() == "probe");
  const double probe_A = d->app().scene.servo_settings.probe_A;
  d->tap("Right");
  d->tap("Right");
  d->tap("Left");
  d->frames(5);
  CHECK(d->app().scene.servo_settings.probe_A == doctest::Approx(probe_A + 0.1));
  CHECK(controlOfKeys() == "probe");
  const auto before = at();  // a larger probe stands farther out
  d->hold("Space");
  d->frames(20);
  d->letGo("Space");
  CHECK_FALSE(d->app().scene.controls.pressing());
  CHECK(d->app().scene.servo_settings.probe_A == doctest::Approx(probe_A + 0.1));
  CHECK(glm::distance(at(), before) < 1e-6);
  d->tap("Tab");
  d->frames(1);
  const std::string next = controlOfKeys();
  const std::string was = d->text(next);
  d->tap("Space");
  d->frames(2);
  CHECK(d->text(next) != was);
  d->tap("Escape");
  d->frames(2);
  CHECK(controlOfKeys().empty());
  CHECK_FALSE(d->shows("welcome/title"));
  d->hold("Right");
  d->frames(30);
  d->letGo("Right");
  CHECK(glm::distance(at(), before) > 0.1);
  // A click gives the keys back, too.
  d->tap("Tab");
  REQUIRE_FALSE(controlOfKeys().empty());
  d->click("view");
  d->frames(2);
  CHECK(controlOfKeys().empty());
}

TEST_CASE("F6 leads from panel to panel, from the molecule to the molecule") {
  auto d = startWith("");
  openFirst(*d);
  d->frames(5);
  std::vector<std::string> firsts;
  for (int k = 0; k < 10; ++k) {
    d->tap("F6");
    d->frames(2);
    if (!d->app().panels.keys_in_panels) break;
    firsts.push_back(controlOfKeys().substr(0, controlOfKeys().find('/')));
  }
  REQUIRE(firsts.size() >= 3);
  CHECK(firsts.front() == "lesson");
  CHECK(firsts.back() == "tool");
  CHECK(std::count(firsts.begin(), firsts.end(), "tool") == 1);
}

TEST_CASE(
    "F10, Alt and Alt with a letter open the menus; arrows go from line to line and menu to menu, Enter chooses, "
    "Escape closes") {
  auto d = startWith("argon");
  d->tap("F10");
  d->frames(3);
  CHECK(d->shows("menu/file/open"));
  d->tap("Escape");
  d->frames(3);
  CHECK_FALSE(d->shows("menu/file/open"));
  CHECK_FALSE(d->shows("welcome/title"));

  d->hold("Alt");
  d->letGo("Alt");
  d->frames(3);
  CHECK(d->shows("menu/file/open"));
  d->tap("Right");
  d->frames(4);
  CHECK(d->shows("menu/edit/preferences"));
  CHECK_FALSE(d->shows("menu/file/open"));
  d->hold("Alt");
  d->letGo("Alt");
  d->frames(3);
  CHECK_FALSE(d->shows("menu/edit/preferences"));

  d->tap("Alt+V");
  d->frames(3);
  REQUIRE(d->shows("menu/view/dark"));
  for (int k = 0; k < 40 && controlOfKeys() != "menu/view/dark"; ++k) {
    d->tap("Down");
    d->frames(2);
  }
  CHECK(controlOfKeys() == "menu/view/dark");
  d->tap("Enter");
  d->frames(3);
  CHECK(d->app().settings.theme == ThemeChoice::Dark);
  CHECK_FALSE(d->shows("menu/view/dark"));

  // Alt with another key, or held during mouse input, is not a tap.
  d->tap("Alt+Right");
  d->frames(3);
  CHECK_FALSE(d->shows("menu/file/open"));
}

TEST_CASE("a link in the lesson's text is followed by keys") {
  Scratch scratch;
  const auto file =
      scratch.file("mine.md",
                   "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n"
                   "## One\n```scene\nmolecule: argon\n```\nSee [the second](#two) step.\n## Two\nText.\n");
  auto d = startWith(file.string());
  d->tap("Tab");  // the goals
  d->tap("Tab");
  d->frames(2);
  CHECK(controlOfKeys().ends_with("/the second"));
  d->tap("Enter");
  d->frames(3);
  CHECK(d->text("lesson/step") == "Two");
}

}  // namespace moltact
