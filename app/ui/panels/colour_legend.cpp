// The legend of the atoms' colours in the view's upper left corner. If it would hide the molecule, it is a closed line
// that a click opens.
#include "engine/render/colour_legend.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr float kWidthShare = 1.0f / 3.0f, kHeightShare = 0.5f;  // shares of the view; a larger legend is closed at
                                                                 // first

bool namesMarks(const Application& app) {
  const auto& marks = app.scene.look.atoms.marks;
  return marks && std::any_of(marks->begin(), marks->end(), [](const OwnColour& m) { return !m.name.empty(); });
}

bool holdsCarbon(const TouchableModel& stage) {
  return stage.body && std::any_of(stage.body->atoms.begin(), stage.body->atoms.end(),
                                   [&](std::uint32_t a) { return stage.molecule->atoms[a].atomic_number == 6; });
}

// A single element in its customary colour needs no legend.
std::vector<LegendEntry> entriesOf(Application& app) {
  const std::vector<LegendEntry>& of_atoms = app.panels.colours.of(
      app.scene.stage().molecule, app.scene.look.colour_by, elementColoursOf(app.settings), app.scene.look.atoms);
  const bool painted = app.extensions().touch_paint.painted() != nullptr;
  if (of_atoms.size() < 2 && !app.settings.colour_blind_safe && app.scene.look.colour_by != ColourBy::Chain &&
      !app.scene.look.atoms.colouring && !painted && !namesMarks(app))
    return {};
  std::vector<LegendEntry> entries = of_atoms;
  if (holdsCarbon(app.scene.stage())) entries.push_back({look().viewTheme().probe, tr("carbon in your hand")});
  if (painted) entries.push_back({look().viewTheme().touched, tr("touched")});
  ViewScene marks;
  app.lesson.decorate(marks);
  if (!marks.highlighted.empty() && app.scene.look.shown.has(ViewPart::Target))
    entries.push_back({look().viewTheme().target, tr("marked")});
  return entries;
}

ImVec2 sizeOfLine() {
  const Look& l = look();
  return {l.px(38) + ImGui::CalcTextSize(tr("Colours")).x, ImGui::GetFontSize() + l.px(12)};
}

// Draws the line that opens and closes the legend. Returns its lower edge.
float drawLine(Application& app, ImVec2 low) {
  const Look& l = look();
  const char* const label = tr("Colours");
  const ImVec2 pad{l.px(10), l.px(6)}, whole = sizeOfLine();
  const float side = l.px(12), gap = l.px(6);
  ImGui::SetCursorScreenPos(low);
  bool& open = app.panels.legend;
  if (ImGui::InvisibleButton("legend", whole)) open = !open;
  const bool hovered = ImGui::IsItemHovered();
  recordItem("view/legend/line", open ? "open" : "closed");
  tip(open ? tr("Close the legend") : tr("What the colours mean"));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, {low.x + whole.x, low.y + whole.y},
                      faded(hovered ? l.palette.hovered : l.palette.panel, 0.88f), l.px(8));
  drawIcon(draw, open ? Icon::ChevronDown : Icon::ChevronRight, {low.x + pad.x + 0.5f * side, low.y + 0.5f * whole.y},
           side, l.palette.text);
  draw->AddText({low.x + pad.x + side + gap, low.y + pad.y}, l.palette.text, label);
  return low.y + whole.y;
}

}  // namespace

void drawColourLegend(Application& app, ViewRoom& room) {
  const Rectangle &view = room.view, &kept_free = room.slider;
  if (!app.settings.legend || !app.scene.look.shown.has(ViewPart::Atoms)) return;
  std::vector<LegendEntry> entries = entriesOf(app);
  if (entries.empty()) return;
  const Look& l = look();
  WithFont small(Font::Small);
  const float line = ImGui::GetFontSize() + l.px(5), pad = l.px(10), dot = 0.36f * ImGui::GetFontSize(),
              indent = 2 * dot + l.px(8);
  float wide = 0.0f;
  for (const LegendEntry& e : entries) wide = std::max(wide, ImGui::CalcTextSize(e.name.c_str()).x);
  const auto heightOf = [&](std::size_t lines) { return line * float(lines) - l.px(5) + 2 * pad; };
  ImVec2 low{view.low.x + l.px(14), view.low.y + l.px(14)};
  const float width = indent + wide + 2 * pad;
  const bool large = width > kWidthShare * view.size().x || heightOf(entries.size()) > kHeightShare * view.size().y;
  // Overlays at the top of the view keep their place.
  const float stands = !large ? width : app.panels.legend ? std::max(width, sizeOfLine().x) : sizeOfLine().x;
  if (!kept_free.empty() && low.x + stands > kept_free.low.x) low.y = kept_free.high.y + l.px(8);
  const float most_x = view.high.x - l.px(60), most_y = std::min(view.high.y - l.px(80), room.words_top);
  if (large) {
    const Rectangle closed{{low.x, low.y}, {low.x + sizeOfLine().x, low.y + sizeOfLine().y}};
    if (closed.high.y > room.words_top || !room.isFree(closed)) return;
    room.take(closed);
    low.y = drawLine(app, low) + l.px(4);
    if (!app.panels.legend) return;
  }
  const auto lines = std::size_t(std::max(0.0f, std::floor((most_y - low.y + l.px(5) - 2 * pad) / line)));
  if (lines == 0 || low.x + indent + 2 * pad >= most_x) return;  // no room for it
  if (entries.size() > lines) entries.resize(lines);
  const ImVec2 high{std::min(low.x + width, most_x), low.y + heightOf(entries.size())};
  if (!room.isFree({{low.x, low.y}, {high.x, high.y}})) return;
  room.take({{low.x, low.y}, {high.x, high.y}});
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, faded(l.palette.panel, 0.88f), l.px(8));
  std::string text;
  float y = low.y + pad;
  for (const LegendEntry& e : entries) {
    const ImVec2 centre{low.x + pad + dot, y + 0.5f * ImGui::GetFontSize()};
    draw->AddCircleFilled(centre, dot, ImGui::ColorConvertFloat4ToU32({e.colour.x, e.colour.y, e.colour.z, 1.0f}), 24);
    draw->AddCircle(centre, dot, l.palette.quiet, 24, 1.0f);
    const float x = low.x + pad + indent;
    draw->AddText({x, y}, l.palette.text, elided(e.name, high.x - pad - x + 1.0f).c_str());
    text += (text.empty() ? "" : ", ") + e.name;
    y += line;
  }
  recordRectangle("view/legend", {low.x, low.y}, {high.x, high.y}, text);
}

}  // namespace moltact
