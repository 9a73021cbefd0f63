// Nothing is cut off: every widget of every page lies in the window that it stands in, at each scale and in each theme.
#include <functional>

#include "app/ui/extensions.h"
#include "tests/app/driver_fixture.h"

namespace moltact {
namespace {

// The names of widgets that stick out of their window sideways, or upward and downward where it cannot be scrolled.
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

struct Page {
  const char* name;
  std::function<void(Driver&)> show;
};

const Page kPages[] = {
    {"lesson", [](Driver&) {}},
    {"touch details", [](Driver& d) { d.app().panels.touch_details = true; }},
    {"methods", [](Driver& d) { d.app().panels.showMethods(true); }},
    {"message", [](Driver& d) { d.app().messages.error("benzene.pdb:12:3: this is no number; write one there and open the file again"); }},
    {"controls", [](Driver& d) { d.app().panels.controls_page = true; }},
    {"about", [](Driver& d) { d.app().panels.about_page = true; }},
    {"preferences", [](Driver& d) { d.app().panels.preferences_page = true; }},
    {"open", [](Driver& d) { d.app().panels.open_page = true; }},
    {"file", [](Driver& d) { d.app().askForPictureAs(); }},
    {"welcome", [](Driver& d) { d.app().panels.welcome = true; }},
};

void closeAll(Driver& d) {
  PanelState& p = d.app().panels;
  for (int k = 0; k < 2; ++k) {
    d.tap("Escape");
    p.welcome = p.controls_page = p.about_page = p.preferences_page = p.open_page = false;
    d.app().file_dialog.close();
    d.frames(2);
  }
  p.welcome = false;
  p.showMethods(false);
  while (!d.app().messages.all().empty()) d.app().messages.dismiss(0);
  d.frames(2);
}

void checkAllPages(Driver& d, glm::vec2 window) {
  for (const Page& page : kPages) {
    page.show(d);
    d.frames(5);
    CAPTURE(page.name);
    CHECK(cutOff(window) == "");
    closeAll(d);
  }
}

}  // namespace

TEST_CASE("on every page at 100 % and 200 % of 1280x800, in every theme, every widget lies inside its panel") {
  for (const double scale : {1.0, 2.0}) {
    Driver::Options options;
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

TEST_CASE("on every page of a small and of a large window at 150 % every widget lies inside its panel") {
  Driver::Options options;
  options.content_scale = 1.5;
  auto d = startWith("", options);
  openFirst(*d);
  for (const auto& [width, height] : {std::pair{640, 480}, {800, 600}, {1920, 1080}}) {
    d->resize(width, height);
    CAPTURE(width);
    checkAllPages(*d, {width, height});
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
