// The start page: lessons as cards, the last lesson, and molecules to explore. The arrow keys select a card and Enter
// opens it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/files/library.h"
#include "app/ui/panels/actions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/imgui_versions.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr float kWidest = 1160.0f, kLessonWidth = 262.0f, kMoleculeWidth = 178.0f, kCardGap = 18.0f;  // at 96 dpi

struct CardText {
  std::string name, title, line, tip;
  std::string about = {};  ///< two small lines of summary, if the section's cards have them
  float progress = -1.0f;  ///< negative: no bar
  bool done = false, bad = false;
};

// The position of a card among all cards, for the keys.
struct Grid {
  explicit Grid(PanelState& p) : panels(p) {}

  PanelState& panels;
  float width = 0.0f;  ///< of the page's content
  std::size_t count = 0;
  std::vector<std::size_t> columns;  ///< of each card's section
  bool enter = false;

  bool selected() const { return panels.card.card == count; }
};

// At most two lines of a title.
std::string twoLines(const std::string& text, float width) {
  const char* end = ImGui::GetFont()->CalcWordWrapPositionA(1.0f, text.c_str(), text.c_str() + text.size(), width);
  const std::size_t first = std::size_t(end - text.c_str());
  if (first >= text.size()) return text;
  std::size_t next = first;
  while (next < text.size() && text[next] == ' ') ++next;
  return text.substr(0, first) + "\n" + elided(text.substr(next), width);
}

void drawProgress(ImDrawList* draw, const CardText& text, ImVec2 a, float width) {
  const Palette& p = look().palette;
  const float high = look().px(5);
  const ImVec2 b{a.x + width, a.y + high};
  draw->AddRectFilled(a, b, p.pressed, 0.5f * high);
  if (text.progress > 0.0f)
    draw->AddRectFilled(a, {a.x + std::max(high, width * std::min(1.0f, text.progress)), b.y},
                        text.done ? p.good : p.accent, 0.5f * high);
}

// `find` returns the picture, and is called only while the card is in sight.
template <class Find>
bool drawCard(Grid& grid, const CardText& text, Find find, float width, bool abouts = false) {
  const Look& l = look();
  const Palette& p = l.palette;
  const float pad = l.px(12), round = l.px(10), shot = std::round(width * 9.0f / 16.0f);
  const float line = ImGui::GetTextLineHeight(), small_line = l.font(Font::Small)->FontSize;
  const float about_h = abouts ? 2 * small_line + l.px(7) : 0.0f;
  const float height =
      shot + pad + 2 * line + l.px(5) + about_h + small_line + (text.progress >= 0.0f ? l.px(14) : 0.0f) + pad;
  ImGui::PushID(text.name.c_str());
  const bool clicked = ImGui::InvisibleButton("card", {width, height});
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImTextureID picture = ImGui::IsItemVisible() ? find() : ImTextureID{};
  const bool hovered = ImGui::IsItemHovered();
  if (keysAtItem()) grid.panels.card.card = grid.count;
  const bool selected = grid.selected();
  if (selected && grid.panels.card.scroll) {
    grid.panels.card.scroll = false;
    ImGui::SetScrollHereY(0.5f);
  }
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, hovered || selected ? p.hovered : p.raised, round);
  const ImVec2 shot_end{high.x, low.y + shot};
  if (picture)
    draw->AddImageRounded(picture, low, shot_end, {0, 0}, {1, 1}, IM_COL32_WHITE, round, ImDrawFlags_RoundCornersTop);
  else
    draw->AddRectFilled(low, shot_end, p.pressed, round, ImDrawFlags_RoundCornersTop);
  float y = low.y + shot + pad;
  {
    WithFont strong(Font::Strong);
    const std::string title = twoLines(text.title, width - 2 * pad);
    draw->AddText({low.x + pad, y}, text.bad ? p.bad : p.text, title.c_str());
  }
  y += 2 * line + l.px(5);
  {
    WithFont small(Font::Small);
    if (abouts) draw->AddText({low.x + pad, y}, p.quiet, twoLines(text.about, width - 2 * pad).c_str());
    y += about_h;
    const float mark = text.done ? l.px(20) : 0.0f;
    const std::string shown = elided(text.line, width - 2 * pad - mark);
    draw->AddText({low.x + pad, y}, text.bad ? p.bad : p.quiet, shown.c_str());
    if (text.done) drawIcon(draw, Icon::Check, {high.x - pad - l.px(7), y + 0.5f * small_line}, l.px(13), p.good);
  }
  if (text.progress >= 0.0f) drawProgress(draw, text, {low.x + pad, high.y - pad - l.px(5)}, width - 2 * pad);
  const float edge = std::max(1.0f, std::round(l.scale));
  draw->AddRect(low, high, hovered || selected ? p.accent : p.line, round, 0, selected ? 2 * edge : edge);
  recordItem(text.name, text.title + "\n" + text.line + (text.about.empty() ? "" : "\n" + text.about));
  tip(text.tip.c_str());
  const bool entered = selected && grid.enter;
  ++grid.count;
  return clicked || entered;
}

// Lays cards out in rows; draw(k, width) draws card k.
template <class Draw>
void rows(Grid& grid, std::size_t count, float card_width, Draw draw) {
  const float gap = look().px(kCardGap), left = ImGui::GetCursorPosX();
  const std::size_t columns = std::max<std::size_t>(1, std::size_t((grid.width + gap) / (look().tx(card_width) + gap)));
  const float width = std::floor((grid.width - gap * float(columns - 1)) / float(columns));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (std::size_t k = 0; k < count; ++k) {
    if (k % columns)
      ImGui::SameLine();
    else
      ImGui::SetCursorPosX(left);
    grid.columns.push_back(columns);
    draw(k, width);
  }
  ImGui::PopStyleVar();
  ImGui::SetCursorPosX(left);
}

void heading(const char* text) {
  ImGui::Dummy({0, look().px(10)});
  WithFont title(Font::Title);
  ImGui::TextUnformatted(text);
  ImGui::Dummy({0, look().px(2)});
}

CardText textOf(const LessonCard& card) {
  CardText t;
  t.name = (card.own ? "welcome/own/" : "welcome/lesson/") + card.id;
  t.title = card.title;
  if (!card.fault.empty()) {
    t.line = tr("cannot be opened");
    t.tip = card.fault;
    t.bad = true;
    return t;
  }
  t.about = card.description;
  if (card.minutes > 0) t.line = quantityText(60.0 * card.minutes, Dimension::Time, {plain(), "min"});
  if (!card.level.empty()) t.line += (t.line.empty() ? "" : " · ") + std::string(tr(card.level.c_str()));
  t.progress = card.progress ? float(card.progress->share()) : 0.0f;
  t.done = card.progress && card.progress->finished;
  if (card.progress && card.progress->canResume()) t.tip = trf("Go on at: {0}", card.progress->step_title);
  return t;
}

void drawLessons(Application& app, Grid& grid, bool own) {
  Extensions& e = app.extensions();
  std::vector<const LessonCard*> cards;
  for (const LessonCard& c : e.lesson_list.cards())
    if (c.own == own) cards.push_back(&c);
  if (cards.empty()) return;
  const bool abouts =
      std::any_of(cards.begin(), cards.end(), [](const LessonCard* c) { return !c->description.empty(); });
  heading(own ? tr("Your lessons") : tr("Lessons"));
  const LessonCard* chosen = nullptr;
  rows(grid, cards.size(), kLessonWidth, [&](std::size_t k, float width) {
    const LessonCard& c = *cards[k];
    const auto picture = [&] { return c.scene ? e.card_pictures.find({c.molecule, *c.scene}) : ImTextureID{}; };
    if (drawCard(grid, textOf(c), picture, width, abouts)) chosen = &c;
  });
  if (chosen) e.lesson_list.begin(*chosen);
}

// Sets the open lesson aside until its panel or another lesson is opened.
void explore(Application& app, const std::filesystem::path& molecule) {
  app.open(molecule);
  const LessonSession* session = app.lesson.session();
  if (!session) return;
  app.panels.lesson = false;
  app.messages.notice(
      trf("{0} is set aside. It waits on the welcome page, and in View, Lesson panel.", session->lesson().title));
}

void drawMolecules(Application& app, Grid& grid) {
  const std::vector<LibraryItem>& items = library();
  if (items.empty()) return;
  heading(tr("Explore freely"));
  rows(grid, items.size(), kMoleculeWidth, [&](std::size_t k, float width) {
    const LibraryItem& m = items[k];
    const auto picture = [&] { return app.extensions().card_pictures.find({{m.file}, SceneSpec{}}); };
    if (drawCard(grid, {.name = "welcome/molecule/" + m.id, .title = m.label, .line = m.id, .tip = m.label}, picture,
                 width))
      explore(app, m.file);
  });
}

// Suggests the most likely next step.
void drawNext(Application& app, float max) {
  const LessonCard* latest = app.extensions().lesson_list.latest();
  const LessonSession* session = app.lesson.session();
  std::string label;
  if (session)
    label = trf("Back to {0}", session->lesson().title);
  else if (app.scene.stage())
    label = tr("Back to the molecule");
  else if (latest)
    label = trf("Go on with {0}", latest->title);
  if (!label.empty()) {
    const std::string shown = elided(label, max - look().px(40));
    if (button("welcome/next", shown.c_str(), ButtonLook::Primary)) {
      if (app.hasWork())
        app.panels.pages.welcome = false;
      else
        app.extensions().lesson_list.begin(*latest);
    }
    if (max > look().px(560)) ImGui::SameLine();
  }
  if (button("welcome/open", tr("Open a file …"))) findAction("open")->run(app);
  // Beside it if there is room.
  const ImGuiStyle& style = ImGui::GetStyle();
  const float end = ImGui::GetItemRectMax().x + style.ItemSpacing.x + 2 * style.FramePadding.x +
                    ImGui::CalcTextSize(tr("Add a lesson …")).x + look().px(16);
  if (end <= ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x) ImGui::SameLine();
  if (button("welcome/add", tr("Add a lesson …"))) app.panels.pages.open = app.panels.open_adds = true;
  tip(tr("Puts a lesson that you were given (.moltact) or wrote (.md) on this page"));
}

void readKeys(Grid& grid, PanelState& panels) {
  if (!keysFree()) return;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl || io.KeyAlt) return;
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key, true); };
  grid.enter = ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false);
  const int count = int(panels.card.cards);
  int at = int(panels.card.card);
  const bool none = at >= count;
  const int row = none ? 1 : std::max(1, int(panels.card.columns));
  const int step = (pressed(ImGuiKey_RightArrow)) - (pressed(ImGuiKey_LeftArrow)) +
                   row * (pressed(ImGuiKey_DownArrow) - pressed(ImGuiKey_UpArrow));
  if (!step || !count) return;
  at = none ? 0 : std::clamp(at + step, 0, count - 1);
  panels.card.card = std::size_t(at);
  panels.card.scroll = true;
}

}  // namespace

void drawWelcomePage(Application& app) {
  if (!beginPanel("welcome", app.layout().page)) return;
  const Look& l = look();
  PanelState& panels = app.panels;
  Grid grid(panels);
  readKeys(grid, panels);
  const float room = ImGui::GetContentRegionAvail().x;
  grid.width = std::min(room, l.tx(kWidest));
  const float indent = std::max(1.0f, std::floor(0.5f * (room - grid.width)));
  ImGui::Indent(indent);
  ImGui::Dummy({0, l.px(6)});
  {
    WithFont big(Font::Heading);
    ImGui::TextUnformatted(tr("Touch the molecules of life"));
    recordItem("welcome/title", tr("Touch the molecules of life"));
  }
  {
    WithText quiet(l.palette.quiet);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + grid.width);
    ImGui::TextUnformatted(
        tr("Take a lesson, or explore a molecule on your own. A haptic stylus lets you feel the surface; the mouse "
           "works too."));
    ImGui::PopTextWrapPos();
  }
  ImGui::Dummy({0, l.px(4)});
  drawNext(app, grid.width);
  drawLessons(app, grid, false);
  drawLessons(app, grid, true);
  drawMolecules(app, grid);
  ImGui::Dummy({0, l.px(16)});
  ImGui::Unindent(indent);
  panels.card.cards = grid.count;
  panels.card.columns = panels.card.card < grid.columns.size() ? grid.columns[panels.card.card] : 1;
  endPanel();
}

}  // namespace moltact
