// In the view's upper left corner where the colours of the atoms are not the customary ones: what each of them is.
#include "engine/render/colour_legend.h"

#include <algorithm>
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

bool namesMarks(const Application& app) {
  const auto& marks = app.scene.look.marks;
  return marks && std::any_of(marks->begin(), marks->end(), [](const OwnColour& m) { return !m.name.empty(); });
}

}  // namespace

void drawColourLegend(Application& app, const Rectangle& view) {
  const bool by_chain = app.scene.colour_by == ColourBy::Chain;
  const Colouring* const scheme = app.scene.look.colouring.get();
  const bool painted = app.extensions().touch_traces.painted() != nullptr;
  if (!app.settings.legend || !(app.settings.colour_blind_safe || by_chain || scheme || painted || namesMarks(app)) ||
      !app.scene.shown.has(ViewPart::Atoms))
    return;
  const Look& l = look();
  std::vector<LegendEntry> entries =
      legendOf(*app.scene.stage().molecule, app.scene.colour_by, elementColoursOf(app.settings), app.scene.look);
  if (painted) entries.push_back({l.viewTheme().touched, tr("touched")});
  ViewScene marks;
  app.lesson.decorate(marks);
  if (!marks.highlighted.empty() && app.scene.shown.has(ViewPart::Target))
    entries.push_back({l.viewTheme().target, tr("marked")});
  WithFont small(Font::Small);
  const float line = ImGui::GetFontSize() + l.px(5), pad = l.px(10), dot = 0.36f * ImGui::GetFontSize(),
              indent = 2 * dot + l.px(8);
  float wide = 0.0f;
  for (const LegendEntry& e : entries) wide = std::max(wide, ImGui::CalcTextSize(e.name.c_str()).x);
  const ImVec2 low{view.low.x + l.px(14), view.low.y + l.px(14)};
  const ImVec2 high{low.x + indent + wide + 2 * pad, low.y + line * float(entries.size()) - l.px(5) + 2 * pad};
  if (high.x > view.high.x - l.px(60) || high.y > view.high.y - l.px(80)) return;  // no room for it
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, faded(l.palette.panel, 0.88f), l.px(8));
  std::string text;
  float y = low.y + pad;
  for (const LegendEntry& e : entries) {
    const ImVec2 centre{low.x + pad + dot, y + 0.5f * ImGui::GetFontSize()};
    draw->AddCircleFilled(centre, dot, ImGui::ColorConvertFloat4ToU32({e.colour.x, e.colour.y, e.colour.z, 1.0f}), 24);
    draw->AddCircle(centre, dot, l.palette.quiet, 24, 1.0f);
    draw->AddText({low.x + pad + indent, y}, l.palette.text, e.name.c_str());
    text += (text.empty() ? "" : ", ") + e.name;
    y += line;
  }
  recordRectangle("view/legend", {low.x, low.y}, {high.x, high.y}, text);
}

}  // namespace moltact
