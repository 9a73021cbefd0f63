// Nothing is cut off: every widget of every page lies inside its window, at each scale and in each theme.
#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/actions.h"
#include "app/ui/panels/panels.h"
#include "app/ui/panels/side_panel.h"
#include "app/ui/widgets/rich_text.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/platform/folders.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

// The names of widgets that extend beyond their window sideways, or vertically if it cannot be scrolled.
std::string cutOff(glm::vec2 window) {
  std::string out;
  for (const auto& [name, r] : widgets().all()) {
    const glm::vec2 low = glm::max(r.clip_low, glm::vec2(0.0f)), high = glm::min(r.clip_high, window);
    const bool sideways = r.low.x < low.x - 1 || r.high.x > high.x + 1;
    const bool upright = !r.scrolls && (r.low.y < low.y - 1 || r.high.y > high.y + 1);
    if (sideways || upright) out += name + ' ';
  }
  return out;
}

const std::string kLongTitle = "A lesson of a length that a title may have";

struct Page {
  std::string name;
  std::function<void(ScriptedUser&)> show;
};

// A lesson with an aside, locks and colours by chain; a copy of it with mistakes; an attempt.
struct Files {
  ScratchFolder scratch;
  std::string lesson, wrong, attempt;

  Files() {
    const std::string head = "---\ntitle: " + kLongTitle +
                             "\nminutes: 1\ngoals: G\nmolecules: 1ubq\nauthor: "
                             "A\nlicence: L\nlocked: all\n---\n";
    const std::string text =
        "## One\n```scene\nmolecule: 1ubq\ncolour: chain\n```\nSee [more](#aside-more).\n## Aside: More\nText.\n## "
        "Two\nText.\n";
    lesson = (scratch.path / "mine.md").string();
    wrong = (scratch.path / "wrong.md").string();
    attempt = (scratch.path / "mine.jsonl").string();
    writeFile(lesson, head + text);
    writeFile(wrong, head + text + "[x](#nowhere)\n```touch\nreech: all\n```\n");
    std::string lines = lineOf(sampleHeader());
    for (const AttemptEvent& e : sampleEvents()) lines += lineOf(e);
    writeFile(attempt, lines);
  }
};
const std::string& fileOf(std::string Files::*member) {
  static const Files files;
  return files.*member;
}

void beginTurns(ScriptedUser& d) {
  d.app().extensions().turns.begin({"Ana with a long second name", "Bo", "Carla"}, 60.0);
  d.frames(3);
}

// Pages that a flag opens and tabs beside the view come from their tables.
const Page kStates[] = {
    {"lesson", [](ScriptedUser&) {}},
    {"touch details", [](ScriptedUser& d) { d.app().panels.touch_details = true; }},
    {"message",
     [](ScriptedUser& d) {
       d.app().messages.error("benzene.pdb:12:3: this is no number; write one there and open the file again");
     }},
    {"file", [](ScriptedUser& d) { d.app().askForPictureAs(); }},
    {"legend", [](ScriptedUser& d) { d.app().settings.colour_blind_safe = true; }},
    {"all force stopped", [](ScriptedUser& d) { d.app().scene.servo_settings.panic = true; }},
    {"add a lesson", [](ScriptedUser& d) { d.app().panels.pages.open = d.app().panels.open_adds = true; }},
    {"name", [](ScriptedUser& d) { d.app().extensions().name_asker.ask(false); }},
    {"code", [](ScriptedUser& d) { d.app().extensions().name_asker.ask(true); }},
    {"hand over", beginTurns},
    {"turns strip", [](ScriptedUser& d) { beginTurns(d), d.app().extensions().turns.start(); }},
    {"playback", [](ScriptedUser& d) { d.app().open(fileOf(&Files::attempt)); }},
    {"locks, touch",
     [](ScriptedUser& d) { d.app().open(fileOf(&Files::lesson)), d.app().panels.lesson_first = false; }},
    {"aside", [](ScriptedUser& d) { d.app().open(fileOf(&Files::lesson)), d.app().lesson.follow("#aside-more"); }},
    {"mistakes",
     [](ScriptedUser& d) { d.app().open(fileOf(&Files::wrong)), d.app().panels.lesson_memory.problems = true; }},
};

void closePages(PanelState& panels) {
  for (const Panel& panel : allPanels())
    if (panel.page) panels.pages.*panel.page = false;
}

std::vector<Page> pages() {
  std::vector<Page> out(std::begin(kStates), std::end(kStates));
  for (const Panel& panel : allPanels())
    if (panel.page)
      out.push_back({std::string(panel.name), [&panel](ScriptedUser& d) { d.app().panels.pages.*panel.page = true; }});
  for (const SideTab& tab : sideTabs())
    out.push_back({tab.key, [&tab](ScriptedUser& d) { d.app().panels.tabs.open(tab.key); }});
  return out;
}

void closeAll(ScriptedUser& d) {
  PanelState& p = d.app().panels;
  for (int k = 0; k < 2; ++k) {
    d.tap("Escape");
    closePages(p);
    d.app().file_dialog.close();
    d.frames(2);
  }
  closePages(p);
  p.lesson_memory.problems = false;
  for (const SideTab& tab : sideTabs()) p.tabs.close(tab.key);
  d.app().settings.colour_blind_safe = d.app().scene.servo_settings.panic = false;
  if (d.app().extensions().turns.on()) d.app().extensions().turns.end();
  d.app().extensions().playback.close(false);
  openFirst(d);
  while (!d.app().messages.all().empty()) d.app().messages.dismiss(0);
  d.frames(2);
}

void checkAllPages(ScriptedUser& d, glm::vec2 window) {
  for (const Page& page : pages()) {
    page.show(d);
    d.frames(5);
    REQUIRE_FALSE(widgets().all().empty());
    CAPTURE(page.name);
    CHECK(cutOff(window) == "");
    closeAll(d);
  }
}

// The first two overlapping items over the view; names at atoms are part of the picture and excluded.
std::string covered() {
  std::vector<std::pair<std::string, WidgetRecord>> over;
  for (const auto& [name, r] : widgets().all())
    if ((name.starts_with("view/") && !name.starts_with("view/label") && !name.starts_with("view/measure/") &&
         !name.starts_with("view/state/") && name != "view/legend/closed") ||
        name == "limits" || (name.starts_with("message/") && name.find('/', 8) == std::string::npos))
      over.emplace_back(name, r);
  std::string out;
  for (std::size_t j = 0; j < over.size(); ++j)
    for (std::size_t k = j + 1; k < over.size(); ++k) {
      const WidgetRecord &a = over[j].second, &b = over[k].second;
      const glm::vec2 both = glm::min(a.high, b.high) - glm::max(a.low, b.low);
      if (both.x > 1.0f && both.y > 1.0f) out += over[j].first + " on " + over[k].first + "; ";
    }
  return out;
}

}  // namespace

TEST_CASE(
    "over the view of 1024x640, 1280x800 and 2560x1440 at 100, 150 and 200 % nothing covers anything: messages, "
    "legend, "
    "state, hint, limit, depth, scale bar and force") {
  for (const double scale : {1.0, 1.5, 2.0})
    for (const auto& [width, height] : {std::pair{1024, 640}, {1280, 800}, {2560, 1440}}) {
      ScriptedUser::Options options;
      options.content_scale = scale;
      options.width = width;
      options.height = height;
      auto d = startWith("", options);
      CAPTURE(scale);
      CAPTURE(width);
      d->app().open(std::string(MOLTACT_SOURCE_DIR) + "/lessons/a-drug-in-its-tunnel.md");
      d->app().finishLoading();
      d->frames(20);
      CHECK(covered() == "");
      d->app().messages.notice("A message of some length, which takes more than one line where the window is small.");
      d->app().messages.warning("A second one, which is true at the same time.");
      d->frames(3);
      CHECK(covered() == "");
      // A press that rests, with the hint and the depth, and a limit that acts.
      d->point("view", 0.5, 0.5);
      d->press();
      for (const bool stopped : {false, true}) {
        d->app().scene.servo_settings.panic = stopped;
        d->frames(100);
        CAPTURE(stopped);
        CHECK(covered() == "");
        CHECK(d->shows("limits") == stopped);
        if (scale < 2.0) CHECK(d->shows("view/state"));  // else a message may lie under the pointer
      }
      d->app().scene.servo_settings.panic = false;
      d->app().panels.legend = true;
      while (!d->app().messages.all().empty()) d->app().messages.dismiss(0);
      d->frames(30);
      CHECK(covered() == "");
      d->release();
      // The two states' slider, and a press beside the molecule.
      d->app().open(std::string(MOLTACT_SOURCE_DIR) + "/lessons/an-enzymes-door.md");
      d->app().finishLoading();
      d->frames(20);
      CHECK(covered() == "");
      d->point("view", 0.03, 0.93);
      d->press();
      d->frames(60);
      CHECK(covered() == "");
      d->release();
    }
}

TEST_CASE("a figure over the view is broken neither at its decimal point nor from its unit, however narrow the line") {
  auto d = startWith("argon");
  for (float width = 60.0f; width < 400.0f; width += 7.0f) {
    const std::string lines = wrapped("touching: argon atom 2, 0.6\u00a0N, and 12.25\u00a0Å deep", width);
    CAPTURE(width);
    CHECK(contains(lines, "0.6\u00a0N"));
    CHECK(contains(lines, "12.25\u00a0Å"));
  }
}

// The file dialog and a live class open their pages.
TEST_CASE(
    "each page but those of the file dialog and of a class is opened by a flag of its own, which shows widgets, and "
    "Escape closes it") {
  auto d = startWith("argon");
  std::vector<bool OpenPages::*> flags;
  for (const Panel& panel : allPanels()) {
    CAPTURE(panel.name);
    CHECK(bool(panel.page) == (panel.name.ends_with("Page") && panel.name != "FilePage" && panel.name != "ClassPage"));
    if (!panel.page) continue;
    CHECK(std::find(flags.begin(), flags.end(), panel.page) == flags.end());
    flags.push_back(panel.page);
    std::set<std::string> before;
    for (const auto& [name, record] : widgets().all()) before.insert(name);
    d->app().panels.pages.*panel.page = true;
    d->frames(5);
    std::size_t fresh = 0;
    for (const auto& [name, record] : widgets().all()) fresh += !before.contains(name);
    CHECK(fresh > 0);
    d->tap("Escape");
    d->frames(3);
    CHECK_FALSE(d->app().panels.pages.*panel.page);
  }
  CHECK(flags.size() >= 7);
}

TEST_CASE("on every page at 100 % and 200 % of 1280x800, in every theme, every widget lies inside its panel") {
  for (const double scale : {1.0, 2.0}) {
    ScriptedUser::Options options;
    options.content_scale = scale;
    auto d = startWith("", options);
    openFirst(*d);
    d->frames(3);
    for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark, ThemeChoice::HighContrast}) {
      d->app().settings.theme = theme;
      CAPTURE(scale);
      CAPTURE(themeName(theme));
      checkAllPages(*d, {1280, 800});
    }
  }
}

TEST_CASE(
    "on every page of 1024x768 at 200 % every widget lies inside its panel; in the lesson of most chains the legend is "
    "a "
    "closed line that leaves the view's middle free, and the first task's card is in sight") {
  auto d = startWith("", smallScreen());
  openFirst(*d);
  d->frames(3);
  checkAllPages(*d, {1024, 768});
  d->app().open(std::string(MOLTACT_SOURCE_DIR) + "/lessons/four-chains-as-one.md");
  d->app().finishLoading();
  d->frames(20);
  CHECK(cutOff({1024, 768}) == "");
  const Rectangle view = d->app().layout().view;
  CHECK_FALSE(d->shows("view/legend"));
  const WidgetRecord* line = widgets().find("view/legend/line");
  REQUIRE(line);
  const glm::vec2 size = line->high - line->low;
  CHECK(size.x * size.y < 0.1f * view.size().x * view.size().y);
  const glm::vec2 middle = 0.5f * (view.low + view.high);
  CHECK_FALSE((line->low.x < middle.x && line->high.x > middle.x && line->low.y < middle.y && line->high.y > middle.y));
}

TEST_CASE("on every page of a small and of a large window at 150 % every widget lies inside its panel") {
  ScriptedUser::Options options;
  options.content_scale = 1.5;
  auto d = startWith("", options);
  openFirst(*d);
  for (const auto& [width, height] : {std::pair{640, 480}, {800, 600}, {1920, 1080}}) {
    d->resize(width, height);
    CAPTURE(width);
    checkAllPages(*d, {width, height});
  }
}

TEST_CASE("on every page of a telephone's upright window every widget lies inside its panel") {
  auto d = startWith("");
  openFirst(*d);
  d->resize(390, 844);
  checkAllPages(*d, {390, 844});
}

TEST_CASE("on every page with letters of 130 % and 150 % every widget lies inside its panel") {
  auto d = startWith("");
  openFirst(*d);
  for (const double size : {1.3, 1.5}) {
    d->app().settings.text_size = size;
    CAPTURE(size);
    checkAllPages(*d, {1280, 800});
  }
}

TEST_CASE("in every language no text of a page at 1280x800 sticks out, nor is one cut off that is whole in English") {
  auto d = startWith("");
  openFirst(*d);
  std::map<std::string, std::set<std::string>> in_english;
  for (const Language& language : languages(translationsFolder())) {
    d->app().settings.language = language.code;
    d->app().panels.tabs.show(true);
    d->frames(3);
    REQUIRE(moltact::language() == language.code);
    CAPTURE(language.code);
    for (const Page& page : pages()) {
      page.show(*d);
      d->frames(5);
      CAPTURE(page.name);
      CHECK(cutOff({1280, 800}) == "");
      std::string cut;
      // Names of files and titles of lessons may be too long in any language.
      for (const std::string& text : widgets().cut())
        if (text != kLongTitle && !in_english[page.name].contains(text)) cut += "\n" + text;
      if (language.code == "en")
        in_english[page.name] = widgets().cut();
      else
        CHECK(cut == "");
      closeAll(*d);
    }
  }
}

TEST_CASE("in every language the menus are whole, and no two begin with the same letter") {
  auto d = startWith("argon");
  for (const Language& language : languages(translationsFolder())) {
    d->app().settings.language = language.code;
    d->frames(3);
    CAPTURE(language.code);
    std::set<int> letters;
    for (int menu = 0; menu < kMenus; ++menu) {
      const std::string name = "menu/" + lower(menuName(Menu(menu)));
      CHECK(letters.insert(menuLetter(Menu(menu))).second);
      CHECK(d->text(name) == menuLabel(Menu(menu)));
      CHECK(d->click(name));
      d->frames(3);
      // A menu is as wide as its longest line; that must have room.
      for (const auto& [item, r] : widgets().all()) {
        CAPTURE(item);
        if (item.starts_with(name + "/")) CHECK((r.low.x >= 0 && r.high.x <= 1280 && r.high.y <= 800));
      }
      d->tap("Escape");
      d->frames(3);
    }
  }
}

TEST_CASE("with numbers of the longest kind and a long file name the status bar keeps within its line") {
  auto d = startWith("1ubq");
  for (const int width : {1280, 900, 640, 480}) {
    d->resize(width, 700);
    CAPTURE(width);
    CHECK(cutOff({width, 700}) == "");
    CHECK(d->shows("status/contact"));
    CHECK(d->shows("tool/welcome"));
  }
}

}  // namespace moltact
