#include "app/ui/widgets/plot.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// The smallest of 1, 2, 5, 10, 20, … that is not less than the value.
float roundUp(float value) {
  const float ten = std::pow(10.0f, std::floor(std::log10(std::max(value, 1e-6f))));
  for (const float step : {1.0f, 2.0f, 5.0f, 10.0f})
    if (value <= step * ten * 1.0001f) return step * ten;
  return value;
}

}  // namespace

void plot(const char* name, const PlotBuffer& buffer, double newest, const PlotLook& how) {
  const Look& l = look();
  const Palette& p = l.palette;
  const float width = ImGui::GetContentRegionAvail().x, small = l.font(Font::Small)->FontSize;
  const std::string reading = quantityText(newest * how.shown_as.code_units, how.shown_as.dimension, how.shown_as.how);

  const float head = small + l.px(6), body = l.px(how.height);
  ImGui::Dummy({width, head + body});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImFont* font = l.font(Font::Small);
  const std::string title = trf("{0}, last {1}", how.title, quantityText(how.span_s, Dimension::Time, decimals(0)));
  draw->AddText(font, small, low, p.quiet, title.c_str());
  const float reading_w = font->CalcTextSizeA(small, 1e9f, 0.0f, reading.c_str()).x;
  if (font->CalcTextSizeA(small, 1e9f, 0.0f, title.c_str()).x + reading_w > width) widgets().noteCut(title);
  draw->AddText(font, small, {high.x - reading_w, low.y}, p.text, reading.c_str());

  const ImVec2 a{low.x, low.y + head}, b = high;
  draw->AddRectFilled(a, b, p.raised, l.px(6));
  float top = how.min_top;
  for (std::size_t k = 0; k < buffer.size(); ++k) top = std::max(top, buffer.ago(k));
  top = roundUp(std::min(top, 1e30f) * 1.02f);
  const float inset = l.px(6), y0 = b.y - inset, y1 = a.y + inset;
  const auto y = [&](float v) { return y0 - (y0 - y1) * std::clamp(v / top, 0.0f, 1.0f); };
  for (const float part : {0.5f, 1.0f}) draw->AddLine({a.x, y(part * top)}, {b.x, y(part * top)}, p.line, 1.0f);

  // One point per pixel column: the largest of the values in that column.
  if (buffer.size() > 1) {
    draw->PushClipRect(a, b, true);
    const std::size_t columns = std::min<std::size_t>(std::max<std::size_t>(2, std::size_t(width)), buffer.capacity());
    ImVec2 before{};
    const ImU32 fill = faded(p.accent, 0.18f);
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t newest_age = (columns - 1 - c) * buffer.capacity() / columns;
      const std::size_t oldest_age = std::min((columns - c) * buffer.capacity() / columns, buffer.size());
      if (newest_age >= oldest_age) continue;
      float most = 0.0f;
      for (std::size_t age = newest_age; age < oldest_age; ++age) most = std::max(most, buffer.ago(age));
      const ImVec2 here{a.x + (b.x - a.x) * float(c) / float(columns - 1), y(most)};
      if (before.x > 0.0f) {
        draw->AddQuadFilled(before, here, {here.x, y0}, {before.x, y0}, fill);
        draw->AddLine(before, here, p.accent, l.px(1.6f));
      }
      before = here;
    }
    draw->PopClipRect();
  }
  // Drawn above the curve, which may pass behind it.
  const std::string most = numberText(double(top), top < 1.0f ? plain(2) : decimals(0));
  const ImVec2 size = font->CalcTextSizeA(small * 0.86f, 1e9f, 0.0f, most.c_str()), at{a.x + l.px(6), y(top) + l.px(1)};
  draw->AddRectFilled({at.x - l.px(2), at.y}, {at.x + size.x + l.px(2), at.y + size.y}, faded(p.raised, 0.85f),
                      l.px(3));
  draw->AddText(font, small * 0.86f, at, p.quiet, most.c_str());
  recordItem(name, reading);
}

}  // namespace moltact
