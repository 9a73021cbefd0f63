#include "app/ui/widgets/plot.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/saturated.h"
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

// The plot's area, below a title at the left and a text at the right.
struct PlotFrame {
  ImVec2 a, b, head;  ///< corners of the area, and the place of the title
  ImFont* font;
  float small;
};

PlotFrame plotFrame(const std::string& title, float height, const std::string& reading) {
  const Look& l = look();
  const float width = ImGui::GetContentRegionAvail().x, small = l.font(Font::Small)->FontSize;
  const float head = small + l.px(6), body = l.px(height);
  ImGui::Dummy({width, head + body});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImFont* font = l.font(Font::Small);
  draw->AddText(font, small, low, l.palette.quiet, title.c_str());
  const float reading_w = font->CalcTextSizeA(small, 1e9f, 0.0f, reading.c_str()).x;
  if (font->CalcTextSizeA(small, 1e9f, 0.0f, title.c_str()).x + reading_w > width) widgets().noteCut(title);
  draw->AddText(font, small, {high.x - reading_w, low.y}, l.palette.text, reading.c_str());
  const ImVec2 a{low.x, low.y + head};
  draw->AddRectFilled(a, high, l.palette.raised, l.px(6));
  return {a, high, low, font, small};
}

PlotFrame plotFrame(const PlotLook& how, const std::string& reading) {
  return plotFrame(trf("{0}, last {1}", how.title, quantityText(how.span_s, Dimension::Time, decimals(0))), how.height,
                   reading);
}

// Calls point(x, values from, to) for each pixel column of the area that has values, by their ages.
template <class Point>
void eachColumn(const PlotBuffer& buffer, const PlotFrame& frame, Point&& point) {
  if (buffer.size() < 2) return;
  const float width = frame.b.x - frame.a.x;
  const std::size_t columns = std::min<std::size_t>(std::max<std::size_t>(2, std::size_t(width)), buffer.capacity());
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t newest_age = (columns - 1 - c) * buffer.capacity() / columns;
    const std::size_t oldest_age = std::min((columns - c) * buffer.capacity() / columns, buffer.size());
    if (newest_age < oldest_age) point(frame.a.x + width * float(c) / float(columns - 1), newest_age, oldest_age);
  }
}

// A text of a scale, above the curves, which may pass behind it.
void scaleText(const PlotFrame& frame, const std::string& text, const ImVec2& at) {
  const Look& l = look();
  const float size_px = frame.small * 0.86f;
  const ImVec2 size = frame.font->CalcTextSizeA(size_px, 1e9f, 0.0f, text.c_str());
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({at.x - l.px(2), at.y}, {at.x + size.x + l.px(2), at.y + size.y}, faded(l.palette.raised, 0.85f),
                      l.px(3));
  draw->AddText(frame.font, size_px, at, l.palette.quiet, text.c_str());
}

// The number at the end of a scale.
void scaleEnd(const PlotFrame& frame, float value, const ImVec2& at) {
  scaleText(frame, numberText(double(value), std::abs(value) < 1.0f ? plain(2) : decimals(0)), at);
}

}  // namespace

void plot(const char* name, const PlotBuffer& buffer, double newest, const PlotLook& how) {
  const Look& l = look();
  const Palette& p = l.palette;
  const std::string reading = quantityText(newest * how.shown_as.code_units, how.shown_as.dimension, how.shown_as.how);
  const PlotFrame frame = plotFrame(how, reading);
  const auto& [a, b, head, font, small] = frame;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  float top = how.min_top;
  for (std::size_t k = 0; k < buffer.size(); ++k) top = std::max(top, buffer.ago(k));
  top = roundUp(std::min(top, 1e30f) * 1.02f);
  const float inset = l.px(6), y0 = b.y - inset, y1 = a.y + inset;
  const auto y = [&](float v) { return y0 - (y0 - y1) * std::clamp(v / top, 0.0f, 1.0f); };
  for (const float part : {0.5f, 1.0f}) draw->AddLine({a.x, y(part * top)}, {b.x, y(part * top)}, p.line, 1.0f);

  // One point per pixel column: the largest of the values in that column.
  draw->PushClipRect(a, b, true);
  ImVec2 before{};
  const ImU32 fill = faded(p.accent, 0.18f);
  eachColumn(buffer, frame, [&](float x, std::size_t newest_age, std::size_t oldest_age) {
    float most = 0.0f;
    for (std::size_t age = newest_age; age < oldest_age; ++age) most = std::max(most, buffer.ago(age));
    const ImVec2 here{x, y(most)};
    if (before.x > 0.0f) {
      draw->AddQuadFilled(before, here, {here.x, y0}, {before.x, y0}, fill);
      draw->AddLine(before, here, p.accent, l.px(1.6f));
    }
    before = here;
  });
  draw->PopClipRect();
  scaleEnd(frame, top, {a.x + l.px(6), y(top) + l.px(1)});
  recordItem(name, reading);
}

void signedPlot(const char* name, std::span<const PlotCurve> curves, const PlotLook& how) {
  const Look& l = look();
  const Palette& p = l.palette;
  const PlotFrame frame = plotFrame(how, {});
  const ImVec2 a = frame.a, b = frame.b;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  float top = how.min_top, bottom = -how.min_top;
  for (const PlotCurve& c : curves)
    for (std::size_t k = 0; k < c.buffer->size(); ++k)
      top = std::max(top, c.buffer->ago(k)), bottom = std::min(bottom, c.buffer->ago(k));
  top = roundUp(std::min(top, 1e30f) * 1.02f);
  bottom = -roundUp(std::min(-bottom, 1e30f) * 1.02f);
  const float inset = l.px(6), y0 = b.y - inset, y1 = a.y + inset;
  const auto y = [&](float v) { return y0 - (y0 - y1) * std::clamp((v - bottom) / (top - bottom), 0.0f, 1.0f); };
  for (const float v : {bottom, top}) draw->AddLine({a.x, y(v)}, {b.x, y(v)}, p.line, 1.0f);
  draw->AddLine({a.x, y(0.0f)}, {b.x, y(0.0f)}, p.quiet, 1.0f);
  draw->PushClipRect(a, b, true);
  for (const PlotCurve& c : curves) {
    ImVec2 before{};
    eachColumn(*c.buffer, frame, [&](float x, std::size_t newest_age, std::size_t) {
      const ImVec2 here{x, y(c.buffer->ago(newest_age))};
      if (before.x > 0.0f) draw->AddLine(before, here, c.colour, l.px(1.8f));
      before = here;
    });
  }
  draw->PopClipRect();
  scaleEnd(frame, top, {a.x + l.px(6), y(top) + l.px(1)});
  scaleEnd(frame, bottom, {a.x + l.px(6), y(bottom) - frame.small});
  // Each curve's newest value, in its colour.
  std::string all;
  for (const PlotCurve& c : curves) {
    const std::string text = c.title + "  " + c.reading;
    ImGui::PushStyleColor(ImGuiCol_Text, c.colour);
    ImGui::PushFont(frame.font);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
    all += (all.empty() ? "" : "; ") + c.title + " " + c.reading;
  }
  recordItem(name, all);
}

void functionPlot(const char* name, const std::function<double(double)>& function, const FunctionPlot& how) {
  const Look& l = look();
  const Palette& p = l.palette;
  const PlotFrame frame = plotFrame(how.title, how.height, {});
  const ImVec2 a = frame.a, b = frame.b;
  double from = how.from, to = how.to;
  if (how.at && *how.at > to) to = double(roundUp(saturateToFloat(std::min(*how.at, 1e30) * 1.02)));
  if (how.at && *how.at < from) from = -double(roundUp(saturateToFloat(std::min(-*how.at, 1e30) * 1.02)));
  const double low = function(from), high = function(to);
  const float inset = l.px(8);
  const auto place = [&](double x, double y) {
    const auto across = float((x - from) / (to - from)), up = float((y - low) / (high - low));
    return ImVec2{a.x + inset + (b.x - a.x - 2 * inset) * across, b.y - inset - (b.y - a.y - 2 * inset) * up};
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(a, b, true);
  draw->AddLine({a.x, place(0, 0).y}, {b.x, place(0, 0).y}, p.quiet, 1.0f);
  draw->AddLine({place(0, 0).x, a.y}, {place(0, 0).x, b.y}, p.quiet, 1.0f);
  draw->AddLine(place(from, from), place(to, to), p.faint, 1.0f);
  constexpr int kPieces = 120;
  ImVec2 before{};
  for (int k = 0; k <= kPieces; ++k) {
    const double x = from + (to - from) * k / kPieces;
    const ImVec2 here = place(x, function(x));
    if (k > 0) draw->AddLine(before, here, p.accent, l.px(1.8f));
    before = here;
  }
  std::string text;
  if (how.at) {
    const ImVec2 at = place(*how.at, function(*how.at));
    draw->AddCircleFilled(at, l.px(4.5f), p.text, 20);
    draw->AddCircleFilled(at, l.px(3.0f), p.accent, 20);
    text = numberText(*how.at, decimals(1)) + " " + numberText(function(*how.at), decimals(1));
  }
  draw->PopClipRect();
  const float size_px = frame.small * 0.86f;
  const std::string up_end = numberText(high, plain(2)) + " " + how.up,
                    across_end = numberText(to, plain(2)) + " " + how.across;
  const ImVec2 zero = place(0, 0);
  scaleText(frame, up_end, {zero.x + l.px(5), a.y + l.px(2)});
  const float wide = frame.font->CalcTextSizeA(size_px, 1e9f, 0.0f, across_end.c_str()).x;
  scaleText(frame, across_end, {b.x - l.px(6) - wide, zero.y - size_px - l.px(2)});
  recordItem(name, text);
}

void seriesPlot(const char* name, std::span<const float> values, const SeriesPlot& how) {
  if (values.size() < 2) return;
  const Look& l = look();
  const Palette& p = l.palette;
  const PlotFrame frame = plotFrame(how.title, how.height, {});
  const ImVec2 a = frame.a, b = frame.b;
  const double high = double(roundUp(std::max(1.02f * *std::max_element(values.begin(), values.end()), 1e-6f)));
  const float inset = l.px(8), size_px = frame.small * 0.86f, floor = b.y - size_px - l.px(6);
  const auto place = [&](double k, double y) {
    return ImVec2{a.x + inset + (b.x - a.x - 2 * inset) * float(k / double(values.size() - 1)),
                  floor - (floor - a.y - inset) * float(y / high)};
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddLine({a.x, floor}, {b.x, floor}, p.quiet, 1.0f);
  for (std::size_t k = 1; k < values.size(); ++k)
    draw->AddLine(place(double(k - 1), double(values[k - 1])), place(double(k), double(values[k])), p.accent,
                  l.px(1.4f));
  const double k = std::clamp((how.at - how.first) / how.step, 0.0, double(values.size() - 1));
  const auto low = std::min(std::size_t(k), values.size() - 2);
  const double value = double(values[low]) + (k - double(low)) * (double(values[low + 1]) - double(values[low]));
  const ImVec2 at = place(k, value);
  draw->AddLine({at.x, a.y}, {at.x, floor}, p.faint, 1.0f);
  draw->AddCircleFilled(at, l.px(4.5f), p.text, 20);
  draw->AddCircleFilled(at, l.px(3.0f), p.accent, 20);
  scaleText(frame, numberText(high, plain(2)) + " " + how.up, {a.x + l.px(5), a.y + l.px(2)});
  const double last = how.first + how.step * double(values.size() - 1);
  const std::string end = numberText(last, decimals(0)), begin = numberText(how.first, decimals(0)) + " " + how.across;
  const float wide = frame.font->CalcTextSizeA(size_px, 1e9f, 0.0f, end.c_str()).x;
  scaleText(frame, begin, {a.x + l.px(5), floor + l.px(2)});
  scaleText(frame, end, {b.x - l.px(5) - wide, floor + l.px(2)});
  recordItem(name, numberText(value, decimals(2)));
}

}  // namespace moltact
