// At the view's upper right: the height picture of the scanning tip as it grows, with a button that switches between
// touching the scanned surface and the atoms.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/render/height_picture.h"

namespace moltact {

void drawScanCard(Application& app, ViewRoom& room) {
  SurfaceScan& scan = app.extensions().surface_scan;
  if (!scan.on() || app.extensions().playback.on()) return;
  const Look& l = look();
  const HeightField& field = scan.field();
  const float pad = l.px(8), line = ImGui::GetTextLineHeight(), high_button = l.tx(30);
  const float most = std::min(l.tx(180), 0.4f * std::min(room.view.size().x, room.view.size().y));
  const float longest = float(std::max(field.columns, field.rows));
  const ImVec2 picture{most * float(field.columns) / longest, most * float(field.rows) / longest};
  const char* const label = scan.touching() ? tr("Touch the atoms") : tr("Touch the scan");
  const std::string done = quantityText(double(scan.lines()) / field.rows, Dimension::Share),
                    high = quantityText(highest_A(field, field.rows), Dimension::Length, decimals(1));
  const double force_pN = scan.setup().force_pN;
  const std::string words =
      force_pN > 0.0   ? scan.running() ? trf("Scanning at {0} pN: {1}", numberText(force_pN, decimals(0)), done)
                                        : trf("At {0} pN up to {1} high", numberText(force_pN, decimals(0)), high)
        : scan.running() ? trf("Scanning: {0}", done)
                       : trf("Up to {0} high", high);
  const auto wide = [&](const char* text) { return ImGui::CalcTextSize(text).x; };
  const float buttons = std::max({wide(tr("Touch the atoms")), wide(tr("Touch the scan")), wide(tr("Scan from here"))});
  const float width = std::max({picture.x, wide(words.c_str()), buttons + l.px(24)}) + 2 * pad,
              below = scan.running() ? 0.0f : 2 * (high_button + pad);
  const float height = picture.y + line + below + 3 * pad;
  // Below the button that resets the view.
  const float right = room.view.high.x - l.px(14), top = room.view.low.y + l.px(56);
  const Rectangle place{{right - width, top}, {right, top + height}};
  if (place.high.y > room.view.high.y || place.low.x < room.view.low.x || !room.isFree(place)) return;
  room.take(place);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({place.low.x, place.low.y}, {place.high.x, place.high.y}, faded(l.palette.panel, 0.92f), l.px(8));
  const ImVec2 at{std::round(place.low.x + 0.5f * (width - picture.x)), place.low.y + pad};
  if (scan.texture()) draw.AddImage(scan.texture(), at, {at.x + picture.x, at.y + picture.y});
  recordRectangle("view/scan", place.low, place.high);
  float y = at.y + picture.y + pad;
  ImGui::SetCursorScreenPos({place.low.x + pad, y});
  ImGui::TextUnformatted(words.c_str());
  recordItem("view/scan/words", words);
  if (scan.running()) return;
  y += line + pad;
  ImGui::SetCursorScreenPos({place.low.x + pad, y});
  if (button("view/scan/touch", label, ButtonLook::Plain, width - 2 * pad)) scan.touch(!scan.touching());
  tip(tr("A touch of the scan does no task"));
  ImGui::SetCursorScreenPos({place.low.x + pad, y + high_button + pad});
  if (button("view/scan/again", tr("Scan from here"), ButtonLook::Plain, width - 2 * pad)) scan.again();
  tip(tr("The tip comes from the viewer's side"));
}

}  // namespace moltact
