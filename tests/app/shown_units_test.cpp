// The unit in which a person wants lengths: chosen in Preferences, kept, and followed by all that the window writes.
#include "app/ui/panels/panels.h"
#include "app/ui/widgets/theme.h"
#include "engine/workspace/scale.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// What is shown that has this in it, but for the choice itself.
std::string shownWith(std::string_view part) {
  std::string out;
  for (const auto& [name, record] : widgets().all())
    if (contains(record.text, std::string(part)) && !name.starts_with("preferences/length-unit"))
      out += name + ": " + record.text + "\n";
  return out;
}

}  // namespace

TEST_CASE(
    "with nm chosen in Preferences the probe is 0.14 nm, the finest grid 0.02 nm, and no panel or page writes an Å; pm "
    "and Å again are followed as quickly, and the choice is kept") {
  Scratch scratch;
  ScriptedUser::Options options;
  options.application.settings_file = scratch.folder / "settings.json";
  {
    auto d = startWith("argon", options);
    CHECK(d->text("probe") == "1.4\u00a0Å");
    CHECK(d->click("tool/preferences"));
    d->frames(3);
    CHECK(d->click("preferences/length-unit/nm"));
    d->frames(2);
    CHECK(d->app().settings.length_unit == "nm");
    d->tap("Escape");
    d->app().panels.touch_details = true;
    d->app().scene.useMethod("grid02");
    d->point("view");
    d->press(0);
    d->frames(60);
    REQUIRE(d->app().scene.log().touching());
    CHECK(d->text("probe") == "0.14\u00a0nm");
    CHECK(contains(scaleSentence(d->app().scene.servo_settings.workspace, 0.5), "\u00a0nm there"));
    CHECK(shownWith("Å") == "");
    d->app().panels.showMethods(true);
    d->frames(3);
    CHECK(d->shows("grade/0.02\u00a0nm"));
    CHECK(shownWith("Å") == "");
    for (const Panel& panel : allPanels()) {
      if (!panel.page) continue;
      CAPTURE(panel.name);
      d->app().panels.*panel.page = true;
      d->frames(3);
      CHECK(shownWith("Å") == "");
      d->app().panels.*panel.page = false;
    }
    d->app().panels.showMethods(false);
    d->app().settings.length_unit = "pm";
    d->frames(2);
    CHECK(d->text("probe") == "140\u00a0pm");
    d->app().settings.length_unit = "nm";
    d->frames(2);
  }
  auto again = startWith("argon", options);
  again->frames(2);
  CHECK(again->text("probe") == "0.14\u00a0nm");
  CHECK(again->click("tool/preferences"));
  again->frames(3);
  CHECK(again->text("preferences/length-unit/nm") == "on");
  CHECK(again->click("preferences/length-unit/Å"));
  again->frames(2);
  CHECK(again->app().settings.length_unit.empty());
  CHECK(again->text("probe") == "1.4\u00a0Å");
}

TEST_CASE("a kept unit that lengths are not shown in, mm or a word, counts as none chosen") {
  Scratch scratch;
  for (const char* text : {R"({"length_unit": "mm"})", R"({"length_unit": "ell"})", R"({"length_unit": 3})"}) {
    CAPTURE(text);
    CHECK(loadSettings(scratch.file("settings.json", text)).settings.length_unit.empty());
  }
}

}  // namespace moltact
