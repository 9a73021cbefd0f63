// The user's units of length, force and stiffness: chosen in Preferences, stored, and used in all texts of the window.
#include <cctype>
#include <map>

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
    if (contains(record.text, std::string(part)) && !name.starts_with("preferences/unit/"))
      out += name + ": " + record.text + "\n";
  return out;
}

// What is shown that has a number in this unit, or names it in brackets, but for the choice itself.
std::string shownIn(const std::string& symbol) {
  std::string out;
  for (const auto& [name, record] : widgets().all()) {
    if (name.starts_with("preferences/unit/")) continue;
    bool there = contains(record.text, "(" + symbol + ")");
    const std::string after_number = "\u00a0" + symbol;
    for (std::size_t at = 0; (at = record.text.find(after_number, at)) != std::string::npos;) {
      at += after_number.size();
      const unsigned char next = at < record.text.size() ? static_cast<unsigned char>(record.text[at]) : ' ';
      there = there || !(std::isalnum(next) || next == '/' || next >= 0x80);
    }
    if (there) out += name + ": " + record.text + "\n";
  }
  return out;
}

using Units = std::map<std::string, std::string>;

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
    CHECK(d->click("preferences/unit/length/nm"));
    d->frames(2);
    CHECK(d->app().settings.units == Units{{"length", "nm"}});
    d->tap("Escape");
    d->app().panels.touch_details = true;
    useMethod(d->app().scene, "grid02");
    d->point("view");
    d->press(0);
    d->frames(60);
    REQUIRE(d->app().scene.log().touching());
    CHECK(d->text("probe") == "0.14\u00a0nm");
    CHECK(contains(scaleSentence(d->app().scene.servo_settings.workspace, 0.5), "\u00a0nm there"));
    CHECK(shownWith("Å") == "");
    d->app().panels.tabs.open("methods");
    d->frames(3);
    CHECK(d->shows("grade/0.02\u00a0nm"));
    CHECK(shownWith("Å") == "");
    for (const Panel& panel : allPanels()) {
      if (!panel.page) continue;
      CAPTURE(panel.name);
      d->app().panels.pages.*panel.page = true;
      d->frames(3);
      CHECK(shownWith("Å") == "");
      d->app().panels.pages.*panel.page = false;
    }
    d->app().panels.tabs.close("methods");
    d->app().settings.units["length"] = "pm";
    d->frames(2);
    CHECK(d->text("probe") == "140\u00a0pm");
    d->app().settings.units["length"] = "nm";
    d->frames(2);
  }
  auto again = startWith("argon", options);
  again->frames(2);
  CHECK(again->text("probe") == "0.14\u00a0nm");
  CHECK(again->click("tool/preferences"));
  again->frames(3);
  CHECK(again->text("preferences/unit/length/nm") == "on");
  CHECK(again->click("preferences/unit/length/Å"));
  again->frames(2);
  CHECK(again->app().settings.units.empty());
  CHECK(again->text("probe") == "1.4\u00a0Å");
}

TEST_CASE(
    "with another unit chosen for each dimension that offers some, no panel or page writes a number in the unit that "
    "it "
    "had") {
  auto d = startWith("argon", {});
  CHECK(d->click("tool/preferences"));
  d->frames(3);
  d->point("preferences/unit/length/nm");
  d->wheel(-40);
  d->frames(3);
  for (const OfferedDimension& offered : offeredDimensions()) {
    const std::string own(UnitSet().of(offered.dimension)->symbol);
    CAPTURE(own);
    std::string other;
    for (const std::string_view symbol : offeredUnits(offered.dimension))
      if (symbol != own) other = symbol;
    REQUIRE_FALSE(other.empty());
    CHECK(d->click("preferences/unit/" + std::string(offered.name) + "/" + other));
    d->frames(2);
    CHECK(unitText(offered.dimension) == other);
  }
  d->tap("Escape");
  d->app().panels.touch_details = true;
  d->app().settings.expert = true;
  d->point("view");
  d->press(0);
  d->frames(60);
  REQUIRE(d->app().scene.log().touching());
  const auto noOwnUnit = [&] {
    for (const OfferedDimension& offered : offeredDimensions()) {
      const std::string own(UnitSet().of(offered.dimension)->symbol);
      CAPTURE(own);
      CHECK(shownIn(own) == "");
    }
  };
  noOwnUnit();
  for (const Panel& panel : allPanels()) {
    if (!panel.page) continue;
    CAPTURE(panel.name);
    d->app().panels.pages.*panel.page = true;
    d->frames(3);
    noOwnUnit();
    d->app().panels.pages.*panel.page = false;
    d->frames(1);
  }
}

TEST_CASE(
    "a kept unit that its dimension is not shown in, or of no dimension, counts as none chosen; what an older file "
    "chose for lengths holds until a newer one says otherwise") {
  Scratch scratch;
  const auto unitsOf = [&](const char* text) {
    return loadSettings(scratch.file("settings.json", text)).settings.units;
  };
  for (const char* text :
       {R"({"length_unit": "mm"})", R"({"length_unit": "ell"})", R"({"length_unit": 3})",
        R"({"units": {"length": "mm"}})", R"({"units": {"force": "Å", "mass": "kg", "stiffness": 7}})",
        R"({"units": ["nm"]})", R"({"units": {}, "length_unit": "nm"})"}) {
    CAPTURE(text);
    CHECK(unitsOf(text).empty());
  }
  CHECK(unitsOf(R"({"length_unit": "nm"})") == Units{{"length", "nm"}});
  CHECK(unitsOf(R"({"units": {"length": "pm", "force": "mN"}, "length_unit": "nm"})") ==
        Units{{"force", "mN"}, {"length", "pm"}});
}

}  // namespace moltact
