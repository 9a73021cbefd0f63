// The table of actions and its users: menus, tool bar, shortcuts and their list; undo; preferences.
#include "app/ui/panels/actions.h"

#include <cmath>
#include <cstdlib>
#include <set>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// The contrast ratio of WCAG 2.1, from relative luminance.
double contrast(ImU32 a, ImU32 b) {
  const auto luminance = [](ImU32 c) {
    const auto part = [&](int shift) {
      const double v = double(c >> shift & 255u) / 255.0;
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * part(IM_COL32_R_SHIFT) + 0.7152 * part(IM_COL32_G_SHIFT) + 0.0722 * part(IM_COL32_B_SHIFT);
  };
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace

TEST_CASE("no two actions share a name or a shortcut, and every shortcut names keys that there are") {
  std::set<std::string_view> names, keys;
  for (const Action& a : allActions()) {
    CAPTURE(a.name);
    CHECK(names.insert(a.name).second);
    REQUIRE(bool(a.run));
    CHECK_FALSE(a.label.empty());
    for (const std::string_view shortcut : {a.shortcut, a.also}) {
      if (shortcut.empty()) continue;
      CHECK(keys.insert(shortcut).second);
      CHECK((shortcut == "?" || !keysNamed(shortcut).empty()));
    }
    if (a.tool > 0) CHECK(a.icon != Icon::None);
  }
}

TEST_CASE("keys are named in capitals or not, joined by plus; an unknown name gives none") {
  CHECK(keysNamed("Ctrl+Shift+S").size() == 3);
  CHECK(keysNamed("ctrl+s") == keysNamed("Ctrl+S"));
  CHECK(keysNamed("Page Up") == keysNamed("pageup"));
  CHECK(keysNamed("F11").size() == 1);
  CHECK(keysNamed("F13").empty());
  CHECK(keysNamed("Ctrl+Nothing").empty());
}

TEST_CASE("F1 and ? open a sheet with every shortcut of the table") {
  for (const char* way : {"F1", "?"}) {
    auto d = startWith("argon");
    if (*way == '?')
      d->type("?");
    else
      d->tap(way);
    d->frames(3);
    REQUIRE(d->shows("controls/close"));
    for (const Action& a : allActions())
      if (!a.shortcut.empty())
        CHECK(contains(d->text("controls/command/" + std::string(a.name)), std::string(a.shortcut)));
  }
}

TEST_CASE("a whole drag of the probe's slider is undone at once, and redone") {
  auto d = startWith("argon");
  const double before_A = d->app().scene.servo_settings.probe_A;
  CHECK_FALSE(d->app().extensions().history.canUndo());
  d->drag("probe", 60, 0);
  const double after_A = d->app().scene.servo_settings.probe_A;
  REQUIRE(after_A > before_A + 0.3);
  d->tap("Ctrl+Z");
  CHECK(d->app().scene.servo_settings.probe_A == before_A);
  CHECK_FALSE(d->app().extensions().history.canUndo());
  d->tap("Ctrl+Shift+Z");
  CHECK(d->app().scene.servo_settings.probe_A == after_A);
}

TEST_CASE("every change of a touch property is undone and redone; an unknown word changes nothing") {
  for (const TouchProperty& p : touchProperties()) {
    if (!isChoice(p)) continue;
    CAPTURE(std::string(p.key));
    auto d = startWith("argon");
    const TouchSetup before = d->app().scene.touch();
    TouchSetup after = before;
    if (std::holds_alternative<double TouchSetup::*>(p.member))
      setTouchValue(after, p, p.control.title.empty() ? p.in_scenes.max : p.control.range.max);
    else if (p.member == TouchMember(&TouchSetup::interaction))
      continue;  // a choice only with a body, see body_in_hand_test.cpp
    else if (p.words)
      setTouchValue(after, p, std::string(p.words().back().name));
    else
      setTouchValue(after, p, !std::get<bool>(touchValue(before, p)));
    REQUIRE_FALSE(after == before);
    d->app().scene.setTouch(after);
    d->frames(2);
    CHECK(d->app().scene.touch() == after);
    d->tap("Ctrl+Z");
    CHECK(d->app().scene.touch() == before);
    d->tap("Ctrl+Shift+Z");
    CHECK(d->app().scene.touch() == after);
  }
  // An unknown word changes nothing.
  auto d = startWith("argon");
  TouchSetup wrong;
  wrong.method = "none";
  wrong.interaction = "none";
  d->app().scene.setTouch(wrong);
  CHECK(d->app().scene.touch() == TouchSetup());
}

TEST_CASE("method, parts shown and a view that was reset are undone in the order in which they were changed") {
  auto d = startWith("argon-pair");
  d->drag("view", 80, 0, 1);
  const Camera turned = d->app().scene.camera;
  const ViewPartSet shown = d->app().scene.look.shown;
  CHECK(d->click("show/spheres"));
  useMethod(d->app().scene, "mesh80");
  d->frames(2);
  d->tap("Home");
  CHECK_FALSE(d->app().scene.camera == turned);
  CHECK(d->click("tool/undo"));
  CHECK(d->app().scene.camera == turned);
  CHECK(d->click("tool/undo"));
  CHECK(d->app().scene.touch().method == "exact");
  CHECK(d->click("tool/undo"));
  CHECK(d->app().scene.look.shown == shown);
  CHECK(d->click("tool/redo"));
  CHECK_FALSE(d->app().scene.look.shown == shown);
}

TEST_CASE("what a lesson's step sets cannot be undone") {
  auto d = startWith("");
  openFirst(*d);
  d->frames(5);
  d->drag("probe", 60, 0);
  REQUIRE(d->app().extensions().history.canUndo());
  CHECK(d->click("lesson/next"));
  d->frames(3);
  CHECK_FALSE(d->app().extensions().history.canUndo());
}

TEST_CASE("with a left-handed mouse the right button pushes and the left one turns") {
  auto d = startWith("argon");
  d->app().settings.left_handed = true;
  d->point("view");
  d->press(1);
  d->frames(60);
  CHECK(d->app().scene.log().touching());
  d->release(1);
  const Camera before = d->app().scene.camera;
  d->drag("view", 60, 0, 0);
  CHECK_FALSE(d->app().scene.camera == before);
}

TEST_CASE("with a decimal comma 1.4 Å reads 1,4 Å, and the other way about") {
  auto d = startWith("argon");
  CHECK(d->text("probe") == "1.4\u00a0Å");
  d->app().settings.decimal_sign = DecimalSign::Comma;
  d->frames(2);
  CHECK(d->text("probe") == "1,4\u00a0Å");
  CHECK(d->click("tool/preferences"));
  d->frames(3);
  CHECK(d->click("preferences/numbers/1.4"));
  d->frames(2);
  CHECK(d->text("probe") == "1.4\u00a0Å");
  CHECK(d->app().settings.decimal_sign == DecimalSign::Point);
}

TEST_CASE(
    "a pressed spring stores half the square of its force over its stiffness, as the touch panel's "
    "details show") {
  auto d = startWith("argon");
  d->app().panels.touch_details = true;
  d->frames(3);
  CHECK(d->text("energy") == "Energy in the spring: 0.00\u00a0mJ");
  d->point("view");
  d->press(0);
  d->frames(120);
  const double force_N = d->app().scene.log().force_N();
  REQUIRE(force_N > 0.3);
  const double mJ = force_N * force_N / (2.0 * d->app().scene.servo_settings.stiffness_N_per_mm);  // N mm
  const std::string reported = d->text("energy"), before = "Energy in the spring: ";
  REQUIRE(reported.starts_with(before));
  CHECK(std::strtod(reported.c_str() + before.size(), nullptr) == doctest::Approx(mJ).epsilon(0.05));
  d->app().scene.servo_settings.force_on = false;
  d->frames(3);
  CHECK(d->text("energy") == "Energy in the spring: 0.00\u00a0mJ");
  d->release(0);
}

TEST_CASE("preferences change the theme, the size and the atoms' colours at once") {
  auto d = startWith("1ubq");
  d->tap("Ctrl+,");
  d->frames(3);
  REQUIRE(d->shows("preferences/close"));
  CHECK(d->click("preferences/theme/High contrast"));
  CHECK(d->app().settings.theme == ThemeChoice::HighContrast);
  CHECK(d->click("preferences/larger"));
  d->frames(3);
  CHECK(d->app().settings.scale == 1.25);
  CHECK(d->click("preferences/smaller"));
  d->tap("Escape");
  d->frames(12);
  REQUIRE_FALSE(d->shows("preferences/close"));
  const Picture customary = d->picture();
  d->app().settings.colour_blind_safe = true;
  d->frames(12);
  CHECK(difference(customary, d->picture()) > 0.05);
}

TEST_CASE(
    "text grows separately: at 150 % a line of text is 1.5 times as high, and the tool bar's icons "
    "keep their size") {
  auto d = startWith("argon");
  const auto high = [](const char* name) { return widgets().find(name)->high.y - widgets().find(name)->low.y; };
  const float sign = high("tool/open"), row = high("show/hip"), words = look().font(Font::Body)->FontSize;
  d->tap("Ctrl+,");
  d->frames(3);
  CHECK(d->click("preferences/text-size/150 %"));
  d->tap("Escape");
  d->frames(3);
  CHECK(d->app().settings.text_size == 1.5);
  CHECK(d->app().settings.scale == 1.0);
  CHECK(look().font(Font::Body)->FontSize == doctest::Approx(1.5 * words).epsilon(0.05));
  CHECK(high("show/hip") == doctest::Approx(1.5 * row).epsilon(0.05));
  CHECK(high("tool/open") == sign);
}

TEST_CASE(
    "where more than one element is drawn its colours are named in the view, commonest first, in the colours as they "
    "are "
    "drawn; of one element alone only in colours that are not the customary ones; an element that is hidden is not "
    "named") {
  auto d = startWith("1ubq");
  CHECK(d->text("view/legend") == "carbon, oxygen, nitrogen, sulfur");
  // Calm as those of a large molecule: what the legend shows is what the picture shows.
  const Molecule& m = *d->app().scene.stage().molecule;
  const std::vector<LegendEntry> entries =
      legendOf(m, ColourBy::Element, ElementColours::Customary, d->app().scene.look.atoms);
  CHECK(entries.at(1).colour == elementColour(8, ElementColours::Calm));
  std::vector<std::uint32_t> sulfurs;
  for (std::uint32_t a = 0; a < m.atoms.size(); ++a)
    if (m.atoms[a].atomic_number == 16) sulfurs.push_back(a);
  d->app().scene.look.atoms.hidden = std::make_shared<const std::vector<std::uint32_t>>(sulfurs);
  d->frames(2);
  CHECK(d->text("view/legend") == "carbon, oxygen, nitrogen");
  d->app().scene.look.atoms.hidden = nullptr;
  // A cartoon has one colour per residue, which does not identify elements.
  d->app().scene.look.atoms.styles = {{.style = DrawStyle::Cartoon}};
  d->app().scene.look.atoms.spheres_near_A = 0.0;
  d->frames(2);
  CHECK_FALSE(d->shows("view/legend"));
  // Where atoms come out of it near the probe, these have their elements' colours.
  d->app().scene.look.atoms.spheres_near_A = 4.0;
  d->frames(2);
  CHECK(contains(d->text("view/legend"), "oxygen"));
  d->app().scene.look.atoms.styles.clear();
  d->app().settings.colour_blind_safe = true;
  d->frames(2);
  CHECK(d->text("view/legend") == "carbon, oxygen, nitrogen, sulfur");
  d->app().settings.legend = false;
  d->frames(2);
  CHECK_FALSE(d->shows("view/legend"));
  d->app().settings = {};
  d->app().open("argon");
  d->app().finishLoading();
  d->frames(10);
  CHECK_FALSE(d->shows("view/legend"));
  d->app().settings.colour_blind_safe = true;
  d->frames(2);
  CHECK(d->text("view/legend") == "argon");
}

TEST_CASE(
    "a legend that would take more than a third of the view's width or half of its height is a closed line; a click "
    "opens it, and closes it again") {
  auto d = startWith("2hhb", smallScreen());
  d->app().messages = {};
  d->frames(3);
  const Rectangle view = d->app().layout().view;
  CHECK_FALSE(d->shows("view/legend"));
  REQUIRE(d->text("view/legend/line") == "closed");
  const WidgetRecord* line = widgets().find("view/legend/line");
  CHECK(line->high.y - line->low.y < 0.1f * view.size().y);
  CHECK(d->click("view/legend/line"));
  d->frames(3);
  CHECK(contains(d->text("view/legend"), "chain A, chain B"));
  const WidgetRecord* open = widgets().find("view/legend");
  REQUIRE(open);
  CHECK(open->low.y >= widgets().find("view/legend/line")->high.y);
  CHECK(open->high.y <= view.high.y);
  CHECK(open->high.x <= view.high.x);
  CHECK(d->click("view/legend/line"));
  d->frames(3);
  CHECK_FALSE(d->shows("view/legend"));
  // A wide one needs no line.
  d->app().settings.scale = 0.75;
  d->frames(5);
  CHECK(d->shows("view/legend"));
  CHECK_FALSE(d->shows("view/legend/line"));
}

TEST_CASE(
    "a molecule of four chains opens with a colour for each, what is no chain keeps its own; by the menu it has its "
    "elements' colours, and undo brings the chains back") {
  auto d = startWith("2hhb");
  d->app().messages = {};
  d->frames(10);
  CHECK(d->app().scene.look.colour_by == ColourBy::Chain);
  CHECK(d->text("view/legend").starts_with("chain A, chain B, chain C, chain D, carbon"));
  CHECK(contains(d->text("view/legend"), "iron"));
  const Picture chains = d->picture();
  d->click("menu/view");
  d->frames(3);
  CHECK(d->click("menu/view/colours"));
  d->frames(3);
  CHECK(d->click("menu/view/colours/element"));
  d->frames(10);
  CHECK(d->text("view/legend") == "carbon, oxygen, nitrogen, sulfur, iron, phosphorus");
  CHECK(difference(chains, d->picture()) > 0.1);
  CHECK(d->click("tool/undo"));
  d->frames(10);
  CHECK(contains(d->text("view/legend"), "chain A"));
  CHECK(d->app().scene.look.colour_by == ColourBy::Chain);
}

TEST_CASE(
    "the menu's styles change the picture one by one, a lesson that locks what is shown keeps its own, and the cut "
    "opens the molecule") {
  auto d = startWith("1ubq");
  d->frames(10);
  const Picture spheres = d->picture();
  d->app().scene.look.atoms.styles = {{.style = DrawStyle::Surface}};
  d->frames(10);
  const Picture surface = d->picture();
  CHECK(difference(spheres, surface) > 0.02);
  findAction("cut")->run(d->app());
  REQUIRE(d->app().scene.look.atoms.cut);
  d->frames(10);
  CHECK(difference(surface, d->picture()) > 0.02);
  findAction("cut")->run(d->app());
  CHECK_FALSE(d->app().scene.look.atoms.cut);
  Scratch scratch;
  const auto file =
      scratch.file("mine.md",
                   "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: 1ubq\nauthor: A\nlicence: L\n---\n"
                   "## One\n```scene\nmolecule: 1ubq\nstyle: surface 50% for residue 1-40, spheres for residue 41-76\n"
                   "hide: residue 5\nlocked: show\n```\nText.\n");
  d.reset();  // one window at a time
  auto lesson = startWith(file.string());
  const AtomsLook& look = lesson->app().scene.look.atoms;
  REQUIRE(look.styles.size() == 2);
  CHECK(look.styles[0].style == DrawStyle::Surface);
  CHECK(look.styles[0].opacity == 0.5f);
  CHECK(look.styles[0].atoms->size() + look.styles[1].atoms->size() ==
        lesson->app().scene.stage().molecule->atoms.size());
  CHECK(look.hidden->size() == 7);  // the heavy atoms of valine
  lesson->app().scene.look.atoms.styles.clear();
  lesson->frames(2);
  CHECK(lesson->app().scene.look.atoms.styles.size() == 2);
}

TEST_CASE("a lesson's scene colours by chain until another scene says otherwise, and locks it with what is shown") {
  Scratch scratch;
  const auto file =
      scratch.file("mine.md",
                   "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: 1ubq, argon\nauthor: A\nlicence: L\n---\n"
                   "## One\n```scene\nmolecule: 1ubq\ncolour: chain\nlocked: show\n```\nText.\n## Two\nText.\n## "
                   "Three\n```scene\nmolecule: argon\n```\nText.\n");
  auto d = startWith(file.string());
  CHECK(d->text("view/legend") == "chain A");
  d->app().scene.look.colour_by = ColourBy::Element;
  d->frames(2);
  CHECK(d->app().scene.look.colour_by == ColourBy::Chain);
  d->app().lesson.next();
  d->frames(3);
  CHECK(d->app().scene.look.colour_by == ColourBy::Chain);
  d->app().lesson.next();
  d->frames(3);
  CHECK(d->app().scene.look.colour_by == ColourBy::Element);
}

TEST_CASE("text has a contrast to its background of 4.5 to 1 in the light and dark theme, 7 to 1 in high contrast") {
  auto d = startWith("argon");
  for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark, ThemeChoice::HighContrast}) {
    d->app().settings.theme = theme;
    d->frames(3);
    const Palette& p = look().palette;
    const double least = theme == ThemeChoice::HighContrast ? 7.0 : 4.5;
    CAPTURE(themeName(theme));
    for (const ImU32 ground : {p.panel, p.raised}) {
      CHECK(contrast(p.text, ground) >= least);
      CHECK(contrast(p.quiet, ground) >= least);
    }
    CHECK(contrast(p.accent_text, p.accent) >= least);
    CHECK(contrast(p.text, p.accent_soft) >= least);
    CHECK(contrast(p.good, p.good_soft) >= (least > 5 ? 7.0 : 3.0));
    CHECK(contrast(p.bad, p.bad_soft) >= (least > 5 ? 7.0 : 3.0));
    CHECK(contrast(p.warn, p.warn_soft) >= (least > 5 ? 7.0 : 3.0));
  }
}

TEST_CASE("Ctrl+Shift+S asks for a name, refuses to overwrite without a click, and writes the picture") {
  Scratch scratch;
  ScriptedUser::Options options;
  options.application.picture_folder = scratch.folder;
  auto d = startWith("argon", options);
  d->tap("Ctrl+Shift+S");
  d->frames(3);
  REQUIRE(d->shows("file/name"));
  CHECK(d->text("file/name") == "moltact-001.png");
  CHECK(d->click("file/choose"));
  d->frames(3);
  CHECK(std::filesystem::exists(scratch.folder / "moltact-001.png"));
  d->tap("Ctrl+Shift+S");
  d->frames(3);
  d->app().file_dialog.written = "moltact-001";
  d->frames(2);
  CHECK(d->shows("file/warning"));
  CHECK(d->text("file/choose") == "Replace it");
  d->tap("Escape");
  d->frames(2);
  CHECK_FALSE(d->shows("file/name"));
}

TEST_CASE("a stored preference of every kind is restored") {
  Scratch scratch;
  Settings s;
  s.theme = ThemeChoice::HighContrast;
  s.colour_blind_safe = s.left_handed = true;
  s.decimal_sign = DecimalSign::Comma;
  s.units = {{"length", "nm"}, {"force", "mN"}};
  s.language = "de";
  s.text_size = 1.3;
  s.legend = false;
  s.lesson_folder = "/tmp/lessons of mine";
  REQUIRE(saveSettings(s, scratch.folder / "settings.json").empty());
  CHECK(loadSettings(scratch.folder / "settings.json").settings == s);
}

TEST_CASE("a settings file from before the choice of three that wanted a decimal comma still gives one") {
  Scratch scratch;
  const auto file = scratch.file("settings.json", R"({"decimal_comma": true})");
  CHECK(loadSettings(file).settings.decimal_sign == DecimalSign::Comma);
  CHECK(loadSettings(scratch.file("other.json", R"({"decimal_comma": true, "decimal_sign": "point"})"))
            .settings.decimal_sign == DecimalSign::Point);
}

TEST_CASE("F11 enters and leaves full screen") {
  auto d = startWith("argon");
  d->tap("F11");
  CHECK(d->app().panels.window.full_screen);
  d->tap("F11");
  CHECK_FALSE(d->app().panels.window.full_screen);
}

}  // namespace moltact
