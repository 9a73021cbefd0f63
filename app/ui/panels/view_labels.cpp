// Names, arrows and measures over the view. While the user measures: the last measurement or instructions.
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/scene/view_picture.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/render/label_painter.h"

namespace moltact {

void drawViewLabels(Application& app, const ViewScene& scene, const Rectangle& view) {
  if ((scene.annotations.empty() && !scene.held_lines) || !app.scene.stage()) return;
  const Look& l = look();
  const WithFont body(Font::Body);
  const double unit = double(l.px(1));
  const LabelRoom room{int(view.size().x), int(view.size().y), unit, [](const std::string& text) {
                         const ImVec2 size = ImGui::CalcTextSize(text.c_str());
                         return glm::dvec2(size.x, size.y);
                       }};
  const LabelColours colours = labelColours(scene.theme);
  const auto packed = [](const Colour& c, double alpha) {
    return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, float(alpha)});
  };
  const auto at = [&](const glm::dvec2& p) { return ImVec2(view.low.x + float(p.x), view.low.y + float(p.y)); };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect({view.low.x, view.low.y}, {view.high.x, view.high.y}, true);
  std::size_t count = 0;
  for (const PlacedLabel& label :
       app.picture().labels(scene, app.scene.stage().spheres.get(), room, ImGui::GetFontSize())) {
    const ImU32 line = packed(colours.line, label.strength);
    if (const ArrowShape arrow = arrowOf(label, unit); arrow.drawn) {
      draw->AddLine(at(arrow.from), at(arrow.neck), packed(colours.ground, 0.6 * label.strength), l.px(4.4f));
      draw->AddLine(at(arrow.from), at(arrow.neck), line, l.px(2));
      draw->AddTriangleFilled(at(label.tip), at(arrow.left), at(arrow.right), line);
    }
    draw->AddRectFilled(at(label.low), at(label.high), packed(colours.ground, 0.86 * label.strength), l.px(6));
    draw->AddText(at(label.low + labelPadding_px(unit)), packed(colours.text, label.strength), label.text.c_str());
    const ImVec2 low = at(label.low), high = at(label.high);
    recordRectangle((label.measure ? "view/measure/" : "view/label/") + std::to_string(count++), {low.x, low.y},
                    {high.x, high.y}, label.text);
  }
  draw->PopClipRect();
}

std::string measuringText(const Application& app) {
  const Measuring& measuring = app.extensions().measuring;
  if (!measuring.on()) return {};
  return measuring.text().empty()
             ? tr("Click two atoms for their distance, a third for the angle, a fourth for the torsion")
             : measuring.text();
}

}  // namespace moltact
